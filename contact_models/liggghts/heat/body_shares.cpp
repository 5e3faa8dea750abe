// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/heat/body_shares.h"

#include <sstream>

#include "atom.h"
#include "lammps.h"
#include "liggghts/model/deck_properties.h"

namespace plastigran {

void BodyShares::read(LAMMPS_NS::LAMMPS* engine, const std::string& caller) {
  const int type_count = engine->atom->ntypes;
  const DeckProperties deck(engine, caller, type_count);
  yield_pressures_.clear();
  factors_.clear();
  const std::vector<Body> bodies = deck.bodies(deck.given("yield_strength"));
  deck.check(validate(bodies));
  for (const Body& body : bodies) yield_pressures_.push_back(yield_pressure(body));
  given_ = deck.given("taylor_quinney_factor");
  for (int type = 1; type <= type_count; ++type) {
    const double factor = deck.per_type("taylor_quinney_factor", type, "", 0.9);
    if (!(factor >= 0 && factor <= 1)) {
      std::ostringstream reason;
      reason << "taylorQuinneyFactor is " << factor << "; it must be between 0 and 1";
      deck.fail(about_types(reason.str(), type));
    }
    factors_.push_back(factor);
  }
  misspellings_ = deck.misspellings();
}

std::string BodyShares::describe(const std::string& caller) const {
  std::ostringstream text;
  for (std::size_t k = 0; k < factors_.size(); ++k)
    text << caller << ", atom type " << k + 1 << ": taylorQuinneyFactor " << factors_[k]
         << (given_ ? "\n" : " (default)\n");
  return text.str();
}

}  // namespace plastigran
