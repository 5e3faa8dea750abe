// SPDX-License-Identifier: GPL-2.0-or-later
//
// Loading curve of the laws for cylinders: line contact with an elastic-plastic body in plane
// strain. Lim & Stronge 1998 (Math. Comput. Model. 28:323) and Katta & Polycarpou 2010 (J. Tribol.
// 132); elastic part after Johnson, Contact Mechanics (1985), sec. 5.6.
//
//   L  length of the cylinder          D  thickness of the body that yields    R  effective radius
//   q  F/(pi E* L), load [m]           a  half-width of the contact            Y  yield strength
//   p  mean pressure/Y                 k  nu/(1-nu)                            s  a/a_Y
//
//   elastic      overlap = q (ln(4 D^2/a^2) - k),  a^2 = 4 q R            p <= 1.5
//   yield        a_Y = 12 Y R/(pi E*)
//   beyond       overlap = overlap_Y + (a^2 - a_Y^2)/(2R),  F = 2 a L Y p
//                p = min(1.5 + ln(s)/sqrt(3), 2.4)
//   unloading    a^2 = 4 q R_e with the radius R_e of the unloaded surface, larger than R
//
// The overlap is the approach of the cylinder to the far side of the body, so the thickness D
// enters the logarithm. For large a, the logarithmic formula is invalid. Therefore the load follows
// the tangent of the curve if ln(4 D^2/a^2) - k < 2. This is outside the validity range: for nu
// near 0.25, a exceeds 0.6 D.
//
// The laws differ in the unloading (tables/line_contact.h).
#pragma once

#include <algorithm>
#include <cmath>

#include "plastigran/shared/device.h"

namespace plastigran {

// Returns the root w > 1 of w - ln w = t for t >= 1.25, which is -W(-exp(-t)) on the lower branch
// of Lambert's function. Halley's method starts from two terms of the asymptotic series; four steps
// converge to round-off.
PLASTIGRAN_DEVICE inline double lambert_root(double t) {
  const double log_t = std::log(t);
  double w = t + log_t + log_t / t;
  for (int i = 0; i < 4; ++i) {
    const double off = w - std::log(w) - t, s = w - 1;
    w -= 2 * off * s * w / (2 * s * s - off);
  }
  return w;
}

// Returns load/overlap of the elastic contact, for which overlap = load ln(reach/load) with a
// constant length `reach`. The argument x is overlap/reach. The result is 1/w, where w - ln w =
// ln(1/x).
PLASTIGRAN_DEVICE inline double load_share(double x) {
  return 1 / lambert_root(std::max(1.25, -std::log(x)));
}

// Contact beyond yield: load divided by the load at yield, and work, as functions of s = a/a_Y and
// ln(s).
struct LineYielding {
  static constexpr double hardening = 0.38490017945975051;  // pressure slope, (1/sqrt(3))/1.5
  static constexpr double pressure_cap = 1.6;  // largest mean pressure/pressure at yield, 2.4/1.5
  static constexpr double plastic_from = 4.7533314343482855;  // s at the cap, exp(0.9 sqrt(3))

  PLASTIGRAN_DEVICE static double load(double s, double log_s) {
    return s * std::min(1 + hardening * log_s, pressure_cap);
  }
  // Returns the work beyond yield divided by F_Y a_Y^2/R: the integral of s^2 p/1.5 over s = a/a_Y,
  // from yield. p is the mean pressure divided by the yield strength.
  PLASTIGRAN_DEVICE static double work(double s, double log_s) {
    const double cube = s * s * s;
    if (s > plastic_from) {
      const double full = plastic_from * plastic_from * plastic_from;
      return hardened(full, 0.9 * 1.7320508075688772) + pressure_cap / 3 * (cube - full);
    }
    return hardened(cube, log_s);
  }

 private:
  PLASTIGRAN_DEVICE static double hardened(double cube, double log_s) {
    return (cube - 1) / 3 + hardening * (cube * log_s - (cube - 1) / 3) / 3;
  }
};

}  // namespace plastigran
