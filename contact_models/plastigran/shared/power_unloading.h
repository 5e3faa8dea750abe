// SPDX-License-Identifier: GPL-2.0-or-later
//
// Laws given by a virgin curve and a residual overlap, which unload along a power of the way left:
//
//   F = F_max y^n,   y = (overlap - overlap_res)/(overlap_max - overlap_res),   n = 3/2 for most
//
// A curve says the law in its own yield units, x = overlap/overlap_y and f = F/F_y, where overlap_y
// and F_y are the Hertzian values at its onset of yield:
//
//   yield_radius_ratio  r = a_y/R*: overlap_y = r^2 R*, F_y = 4/3 E* r^3 R*^2
//   breaks              where the formula changes, ascending; Hertz below the first
//   force(x)            f beyond the first break
//   recovery(x)         (overlap_max - overlap_res)/overlap_y after loading to x
//   contact_radius(x)   a/a_y beyond the first break
//   exponent(x)         optional: n, 3/2 where it says nothing
//   overlap_range()     optional: largest overlap over R* the curve is good for
//
// It says the rest of a law as contact.h has it: name, source, range, Parameters and what else it
// has to say; it is made from (MaterialPair, Parameters). The law itself is
//
//   using KogutEtsion = PowerUnloading<KogutEtsionCurve>;
//
// Near yield, and where the force jumps up, some published curves return more than was put in: the
// energy guard (energy_guard.h; on by default) shortens the rebound.
#pragma once

#include <algorithm>
#include <tuple>

#include "plastigran/shared/contact.h"
#include "plastigran/shared/energy_guard.h"
#include "plastigran/shared/hertz_contact.h"
#include "plastigran/shared/largest_overlap.h"
#include "plastigran/shared/power.h"
#include "plastigran/shared/tabulated.h"

namespace plastigran {

template <class Curve, class = void>
constexpr bool says_exponent = false;
template <class Curve>
constexpr bool says_exponent<Curve, std::void_t<decltype(&Curve::exponent)>> = true;

template <class Curve>
class PowerUnloading : public Curve, public LargestOverlap {
 public:
  struct Parameters : Curve::Parameters {
    int energy_guard = 1;
  };
  static constexpr auto parameters = [] {
    std::array<Parameter<Parameters>, parameters_of<Curve>.size()> all{};
    std::size_t k = 0;
    for (const auto& p : parameters_of<Curve>)
      all[k++] = {p.name, p.unit, p.value, p.lower, p.upper, p.meaning, p.per_body};
    return all;
  }();
  static constexpr auto options = [] {
    std::array<Option<Parameters>, options_of<Curve>.size() + 1> all{};
    std::size_t k = 0;
    for (const auto& o : options_of<Curve>) all[k++] = {o.name, o.value, o.choices, o.meaning};
    all[k] = energy_guard_option<Parameters>(&Parameters::energy_guard);
    return all;
  }();

  PowerUnloading(const MaterialPair& pair, const Parameters& constants)
      : Curve(pair, constants),
        modulus_(4.0 / 3.0 * pair.youngs_modulus_eff),
        overlap_ratio_(Curve::yield_radius_ratio * Curve::yield_radius_ratio) {
    const double yield = Curve::breaks[0];
    virgin_work_ =
        Tabulated<1>(
            yield, [this](double x) { return std::array{Curve::force(x)}; }, Curve::breaks)
            .integral(0.4 * yield * yield * std::sqrt(yield));
    if (constants.energy_guard == 1)
      guard_ = Guard(
          Curve::breaks, 1e3 * Curve::breaks.back(), [this](double x) { return virgin_work(x); },
          [this](double x) { return published_plastic_work(x); });
    works_ = Tabulated<2>(
        yield, [this](double x) { return computed_works(x); }, Curve::breaks);
    loaded_ = Tabulated<quantities>(
        yield, [this](double x) { return compute(x); }, Curve::breaks);
  }

  // Overlaps over R* where the formula changes: the virgin force may jump there.
  auto overlap_breaks() const {
    auto overlaps = Curve::breaks;
    for (double& overlap : overlaps) overlap *= overlap_ratio_;
    return overlaps;
  }

  Response respond(double radius_eff, double overlap, State& state) const {
    const double overlap_y = radius_eff * overlap_ratio_;
    if (state.overlap_max == 0 && overlap <= Curve::breaks[0] * overlap_y) {
      if (!(overlap > 0)) return {};
      return hertz_response(modulus_, radius_eff, overlap);
    }
    if (!(overlap > 0)) {
      if (!(state.overlap_max > 0)) return {};  // an overlap that is no number
      return {0, 0, 0, plastic_work(radius_eff, overlap_y, state.overlap_max)};
    }
    // Loading and unloading go two ways: the processor begins on the largest overlap of a contact
    // that unloads before it has the present one.
    if (overlap > state.overlap_max) {
      state.overlap_max = overlap;
      return answer(peak(radius_eff, overlap_y, overlap), 1);
    }
    const Peak reached = peak(radius_eff, overlap_y, state.overlap_max);
    const double y = 1 - (state.overlap_max - overlap) * reached.inverse_recovery;
    return answer(reached, y);
  }

 private:
  // What loading to x leaves, each over its value at yield. Who loads on asks for the first two.
  enum Quantity { FORCE, RADIUS, INVERSE_RECOVERY, EXPONENT };
  static constexpr std::size_t quantities = says_exponent<Curve> ? 4 : 3;
  typedef std::array<double, quantities> Values;

  // A contact at its largest overlap, and 1/(overlap_max - overlap_res).
  struct Peak {
    double force, inverse_recovery, contact_radius, exponent, plastic_work;
  };

  Peak peak(double radius_eff, double overlap_y, double overlap_max) const {
    const double per_overlap_y = 1 / overlap_y, x = overlap_max * per_overlap_y;
    const Values at = loaded_.covers(x) ? loaded_(x) : computed(x);
    const double radius_y = radius_eff * Curve::yield_radius_ratio;
    const double force_y = modulus_ * radius_y * overlap_y;
    return {force_y * at[FORCE], at[INVERSE_RECOVERY] * per_overlap_y, radius_y * at[RADIUS],
            exponent_in(at), plastic_work(radius_eff, overlap_y, overlap_max)};
  }

  double plastic_work(double radius_eff, double overlap_y, double overlap_max) const {
    const double x = overlap_max * (1 / overlap_y);
    const auto [taken, returned] = works_.covers(x) ? works_(x) : computed_works(x);
    return modulus_ * radius_eff * Curve::yield_radius_ratio * overlap_y * overlap_y *
           (taken - returned);
  }

  // At y of the way from the residual to the largest overlap.
  Response answer(const Peak& peak, double y) const {
    const double peak_energy = peak.force / (peak.inverse_recovery * (peak.exponent + 1));
    Response response;
    if (y > 0) {
      const double root = std::sqrt(y);
      double share = y * root;  // of the largest force
      if constexpr (says_exponent<Curve>)
        if (y < 1 && peak.exponent != 1.5) share *= power(y, peak.exponent - 1.5);
      response.force = peak.force * share;
      response.contact_radius = peak.contact_radius * root;
      response.elastic_energy = peak_energy * share * y;
    }
    response.plastic_work = peak.plastic_work;
    return response;
  }

  Values compute(double x) const {
    Values at{Curve::force(x), Curve::contact_radius(x), 1 / guarded_recovery(x)};
    if constexpr (says_exponent<Curve>) at[EXPONENT] = Curve::exponent(x);
    return at;
  }
  // Apart, where no table reaches.
  [[gnu::noinline, gnu::cold]] Values computed(double x) const { return compute(x); }

  static double exponent_in([[maybe_unused]] const Values& at) {
    if constexpr (says_exponent<Curve>)
      return at[EXPONENT];
    else
      return 1.5;
  }

  // The power n of unloading after loading to x.
  double exponent_after([[maybe_unused]] double x) const {
    if constexpr (says_exponent<Curve>)
      return Curve::exponent(x);
    else
      return 1.5;
  }

  // The virgin curve's work up to x, over F_y overlap_y.
  double virgin_work(double x) const {
    return virgin_work_.covers(x) ? virgin_work_(x)[0] : summed_work(x);
  }

  // The same where no table reaches: Hertz's below the first break, and beyond the table's end
  // summed on panels that double in length.
  [[gnu::noinline, gnu::cold, gnu::pure]] double summed_work(double x) const {
    if (!(x > Curve::breaks[0])) return 0.4 * x * x * std::sqrt(x);
    double left = virgin_work_.end(), sum = virgin_work_(left * (1 - 1e-15))[0];
    while (left < x) {
      double right = std::min(2 * left, x);
      for (double edge : Curve::breaks)
        if (edge > left) right = std::min(right, edge);
      sum += gauss_legendre([this](double at) { return Curve::force(at); }, left, right);
      left = right;
    }
    return sum;
  }

  // What loading to x takes and unloading returns, over F_y overlap_y.
  [[gnu::noinline, gnu::cold]] std::array<double, 2> computed_works(double x) const {
    return {virgin_work(x), Curve::force(x) * guarded_recovery(x) / (exponent_after(x) + 1)};
  }

  double published_plastic_work(double x) const {
    return virgin_work(x) - Curve::force(x) * Curve::recovery(x) / (exponent_after(x) + 1);
  }

  double guarded_recovery(double x) const {
    const double returned = virgin_work(x) - guard_.least_loss(x);
    return std::min(Curve::recovery(x), (exponent_after(x) + 1) * returned / Curve::force(x));
  }

  typedef EnergyGuard<std::tuple_size_v<decltype(Curve::breaks)>> Guard;

  double modulus_;               // 4/3 E*
  double overlap_ratio_;         // overlap_y / R*
  Guard guard_;                  // of x, over F_y overlap_y
  Tabulated<1, 9> virgin_work_;  // of the virgin curve, over F_y overlap_y
  Tabulated<2> works_;           // it, and what unloading returns
  Tabulated<quantities> loaded_;
};

}  // namespace plastigran
