// SPDX-License-Identifier: GPL-2.0-or-later
//
// Unloading of an elliptical indenter from a bed of springs (laws/mdr.h), for curve_table.h. y is
// the depth of the indenter divided by half its height:
//
//   F = F_max h(y),   h = 2/pi (acos(1-y) - (1-y) c),   a = a_max c,   c = sqrt(2y - y^2)
//   integral of h = 2/pi (c - (1-y) acos(1-y) - c^3/3)
//
// Beyond y = 1 the indenter is a flat punch: h = 1 + 4/pi (y-1), c = 1. Near y = 0, the closed
// forms lose digits by cancellation, so h is computed from the series of its integral form, 4/pi
// times the integral of sqrt(2y) sqrt(1 - y/2). The table contains h/y^(3/2) and (integral of
// h)/y^(5/2), because these are smooth functions. Below yield, y = overlap/(2R), F_max = pi E' R^2
// and a_max = R.
#pragma once

#include <array>
#include <cmath>

#include "plastigran/shared/contact.h"
#include "plastigran/shared/device.h"
#include "plastigran/tables/tabulated.h"
#include "plastigran/tables/unloading.h"

namespace plastigran {

class EllipticalUnloading {
 public:
  static constexpr bool has_shape = false;
  static constexpr double usual_shape = 0;

  EllipticalUnloading() : shares_(1, [](double z) { return computed_shares(z - 1); }) {}

  PLASTIGRAN_DEVICE Response elastic(double modulus, double radius_eff, double radius_ratio,
                                     double overlap) const {
    const double radius = radius_eff * radius_ratio;
    const double force_unit = 0.75 * pi * modulus * radius_ratio * radius * radius;
    const double overlap_unit = radius * radius_ratio;
    const double y = 0.5 * overlap / overlap_unit, root = std::sqrt(y);
    const Shares share = shares(y);
    Response response;
    response.force = force_unit * y * root * share[0];
    response.contact_radius = radius * chord(y);
    response.elastic_energy = force_unit * overlap_unit * 2 * y * y * root * share[1];
    return response;
  }
  // Returns the work of elastic loading to x = overlap/R, divided by 4/3 E* r^5 R*^3 with r =
  // yield_radius_ratio.
  PLASTIGRAN_DEVICE static double elastic_work(double x) { return 1.5 * pi * stored(0.5 * x); }

  template <class Table>
  PLASTIGRAN_DEVICE static double shape(const Table&, double) {
    return usual_shape;
  }
  PLASTIGRAN_DEVICE static double work_ratio(double) { return 0.75 * pi; }

  PLASTIGRAN_DEVICE Response at(const Peak& peak, double y) const {
    if (y == 1) return at_largest(peak);  // bitwise identical to the response of first loading
    Response response;
    if (y > 0) {
      const double root = std::sqrt(y);
      const Shares share = shares(y);
      response.force = peak.force * (y * root * share[0]);
      response.contact_radius = peak.contact_radius * chord(y);
      response.elastic_energy = peak.force / peak.inverse_recovery * (y * y * root * share[1]);
    }
    response.plastic_work = peak.plastic_work;
    return response;
  }
  PLASTIGRAN_DEVICE Response at_largest(const Peak& peak) const {
    const double energy = peak.force / (peak.inverse_recovery * work_ratio(0));
    return {peak.force, peak.contact_radius, energy, peak.plastic_work};
  }

 private:
  // The force ratio h = F/F_max divided by y^(3/2), and the integral of h divided by y^(5/2).
  typedef std::array<double, 2> Shares;
  PLASTIGRAN_DEVICE Shares shares(double y) const {
    return shares_.covers(1 + y) ? shares_(1 + y) : computed_shares(y);
  }
  PLASTIGRAN_DEVICE static Shares computed_shares(double y) {
    if (y < series_end) return {series(y, 0), series(y, 1)};
    const double root = std::sqrt(y);
    return {share(y) / (y * root), stored(y) / (y * y * root)};
  }
  // Returns h = F/F_max at the relative depth y of the indenter.
  PLASTIGRAN_DEVICE static double share(double y) {
    if (y > 1) return 1 + 4 / pi * (y - 1);
    return 2 / pi * (std::acos(1 - y) - (1 - y) * chord(y));
  }
  // Returns the integral of h = F/F_max over the relative depth, from 0 to y.
  PLASTIGRAN_DEVICE static double stored(double y) {
    if (y < series_end) return y * y * std::sqrt(y) * series(y, 1);
    if (y > 1) return stored(1) + (y - 1) + 2 / pi * (y - 1) * (y - 1);
    const double root = chord(y);
    return 2 / pi * (root - (1 - y) * std::acos(1 - y) - root * root * root / 3);
  }
  PLASTIGRAN_DEVICE static double chord(double y) { return y < 1 ? std::sqrt(y * (2 - y)) : 1; }

  // Series for small y, where the closed forms lose digits. With integrals = 0, returns h/y^(3/2):
  // 4 sqrt(2)/pi times the sum of binomial(1/2, k) (-y/2)^k/(k + 3/2). With integrals = 1, divides
  // each term also by (k + 5/2), and returns (integral of h)/y^(5/2). For y < 1/4, 16 terms have an
  // error below 1e-17.
  static constexpr double series_end = 0.25;
  PLASTIGRAN_DEVICE static double series(double y, int integrals) {
    double sum = 0, term = 4 * 1.4142135623730951 / pi;
    double terms[16];
    for (int k = 0; k < 16; ++k) {
      terms[k] = integrals ? term / (k + 1.5) / (k + 2.5) : term / (k + 1.5);
      term *= 0.5 * (k - 0.5) / (k + 1);
    }
    for (int k = 15; k >= 0; --k) sum = sum * y + terms[k];
    return sum;
  }

  Tabulated<2, 8, 2, 40> shares_;  // shares() as functions of 1 + y
};

}  // namespace plastigran
