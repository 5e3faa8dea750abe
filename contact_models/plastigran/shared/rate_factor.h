// SPDX-License-Identifier: GPL-2.0-or-later
//
// Yield strength that increases with the strain rate (Johnson & Cook 1983, 7th Int. Symp.
// Ballistics: 541), without temperature:
//
//   factor = 1 + C ln(rate/reference_rate) above the reference rate, otherwise 1
//
// One strain rate represents a whole impact: the closing speed v at first touch divided by the
// radius R. Reason: the mean strain of an indentation is 0.2 a/R (Tabor, The Hardness of Metals,
// 1951) and develops in a time of about a^2/(2 R v). The strain rate is thus 0.4 v/a, which equals
// v/R at a = 0.4 R. At a = 0.04 R the strain rate is ten times larger, which changes the factor by
// 2.3 C. R and v belong to the fitted sphere (shared/fitted_sphere.h): R = R* E'/E*, v = speed
// E*/E'. For two equal spheres, R is their radius and v is half of their closing speed.
#pragma once

#include <cmath>
#include <string_view>

#include "plastigran/shared/contact.h"
#include "plastigran/shared/fitted_sphere.h"

namespace plastigran {

// Rate factors are rounded to multiples of this step.
constexpr double rate_factor_step = 1e-4;

// Returns v/R of an impact [1/s]; `speed` is the closing speed of the two bodies [m/s].
inline double impact_rate(const MaterialPair& pair, double radius_eff, double speed) {
  const double ratio = FittedSphere(pair, of_yielding_body).radius_ratio;
  return speed / (radius_eff * ratio * ratio);
}

// Returns the factor by which the strain rate of an impact increases the yield strength of the
// weaker body.
inline double rate_factor(const MaterialPair& pair, double radius_eff, double speed) {
  if (!(pair.rate_coefficient > 0)) return 1;
  const double ratio = impact_rate(pair, radius_eff, speed) / pair.reference_rate;
  if (!(ratio > 1)) return 1;
  return 1 +
         rate_factor_step * std::round(pair.rate_coefficient * std::log(ratio) / rate_factor_step);
}

// Returns the pair with its yield strength and yield pressure multiplied by a rate factor. The
// returned pair does not depend on the strain rate.
inline MaterialPair strengthened(MaterialPair pair, double factor) {
  pair.yield_strength *= factor;
  pair.yield_pressure *= factor;
  pair.rate_coefficient = 0;
  return pair;
}

// Returns the constants of a law for a yield strength multiplied by `factor`. Constants in Pa are
// pressures of plastic flow, so they are multiplied, too.
template <class Law>
typename Law::Parameters strengthened_constants(typename Law::Parameters constants, double factor) {
  for (const auto& parameter : parameters_of<Law>)
    if (std::string_view(parameter.unit) == "Pa") constants.*parameter.value *= factor;
  return constants;
}

}  // namespace plastigran
