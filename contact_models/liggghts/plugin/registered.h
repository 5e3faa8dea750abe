// SPDX-License-Identifier: GPL-2.0-or-later
//
// The laws that the plugin registers, and the combinations of LIGGGHTS' tangential, cohesion,
// rolling and surface models. CMake generates one source file for each law and each combination,
// from law.cpp.in and combination.cpp.in.
#pragma once

#include <memory>
#include <string>

#include "liggghts/model/contact_setup.h"
#include "liggghts/plugin/engine_styles.h"

namespace plastigran {

// Name, ID and factory functions of the normal model of a law, or of LIGGGHTS' own `hertz`.
struct RegisteredLaw {
  typedef std::shared_ptr<LIGGGHTS::ContactModels::NormalModelBase> Model;

  const char* name;  // name in decks
  int id;            // ID in LIGGGHTS' hash of a combination
  Model (*make)(LAMMPS_NS::LAMMPS*, ContactSetup&, LIGGGHTS::ContactModels::ContactModelBase*);
  // Creates the law with the option `adhesion jkr`, from the settings of its pair_style or wall
  // line. Stops if the law cannot have this option.
  Model (*make_adhesive)(LAMMPS_NS::LAMMPS*, ContactSetup&,
                         LIGGGHTS::ContactModels::ContactModelBase*, const std::string& settings);
};

// IDs of the other models of a contact (ANY: any model of the kind), and factory functions of the
// pair style and the wall for this combination.
struct RegisteredCombination {
  int tangential, cohesion, rolling, surface;
  LIGGGHTS::PairStyles::IGranularPairStyle* (*pair)(LAMMPS_NS::LAMMPS*, LAMMPS_NS::PairGran*,
                                                    int64_t);
  LIGGGHTS::Walls::IGranularWall* (*wall)(LAMMPS_NS::LAMMPS*, LAMMPS_NS::FixWallGran*, int64_t);
};

// Stops the run if the plugin was compiled with the headers of another LIGGGHTS version.
void require_version(LAMMPS_NS::LAMMPS* engine);

}  // namespace plastigran
