// SPDX-License-Identifier: GPL-2.0-or-later
//
// Brake 2015 (Int. J. Solids Struct. 62:104): hyperbolic secants blend the Hertz force into the
// force of a plastic indentation with Meyer index n. The equations are those of Ghaednia et al.
// 2015 (Int. J. Impact Eng. 86:307), eqs 28-31, corrected as in docs/laws/brake_2015.md. Yield
// begins at the contact pressure p_y. In yield units, x = overlap/overlap_y and f = F/F_y:
//
//   overlap_y = R* (pi p_y/(2 E*))^2,  overlap_p = R* (3 pi P0/(2 E*))^2
//   x_p = overlap_p/overlap_y
//   s = (x - 1)/(x_p - 1)
//   f = sech((n-1) s) x^1.5 + (1 - sech((3-n) s)) x_p^(1/2) x (x/x_p)^((n-2)/2)
//   overlap_res = overlap_max (1 - f/x^1.5), not below 0;   a^2 = R* overlap (2 - sech((n-1) s))
//
// P0 is the indentation pressure (hardness), n = 2 is perfect plasticity. Force and slope are
// continuous. The source gives no contact radius. In this law, a^2 changes from R* overlap (Hertz)
// to 2 R* overlap (plastic indentation), blended like the force. n is at most 2.7, because the
// force of a larger n would decrease with overlap.
#pragma once

#include "plastigran/shared/indentation_pressure.h"
#include "plastigran/tables/power_unloading.h"

namespace plastigran {

struct Brake2015Curve {
  static constexpr const char* name = "brake_2015";
  static constexpr const char* source = "Brake 2015, Int. J. Solids Struct. 62:104";
  static constexpr const char* range =
      "small strain; as accurate as the given indentation pressure";
  static constexpr bool self_similar = true;
  struct Parameters {
    double indentation_pressure = 0;  // P0 [Pa]
    double meyer_index = 2;           // n [-]
  };
  static constexpr std::array<Parameter<Parameters>, 2> parameters{{
      indentation_pressure_parameter(&Parameters::indentation_pressure),
      {"meyer_index", "-", &Parameters::meyer_index, 2, 2.7,
       "Meyer index of hardening; 2: perfectly plastic"},
  }};

  // Returns whether yield occurs before full plasticity.
  static bool admissible(const MaterialPair& pair, const Parameters& constants) {
    return Brake2015Curve(pair, constants).plastic > 1;
  }
  static constexpr const char* admissibility =
      "{indentation_pressure} must be more than a third of the yield pressure of the weaker body";

  std::array<double, 2> breaks;  // yield, and the end of the transition
  double yield_radius_ratio;
  double meyer;    // Meyer index n
  double plastic;  // x_p, start of full plasticity

  Brake2015Curve(const MaterialPair& pair, const Parameters& constants)
      : yield_radius_ratio(plastigran::yield_radius_ratio(pair)), meyer(constants.meyer_index) {
    const double root =
        3 * indentation_pressure(pair, constants.indentation_pressure) / pair.yield_pressure;
    plastic = root * root;
    breaks = {1, plastic};
  }

  PLASTIGRAN_DEVICE double elastic_share(double x) const {
    return 1 / std::cosh((meyer - 1) * (x - 1) / (plastic - 1));
  }
  PLASTIGRAN_DEVICE double force(double x) const {
    const double s = (x - 1) / (plastic - 1);
    return elastic_share(x) * x * std::sqrt(x) + (1 - 1 / std::cosh((3 - meyer) * s)) *
                                                     std::sqrt(plastic) * x *
                                                     std::pow(x / plastic, 0.5 * meyer - 1);
  }
  PLASTIGRAN_DEVICE double recovery(double x) const { return std::min(x, force(x) / std::sqrt(x)); }
  PLASTIGRAN_DEVICE double contact_radius(double x) const {
    return std::sqrt(x * (2 - elastic_share(x)));
  }
};

using Brake2015 = PowerUnloading<Brake2015Curve>;

}  // namespace plastigran
