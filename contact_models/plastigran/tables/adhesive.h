// SPDX-License-Identifier: GPL-2.0-or-later
//
// Law with the option `adhesion jkr`: adds adhesion to a law whose contacts are elastic at first
// touch. docs/adhesion.md explains the equations. The index 1 marks values without adhesion. D is
// the displacement due to adhesion, S is the slope dF_1/d(overlap_1) of unloading, U_1 is the
// elastic energy, and c = (2 pi Gamma/E*)^(1/2):
//
//   overlap = overlap_1 - D,   F = F_1 - S D
//   D = c (R* overlap_1)^(1/4)        first loading
//   D^2/S constant                    unloading
//   surface energy = -S D^2/4,   elastic + surface energy = U_1 - F_1 D + S D^2/4
//
// Up to yield, these are the equations of shared/adhesion.h. Adhesion delays first yield to the
// contact radius a_y. Beyond yield, the law without adhesion is used with k times its yield
// strength:
//
//   p_y + p_c = 2 E* a_y/(pi R*),   p_c = (2 Gamma E*/(pi a_y))^(1/2),   k = 1 + p_c/p_y
//
// Sources: Maugis 2000, Contact, Adhesion and Rupture of Elastic Solids, ch. 4 (forces); Thornton &
// Ning 1998, Powder Technol. 99:154 (yield, and D of first loading beyond yield).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "plastigran/shared/adhesion.h"
#include "plastigran/shared/contact.h"
#include "plastigran/shared/device.h"
#include "plastigran/shared/numerics.h"
#include "plastigran/tables/adhesive_work.h"
#include "plastigran/tables/tabulated.h"
#include "plastigran/tables/unloading.h"

namespace plastigran {

// Whether a law can have the option `adhesion jkr`.
template <class Law, class = void>
constexpr bool takes_adhesion = false;
template <class Law>
constexpr bool takes_adhesion<Law, std::void_t<decltype(&Law::Rebound::energy_at)>> = true;

// Whether after_loading() of a law is a formula that is faster than a table.
template <class Law, class = void>
constexpr bool has_closed_form = false;
template <class Law>
constexpr bool has_closed_form<Law, std::void_t<decltype(Law::closed_form)>> = Law::closed_form;

template <class Law>
class Adhesive {
 public:
  static constexpr const char* name = Law::name;
  static constexpr const char* line_option = " adhesion jkr";
  static constexpr const char* source = Law::source;
  static constexpr const char* range = Law::range;
  static constexpr bool adhesive = true;
  static constexpr bool hardens = plastigran::hardens<Law>;
  static constexpr bool indentation = plastigran::indentation<Law>;

  struct Parameters : Law::Parameters {
    double surface_energy = required;
  };
  static constexpr auto parameters = inherited_parameters<Law, Parameters>(
      Parameter<Parameters>{"surface_energy", "J/m^2", &Parameters::surface_energy, 0, 1e3,
                            "work of adhesion Gamma of the two surfaces"});
  static constexpr auto options = inherited_options<Law, Parameters>();

  struct State {
    double in_contact = 0;       // 1 from first touch to pull-off
    double strength_factor = 0;  // k; 0 before first touch
    double overlap_max = 0;      // largest overlap_1 beyond yield [m]; 0 while elastic
  };
  static constexpr std::array<const char*, 3> state_names{"in_contact", "strength_factor",
                                                          "overlap_max"};

  Adhesive(const MaterialPair& pair, const Parameters& constants)
      : law_(pair, constants),
        contact_(pair.youngs_modulus_eff, constants.surface_energy),
        elastic_range_(law_.elastic_range()),
        yield_radius_ratio_(std::sqrt(elastic_range_)),
        onset_(0.5 * contact_.pull() / std::pow(elastic_range_, 0.75)),
        work_(law_) {
    if constexpr (!has_closed_form<Law>)
      loaded_ = Tabulated<quantities>(
          1, [this](double x) { return loaded(x); }, kinks_of(law_));
  }

  double overlap_range() const { return plastigran::overlap_range(law_); }
  double pull_off_distance(double radius_eff) const {
    return -contact_.pull_off_overlap(radius_eff);
  }
  // Returns the values of overlap/R* at which the force of first loading may jump.
  std::vector<double> overlap_breaks(double radius_eff) const {
    std::vector<double> all;
    const double k = strength_factor(radius_eff);
    if constexpr (energy_guarded<Law>)
      for (const double x : kinks_of(law_)) {
        const double without = x * k * k * elastic_range_;
        const double overlap =
            without - contact_.pull() / std::sqrt(radius_eff) * std::sqrt(std::sqrt(without));
        if (overlap > 0) all.push_back(overlap);
      }
    return all;
  }
  PLASTIGRAN_DEVICE double pull_off_force(double radius_eff, double, const State& state) const {
    if (state.overlap_max == 0) return contact_.pull_off_force(radius_eff);
    return pull_off_force(peak_of(radius_eff, state));
  }

  // Returns elastic energy plus surface energy [J] of a contact that has just formed (`forms`) or
  // is about to break.
  double energy_at_end(double radius_eff, const State& before, bool forms) const {
    if (before.overlap_max == 0) return contact_.energy_at_end(radius_eff, forms);
    const Peak peak = peak_of(radius_eff, before);
    double broken = -2, joined = 0;  // (overlap - overlap_res)/(overlap_max - overlap_res)
    if (!forms) halve(broken, joined, [&](double beyond) { return point(peak, beyond).root > 0; });
    const Response end = unloading(peak, point(peak, joined));
    return end.elastic_energy + end.surface_energy;
  }

  PLASTIGRAN_DEVICE Response respond(double radius_eff, double overlap, State& state) const {
    if (state.overlap_max == 0) {
      if (state.in_contact == 0) {
        if (!(overlap > 0)) return {};
        state.strength_factor = strength_factor(radius_eff);
      } else if (!(overlap > 0) && !(overlap >= contact_.pull_off_overlap(radius_eff))) {
        state.in_contact = 0;
        return {};
      }
      state.in_contact = 1;
      const double s = contact_.root(radius_eff, overlap), without = overlap + contact_.pull() * s;
      if (!(without > overlap_y(radius_eff, state))) return contact_.at(radius_eff, s);
      return loading(radius_eff, s, without, state);
    }
    const double pull = pull_of(radius_eff, state.overlap_max);
    if (overlap > state.overlap_max - pull) {
      const double s = contact_.root(radius_eff, overlap), without = overlap + contact_.pull() * s;
      return loading(radius_eff, s, std::max(state.overlap_max, without), state);
    }
    const Peak peak = peak_of(radius_eff, state, pull);
    const double beyond = 1 - (state.overlap_max - overlap) * peak.inverse_recovery;
    Point at{};
    if (state.in_contact != 0 || beyond > 0) at = point(peak, beyond);
    state.in_contact = at.root > 0;
    return with_work(at.root > 0 ? unloading(peak, at) : Response(), peak, radius_eff, state);
  }

 private:
  typedef typename Law::Rebound Rebound;
  static constexpr bool may_stiffen = energy_guarded<Law>;
  enum Quantity { FORCE, INVERSE_RECOVERY, RADIUS };
  static constexpr std::size_t stiffening = 3, shape = stiffening + may_stiffen,
                               quantities = shape + Rebound::has_shape;
  typedef std::array<double, quantities> Values;

  // Values of a contact at its largest overlap.
  struct Peak {
    double force, slope, pull;  // F_1, S and D
    double contact_radius, inverse_recovery, shape;
  };

  PLASTIGRAN_DEVICE Values loaded(double x) const {
    const auto at = law_.after_loading(x);
    Values values{at.force, at.inverse_recovery, at.contact_radius};
    if constexpr (may_stiffen) values[stiffening] = work_.eta(x, work_.after_loading(law_, x));
    if constexpr (Rebound::has_shape) values[shape] = at.shape;
    return values;
  }
  [[gnu::noinline, gnu::cold]] PLASTIGRAN_DEVICE Values computed(double x) const {
    return loaded(x);
  }

  // Returns k, the factor of the yield strength that represents adhesion beyond yield. A lower
  // limit of k keeps number(), the measure B of adhesion, below the largest B of adhesive_work.h.
  [[gnu::noinline, gnu::cold]] PLASTIGRAN_DEVICE double strength_factor(double radius_eff) const {
    const double b = onset_ / std::sqrt(radius_eff);
    const double q = root_at_yield(b);
    const double least = 2 * b / work_.largest_number();
    return std::max(q * q, std::cbrt(least * least));
  }

  // Returns overlap_y of the law with k times its yield strength. For this law, F_k(R*, overlap) =
  // F(k^2 R*, overlap)/k.
  PLASTIGRAN_DEVICE double overlap_y(double radius_eff, const State& state) const {
    return state.strength_factor * state.strength_factor * elastic_range_ * radius_eff;
  }
  // Returns the contact radius a_y at first yield with adhesion [m].
  PLASTIGRAN_DEVICE double yield_radius(double radius_eff, const State& state) const {
    return state.strength_factor * yield_radius_ratio_ * radius_eff;
  }
  // Returns B = c R*/a_y^(3/2), which measures adhesion. B is 2 (1 - 1/k) unless k is at its lower
  // limit. In first loading, the displacement due to adhesion is D = B x^(1/4) overlap_y with
  // x = overlap_1/overlap_y.
  PLASTIGRAN_DEVICE double number(double radius_eff, const State& state) const {
    const double k = state.strength_factor;
    return 2 * onset_ / std::sqrt(radius_eff * k * k * k);
  }

  PLASTIGRAN_DEVICE double pull_of(double radius_eff, double overlap_max) const {
    return contact_.pull() * std::sqrt(std::sqrt(radius_eff * overlap_max));
  }
  // Returns the response of first loading. `without` is overlap_1, the overlap of the same contact
  // without adhesion; `s` is the square root of the contact radius in the JKR equations.
  PLASTIGRAN_DEVICE Response loading(double radius_eff, double s, double without,
                                     State& state) const {
    state.in_contact = 1;
    state.overlap_max = without;
    const Peak peak = peak_of(radius_eff, state, contact_.pull() * s);
    return with_work(unloading(peak, largest()), peak, radius_eff, state);
  }

  PLASTIGRAN_DEVICE Peak peak_of(double radius_eff, const State& state) const {
    return peak_of(radius_eff, state, pull_of(radius_eff, state.overlap_max));
  }
  PLASTIGRAN_DEVICE Peak peak_of(double radius_eff, const State& state, double pull) const {
    const double unit = overlap_y(radius_eff, state), per_unit = 1 / unit;
    const double x = state.overlap_max * per_unit;
    const Values at = has_closed_form<Law> ? loaded(x)
                      : loaded_.covers(x)  ? loaded_(x)
                                           : computed(x);
    const double radius_y = yield_radius(radius_eff, state);
    double shape_at_x = Rebound::usual_shape;
    if constexpr (Rebound::has_shape) shape_at_x = at[shape];
    Peak peak;
    peak.force = 4.0 / 3.0 * contact_.modulus() * radius_y * unit * at[FORCE];
    peak.inverse_recovery = per_unit * at[INVERSE_RECOVERY];
    if constexpr (may_stiffen)
      peak.inverse_recovery *= 1 + number(radius_eff, state) * at[stiffening];
    peak.slope = Rebound::largest_slope(shape_at_x) * peak.force * peak.inverse_recovery;
    peak.pull = pull;
    peak.contact_radius = radius_y * at[RADIUS];
    peak.shape = shape_at_x;
    return peak;
  }

  PLASTIGRAN_DEVICE double pull_off_force(const Peak& peak) const {
    const double b = peak.pull * peak.inverse_recovery;
    return peak.slope * peak.pull * work_.rebound().pull_off(b, peak.shape);
  }

  // Point of the unloading curve, where root^2 = y = (overlap_1 - overlap_res)/(overlap_max -
  // overlap_res). Force and root of the slope are divided by their values at the largest overlap.
  struct Point {
    double root, force, root_of_slope;
  };
  PLASTIGRAN_DEVICE static Point largest() { return {1, 1, 1}; }

  // Returns the point of unloading at an overlap. `beyond` is (overlap - overlap_res)/(overlap_max
  // - overlap_res). With the slope S of unloading, and b = D/(overlap_max - overlap_res) at the
  // largest overlap, y is the largest root of y - b (S/S_max)^(1/2) = beyond. Without a root, the
  // contact breaks, and y is 0.
  PLASTIGRAN_DEVICE Point point(const Peak& peak, double beyond) const {
    const double b = peak.pull * peak.inverse_recovery;
    if constexpr (Rebound::is_hertzian) {
      const double w = adhesive_root(beyond, b), root = w * w;  // S^(1/2) is proportional to w
      // If no root exists, adhesive_root() returns the w of pull-off. Therefore check that a root
      // exists.
      const bool joined =
          beyond > 0 || 4 * w * root > b * (1 + 1e-7) || w * (w * root - b) <= beyond;
      return joined ? Point{root, root * root * root, w} : Point{};
    } else {
      return point_of_any_shape(peak, b, beyond);
    }
  }
  // Solves the equation of point() for y by Newton's method. For weak adhesion, the equation is
  // nearly linear in y. The start value is a series, valid for a slope that is a power of y. The
  // last term of the series is exact only for a Hertz contact.
  PLASTIGRAN_DEVICE Point point_of_any_shape(const Peak& peak, double b, double beyond) const {
    const double start = std::sqrt(beyond);
    ShapeOfUnloading at = work_.rebound().shape_at(start, peak.shape);
    const double e = b * at.root_of_slope * (1 / beyond);
    if (!(beyond > 0 && e <= 0.5)) return point_near_pull_off(peak, b, beyond);
    double root = start * (1 + e * (0.5 + e * (0.5 * at.exponent - 0.125 - 0.015625 * e)));
    for (;;) {
      at = work_.rebound().shape_at(root, peak.shape);
      const double y = root * root, pulled = b * at.root_of_slope;
      const double change = (beyond + pulled - y) / (y - at.exponent * pulled);
      root *= 1 + change * (0.5 - change * (0.125 - 0.0625 * change));
      // At this limit, the relative error of y is less than 1e-12. After such a small last change,
      // two terms of a series give the force and the slope.
      if (!(e * change * change > 1e-11)) {
        const double root_of_slope =
            at.root_of_slope * (1 + at.exponent * change * (1 + 0.5 * (at.exponent - 1) * change));
        const double slopes = at.root_of_slope * at.root_of_slope + root_of_slope * root_of_slope;
        const double rise = 0.5 * Rebound::largest_slope(peak.shape) * y * change * slopes;
        return {root, at.force + rise, root_of_slope};
      }
    }
  }
  [[gnu::noinline]] PLASTIGRAN_DEVICE Point point_near_pull_off(const Peak& peak, double b,
                                                                double beyond) const {
    double w = refined_root(peak.shape, b, beyond, adhesive_root(beyond, b));
    if (!(w > 0)) w = refined_root(peak.shape, b, beyond, 1);
    const ShapeOfUnloading at = work_.rebound().shape_at(w * w, peak.shape);
    return {w * w, at.force, at.root_of_slope};
  }
  // Improves w = y^(1/4) by Newton's method. The function is convex where it rises, so after the
  // first steps w only decreases. Each step squares the error: after a step of 1e-7 it is about
  // 1e-14.
  PLASTIGRAN_DEVICE double refined_root(double shape_at_x, double b, double beyond,
                                        double w) const {
    for (int k = 0; k < 100; ++k) {
      const ShapeOfUnloading at = work_.rebound().shape_at(w * w, shape_at_x);
      const double cube = w * w * w, rise = 4 * (cube - b * at.root_of_slope * at.exponent / w);
      if (!(rise > 0)) return 0;
      const double step = (cube * w - b * at.root_of_slope - beyond) / rise;
      w -= step;
      if (!(w > 0)) return 0;
      if (std::abs(step) <= 1e-7 * w || (k > 8 && step <= 0)) return std::min(w, 1.0);
    }
    return 0;
  }

  PLASTIGRAN_DEVICE Response unloading(const Peak& peak, const Point& at) const {
    const double slope = peak.slope * (at.root_of_slope * at.root_of_slope);
    const double pull = peak.pull * at.root_of_slope;
    const double force = peak.force * at.force, pulling = slope * pull;
    Response response;
    response.force = force - pulling;
    response.contact_radius = peak.contact_radius * work_.rebound().contact_radius_at(
                                                        at.root, at.root_of_slope, peak.shape);
    response.elastic_energy =
        peak.force / peak.inverse_recovery * work_.rebound().energy_at(at.root, peak.shape) -
        (force - 0.5 * pulling) * pull;
    response.surface_energy = -0.25 * pulling * pull;
    response.pull_off_force = pull_off_force(peak);
    return response;
  }

  // Adds the plastic work: work of first loading minus elastic and surface energy at the largest
  // overlap.
  PLASTIGRAN_DEVICE Response with_work(Response response, const Peak& peak, double radius_eff,
                                       const State& state) const {
    const double unit = overlap_y(radius_eff, state);
    const Response at_largest = unloading(peak, largest());
    response.plastic_work = 4.0 / 3.0 * contact_.modulus() * yield_radius(radius_eff, state) *
                                unit * unit *
                                work_(law_, state.overlap_max / unit, number(radius_eff, state)) -
                            at_largest.elastic_energy - at_largest.surface_energy;
    return response;
  }

  Law law_;
  JkrContact contact_;
  double elastic_range_;       // overlap_y/R*
  double yield_radius_ratio_;  // a_y/R*
  double onset_;               // b R*^(1/2) with the argument b of root_at_yield() [m^(1/2)]
  WorkOfLoading<Law> work_;
  Tabulated<quantities> loaded_;  // empty if `has_closed_form`
};

}  // namespace plastigran
