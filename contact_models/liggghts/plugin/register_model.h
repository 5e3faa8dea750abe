// SPDX-License-Identifier: GPL-2.0-or-later
//
// Puts one normal model into the engine's factories: its name, a compiled class for every
// combination with the tangential and rolling models we promise, and for every other combination
// a creator that says so. (An unregistered combination would reach the engine's generic class,
// which knows nothing of models that came with a plugin.)
#pragma once

#include <algorithm>
#include <array>
#include <string>
#include <vector>

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

// A model to combine with, as a deck names it.
struct Companion {
  int id;
  const char* name;
};

// The four places of a combination beside the normal model, in the order of the engine's hash: what
// a deck calls it, the models of the engine's headers, and which of them we promise.
struct Place {
  const char* keyword;
  std::vector<Companion> models;
  std::vector<int> promised;

  bool promises(int id) const {
    return std::find(promised.begin(), promised.end(), id) != promised.end();
  }
};

inline const std::array<Place, 4> places{{
    {"tangential",
     {
         {TANGENTIAL_OFF, "off"},
#define TANGENTIAL_MODEL(identifier, name, id) {identifier, #name},
#include "style_tangential_model.h"
#undef TANGENTIAL_MODEL
     },
     {TANGENTIAL_OFF, TANGENTIAL_NO_HISTORY, TANGENTIAL_HISTORY}},
    {"cohesion",
     {
         {COHESION_OFF, "off"},
#define COHESION_MODEL(identifier, name, id) {identifier, #name},
#include "style_cohesion_model.h"
#undef COHESION_MODEL
     },
     {COHESION_OFF}},
    {"rolling_friction",
     {
         {ROLLING_OFF, "off"},
#define ROLLING_MODEL(identifier, name, id) {identifier, #name},
#include "style_rolling_model.h"
#undef ROLLING_MODEL
     },
     {ROLLING_OFF, ROLLING_CDT, ROLLING_EPSD2}},
    {"surface",
     {
#define SURFACE_MODEL(identifier, name, id) {identifier, #name},
#include "style_surface_model.h"
#undef SURFACE_MODEL
     },
     {SURFACE_DEFAULT}},
}};

// What a deck asks of a place by the engine's hash.
inline int asked(int64_t hash, std::size_t place) { return hash >> 6 * (place + 1) & 63; }

// The words of a combination that are not promised, with those that are.
inline std::string describe_refusal(const std::string& model, int64_t hash) {
  std::string text;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Place& place = places[k];
    if (place.promises(asked(hash, k))) continue;
    std::string refused, possible;
    for (const Companion& companion : place.models) {
      if (companion.id == asked(hash, k)) refused = companion.name;
      if (place.promises(companion.id)) possible += std::string(" ") + companion.name;
    }
    text += (text.empty() ? "model " + model + ": " : "; ") + place.keyword + ' ' + refused +
            " is not available with this model; possible:" + possible;
  }
  return text;
}

template <class Style, class Interface, class Parent>
Interface* create(LAMMPS_NS::LAMMPS* lmp, Parent* parent, int64_t hash) {
  require_version(lmp);
  return new Style(lmp, parent, hash);
}

template <int Model>
class RegisterModel {
 public:
  explicit RegisterModel(const char* name) {
    name_ = name;
    ContactModels::Factory::instance().addNormalModel(name, Model);
    for (const Companion& tangential : places[0].models)
      for (const Companion& cohesion : places[1].models)
        for (const Companion& rolling : places[2].models)
          for (const Companion& surface : places[3].models) {
            const int64_t hash = Utils::generate_gran_hashcode(Model, tangential.id, cohesion.id,
                                                               rolling.id, surface.id);
            if (!promised(hash))
              add(hash, &refuse<PairStyles::IGranularPairStyle, PairGran>,
                  &refuse<Walls::IGranularWall, FixWallGran>);
          }
    with_tangential<TANGENTIAL_OFF>();
    with_tangential<TANGENTIAL_NO_HISTORY>();
    with_tangential<TANGENTIAL_HISTORY>();
  }

 private:
  typedef PairStyles::IGranularPairStyle* (*PairCreator)(LAMMPS_NS::LAMMPS*, PairGran*, int64_t);
  typedef Walls::IGranularWall* (*WallCreator)(LAMMPS_NS::LAMMPS*, FixWallGran*, int64_t);

  static bool promised(int64_t hash) {
    for (std::size_t k = 0; k < places.size(); ++k)
      if (!places[k].promises(asked(hash, k))) return false;
    return true;
  }

  template <class Interface, class Parent>
  static Interface* refuse(LAMMPS_NS::LAMMPS* lmp, Parent*, int64_t hash) {
    lmp->error->all(FLERR, describe_refusal(name_, hash).c_str());
    return nullptr;
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

  inline static const char* name_ = nullptr;
};

}  // namespace plastigran
