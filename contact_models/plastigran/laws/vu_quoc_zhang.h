// SPDX-License-Identifier: GPL-2.0-or-later
//
// Vu-Quoc & Zhang 1999 (Proc. R. Soc. A 455:4013), equations of Zhang & Vu-Quoc 2002 (Int. J.
// Impact Eng. 27:317), eqs 4.1-4.9. The contact radius has an elastic part a_e and a plastic part
// a_p. Plastic flow enlarges the radius of curvature by the factor C_R. a_p and C_R grow linearly
// with the force beyond the yield force P_Y; <x> is max(x, 0):
//
//   a = a_e + a_p,  a_e^3 = 3 F R*/(4 E*),  a_p = C_a <F - P_Y>,  C_R = 1 + K_c <F - P_Y>
//   overlap = a^2 / (C_R R*)                        first loading
//   unloading, reloading: a_p and C_R keep their values at the largest force
//   P_Y = pi^3 R*^2 p_y^3/(6 E*^2),  a_Y = pi p_y R*/(2 E*),  overlap_Y = a_Y^2/R*   (yield)
//
// With s = a_e/a_Y, F = P_Y s^3, u = <s^3 - 1>, c_a = C_a P_Y/a_Y and k_c = K_c P_Y, the law does
// not depend on size and material:
//
//   overlap/overlap_Y = A^2/C,   A = s + c_a u,   C = 1 + k_c u
//
// The defaults of c_a and k_c follow from the paper's calibration for an aluminum sphere of 0.1 m
// radius: C_a = 2.33e-7 m/N, K_c = 2.69e-4 1/N. Range: calibrated up to F = 41 P_Y for nu = 0.3,
// perfectly plastic. Far beyond, F tends to (k_c/c_a^2) P_Y overlap/overlap_Y. F/(2 pi R* overlap)
// is then 4.9 p_y, a mean pressure that no metal reaches.
#pragma once

#include "plastigran/tables/parametric_table.h"

namespace plastigran {

struct VuQuocZhangCurve {
  static constexpr const char* name = "vu_quoc_zhang";
  static constexpr const char* source = "Vu-Quoc & Zhang 1999, Proc. R. Soc. A 455:4013";
  static constexpr const char* range = "F <= 41 P_Y, nu near 0.3, perfectly plastic";
  static constexpr bool self_similar = true;
  struct Parameters {
    double contact_radius_coefficient = 0.0258303;  // c_a
    double curvature_coefficient = 0.00980426;      // k_c
  };
  static constexpr std::array<Parameter<Parameters>, 2> parameters{{
      {"contact_radius_coefficient", "-", &Parameters::contact_radius_coefficient, 0, 10,
       "growth of the plastic contact radius with force, C_a P_Y / a_Y"},
      {"curvature_coefficient", "-", &Parameters::curvature_coefficient, 0, 0.99,
       "growth of the radius of curvature with force, K_c P_Y"},
  }};

  double ca, kc;              // c_a, k_c [-]
  double yield_radius_ratio;  // a_Y/R* [-]
  double yield_force_ratio;   // P_Y/R*^2 [Pa]

  VuQuocZhangCurve(const MaterialPair& pair, const Parameters& constants)
      : ca(constants.contact_radius_coefficient),
        kc(constants.curvature_coefficient),
        yield_radius_ratio(plastigran::yield_radius_ratio(pair)),
        yield_force_ratio(4.0 / 3.0 * pair.youngs_modulus_eff * yield_radius_ratio *
                          yield_radius_ratio * yield_radius_ratio) {}

  // Returns whether the coefficients c_a of the contact radius and k_c of the curvature satisfy
  // c_a^(3/2) (2 - k_c) >= 2/5 sqrt(1/5) k_c. Then the force of first loading increases with
  // overlap, and plastic work never decreases. The condition is sufficient; the c_a that it
  // requires is at most a quarter larger than necessary. If the radius of curvature grew and the
  // contact radius did not, unloading would release more energy than loading took.
  static bool admissible(const MaterialPair&, const Parameters& constants) {
    const double ca = constants.contact_radius_coefficient, kc = constants.curvature_coefficient;
    return ca * std::sqrt(ca) * (2 - kc) >= 0.4 * std::sqrt(0.2) * kc;
  }
  static constexpr const char* admissibility =
      "{contact_radius_coefficient}^1.5 * (2 - {curvature_coefficient}) must be at least "
      "0.1789 * {curvature_coefficient}, or the contact might create energy";

  // The next functions return values at s = a_e/a_Y: the plastic radius a_p/a_Y, the contact radius
  // A = a/a_Y, the factor C of the radius of curvature, and the derivatives dA/ds and dC/ds.
  PLASTIGRAN_DEVICE double plastic_radius(double s) const { return ca * (s * s * s - 1); }
  PLASTIGRAN_DEVICE double radius(double s) const { return s + plastic_radius(s); }
  PLASTIGRAN_DEVICE double curvature(double s) const { return 1 + kc * (s * s * s - 1); }
  PLASTIGRAN_DEVICE double radius_slope(double s) const { return 1 + 3 * ca * s * s; }
  PLASTIGRAN_DEVICE double curvature_slope(double s) const { return 3 * kc * s * s; }

  // Returns s at F = 42 P_Y, the end of the range: the calibration ends at 41 P_Y, plus 2 % for
  // rounded values in the source.
  static double largest() { return std::cbrt(42); }
};

using VuQuocZhang = ParametricTable<VuQuocZhangCurve>;

}  // namespace plastigran
