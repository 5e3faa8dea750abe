// SPDX-License-Identifier: GPL-2.0-or-later
//
// Which normal model each line of a deck has: the pair style and the granular walls.
#pragma once

#include <string>

namespace LAMMPS_NS {
class FixWallGran;
class LAMMPS;
class PairGran;
}  // namespace LAMMPS_NS

namespace plastigran {

// The law of this package that a pair style or wall has; empty: a model of LIGGGHTS.
std::string law_of(LAMMPS_NS::PairGran* pair);
std::string law_of(LAMMPS_NS::FixWallGran* wall);

// The lines that have them, as long as there is more than one normal model.
struct MixedModels {
  std::string text;   // "pair_style thornton; fix floor a model of LIGGGHTS"; empty: one model
  std::string first;  // the first line with a law, which reports this: "pair_style", "fix ID"
  bool has_foreign = false;  // a model of LIGGGHTS is one of them
};

MixedModels mixed_models(LAMMPS_NS::LAMMPS* engine);

}  // namespace plastigran
