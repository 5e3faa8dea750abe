// SPDX-License-Identifier: GPL-2.0-or-later
//
// The laws and the combinations of other models that the plugin registers. Each is compiled in a
// file of its own, from law.cpp.in or combination.cpp.in.
#pragma once

#include <memory>

#include "liggghts/model/contact_setup.h"
#include "liggghts/plugin/engine_styles.h"

namespace plastigran {

// The normal model of a law.
struct RegisteredLaw {
  typedef std::shared_ptr<LIGGGHTS::ContactModels::NormalModelBase> Model;

  const char* name;  // in decks
  int id;            // in LIGGGHTS' hash of a combination
  Model (*make)(LAMMPS_NS::LAMMPS*, ContactSetup&, LIGGGHTS::ContactModels::ContactModelBase*);
};

// The other models of a contact (ANY: any of its kind), and functions that make their pair style
// and their wall.
struct RegisteredCombination {
  int tangential, cohesion, rolling, surface;
  LIGGGHTS::PairStyles::IGranularPairStyle* (*pair)(LAMMPS_NS::LAMMPS*, LAMMPS_NS::PairGran*,
                                                    int64_t);
  LIGGGHTS::Walls::IGranularWall* (*wall)(LAMMPS_NS::LAMMPS*, LAMMPS_NS::FixWallGran*, int64_t);
};

// Stops the run if the plugin was compiled with the headers of another LIGGGHTS version.
void require_version(LAMMPS_NS::LAMMPS* engine);

}  // namespace plastigran
