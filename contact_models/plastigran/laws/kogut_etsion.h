// SPDX-License-Identifier: GPL-2.0-or-later
//
// Kogut & Etsion 2002 (J. Appl. Mech. 69:657): flattening of an elastic-perfectly plastic sphere by
// a rigid plane, fitted to finite elements. Unloading: Etsion, Kligerman & Kadin 2005 (Int. J.
// Solids Struct. 42:3716). The equations are those of Ghaednia et al. 2015 (Int. J. Impact Eng.
// 86:307), eqs 15-19. overlap_c is the overlap at yield, H is the hardness, and K H the yield
// pressure. f is F divided by the Hertz force at overlap_c, a_c is the Hertz contact radius at
// overlap_c, and n is the exponent of unloading:
//
//   K = 0.454 + 0.41 nu,  H = 2.8 sigma_Y
//   overlap_c = R* (pi K H/(2 E*))^2,  x = overlap/overlap_c
//   f = x^1.5                x <= 1        a^2 = R* overlap
//   f = 1.03 x^1.425         1 < x <= 6    a^2 = 0.93 x^1.136 a_c^2
//   f = 1.40 x^1.263         beyond        a^2 = 0.94 x^1.146 a_c^2
//   f = (3/K) x, a^2 = 2x a_c^2            beyond 110, option fully_plastic on
//   overlap_res = overlap_max (1 - x^-0.28)(1 - x^-0.69),   n = 1.5 x^-0.0331
//
// Jumps of the force: +3.0 % at x = 1, +1.7 % at x = 6, and with fully_plastic on +7.9 % (nu = 0.3)
// at x = 110.
// Range: fitted for x <= 110.
#pragma once

#include "plastigran/tables/power_unloading.h"

namespace plastigran {

struct KogutEtsionCurve {
  static constexpr const char* name = "kogut_etsion";
  static constexpr const char* source = "Kogut & Etsion 2002, J. Appl. Mech. 69:657";
  static constexpr const char* range = "overlap <= 110 times that at yield, flattening";
  static constexpr bool self_similar = true;
  struct Parameters {
    int fully_plastic = 0;
  };
  static constexpr std::array<Option<Parameters>, 1> options{{
      {"fully_plastic",
       &Parameters::fully_plastic,
       {"off", "on", nullptr},
       "constant pressure beyond 110 times the yield overlap"},
  }};

  std::array<double, 3> breaks{1, 6, 110};
  double yield_radius_ratio;
  double hardness_ratio;  // K [-]
  bool fully_plastic;

  KogutEtsionCurve(const MaterialPair& pair, const Parameters& constants)
      : hardness_ratio(0.454 + 0.41 * pair.poissons_ratio),
        fully_plastic(constants.fully_plastic == 1) {
    const double hardness = 2.8 * pair.yield_strength;
    yield_radius_ratio = pi * hardness_ratio * hardness / (2 * pair.youngs_modulus_eff);
  }

  PLASTIGRAN_DEVICE double force(double x) const {
    if (x <= 6) return 1.03 * std::pow(x, 1.425);
    return fully_plastic && x > 110 ? 3 / hardness_ratio * x : 1.40 * std::pow(x, 1.263);
  }
  PLASTIGRAN_DEVICE double recovery(double x) const {
    return x * (1 - (1 - std::pow(x, -0.28)) * (1 - std::pow(x, -0.69)));
  }
  PLASTIGRAN_DEVICE double exponent(double x) const { return 1.5 * std::pow(x, -0.0331); }
  double overlap_range() const {
    return std::min(110 * yield_radius_ratio * yield_radius_ratio, widest_overlap_range);
  }
  PLASTIGRAN_DEVICE double contact_radius(double x) const {
    if (x <= 6) return std::sqrt(0.93 * std::pow(x, 1.136));
    return fully_plastic && x > 110 ? std::sqrt(2 * x) : std::sqrt(0.94 * std::pow(x, 1.146));
  }
};

using KogutEtsion = PowerUnloading<KogutEtsionCurve>;

}  // namespace plastigran
