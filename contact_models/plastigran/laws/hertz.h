// SPDX-License-Identifier: GPL-2.0-or-later
//
// Hertz 1881 (J. reine angew. Math. 92:156): frictionless elastic contact, the limit of most
// yielding laws for an infinite yield strength.
//
//   F = 4/3 E* sqrt(R*) overlap^(3/2),   a = sqrt(R* overlap),   energy 2/5 F overlap
//
// Range: a << R*; contact time much longer than the period of the slowest vibration of the bodies.
#pragma once

#include "plastigran/shared/contact.h"
#include "plastigran/shared/hertz_contact.h"

namespace plastigran {

class Hertz : public NoConstants {
 public:
  static constexpr const char* name = "hertz";
  static constexpr const char* source = "Hertz 1881, J. reine angew. Math. 92:156";
  static constexpr const char* range = "elastic contact, a << R*";
  static constexpr bool yields = false;
  struct State {};
  static constexpr std::array<const char*, 0> state_names{};

  explicit Hertz(const MaterialPair& pair, const Parameters&)
      : modulus_(4.0 / 3.0 * pair.youngs_modulus_eff) {}

  PLASTIGRAN_DEVICE Response respond(double radius_eff, double overlap, State&) const {
    if (!(overlap > 0)) return {};
    return hertz_response(modulus_, radius_eff, overlap);
  }

 private:
  double modulus_;  // 4/3 E* [Pa]
};

}  // namespace plastigran
