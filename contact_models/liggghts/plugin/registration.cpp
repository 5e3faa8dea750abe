// SPDX-License-Identifier: GPL-2.0-or-later
//
// Registers every law in LIGGGHTS' factories when the program is loaded: its name, the compiled
// combinations with other models, and for all other combinations a function that stops with an
// error. (Otherwise LIGGGHTS would use its generic class, which has only LIGGGHTS' own models.) The
// first deck line with a law registers the styles of the observers.
#include <algorithm>
#include <iterator>
#include <set>
#include <string>

#include "liggghts/heat/dissipation_heat.h"
#include "liggghts/model/companions.h"
#include "liggghts/model/contact_setup.h"
#include "liggghts/plugin/any_model.h"
#include "liggghts/plugin/history_fixes.h"
#include "liggghts/plugin/registered.h"
#include "liggghts/spectra/collision_spectra.h"
#include "liggghts/tangential/tangential_model.h"

namespace plastigran {

using namespace LIGGGHTS;
using namespace LIGGGHTS::ContactModels;

#define LAW(name) extern const RegisteredLaw law_##name;
#define COMBINATION(number) extern const RegisteredCombination combination_##number;
#include "registered.inc"
#undef LAW
#undef COMBINATION
extern const RegisteredLaw host_hertz;

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

// Members of RegisteredCombination in the order of companion_kinds().
int RegisteredCombination::*const places[] = {
    &RegisteredCombination::tangential, &RegisteredCombination::cohesion,
    &RegisteredCombination::rolling, &RegisteredCombination::surface};

const RegisteredLaw& law_of(int64_t hash) {
  const int id = model_of(hash, 0);
  if (id == host_hertz.id) return host_hertz;
  return **std::find_if(std::begin(laws), std::end(laws),
                        [id](const RegisteredLaw* law) { return law->id == id; });
}

// Returns whether a combination was compiled for `model` as its model of the kind `place`, or for
// any model of this kind.
bool has(const RegisteredCombination& combination, int RegisteredCombination::*place, int model) {
  return combination.*place == model || combination.*place == ANY;
}

// Returns the compiled combination that fits these models and has the fewest placeholders ANY; null
// if there is none.
const RegisteredCombination* find(const RegisteredCombination& models) {
  const RegisteredCombination* best = nullptr;
  int most = -1;
  for (const RegisteredCombination* const combination : combinations) {
    int named = 0;
    bool fits = true;
    for (const auto place : places) {
      named += combination->*place == models.*place;
      fits = fits && has(*combination, place, models.*place);
    }
    if (fits && named > most) best = combination, most = named;
  }
  return best;
}

// Returns the error message that names the models that have no compiled combination with the law,
// and the models that are possible instead.
std::string describe_refusal(int64_t hash) {
  std::string text = std::string("model ") + law_of(hash).name + ':';
  for (std::size_t k = 0; k < std::size(places); ++k) {
    const CompanionKind& kind = companion_kinds()[k];
    std::string refused, others;
    for (const Companion& companion : kind.models)
      if (std::any_of(std::begin(combinations), std::end(combinations),
                      [&](const auto* entry) { return has(*entry, places[k], companion.id); }))
        others += std::string(" ") + companion.name;
      else if (companion.id == model_of(hash, k + 1))
        refused = companion.name;
    if (!refused.empty())
      text += std::string(" ") + kind.keyword + ' ' + refused +
              " is not available with this model; possible:" + others;
  }
  return text;
}

template <class Interface, class Parent>
Interface* refuse(LAMMPS_NS::LAMMPS* engine, Parent*, int64_t hash) {
  stop(engine, describe_refusal(hash));
}

void add(const RegisteredLaw& law, const RegisteredCombination& models) {
  const int64_t hash = Utils::generate_gran_hashcode(law.id, models.tangential, models.cohesion,
                                                     models.rolling, models.surface);
  const RegisteredCombination* const combination = find(models);
  // LIGGGHTS' table of styles has 32-bit keys, so several numbers of rings share one key. A key
  // that is added twice would give a warning.
  std::set<int> keys;
  for (int rings = least_rings; rings <= most_rings; ++rings)
    if (rings == default_rings || models.tangential == TANGENTIAL_PARTIAL_SLIP)
      for (const int64_t variant : {hash, hash | with_adhesion})
        keys.insert(static_cast<int>(variant | hash_of_rings(rings)));
  for (const int key : keys) {
    PairStyles::Factory::instance().addStyle(
        "gran", key,
        combination ? combination->pair : refuse<PairStyles::IGranularPairStyle, PairGran>);
    Walls::Factory::instance().addStyle(
        "gran", key, combination ? combination->wall : refuse<Walls::IGranularWall, FixWallGran>);
  }
}

// Registers a law with all combinations of other models, or only with those that contain a
// tangential law of this plugin.
void add_combinations(const RegisteredLaw& law, bool only_tangential_laws) {
  const auto& kinds = companion_kinds();
  for (const Companion& tangential : kinds[0].models) {
    if (only_tangential_laws && !is_tangential_law(tangential.id)) continue;
    for (const Companion& cohesion : kinds[1].models)
      for (const Companion& rolling : kinds[2].models)
        for (const Companion& surface : kinds[3].models)
          add(law, {tangential.id, cohesion.id, rolling.id, surface.id, nullptr, nullptr});
  }
}

const bool registered = [] {
  ContactModels::Factory& factory = ContactModels::Factory::instance();
  factory.addTangentialModel(Incremental::name, TANGENTIAL_INCREMENTAL);
  factory.addTangentialModel(PartialSlip<4>::name, TANGENTIAL_PARTIAL_SLIP);
  for (const RegisteredLaw* law : laws) {
    factory.addNormalModel(law->name, law->id);
    add_combinations(*law, false);
  }
  add_combinations(host_hertz, true);
  return true;
}();

}  // namespace

template <>
RegisteredLaw::Model make_model(LAMMPS_NS::LAMMPS* engine, ContactSetup& setup,
                                ContactModelBase* contact_model) {
  replace_history_fixes(engine);
  add_style<DissipationHeat>(engine->modify);
  add_style<CollisionSpectra>(engine->modify);
  return law_of(setup.hash()).make(engine, setup, contact_model);
}

RegisteredLaw::Model make_adhesive_model(LAMMPS_NS::LAMMPS* engine, ContactSetup& setup,
                                         ContactModelBase* contact_model,
                                         const std::string& settings) {
  return law_of(setup.hash()).make_adhesive(engine, setup, contact_model, settings);
}

}  // namespace plastigran
