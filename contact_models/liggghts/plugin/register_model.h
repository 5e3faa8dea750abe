// SPDX-License-Identifier: GPL-2.0-or-later
//
// Puts one normal model into the engine's factories: its name, a compiled class for every
// combination with the tangential and rolling models we promise, and for every other combination
// a creator that says so. (An unregistered combination would reach the engine's generic class,
// which knows nothing of models that came with a plugin.)
#pragma once

#include <string>

#include "fix_insert_stream.h"  // granular_styles.h uses it without including it
#include "granular_styles.h"
#include "liggghts/ledger/accounted_contact.h"
#include "universe.h"

namespace plastigran {

using namespace LIGGGHTS;
using namespace LIGGGHTS::ContactModels;

// The engine's headers this plugin was compiled against must be the engine's own: see plugin.cpp
// for the layout; the version is only known once an engine exists.
inline void require_version(LAMMPS_NS::LAMMPS* lmp) {
  if (std::string(lmp->universe->version).find(PLASTIGRAN_ENGINE_VERSION) != std::string::npos)
    return;
  const std::string text = std::string("Plastigran was compiled for ") + PLASTIGRAN_ENGINE_VERSION +
                           " but this engine is " + lmp->universe->version +
                           "; compile Plastigran against this engine's headers";
  lmp->error->all(FLERR, text.c_str());
}

// Ids of the models to combine with, as the engine's headers list them.
constexpr int tangential_ids[] = {
    TANGENTIAL_OFF,
#define TANGENTIAL_MODEL(identifier, name, id) identifier,
#include "style_tangential_model.h"
#undef TANGENTIAL_MODEL
};
constexpr int cohesion_ids[] = {
    COHESION_OFF,
#define COHESION_MODEL(identifier, name, id) identifier,
#include "style_cohesion_model.h"
#undef COHESION_MODEL
};
constexpr int rolling_ids[] = {
    ROLLING_OFF,
#define ROLLING_MODEL(identifier, name, id) identifier,
#include "style_rolling_model.h"
#undef ROLLING_MODEL
};
constexpr int surface_ids[] = {
#define SURFACE_MODEL(identifier, name, id) identifier,
#include "style_surface_model.h"
#undef SURFACE_MODEL
};

template <class Style, class Interface, class Parent>
Interface* create(LAMMPS_NS::LAMMPS* lmp, Parent* parent, int64_t hash) {
  require_version(lmp);
  return new Style(lmp, parent, hash);
}

template <class Interface, class Parent>
Interface* refuse(LAMMPS_NS::LAMMPS* lmp, Parent*, int64_t) {
  lmp->error->all(FLERR,
                  "This contact model works with tangential off | no_history | history, "
                  "rolling_friction off | cdt | epsd2, cohesion off, surface default; "
                  "other combinations are not available");
  return nullptr;
}

template <int Model>
class RegisterModel {
 public:
  explicit RegisterModel(const char* name) {
    ContactModels::Factory::instance().addNormalModel(name, Model);
    for (int tangential : tangential_ids)
      for (int cohesion : cohesion_ids)
        for (int rolling : rolling_ids)
          for (int surface : surface_ids)
            if (!promised(tangential, cohesion, rolling, surface))
              add(Utils::generate_gran_hashcode(Model, tangential, cohesion, rolling, surface),
                  &refuse<PairStyles::IGranularPairStyle, PairGran>,
                  &refuse<Walls::IGranularWall, FixWallGran>);
    with_tangential<TANGENTIAL_OFF>();
    with_tangential<TANGENTIAL_NO_HISTORY>();
    with_tangential<TANGENTIAL_HISTORY>();
  }

 private:
  typedef PairStyles::IGranularPairStyle* (*PairCreator)(LAMMPS_NS::LAMMPS*, PairGran*, int64_t);
  typedef Walls::IGranularWall* (*WallCreator)(LAMMPS_NS::LAMMPS*, FixWallGran*, int64_t);

  static bool promised(int tangential, int cohesion, int rolling, int surface) {
    return (tangential == TANGENTIAL_OFF || tangential == TANGENTIAL_NO_HISTORY ||
            tangential == TANGENTIAL_HISTORY) &&
           cohesion == COHESION_OFF &&
           (rolling == ROLLING_OFF || rolling == ROLLING_CDT || rolling == ROLLING_EPSD2) &&
           surface == SURFACE_DEFAULT;
  }

  static void add(int64_t hash, PairCreator pair, WallCreator wall) {
    PairStyles::Factory::instance().addStyle("gran", hash, pair);
    Walls::Factory::instance().addStyle("gran", hash, wall);
  }

  template <int Tangential>
  static void with_tangential() {
    with_rolling<Tangential, ROLLING_OFF>();
    with_rolling<Tangential, ROLLING_CDT>();
    with_rolling<Tangential, ROLLING_EPSD2>();
  }

  template <int Tangential, int Rolling>
  static void with_rolling() {
    typedef GranStyle<Model, Tangential, COHESION_OFF, Rolling, SURFACE_DEFAULT> Style;
    typedef AccountedContact<Style> Contact;
    add(Style::HASHCODE,
        &create<PairStyles::Granular<Contact>, PairStyles::IGranularPairStyle, PairGran>,
        &create<Walls::Granular<Contact>, Walls::IGranularWall, FixWallGran>);
  }
};

}  // namespace plastigran
