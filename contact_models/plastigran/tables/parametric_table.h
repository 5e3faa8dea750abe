// SPDX-License-Identifier: GPL-2.0-or-later
//
// Table of a law whose force and overlap of first loading are both functions of the elastic part of
// the contact radius, s = a_e/a_Y (laws/vu_quoc_zhang.h). A = a/a_Y is the contact radius, and C is
// the factor by which plastic flow enlarges the radius of curvature. s_max is the largest s so far;
// A_max and C_max are the values of A and C at s_max. In yield units:
//
//   F = s^3,   overlap = A^2/C                                   first loading, s > 1
//   overlap C_max = s^2 + A_max^2 - s_max^2,   a = s + A_max - s_max        unloading, reloading
//
// A class Curve defines A = radius(s), C = curvature(s), their derivatives, and the yield
// constants. The host tabulates s as a function of overlap, and the work of loading and unloading
// as functions of s. The force loop reads the tables. The table is trivially copyable.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "plastigran/shared/contact.h"
#include "plastigran/shared/device.h"
#include "plastigran/shared/numerics.h"
#include "plastigran/tables/tabulated.h"
#include "plastigran/tables/unloading.h"

namespace plastigran {

// Unloading for adhesive.h: Hertz unloading, except that the plastic part of the contact radius
// stays constant. `shape` is the elastic fraction of the largest contact radius.
struct PlasticRadiusStays : PowerOfOverlap<void> {
  static_assert(is_hertzian);  // otherwise shape_at() would take `shape` as an exponent
  static constexpr bool has_shape = true;

  PLASTIGRAN_DEVICE static double largest_slope(double) { return usual_shape; }
  PLASTIGRAN_DEVICE static double contact_radius_at(double root, double, double elastic_part) {
    return 1 - elastic_part * (1 - root);
  }
  PLASTIGRAN_DEVICE static double energy_at(double root, double) {
    return PowerOfOverlap<void>().energy_at(root, usual_shape);
  }
};

template <class Curve>
class ParametricTable : public Curve {
 public:
  struct State {
    double elastic_radius_max = 0;  // largest a_e/a_Y beyond yield [-]; 0 while elastic
  };
  static constexpr std::array<const char*, 1> state_names{"elastic_radius_max"};

  ParametricTable(const MaterialPair& pair, const typename Curve::Parameters& constants)
      : Curve(pair, constants) {
    root_ = Tabulated<1>(1, [this](double x) { return std::array{elastic_radius(x, 1)}; });
    const auto complementary =
        Tabulated<1>(1, [this](double s) { return std::array{complement(s)}; }).integral(0);
    works_ = Tabulated<2>(1, [&](double s) {
      const double sum = complementary.covers(s) ? complementary(s)[0] : summed_complement(s);
      return works(point(s), sum);
    });
  }

  PLASTIGRAN_DEVICE Response respond(double radius_eff, double overlap, State& state) const {
    const double overlap_y = radius_eff * Curve::yield_radius_ratio * Curve::yield_radius_ratio;
    const double force_y = radius_eff * radius_eff * Curve::yield_force_ratio;
    const double x = overlap / overlap_y;
    Point max = point(std::max(state.elastic_radius_max, 1.0));
    if (!(overlap > 0)) return {0, 0, 0, force_y * overlap_y * plastic_work(max)};
    double s = max.s;
    // If the overlap differs from the largest overlap by less than the table error, keep the state,
    // so that a second call at the same overlap does not load the contact further.
    const double reached = max.radius * max.radius;
    const double ahead = max.curvature * x - reached;
    if (ahead > rounding * reached) {  // first loading beyond yield
      s = state.elastic_radius_max = root_.covers(x) ? root_(x)[0] : solved(x, max.s);
      max = point(s);
    } else if (!(ahead >= -rounding * reached)) {  // elastic, unloading or reloading
      const double s_squared = max.curvature * x - max.plastic * (2 * max.s + max.plastic);
      s = s_squared > 0 ? std::sqrt(s_squared) : 0;
    }
    Response response;
    response.force = force_y * s * s * s;
    if (s > 0) response.contact_radius = radius_eff * Curve::yield_radius_ratio * (s + max.plastic);
    response.elastic_energy = 0.4 * response.force * overlap_y * s * s / max.curvature;
    response.plastic_work = force_y * overlap_y * plastic_work(max);
    return response;
  }

  // Returns the overlap at a given force >= 0 [m]: the force-driven form of the law (Vu-Quoc, Zhang
  // & Lesburg 2000, J. Appl. Mech. 67:363).
  double overlap(double radius_eff, double force, State& state) const {
    const double overlap_y = radius_eff * Curve::yield_radius_ratio * Curve::yield_radius_ratio;
    const double s = std::cbrt(force / yield_force(radius_eff));
    if (s > 1 && s > state.elastic_radius_max) state.elastic_radius_max = s;
    const Point max = point(std::max(state.elastic_radius_max, 1.0));
    return overlap_y * (s * s + max.plastic * (2 * max.s + max.plastic)) / max.curvature;
  }

  double overlap_range() const {
    const Point at = point(Curve::largest());
    return std::min(at.radius * at.radius / at.curvature * Curve::yield_radius_ratio *
                        Curve::yield_radius_ratio,
                    widest_overlap_range);
  }

  // Returns the yield force P_Y [N].
  double yield_force(double radius_eff) const {
    return radius_eff * radius_eff * Curve::yield_force_ratio;
  }

  // Returns s = a_e/a_Y at x = overlap/overlap_Y >= 1: the root s >= 1 of g(s) = A^2 - x C, by
  // Newton's method. A is the contact radius a/a_Y, and C the factor of the radius of curvature.
  // `start` must not exceed the root. For admissible constants, g is negative left of the root, and
  // increasing and convex right of it. Right of the root, the iterates therefore decrease
  // monotonically. Left of the root, a step is at most s.
  PLASTIGRAN_DEVICE double elastic_radius(double x, double start) const {
    double s = start;
    for (int iteration = 0; iteration < 200; ++iteration) {
      const Point at = point(s);
      const double value = at.radius * at.radius - x * at.curvature;
      const double slope = 2 * at.radius * Curve::radius_slope(s) - x * Curve::curvature_slope(s);
      const double step = slope > 0 ? std::min(-value / slope, s) : s;
      s += step;
      // The relative size of the next step would be about the square of this step, which is below
      // round-off.
      if (std::abs(step) <= 1e-8 * s) break;
    }
    return s;
  }

  // Members that adhesive.h needs, in yield units.
  typedef PlasticRadiusStays Rebound;
  double elastic_range() const { return Curve::yield_radius_ratio * Curve::yield_radius_ratio; }
  PLASTIGRAN_DEVICE Peak after_loading(double x) const {
    const Point at = point(root_.covers(x) ? root_(x)[0] : elastic_radius(x, 1));
    return {at.s * at.s * at.s, at.radius, at.curvature / (at.s * at.s), at.s / at.radius, 0};
  }

 private:
  struct Point {
    double s;          // a_e/a_Y [-]
    double plastic;    // a_p/a_Y [-]
    double radius;     // A = a/a_Y [-]
    double curvature;  // C [-]
  };
  PLASTIGRAN_DEVICE Point point(double s) const {
    const double radius = Curve::radius(s);
    return {s, Curve::plastic_radius(s), radius, Curve::curvature(s)};
  }

  // Returns s = a_e/a_Y at the overlap x, beyond the end of the table.
  [[gnu::noinline, gnu::cold]] PLASTIGRAN_DEVICE double solved(double x, double start) const {
    return elastic_radius(x, start);
  }

  // Relative tolerance of A^2/C: s in the table has a relative error of 3e-14, and A grows at most
  // as s^3.
  static constexpr double rounding = 2e-13;

  // Returns the integrand of the complementary work of first loading: overlap/overlap_Y times
  // d(F/P_Y)/ds.
  PLASTIGRAN_DEVICE double complement(double s) const {
    const Point at = point(s);
    return 3 * s * s * at.radius * at.radius / at.curvature;
  }

  // Returns the plastic work divided by P_Y overlap_Y.
  PLASTIGRAN_DEVICE double plastic_work(const Point& max) const {
    if (!(max.s > 1)) return 0;
    const auto [taken, returned] =
        works_.covers(max.s) ? works_(max.s) : works(max, summed_complement(max.s));
    return taken - returned;
  }
  // Returns the work of first loading, 2/5 + integral of F d(overlap), and the released energy
  // 2/5 s^5/C. The integral begins at yield and equals F overlap - 1 - `complementary`, where
  // `complementary` is the integral of overlap dF from yield. All values are in yield units.
  PLASTIGRAN_DEVICE std::array<double, 2> works(const Point& max, double complementary) const {
    const double force = max.s * max.s * max.s;
    return {0.4 + force * max.radius * max.radius / max.curvature - 1 - complementary,
            0.4 * force * max.s * max.s / max.curvature};
  }
  // Returns the integral of overlap dF beyond the end of the table, by Gauss-Legendre quadrature on
  // panels of doubling length. The poles of the integrand are several panel lengths away, so 12
  // points have an error below 1e-12.
  [[gnu::noinline, gnu::cold, gnu::pure]] PLASTIGRAN_DEVICE double summed_complement(
      double s) const {
    double sum = 0;
    for (double left = 1; left < s; left *= 2)
      sum +=
          gauss_legendre([this](double at) { return complement(at); }, left, std::min(2 * left, s));
    return sum;
  }

  Tabulated<1> root_;   // s of first loading as a function of overlap/overlap_Y
  Tabulated<2> works_;  // work of loading to s and released energy, divided by P_Y overlap_Y
};

}  // namespace plastigran
