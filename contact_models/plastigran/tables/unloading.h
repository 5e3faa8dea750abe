// SPDX-License-Identifier: GPL-2.0-or-later
//
// Shapes of the unloading curve for curve_table.h: force, contact radius and elastic energy between
// residual and largest overlap, as functions of y = (overlap - overlap_res)/(overlap_max -
// overlap_res).
//
//   power       F = F_max y^n,  a = a_max y^(1/2),  n = 3/2 or the curve's exponent(x)
//   steepening  F = F_max y^(3/2) (1 + g)/(1 + g y^(1/2)),  1 + g is the curve's steepness(x);
//               the contact radius is proportional to dF/d(overlap)
//
// Below yield, both are the Hertz contact. work_ratio is F_max (overlap_max - overlap_res) divided
// by the energy that unloading releases: n + 1 for `power`, and 1/((1 + g) W(g)) for `steepening`,
// with W(g) the integral of 2 z^4/(1 + g z) from 0 to 1.
#pragma once

#include <array>
#include <cmath>
#include <type_traits>

#include "plastigran/shared/contact.h"
#include "plastigran/shared/device.h"
#include "plastigran/shared/hertz_contact.h"
#include "plastigran/shared/numerics.h"
#include "plastigran/tables/power_tables.h"
#include "plastigran/tables/tabulated.h"

namespace plastigran {

// Quantities of a contact at its largest overlap.
struct Peak {
  double force, contact_radius;
  double inverse_recovery;  // 1/(overlap_max - overlap_res) [1/m]
  double shape;             // n or 1 + g [-]
  double plastic_work;
};

// Point of an unloading curve, from which adhesive.h computes adhesion. The variable of the curve
// is y, the overlap above the residual overlap divided by its largest value. `force` and
// `root_of_slope` (square root of dF/d(overlap)) are divided by their values at the largest
// overlap. `exponent` is d ln(root_of_slope)/d ln(y).
//
// The classes below also define these functions; `root` is the square root of y:
//   contact_radius_at   contact radius, divided by its value at the largest overlap
//   energy_at           elastic energy, divided by F_max (overlap_max - overlap_res)
//   pull_off            pull-off force, divided by S D, with the slope S and the adhesive
//                       displacement D at the largest overlap (adhesive.h); the argument `b` is
//                       D/(overlap_max - overlap_res)
struct ShapeOfUnloading {
  double force, root_of_slope, exponent;
};

// Base of the unloading shapes: Hertz contact below yield.
struct HertzBelowYield {
  PLASTIGRAN_DEVICE static Response elastic(double modulus, double radius_eff, double,
                                            double overlap) {
    return hertz_response(modulus, radius_eff, overlap);
  }
  // Returns the work of elastic loading to x = overlap/overlap_y, divided by F_y overlap_y.
  PLASTIGRAN_DEVICE static double elastic_work(double x) { return 0.4 * x * x * std::sqrt(x); }
};

template <class Curve, class = void>
constexpr bool has_exponent = false;
template <class Curve>
constexpr bool has_exponent<Curve, std::void_t<decltype(&Curve::exponent)>> = true;

// Power shape with n = 3/2, for curves without a function exponent(x).
struct ThreeHalves {
  PLASTIGRAN_DEVICE static double share(double y, double root, double) { return y * root; }
};
struct AnyExponent {
  PowerTables tables;
  PLASTIGRAN_DEVICE double share(double y, double root, double exponent) const {
    return y < 1 && exponent != 1.5 ? y * root * tables.power(y, exponent - 1.5) : y * root;
  }
  PLASTIGRAN_DEVICE double power(double base, double exponent) const {
    return base > 0 ? tables.power(base, exponent) : 0;
  }
};

template <class Curve>
class PowerOfOverlap : public HertzBelowYield {
 public:
  static constexpr bool has_shape = has_exponent<Curve>;
  static constexpr bool is_hertzian = !has_shape;
  static constexpr double usual_shape = 1.5;

  template <class Table>
  PLASTIGRAN_DEVICE static double shape([[maybe_unused]] const Table& curve,
                                        [[maybe_unused]] double x) {
    if constexpr (has_shape)
      return curve.exponent(x);
    else
      return usual_shape;
  }
  PLASTIGRAN_DEVICE static double work_ratio(double exponent) { return exponent + 1; }

  PLASTIGRAN_DEVICE Response at(const Peak& peak, double y) const {
    const double peak_energy = peak.force / (peak.inverse_recovery * work_ratio(peak.shape));
    Response response;
    if (y > 0) {
      const double root = std::sqrt(y), share = power_.share(y, root, peak.shape);
      response.force = peak.force * share;
      response.contact_radius = peak.contact_radius * root;
      response.elastic_energy = peak_energy * share * y;
    }
    response.plastic_work = peak.plastic_work;
    return response;
  }
  PLASTIGRAN_DEVICE Response at_largest(const Peak& peak) const { return at(peak, 1); }

  // Returns the slope at the largest overlap divided by F_max/(overlap_max - overlap_res).
  PLASTIGRAN_DEVICE static double largest_slope(double exponent) { return exponent; }
  PLASTIGRAN_DEVICE ShapeOfUnloading shape_at(double root, double exponent) const {
    const double y = root * root, force = power_.share(y, root, exponent);
    return {force, y > 0 ? std::sqrt(force / y) : 0, 0.5 * (exponent - 1)};
  }
  PLASTIGRAN_DEVICE static double contact_radius_at(double root, double, double) { return root; }
  PLASTIGRAN_DEVICE double energy_at(double root, double exponent) const {
    const double y = root * root;
    return power_.share(y, root, exponent) * y / (exponent + 1);
  }
  PLASTIGRAN_DEVICE double pull_off(double b, double exponent) const {
    if constexpr (is_hertzian) {
      return 0.375 * b;
    } else {
      const double part = 1.5 * (exponent - 1);
      return (1 - part / exponent) * power_.power(part * b, 2 * part / (3 - exponent));
    }
  }

 private:
  std::conditional_t<has_shape, AnyExponent, ThreeHalves> power_;
};

class SteepeningUnloading : public HertzBelowYield {
 public:
  static constexpr bool has_shape = true;
  static constexpr bool is_hertzian = false;
  static constexpr double usual_shape = 1;

  SteepeningUnloading()
      : work_(1, [](double steepness) { return std::array{summed_work(steepness - 1)}; }) {}

  template <class Table>
  PLASTIGRAN_DEVICE static double shape(const Table& curve, double x) {
    return curve.steepness(x);
  }
  PLASTIGRAN_DEVICE double work_ratio(double steepness) const {
    return 1 / (steepness * work(steepness - 1));
  }

  PLASTIGRAN_DEVICE Response at(const Peak& peak, double left) const {
    const double y = left > 0 ? left : 0, root = std::sqrt(y), g = peak.shape - 1;
    // `steeper` and `wider` are the ratios of force and contact radius to those of a Hertz contact.
    // Both are exactly 1 at the largest overlap, so that first loading continues without a jump.
    const double steeper = peak.shape / (1 + g * root);
    const double wider = steeper * steeper * ((3 + 2 * g * root) / (3 + 2 * g));
    return scaled(peak, root, y * root * steeper, root * wider);
  }
  PLASTIGRAN_DEVICE Response at_largest(const Peak& peak) const { return scaled(peak, 1, 1, 1); }

  PLASTIGRAN_DEVICE static double largest_slope(double steepness) { return 1 + 0.5 / steepness; }
  PLASTIGRAN_DEVICE static ShapeOfUnloading shape_at(double root, double steepness) {
    const double g = steepness - 1, gz = g * root, one = 1 + gz, three = 3 + 2 * gz;
    const double inverse = 1 / (one * three), steeper = steepness * (inverse * three);
    return {root * root * root * steeper, steeper * std::sqrt(root * (three * (1 / (3 + 2 * g)))),
            0.25 - 0.5 * gz * (2 + gz) * inverse};
  }
  PLASTIGRAN_DEVICE static double contact_radius_at(double, double root_of_slope, double) {
    return root_of_slope * root_of_slope;
  }
  PLASTIGRAN_DEVICE double energy_at(double root, double steepness) const {
    const double square = root * root;
    return steepness * square * square * root * work((steepness - 1) * root);
  }
  // Near the residual overlap, the unloading curve is Hertzian. Its force is `steeper` times the
  // force of a Hertz contact with the same slope S at the largest overlap. At larger y, the slope
  // grows less; the last factor is the resulting decrease of the pull-off force. The error of this
  // factor is at most 0.4 % for b up to 0.6, and 2 % for b = 1.2.
  PLASTIGRAN_DEVICE static double pull_off(double b, double steepness) {
    const double steeper = 3 * steepness * steepness / (2 * steepness + 1);
    const double root = cube_root(0.5625 * b * b * steeper);  // y^(1/2) at pull-off
    return 0.375 * b * (steeper * steeper) / (1 + 3 * (steepness - 1) * root);
  }

 private:
  // Returns the response at y = root^2 with the given fractions of the largest force and contact
  // radius.
  PLASTIGRAN_DEVICE Response scaled(const Peak& peak, double root, double force_share,
                                    double radius_share) const {
    const double g = peak.shape - 1, square = root * root;
    const double scale = peak.force * peak.shape / peak.inverse_recovery;
    Response response;
    response.force = peak.force * force_share;
    response.contact_radius = peak.contact_radius * radius_share;
    response.elastic_energy = scale * (square * square * root * work(g * root));
    response.plastic_work = peak.plastic_work;
    return response;
  }

  // Returns W(g), the integral of 2 z^4/(1 + g z) over z from 0 to 1.
  PLASTIGRAN_DEVICE double work(double g) const {
    return work_.covers(1 + g) ? work_(1 + g)[0] : summed_work(g);
  }
  PLASTIGRAN_DEVICE static double summed_work(double g) {
    return gauss_legendre([g](double z) { return 2 * z * z * z * z / (1 + g * z); }, 0, 1);
  }

  Tabulated<1, 8, 1, 16> work_;  // W as a function of 1 + g
};

}  // namespace plastigran
