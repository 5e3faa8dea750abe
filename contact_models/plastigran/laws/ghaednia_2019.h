// SPDX-License-Identifier: GPL-2.0-or-later
//
// Ghaednia, Brake, Berryhill & Jackson 2019 (J. Tribol. 141:031402): flattening of a sphere with
// linear hardening by a rigid plane, fitted to finite elements. The force f is a weighted average
// of the Hertz force and the force f_p of Jackson & Green. Without hardening, f = f_p. a_p is the
// contact radius of Jackson & Green; overlap_c and x are defined in laws/jackson_green.h:
//
//   f = f_p + (x^1.5 - f_p) (1 - exp(-3.3 E_t/E))             x > 1.9; Hertz before
//   a = a_e + (a_p - a_e) exp(Y),   a_e^2 = R overlap
//   Y = -2 sqrt(E/sigma_Y) (E_t/E)^(1 - (overlap - overlap_c)/R)
//       / ((4 - 3 exp(-2 sqrt(E/sigma_Y) E_t/E)) (1 - E_t/E)),  0 without hardening
//
// The hardness H in f_p is evaluated at the contact radius a of this law. The equation for Y is
// taken from the package tmdsimpy and differs from the printed equation. For overlap > overlap_c +
// R, the exponent of E_t/E in Y is 0.
//
// The option `unloading` selects the residual overlap and the exponent n of unloading:
//
//   overlap_max - overlap_res = overlap_c f/x^0.5, n = 3/2   brake_2015 (default)
//   overlap_res = overlap_max (1 - x^-0.28)(1 - x^-0.69), n = 1.5 x^-0.0331   etsion_2005
//
// R and E' belong to the fitted sphere, which fitted_sphere.h defines for two bodies. The force
// jumps at x = 1.9 as in the law of Jackson & Green; the jump is smaller with hardening.
// Range: a/R <= 0.41 without hardening, as for Jackson & Green.
#pragma once

#include "plastigran/laws/jackson_green.h"
#include "plastigran/tables/power_unloading.h"

namespace plastigran {

struct Ghaednia2019Curve : JacksonGreenCurve {
  static constexpr const char* name = "ghaednia_2019";
  static constexpr const char* source =
      "Ghaednia, Brake, Berryhill & Jackson 2019, J. Tribol. 141:031402";
  static constexpr const char* range = "a/R <= 0.41, flattening; linear hardening";
  static constexpr bool hardens = true;
  enum Unloading { brake_2015, etsion_2005 };
  struct Parameters {
    int unloading = brake_2015;
  };
  static constexpr std::array<Option<Parameters>, 1> options{{
      {"unloading",
       &Parameters::unloading,
       {"brake_2015", "etsion_2005", nullptr},
       "source of the residual overlap and of the unloading exponent"},
  }};

  int unloading;
  double hardening;      // E_t/E [-]
  double elastic_share;  // fraction of the Hertz force in f
  double decay;          // Y without its factor (E_t/E)^(1 - (overlap - overlap_c)/R)

  Ghaednia2019Curve(const MaterialPair& pair, const Parameters& constants)
      : JacksonGreenCurve(pair, {}),
        unloading(constants.unloading),
        hardening(pair.tangent_modulus / pair.youngs_modulus),
        elastic_share(-std::expm1(-3.3 * hardening)) {
    const double stiffness = 2 * std::sqrt(pair.youngs_modulus / pair.yield_strength);
    decay = -stiffness / ((4 - 3 * std::exp(-stiffness * hardening)) * (1 - hardening));
  }

  PLASTIGRAN_DEVICE double contact_radius(double x) const {
    const double plastic = JacksonGreenCurve::contact_radius(x);
    if (hardening == 0) return plastic;
    const double elastic = std::sqrt(x);
    const double left = std::max(0.0, 1 - (x - 1) * yield_radius * yield_radius);
    return elastic + (plastic - elastic) * std::exp(decay * std::pow(hardening, left));
  }
  PLASTIGRAN_DEVICE double force(double x) const {
    const double plastic = JacksonGreenCurve::force(x, contact_radius(x));
    return plastic + (x * std::sqrt(x) - plastic) * elastic_share;
  }
  PLASTIGRAN_DEVICE double recovery(double x) const {
    if (unloading == brake_2015) return std::min(x, force(x) / std::sqrt(x));
    return x * (1 - (1 - std::pow(x, -0.28)) * (1 - std::pow(x, -0.69)));
  }
  PLASTIGRAN_DEVICE double exponent(double x) const {
    return unloading == brake_2015 ? 1.5 : 1.5 * std::pow(x, -0.0331);
  }
};

using Ghaednia2019 = PowerUnloading<Ghaednia2019Curve>;

}  // namespace plastigran
