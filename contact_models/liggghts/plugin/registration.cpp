// SPDX-License-Identifier: GPL-2.0-or-later
//
// Puts every law into the engine's factories when the program is loaded: its name, each combination
// with other models that can be had, and for every other combination a creator that says so.
// (An unregistered combination would reach the engine's generic class, which knows nothing of
// models that came with a plugin.) A deck's first line of a law makes the observers' styles known.
#include <algorithm>
#include <iterator>
#include <string>

#include "liggghts/heat/dissipation_heat.h"
#include "liggghts/model/companions.h"
#include "liggghts/model/contact_setup.h"
#include "liggghts/plugin/any_model.h"
#include "liggghts/plugin/foreign_histories.h"
#include "liggghts/plugin/registered.h"
#include "liggghts/spectra/collision_spectra.h"

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

// The places of a combination beside the normal model, in the order of companion_kinds().
int RegisteredCombination::*const places[] = {
    &RegisteredCombination::tangential, &RegisteredCombination::cohesion,
    &RegisteredCombination::rolling, &RegisteredCombination::surface};

const RegisteredLaw& law_of(int64_t hash) {
  return **std::find_if(std::begin(laws), std::end(laws),
                        [hash](const RegisteredLaw* law) { return law->id == model_of(hash, 0); });
}

// The combination compiled for these models: the one that has most of them by name.
const RegisteredCombination* find(const RegisteredCombination& asked) {
  const RegisteredCombination* found = nullptr;
  int most = -1;
  for (const RegisteredCombination* each : combinations) {
    int named = 0;
    const bool fits = std::all_of(std::begin(places), std::end(places), [&](auto place) {
      named += each->*place == asked.*place;
      return each->*place == asked.*place || each->*place == ANY;
    });
    if (fits && named > most) found = each, most = named;
  }
  return found;
}

// The words of a combination that none has in their place, with those that are possible.
std::string describe_refusal(int64_t hash) {
  std::string text = std::string("model ") + law_of(hash).name + ':';
  for (std::size_t k = 0; k < std::size(places); ++k) {
    const CompanionKind& kind = companion_kinds()[k];
    std::string refused, others;
    for (const Companion& companion : kind.models) {
      const bool possible = std::any_of(
          std::begin(combinations), std::end(combinations), [&](const RegisteredCombination* each) {
            return each->*places[k] == companion.id || each->*places[k] == ANY;
          });
      if (possible)
        others += std::string(" ") + companion.name;
      else if (companion.id == model_of(hash, k + 1))
        refused = companion.name;
    }
    if (!refused.empty())
      text += std::string(" ") + kind.keyword + ' ' + refused +
              " is not available with this model; possible:" + others;
  }
  return text;
}

template <class Interface, class Parent>
Interface* refuse(LAMMPS_NS::LAMMPS* engine, Parent*, int64_t hash) {
  engine->error->all(FLERR, describe_refusal(hash).c_str());
  return nullptr;
}

void add(const RegisteredLaw& law, const RegisteredCombination& asked) {
  const int64_t hash = Utils::generate_gran_hashcode(law.id, asked.tangential, asked.cohesion,
                                                     asked.rolling, asked.surface);
  const RegisteredCombination* const found = find(asked);
  PairStyles::Factory::instance().addStyle(
      "gran", hash, found ? found->pair : refuse<PairStyles::IGranularPairStyle, PairGran>);
  Walls::Factory::instance().addStyle(
      "gran", hash, found ? found->wall : refuse<Walls::IGranularWall, FixWallGran>);
}

void add_all(const RegisteredLaw& law) {
  ContactModels::Factory::instance().addNormalModel(law.name, law.id);
  const auto& kinds = companion_kinds();
  for (const Companion& tangential : kinds[0].models)
    for (const Companion& cohesion : kinds[1].models)
      for (const Companion& rolling : kinds[2].models)
        for (const Companion& surface : kinds[3].models)
          add(law, {tangential.id, cohesion.id, rolling.id, surface.id, nullptr, nullptr});
}

const bool registered = [] {
  for (const RegisteredLaw* law : laws) add_all(*law);
  return true;
}();

}  // namespace

template <>
RegisteredLaw::Model make_model(LAMMPS_NS::LAMMPS* engine, ContactSetup& setup,
                                ContactModelBase* contact_model) {
  discard_foreign_histories(engine);
  add_style<DissipationHeat>(engine->modify);
  add_style<CollisionSpectra>(engine->modify);
  return law_of(setup.hash()).make(engine, setup, contact_model);
}

}  // namespace plastigran
