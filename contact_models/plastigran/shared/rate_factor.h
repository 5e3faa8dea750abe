// SPDX-License-Identifier: GPL-2.0-or-later
//
// A yield strength that grows with the rate of strain (Johnson & Cook 1983, 7th Int. Symp.
// Ballistics: 541), without heat:
//
//   factor = 1 + C ln(rate/reference_rate) above the reference rate, 1 up to it
//
// One rate stands for a whole impact: closing speed at first touch over radius, v/R. The mean
// strain of an indentation is 0.2 a/R (Tabor, The Hardness of Metals, 1951), and it takes a time of
// about a^2/(2 R v): its rate 0.4 v/a is v/R at a = 0.4 R, ten times that at a = 0.04 R, which
// moves the factor by 2.3 C. R is the sphere of the yielding body's material on a rigid plane that
// has the pair's Hertzian force and contact radius (shared/fitted_sphere.h), v its share of the
// speed: R = R* E'/E*, v = speed E*/E'. Of two equal spheres that is each one's own.
#pragma once

#include <cmath>
#include <string_view>

#include "plastigran/shared/contact.h"
#include "plastigran/shared/fitted_sphere.h"

namespace plastigran {

// Factors are rounded to multiples of this.
constexpr double rate_factor_step = 1e-4;

// v/R of an impact [1/s]; `speed` is that at which the two bodies close in [m/s].
inline double impact_rate(const MaterialPair& pair, double radius_eff, double speed) {
  const double ratio = FittedSphere(pair, of_yielding_body).radius_ratio;
  return speed / (radius_eff * ratio * ratio);
}

// What an impact multiplies the yield strength of its weaker body by.
inline double rate_factor(const MaterialPair& pair, double radius_eff, double speed) {
  if (!(pair.rate_coefficient > 0)) return 1;
  const double ratio = impact_rate(pair, radius_eff, speed) / pair.reference_rate;
  if (!(ratio > 1)) return 1;
  return 1 +
         rate_factor_step * std::round(pair.rate_coefficient * std::log(ratio) / rate_factor_step);
}

// The pair with its strength at a rate factor, which does not depend on the rate any more.
inline MaterialPair strengthened(MaterialPair pair, double factor) {
  pair.yield_strength *= factor;
  pair.yield_pressure *= factor;
  pair.rate_coefficient = 0;
  return pair;
}

// A law's constants for that pair: those in Pa are pressures of plastic flow.
template <class Law>
typename Law::Parameters strengthened_constants(typename Law::Parameters constants, double factor) {
  for (const auto& parameter : parameters_of<Law>)
    if (std::string_view(parameter.unit) == "Pa") constants.*parameter.value *= factor;
  return constants;
}

}  // namespace plastigran
