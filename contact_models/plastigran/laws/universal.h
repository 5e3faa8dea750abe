// SPDX-License-Identifier: GPL-2.0-or-later
//
// Law of this project: Hertz until yield, then closed forms up to full plasticity, with linear
// hardening. The constants are fitted to finite-element solutions of spheres on a rigid plane
// (docs/universal_derivation.md). With a_Y = pi p_y R*/(2 E*), overlap_Y = a_Y^2/R*,
// F_Y = 4/3 E* a_Y^3/R*, t = (overlap/overlap_Y)^(1/2) and s = t - 1:
//
//   q = (q_1 + s)/(q_1 + w s) + q_2 h s/(1 + q_3 s)       strength divided by strength at yield
//   S = max(t/q - 1, 0)
//   F = F_Y t^3/(1 + f_1 S^2 (S + f_2)/((S + f_3)(S + f_4)) (1 + f_5 Z)),  Z = (r S)^2/(1 + r S)
//   a = a_Y t (1 + c_1 S^2/((1 + c_4 h) S^2 + c_2 S + c_3))^(1/2) (1 + c_5 Z)
//   overlap_max - overlap_res = (1 - D) 3 F/(4 E* a),   D = d_1 S^2/(S^2 + d_2 S + d_3)
//
//   F = F_max y^(3/2) (1 + g)/(1 + g y^(1/2)),  g = g_1 D,       unloading and reloading
//   y = (overlap - overlap_res)/(overlap_max - overlap_res)
//
// S measures how far the contact is beyond yield, and Z describes large a/R. w is p_y/sigma_Y
// divided by its value at nu = 0.3. Because of w, the pressure far beyond yield depends on sigma_Y
// and not on p_y. h = (p_y/sigma_Y) H/E' with the plastic modulus H; r = a_Y/R. E' and R belong to
// the fitted sphere, which fitted_sphere.h defines. The option `yielding flat` sets r = 0, because
// a flat that is indented by a hard sphere has no radius. During unloading, the contact radius is
// proportional to dF/d(overlap).
//
// Restitution is at most 1. In a Hertz contact, the released energy equals the work of loading, and
// F/t^3, (released energy) a/F^2 and a/t are constant. Beyond yield, the first two decrease and a/t
// increases; each of these changes lowers the ratio of released energy to work of loading.
#pragma once

#include "plastigran/shared/fitted_sphere.h"
#include "plastigran/tables/curve_table.h"

namespace plastigran {

struct UniversalCurve {
  static constexpr const char* name = "universal";
  static constexpr const char* source = "finite elements of Plastigran, docs/laws/universal.md";
  static constexpr const char* range = "a/R <= 0.1, hardening to E/20";
  static constexpr bool hardens = true;
  enum Yielding { sphere, flat };
  struct Parameters {
    int yielding = sphere;
  };
  static constexpr std::array<Option<Parameters>, 1> options{{
      {"yielding",
       &Parameters::yielding,
       {"sphere", "flat", nullptr},
       "shape of the yielding body: a sphere that flattens, or a flat; for a flat, the fit for "
       "small a/R is used at any a/R"},
  }};

  static bool admissible(const MaterialPair& pair, const Parameters&) {
    return pair.yield_pressure <= 3 * pair.yield_strength;
  }
  static constexpr const char* admissibility =
      "{yield_pressure_factor} of the weaker body must be at most 3; the fit covers 1.5 to 2.1";

  // Fitted constants, printed by `python -m plastigran.validation.spheres.fit`.
  static constexpr double q_1 = 6.791, q_2 = 0.3561, q_3 = 0.01798;
  static constexpr double f_1 = 0.1253, f_2 = 11.91, f_3 = 8.355, f_4 = 1.114, f_5 = 3.802;
  static constexpr double c_1 = 1.248, c_2 = 5.11, c_3 = 4.411, c_4 = 3.473, c_5 = 7.842;
  static constexpr double d_1 = 0.1902, d_2 = 0.6156, d_3 = 0.359;
  static constexpr double g_1 = 3.642;

  FittedSphere fitted;
  double yield_radius_ratio;  // a_Y/R* [-]
  double yield_radius;        // a_Y/R of the fitted sphere [-]
  double widening_radius;     // r [-]; 0 with option yielding flat
  double onset;               // w [-]
  double hardening;           // h [-]
  std::array<double, 1> breaks{1};

  UniversalCurve(const MaterialPair& pair, const Parameters& constants)
      : fitted(pair, of_yielding_body),
        yield_radius_ratio(plastigran::yield_radius_ratio(pair)),
        yield_radius(pi * pair.yield_pressure / (2 * fitted.modulus)),
        widening_radius(constants.yielding == flat ? 0 : yield_radius) {
    const double pressure_factor = pair.yield_pressure / pair.yield_strength;
    onset = pressure_factor / hertz_yield_pressure_factor(0.3);
    const double plastic_modulus =
        pair.tangent_modulus * pair.youngs_modulus / (pair.youngs_modulus - pair.tangent_modulus);
    hardening = pressure_factor * plastic_modulus / fitted.modulus;
  }

  PLASTIGRAN_DEVICE double depth(double t) const {  // returns S [-]
    const double s = t - 1;
    const double strength = (q_1 + s) / (q_1 + onset * s) + q_2 * hardening * s / (1 + q_3 * s);
    return std::max(0.0, t / strength - 1);
  }
  PLASTIGRAN_DEVICE double large(double S) const {  // returns Z [-]
    const double a = widening_radius * S;
    return a * a / (1 + a);
  }
  PLASTIGRAN_DEVICE double force(double x) const {
    const double t = std::sqrt(x), S = depth(t);
    const double softening = f_1 * S * S * (S + f_2) / ((S + f_3) * (S + f_4));
    return t * t * t / (1 + softening * (1 + f_5 * large(S)));
  }
  PLASTIGRAN_DEVICE double contact_radius(double x) const {
    const double t = std::sqrt(x), S = depth(t);
    const double widening = c_1 * S * S / ((1 + c_4 * hardening) * S * S + c_2 * S + c_3);
    return t * std::sqrt(1 + widening) * (1 + c_5 * large(S));
  }
  PLASTIGRAN_DEVICE double lacking(double x) const {  // returns D [-]
    const double S = depth(std::sqrt(x));
    return d_1 * S * S / (S * S + d_2 * S + d_3);
  }
  PLASTIGRAN_DEVICE double recovery(double x) const {
    return (1 - lacking(x)) * force(x) / contact_radius(x);
  }
  PLASTIGRAN_DEVICE double steepness(double x) const { return 1 + g_1 * lacking(x); }

  // Returns overlap/R* at a/R = 0.1, the end of the fit.
  double overlap_range() const {
    double left = 0, right = 0.1 / yield_radius;  // bounds of t: a is at least the Hertz radius
    halve(left, right,
          [this](double t) { return yield_radius * (t > 1 ? contact_radius(t * t) : t) >= 0.1; });
    return fitted.overlap_range(left * left * yield_radius * yield_radius);
  }
};

using Universal = CurveTable<UniversalCurve, SteepeningUnloading>;

}  // namespace plastigran
