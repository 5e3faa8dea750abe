// SPDX-License-Identifier: GPL-2.0-or-later
//
// Jackson & Green 2005 (J. Tribol. 127:343): flattening of an elastic-perfectly plastic sphere by a
// rigid plane, fitted to finite elements. Residual overlap: Jackson, Green & Marghitu 2010
// (Nonlinear Dyn. 60:217). The equations are those of Ghaednia et al. 2015 (Int. J. Impact Eng.
// 86:307), eqs 9-14. overlap_c is the overlap at yield, C sigma_Y the yield pressure, and H the
// hardness. f is F divided by the Hertz force at overlap_c:
//
//   C = 1.295 exp(0.736 nu),  overlap_c = R (pi C sigma_Y/(2 E'))^2,  x = overlap/overlap_c
//   f = x^1.5                                                             x <= 1.9
//   f = exp(-x^(5/12)/4) x^1.5 + 4H/(C sigma_Y) (1 - exp(-x^(5/9)/25)) x  beyond
//   a^2 = R overlap (x/1.9)^B,  B = 0.14 exp(23 sigma_Y/E')
//   H/sigma_Y = 2.84 - 0.92 (1 - cos(pi a/R))                  option hardness cosine (default)
//   H/sigma_Y = 2.84 (1 - exp(-0.82 (a/R)^-0.7))               option hardness exponential (2005)
//   overlap_res = 1.02 overlap_max (1 - ((x + 5.9)/6.9)^-0.54)            x > 1.9; 0 before
//
// R and E' belong to the fitted sphere, which fitted_sphere.h defines for two bodies.
//
// From x = 10 000, the fitted residual overlap would exceed overlap_max. Therefore at least 1 % of
// the overlap recovers. For small sigma_Y/E' and nu = 0.3, the force jumps by +0.5 % at x = 1.9.
// Range: a/R <= 0.41.
#pragma once

#include "plastigran/shared/fitted_sphere.h"
#include "plastigran/tables/power_unloading.h"

namespace plastigran {

struct JacksonGreenCurve {
  static constexpr const char* name = "jackson_green";
  static constexpr const char* source = "Jackson & Green 2005, J. Tribol. 127:343";
  static constexpr const char* range = "a/R <= 0.41, flattening";
  enum Hardness { cosine, exponential };
  struct Parameters {
    int hardness = cosine;
    int reading = of_yielding_body;
  };
  static constexpr std::array<Option<Parameters>, 2> options{{
      {"hardness",
       &Parameters::hardness,
       {"cosine", "exponential", nullptr},
       "dependence of hardness on the contact radius"},
      reading_option(&Parameters::reading),
  }};

  std::array<double, 1> breaks{1.9};
  FittedSphere sphere;
  double pressure_factor;  // C, from Poisson's ratio [-]
  double area_exponent;    // B, exponent of the contact area [-]
  int hardness;
  double yield_radius;  // a_y/R [-]
  double yield_radius_ratio;

  JacksonGreenCurve(const MaterialPair& pair, const Parameters& constants)
      : sphere(pair, constants.reading),
        pressure_factor(1.295 * std::exp(0.736 * pair.poissons_ratio)),
        area_exponent(0.14 * std::exp(23 * pair.yield_strength / sphere.modulus)),
        hardness(constants.hardness),
        yield_radius(pi * pressure_factor * pair.yield_strength / (2 * sphere.modulus)),
        yield_radius_ratio(yield_radius * sphere.radius_ratio) {}

  PLASTIGRAN_DEVICE double force(double x) const { return force(x, contact_radius(x)); }
  // Returns the force ratio f at x = overlap/overlap_c for a given contact radius, `radius` =
  // a/a_y; ghaednia_2019 passes its own contact radius.
  PLASTIGRAN_DEVICE double force(double x, double radius) const {
    return std::exp(-0.25 * std::pow(x, 5.0 / 12)) * x * std::sqrt(x) +
           4 * hardness_ratio(radius) / pressure_factor * -std::expm1(-std::pow(x, 5.0 / 9) / 25) *
               x;
  }
  PLASTIGRAN_DEVICE double recovery(double x) const {
    return x * std::max(0.01, 1 - 1.02 * (1 - std::pow((x + 5.9) / 6.9, -0.54)));
  }
  PLASTIGRAN_DEVICE double contact_radius(double x) const {
    return std::sqrt(x * std::pow(x / 1.9, area_exponent));
  }
  // Returns the overlap/R* at which a/R = 0.41, the end of the fitted range.
  double overlap_range() const {
    const double x_scale = 1 / (1.9 * yield_radius * yield_radius);
    return sphere.overlap_range(
        std::pow(0.41 * 0.41 / std::pow(x_scale, area_exponent), 1 / (1 + area_exponent)));
  }
  // Returns the ratio H/sigma_Y of hardness to yield strength at `radius` = a/a_y. The cosine form
  // was fitted up to a/R = 0.41. This law keeps it constant beyond a/R = 1.
  PLASTIGRAN_DEVICE double hardness_ratio(double radius) const {
    const double a = yield_radius * radius;
    if (hardness == exponential) return -2.84 * std::expm1(-0.82 * std::pow(a, -0.7));
    return 2.84 - 0.92 * (1 - std::cos(pi * std::min(a, 1.0)));
  }
};

using JacksonGreen = PowerUnloading<JacksonGreenCurve>;

}  // namespace plastigran
