// SPDX-License-Identifier: GPL-2.0-or-later
//
// Table of a law that is defined by a first-loading curve and a residual overlap. The host builds
// the table once per pair of materials; the force loop reads it. The table is trivially copyable.
//
// A class Curve defines the law in yield units, x = overlap/overlap_y and f = F/F_y:
//
//   yield_radius_ratio  r = a_y/R*: overlap_y = r^2 R*, F_y = 4/3 E* r^3 R*^2
//   breaks              values of x where the formula changes, ascending; elastic below the first
//   force(x)            f beyond the first break
//   recovery(x)         (overlap_max - overlap_res)/overlap_y after loading to x
//   contact_radius(x)   a/a_y beyond the first break
//
// Curve also has the members of contact.h that describe a law: name, source, range, Parameters. Its
// constructor takes (MaterialPair, Parameters).
//
// A class Unloading (unloading.h) defines the shape of the unloading curve between overlap_res and
// overlap_max.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>
#include <type_traits>

#include "plastigran/shared/contact.h"
#include "plastigran/shared/device.h"
#include "plastigran/shared/largest_overlap.h"
#include "plastigran/shared/numerics.h"
#include "plastigran/tables/energy_guard.h"
#include "plastigran/tables/tabulated.h"
#include "plastigran/tables/unloading.h"

namespace plastigran {

template <class Curve, class Unloading>
class CurveTable : public Curve, public LargestOverlap {
 public:
  typedef Unloading Rebound;
  static constexpr bool has_guard = false;

  CurveTable(const MaterialPair& pair, const typename Curve::Parameters& constants,
             bool guarded = false)
      : Curve(pair, constants),
        modulus_(4.0 / 3.0 * pair.youngs_modulus_eff),
        overlap_ratio_(Curve::yield_radius_ratio * Curve::yield_radius_ratio) {
    const double yield = Curve::breaks[0];
    loading_work_ =
        Tabulated<1>(
            yield, [this](double x) { return std::array{Curve::force(x)}; }, Curve::breaks)
            .integral(unloading_.elastic_work(yield));
    if (guarded)
      guard_ = Guard(
          Curve::breaks, 1e3 * Curve::breaks.back(), [this](double x) { return loading_work(x); },
          [this](double x) { return published_plastic_work(x); });
    works_ = Tabulated<2>(
        yield, [this](double x) { return computed_works(x); }, Curve::breaks);
    loaded_ = Tabulated<quantities>(
        yield, [this](double x) { return compute(x); }, Curve::breaks);
  }

  PLASTIGRAN_DEVICE Response respond(double radius_eff, double overlap, State& state) const {
    const double overlap_y = radius_eff * overlap_ratio_;
    if (state.overlap_max == 0 && overlap <= Curve::breaks[0] * overlap_y) {
      if (!(overlap > 0)) return {};
      return unloading_.elastic(modulus_, radius_eff, Curve::yield_radius_ratio, overlap);
    }
    if (!(overlap > 0)) {
      if (!(state.overlap_max > 0)) return {};  // overlap is NaN
      return {0, 0, 0, plastic_work(radius_eff, overlap_y, state.overlap_max)};
    }
    // Keep two branches. During unloading, the table look-up needs only the stored overlap_max, so
    // the processor can start it before the current overlap is known.
    if (overlap > state.overlap_max) {
      state.overlap_max = overlap;
      return unloading_.at_largest(peak(radius_eff, overlap_y, overlap));
    }
    const Peak reached = peak(radius_eff, overlap_y, state.overlap_max);
    const double y = 1 - (state.overlap_max - overlap) * reached.inverse_recovery;
    return unloading_.at(reached, y);
  }

  // Members that adhesive.h needs. elastic_range() returns overlap/R* at the end of the elastic
  // formula. after_loading(x) returns the quantities of a contact loaded to x > 1 times this
  // overlap.
  double elastic_range() const { return Curve::breaks[0] * overlap_ratio_; }
  PLASTIGRAN_DEVICE Peak after_loading(double x) const {
    const double unit = Curve::breaks[0], root = std::sqrt(unit);
    const Values at = compute(x * unit);
    double shape = Unloading::usual_shape;
    if constexpr (Unloading::has_shape) shape = at[SHAPE];
    return {at[FORCE] / (unit * root), at[RADIUS] / root, at[INVERSE_RECOVERY] * unit, shape, 0};
  }
  auto kinks() const {
    auto at = Curve::breaks;
    for (double& x : at) x /= Curve::breaks[0];
    return at;
  }

 private:
  // Quantities of a contact loaded to x = overlap/overlap_y, in yield units. Force and contact
  // radius of first loading need only the first two.
  enum Quantity { FORCE, RADIUS, INVERSE_RECOVERY, SHAPE };
  static constexpr std::size_t quantities = Unloading::has_shape ? 4 : 3;
  typedef std::array<double, quantities> Values;

  PLASTIGRAN_DEVICE Peak peak(double radius_eff, double overlap_y, double overlap_max) const {
    const double per_overlap_y = 1 / overlap_y, x = overlap_max * per_overlap_y;
    const Values at = loaded_.covers(x) ? loaded_(x) : computed(x);
    const double radius_y = radius_eff * Curve::yield_radius_ratio;
    const double force_y = modulus_ * radius_y * overlap_y;
    double shape = Unloading::usual_shape;
    if constexpr (Unloading::has_shape) shape = at[SHAPE];
    return {force_y * at[FORCE], radius_y * at[RADIUS], at[INVERSE_RECOVERY] * per_overlap_y, shape,
            plastic_work(radius_eff, overlap_y, overlap_max)};
  }

  PLASTIGRAN_DEVICE double plastic_work(double radius_eff, double overlap_y,
                                        double overlap_max) const {
    const double x = overlap_max * (1 / overlap_y);
    const auto [taken, returned] = works_.covers(x) ? works_(x) : computed_works(x);
    return modulus_ * radius_eff * Curve::yield_radius_ratio * overlap_y * overlap_y *
           (taken - returned);
  }

  PLASTIGRAN_DEVICE Values compute(double x) const {
    Values at{Curve::force(x), Curve::contact_radius(x), 1 / guarded_recovery(x)};
    if constexpr (Unloading::has_shape) at[SHAPE] = unloading_.shape(*this, x);
    return at;
  }
  // Computes the quantities of a contact loaded to x = overlap/overlap_y, beyond the end of the
  // table.
  [[gnu::noinline, gnu::cold]] PLASTIGRAN_DEVICE Values computed(double x) const {
    return compute(x);
  }

  // Returns the work of loading to x = overlap/overlap_y, divided by F_y overlap_y.
  PLASTIGRAN_DEVICE double loading_work(double x) const {
    return loading_work_.covers(x) ? loading_work_(x)[0] : summed_work(x);
  }
  // Returns the work of loading beyond the end of the table, integrated on panels of doubling
  // length.
  [[gnu::noinline, gnu::cold, gnu::pure]] PLASTIGRAN_DEVICE double summed_work(double x) const {
    if (!(x > Curve::breaks[0])) return unloading_.elastic_work(x);
    double left = loading_work_.end(), sum = loading_work_(left * (1 - 1e-15))[0];
    while (left < x) {
      double right = std::min(2 * left, x);
      for (double edge : Curve::breaks)
        if (edge > left) right = std::min(right, edge);
      sum += gauss_legendre([this](double at) { return Curve::force(at); }, left, right);
      left = right;
    }
    return sum;
  }

  // Returns two values for loading to x = overlap/overlap_y: the work of loading, and the energy
  // that unloading releases. Both are divided by F_y overlap_y.
  [[gnu::noinline, gnu::cold]] PLASTIGRAN_DEVICE std::array<double, 2> computed_works(
      double x) const {
    return {loading_work(x), Curve::force(x) * guarded_recovery(x) / work_ratio(x)};
  }
  double published_plastic_work(double x) const {
    return loading_work(x) - Curve::force(x) * Curve::recovery(x) / work_ratio(x);
  }
  PLASTIGRAN_DEVICE double guarded_recovery(double x) const {
    const double returned = loading_work(x) - guard_.least_loss(x);
    return std::min(Curve::recovery(x), work_ratio(x) * returned / Curve::force(x));
  }
  // Returns F_max (overlap_max - overlap_res) divided by the energy released by unloading.
  PLASTIGRAN_DEVICE double work_ratio(double x) const {
    return unloading_.work_ratio(unloading_.shape(*this, x));
  }

  typedef EnergyGuard<std::tuple_size_v<decltype(Curve::breaks)>> Guard;

  double modulus_;        // 4/3 E* [Pa]
  double overlap_ratio_;  // overlap_y/R* [-]
  Unloading unloading_;
  Guard guard_;                   // lower limit of plastic work divided by F_y overlap_y, versus x
  Tabulated<1, 9> loading_work_;  // work of loading divided by F_y overlap_y
  Tabulated<2> works_;            // work of loading and released energy, divided by F_y overlap_y
  Tabulated<quantities> loaded_;
};

// Table of a law with the option energy_guard (energy_guard.h). Near yield, or where the force
// jumps up, the published curves of such a law release more energy than loading took. There, the
// guard (on by default) reduces the recovered overlap.
template <class Curve, class Unloading>
class GuardedTable : public CurveTable<Curve, Unloading> {
 public:
  static constexpr bool has_guard = true;

  struct Parameters : Curve::Parameters {
    int energy_guard = 1;
  };
  static constexpr auto parameters = inherited_parameters<Curve, Parameters>();
  static constexpr auto options = inherited_options<Curve, Parameters>(
      energy_guard_option<Parameters>(&Parameters::energy_guard));

  GuardedTable(const MaterialPair& pair, const Parameters& constants)
      : CurveTable<Curve, Unloading>(pair, constants, constants.energy_guard == 1) {}
};

}  // namespace plastigran
