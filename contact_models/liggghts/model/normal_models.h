// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace plastigran {

// The normal models in the lines of a deck, if they differ.
struct MixedModels {
  std::string
      text;  // "pair_style has thornton; fix floor has a model of LIGGGHTS"; empty: one model
  std::string first;         // the first line with a law: "pair_style" or "fix ID"
  bool has_foreign = false;  // a line has a model of LIGGGHTS
};

MixedModels mixed_models(LAMMPS_NS::LAMMPS* engine);

}  // namespace plastigran
