// SPDX-License-Identifier: GPL-2.0-or-later
//
// Puts every law into the engine's factories when the plugin is loaded: its name, each combination
// with other models that is compiled in, and for every other combination a creator that says so.
// (An unregistered combination would reach the engine's generic class, which knows nothing of
// models that came with a plugin.)
#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "liggghts/model/contact_setup.h"
#include "liggghts/plugin/any_law.h"
#include "liggghts/plugin/registered.h"
#include "universe.h"

namespace plastigran {

using namespace LIGGGHTS;
using namespace LIGGGHTS::ContactModels;

#define LAW(name) extern const RegisteredLaw law_##name;
#define COMBINATION(number) extern const RegisteredCombination combination_##number;
#include "registered.inc"
#undef LAW
#undef COMBINATION

namespace {

#define LAW(name) &law_##name,
#define COMBINATION(number)
const RegisteredLaw* const laws[] = {
#include "registered.inc"
};
#undef LAW
#undef COMBINATION

#define LAW(name)
#define COMBINATION(number) &combination_##number,
const RegisteredCombination* const combinations[] = {
#include "registered.inc"
};
#undef LAW
#undef COMBINATION

// A model to combine with, as a deck names it.
struct Companion {
  int id;
  const char* name;
};

// The four places of a combination beside the normal model, in the order of the engine's hash: what
// a deck calls it, and the models of the engine's headers.
struct Place {
  const char* keyword;
  int RegisteredCombination::*id;
  std::vector<Companion> models;
};

const std::array<Place, 4> places{{
    {"tangential",
     &RegisteredCombination::tangential,
     {
         {TANGENTIAL_OFF, "off"},
#define TANGENTIAL_MODEL(identifier, name, id) {identifier, #name},
#include "style_tangential_model.h"
#undef TANGENTIAL_MODEL
     }},
    {"cohesion",
     &RegisteredCombination::cohesion,
     {
         {COHESION_OFF, "off"},
#define COHESION_MODEL(identifier, name, id) {identifier, #name},
#include "style_cohesion_model.h"
#undef COHESION_MODEL
     }},
    {"rolling_friction",
     &RegisteredCombination::rolling,
     {
         {ROLLING_OFF, "off"},
#define ROLLING_MODEL(identifier, name, id) {identifier, #name},
#include "style_rolling_model.h"
#undef ROLLING_MODEL
     }},
    {"surface",
     &RegisteredCombination::surface,
     {
#define SURFACE_MODEL(identifier, name, id) {identifier, #name},
#include "style_surface_model.h"
#undef SURFACE_MODEL
     }},
}};

// What a deck asks of a place by the engine's hash; place 0 is the normal model.
int asked(int64_t hash, std::size_t place) { return hash >> 6 * place & 63; }

const RegisteredLaw& law_of(int64_t hash) {
  return **std::find_if(std::begin(laws), std::end(laws),
                        [hash](const RegisteredLaw* law) { return law->id == asked(hash, 0); });
}

// Whether any combination has that model in that place.
bool possible(const Place& place, int id) {
  return std::any_of(std::begin(combinations), std::end(combinations),
                     [&](const RegisteredCombination* each) { return each->*place.id == id; });
}

// The words of a combination that no other has in their place, with those that are possible.
std::string describe_refusal(int64_t hash) {
  std::string text;
  for (std::size_t k = 0; k < places.size(); ++k) {
    const Place& place = places[k];
    if (possible(place, asked(hash, k + 1))) continue;
    std::string refused, others;
    for (const Companion& companion : place.models) {
      if (companion.id == asked(hash, k + 1)) refused = companion.name;
      if (possible(place, companion.id)) others += std::string(" ") + companion.name;
    }
    text += (text.empty() ? std::string("model ") + law_of(hash).name + ": " : "; ") +
            place.keyword + ' ' + refused + " is not available with this model; possible:" + others;
  }
  if (text.empty())
    text = std::string("model ") + law_of(hash).name +
           ": these tangential, cohesion, rolling and surface models are not available together";
  return text;
}

template <class Interface, class Parent>
Interface* refuse(LAMMPS_NS::LAMMPS* engine, Parent*, int64_t hash) {
  engine->error->all(FLERR, describe_refusal(hash).c_str());
  return nullptr;
}

void add(const RegisteredLaw& law, const RegisteredCombination& combination) {
  const int64_t hash =
      Utils::generate_gran_hashcode(law.id, combination.tangential, combination.cohesion,
                                    combination.rolling, combination.surface);
  PairStyles::Factory::instance().addStyle("gran", hash, combination.pair);
  Walls::Factory::instance().addStyle("gran", hash, combination.wall);
}

void add_all(const RegisteredLaw& law) {
  ContactModels::Factory::instance().addNormalModel(law.name, law.id);
  for (const Companion& tangential : places[0].models)
    for (const Companion& cohesion : places[1].models)
      for (const Companion& rolling : places[2].models)
        for (const Companion& surface : places[3].models) {
          RegisteredCombination asked{tangential.id,
                                      cohesion.id,
                                      rolling.id,
                                      surface.id,
                                      refuse<PairStyles::IGranularPairStyle, PairGran>,
                                      refuse<Walls::IGranularWall, FixWallGran>};
          for (const RegisteredCombination* each : combinations)
            if (std::all_of(places.begin(), places.end(),
                            [&](const Place& place) { return asked.*place.id == each->*place.id; }))
              asked = *each;
          add(law, asked);
        }
}

const bool registered = [] {
  for (const RegisteredLaw* law : laws) add_all(*law);
  return true;
}();

}  // namespace

RegisteredLaw::Model make_normal_model(LAMMPS_NS::LAMMPS* engine, IContactHistorySetup* setup,
                                       ContactModelBase* contact_model) {
  const int64_t hash = static_cast<ContactSetup*>(setup)->hash();
  return law_of(hash).make(engine, setup, contact_model);
}

void require_version(LAMMPS_NS::LAMMPS* engine) {
  if (std::string(engine->universe->version).find(PLASTIGRAN_ENGINE_VERSION) != std::string::npos)
    return;
  const std::string text = std::string("Plastigran was compiled for ") + PLASTIGRAN_ENGINE_VERSION +
                           " but this engine is " + engine->universe->version +
                           "; compile Plastigran against this engine's headers";
  engine->error->all(FLERR, text.c_str());
}

}  // namespace plastigran
