// SPDX-License-Identifier: GPL-2.0-or-later
//
// What the plugin brings to the engine: laws, and combinations of the other models of a contact.
// Each is compiled in a file of its own, from law.cpp.in and combination.cpp.in.
#pragma once

#include <memory>

#include "liggghts/model/contact_setup.h"
#include "liggghts/plugin/engine_styles.h"

namespace plastigran {

// A normal model over one law.
struct RegisteredLaw {
  typedef std::shared_ptr<LIGGGHTS::ContactModels::NormalModelBase> Model;

  const char* name;  // as a deck has it
  int id;            // of the engine's hash of a combination
  Model (*make)(LAMMPS_NS::LAMMPS*, ContactSetup&, LIGGGHTS::ContactModels::ContactModelBase*);
};

// The other models of a contact, ANY for any of their kind, and how the engine makes the pair style
// or wall that has them.
struct RegisteredCombination {
  int tangential, cohesion, rolling, surface;
  LIGGGHTS::PairStyles::IGranularPairStyle* (*pair)(LAMMPS_NS::LAMMPS*, LAMMPS_NS::PairGran*,
                                                    int64_t);
  LIGGGHTS::Walls::IGranularWall* (*wall)(LAMMPS_NS::LAMMPS*, LAMMPS_NS::FixWallGran*, int64_t);
};

// The engine's headers this was compiled against must be the engine's own; stops the run if not.
void require_version(LAMMPS_NS::LAMMPS* engine);

}  // namespace plastigran
