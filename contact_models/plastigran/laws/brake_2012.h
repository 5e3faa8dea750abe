// SPDX-License-Identifier: GPL-2.0-or-later
//
// Brake 2012 (Int. J. Solids Struct. 49:3129): Hertz until yield, then a cubic, then full
// plasticity at the indentation pressure P0. The cubic continues the adjacent curves without a jump
// in value or slope. Full plasticity begins at x_p, where the contact radius is a_p. In yield
// units, x = overlap/overlap_y and f = F/F_y:
//
//   overlap_y = R* (pi p_y/(2 E*))^2,  a_p = 3 pi P0 R*/(4E*),  alpha = a_p/a_y,  x_p = alpha^2
//   f = alpha (2x - alpha^2),  a^2 = (2x - alpha^2) a_y^2          x >= x_p
//   overlap_max - overlap_res = 3 F_max/(4 E* a_max)
//
// Three conditions determine the constants (derivation: docs/laws/brake_2012.md). Full plasticity
// begins where the mean pressure of the Hertz contact is P0. In full plasticity, the contact area
// grows like the section of the undeformed sphere by the plane of contact. Unloading follows Hertz'
// law and starts with the contact radius a_max at the largest overlap. These conditions are
// assumptions of this package.
//
// Near yield, the rebound speed would be up to 5 % higher than the impact speed; the energy guard
// prevents this. Range: the law is as accurate as the given P0, which must be above 2/3 p_y.
#pragma once

#include "plastigran/shared/indentation_pressure.h"
#include "plastigran/tables/power_unloading.h"

namespace plastigran {

struct Brake2012Curve {
  static constexpr const char* name = "brake_2012";
  static constexpr const char* source = "Brake 2012, Int. J. Solids Struct. 49:3129";
  static constexpr const char* range =
      "small strain; indentation pressure above 2/3 of the yield pressure";
  static constexpr bool self_similar = true;
  struct Parameters {
    double indentation_pressure = 0;  // P0 [Pa]
  };
  static constexpr std::array<Parameter<Parameters>, 1> parameters{{
      indentation_pressure_parameter(&Parameters::indentation_pressure),
  }};

  // Returns whether yield occurs before full plasticity.
  static bool admissible(const MaterialPair& pair, const Parameters& constants) {
    return Brake2012Curve(pair, constants).alpha > 1;
  }
  static constexpr const char* admissibility =
      "{indentation_pressure} must be more than two thirds of the yield pressure of the weaker "
      "body";

  double yield_radius_ratio;
  double alpha;
  std::array<double, 2> breaks;

  Brake2012Curve(const MaterialPair& pair, const Parameters& constants)
      : yield_radius_ratio(plastigran::yield_radius_ratio(pair)),
        alpha(1.5 * plastigran::indentation_pressure(pair, constants.indentation_pressure) /
              pair.yield_pressure),
        breaks{1, alpha * alpha} {}

  // Returns the value at x of the cubic that passes through (1, value) with the slope `slope`, and
  // through (x_p, value_p) with the slope `slope_p`.
  PLASTIGRAN_DEVICE double between(double x, double value, double slope, double value_p,
                                   double slope_p) const {
    const double length = breaks[1] - 1, t = (x - 1) / length, back = 1 - t;
    return back * back * ((1 + 2 * t) * value + t * length * slope) +
           t * t * ((3 - 2 * t) * value_p - back * length * slope_p);
  }
  PLASTIGRAN_DEVICE double force(double x) const {
    if (x >= breaks[1]) return alpha * (2 * x - alpha * alpha);
    return between(x, 1, 1.5, alpha * alpha * alpha, 2 * alpha);
  }
  PLASTIGRAN_DEVICE double contact_radius(double x) const {
    if (x >= breaks[1]) return std::sqrt(2 * x - alpha * alpha);
    return between(x, 1, 0.5, alpha, 1 / alpha);
  }
  PLASTIGRAN_DEVICE double recovery(double x) const {
    return std::min(x, force(x) / contact_radius(x));
  }
};

using Brake2012 = PowerUnloading<Brake2012Curve>;

}  // namespace plastigran
