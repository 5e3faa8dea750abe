// SPDX-License-Identifier: GPL-2.0-or-later
//
// Work of first loading of a law with adhesion (adhesive.h). It depends on x = overlap_1/overlap_y
// and on B = c R*/a_y^(3/2) with c = (2 pi Gamma/E*)^(1/2), which measures adhesion. a_y, the
// contact radius at yield, is proportional to the strength factor k of a contact.
//
// The work of first loading is a polynomial in B, whose coefficients are tabulated as functions of
// x. Plastic work is this work minus the elastic and surface energy at the largest overlap.
//
// For a large B, plastic work would decrease with x, as in the law of Thornton & Ning. The
// constructor finds the largest B, up to 0.8, for which plastic work increases. A lower limit of k
// keeps contacts at or below this B. If the energy guard of a law keeps plastic work constant in an
// interval of x, even a small B would make it decrease. In this interval, a factor 1 + B eta(x)
// therefore increases the slope of unloading.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "plastigran/shared/device.h"
#include "plastigran/shared/numerics.h"
#include "plastigran/tables/tabulated.h"

namespace plastigran {

template <class Law, class = void>
constexpr bool energy_guarded = false;
template <class Law>
constexpr bool energy_guarded<Law, std::void_t<decltype(Law::has_guard)>> = Law::has_guard;

// Returns the values x = overlap/overlap_y at which the curves of a law have kinks or jumps.
template <class Law>
auto kinks_of([[maybe_unused]] const Law& law) {
  if constexpr (energy_guarded<Law>)
    return law.kinks();
  else
    return std::array<double, 1>{1};
}

// Values of a law without adhesion after first loading to x = overlap/overlap_y, in yield units.
// The slope does not contain the factor 1 + B eta, which the energy guard adds.
struct AfterLoading {
  double force, slope, energy;
};

// Work of first loading of a law with adhesion. The functions take the law as an argument instead
// of storing a pointer, so that the object can be copied.
template <class Law>
class WorkOfLoading {
 public:
  typedef typename Law::Rebound Rebound;

  explicit WorkOfLoading(const Law& law) {
    tabulate(law, 0);
    guard(law);
  }

  // Returns the shape of the unloading curve (unloading.h).
  PLASTIGRAN_DEVICE const Rebound& rebound() const { return rebound_; }

  // Returns the largest value that B, the measure of adhesion, may have.
  PLASTIGRAN_DEVICE double largest_number() const { return largest_number_; }

  PLASTIGRAN_DEVICE AfterLoading after_loading(const Law& law, double x) const {
    const auto at = law.after_loading(x);
    const double recovery = 1 / at.inverse_recovery;
    return {at.force, Rebound::largest_slope(at.shape) * at.force / recovery,
            at.force * recovery * rebound_.energy_at(1, at.shape)};
  }

  // Returns the work of first loading to x = overlap_1/overlap_y, divided by F_y overlap_y. B
  // measures adhesion.
  PLASTIGRAN_DEVICE double operator()(const Law& law, double x, double B) const {
    return polynomial(works_at(law, x), B);
  }

  // Returns eta at x = overlap_1/overlap_y. The factor 1 + B eta increases the slope of unloading;
  // eta is 0 for a law without energy guard.
  PLASTIGRAN_DEVICE double eta(double x, const AfterLoading& at) const {
    if constexpr (!energy_guarded<Law>) return 0;
    double work = 0;
    for (const Interval& interval : intervals_)
      if (x > interval.begin && interval.end > 0)
        work += loading_(std::min(x, interval.end))[0] - loading_(interval.begin)[0];
    return lost_ * work / at.energy;
  }

 private:
  typedef std::array<double, 4> Works;  // w_0 to w_3 of the work w_0 - w_1 B + w_2 B^2 + w_3 B^3

  // Returns the derivatives of the work coefficients w_0 to w_3 with respect to x.
  PLASTIGRAN_DEVICE Works powers(const Law& law, double x) const {
    const AfterLoading at = after_loading(law, x);
    const double d = std::sqrt(std::sqrt(x)), slope_of_d = 0.25 * d / x,
                 more = eta(x, at) * at.slope;
    return {at.force, at.slope * d + at.force * slope_of_d, d * (at.slope * slope_of_d - more),
            more * d * slope_of_d};
  }
  // Returns the derivative of the function in table k: w_0, w_1, w_2 or w_0 + w_3. The last table
  // contains the sum because of round-off: near the start of an interval, eta is a difference of
  // nearly equal works, so the round-off of w_3 is small only compared with w_0.
  PLASTIGRAN_DEVICE double derivative(const Law& law, double x, std::size_t k) const {
    const Works all = powers(law, x);
    return k == 3 ? all[0] + all[3] : all[k];
  }
  // Builds the tables of the work coefficients w_k for k >= `first`. If only lost_ has changed,
  // first = 2 suffices: w_0 and w_1 do not depend on lost_.
  void tabulate(const Law& law, std::size_t first) {
    constexpr Works at_yield{0.4, 1, 0.375, 0.4};  // values of the JKR contact in tables 0 to 3
    for (std::size_t k = first; k < works_.size(); ++k) {
      const auto in_table = [&](double x) { return std::array{derivative(law, x, k)}; };
      works_[k] = Tabulated<1>(1, in_table, kinks_of(law)).integral(at_yield[k]);
    }
    end_ = works_[0].end();
    for (const auto& table : works_) end_ = std::min(end_, table.end());
  }
  // Returns the work coefficients w_0 to w_3 beyond the end of their tables, by quadrature.
  [[gnu::noinline, gnu::cold, gnu::pure]] PLASTIGRAN_DEVICE Works summed(const Law& law,
                                                                         double x) const {
    Works sum{};
    for (std::size_t k = 0; k < works_.size(); ++k) {
      double left = std::min(x, works_[k].end());
      sum[k] = works_[k](left * (1 - 1e-15))[0];
      for (double right; left < x; left = right) {
        right = std::min(2 * left, x);
        sum[k] += gauss_legendre([&](double at) { return derivative(law, at, k); }, left, right);
      }
    }
    if constexpr (energy_guarded<Law>) sum[3] -= sum[0];
    return sum;
  }
  PLASTIGRAN_DEVICE Works works_at(const Law& law, double x) const {
    if (!(x >= 1 && x < end_)) return summed(law, x);
    Works all{works_[0](x)[0], works_[1](x)[0], works_[2](x)[0]};
    if constexpr (energy_guarded<Law>) all[3] = works_[3](x)[0] - all[0];
    return all;
  }
  PLASTIGRAN_DEVICE static double polynomial(const Works& w, double B) {
    return w[0] - B * (w[1] - B * (w[2] + B * w[3]));
  }

  // Values after first loading to x that do not depend on B, the measure of adhesion.
  struct Sample {
    double x, eta;
    AfterLoading at;
    Works works;

    double plastic_work(double B) const {
      const double d = std::sqrt(std::sqrt(x)), stiffer = 1 + B * eta;
      return polynomial(works, B) - at.energy / stiffer +
             B * d * (at.force - 0.25 * B * d * at.slope * stiffer);
    }
  };
  std::vector<Sample> samples(const Law& law) const {
    std::vector<Sample> all;
    for (const double x : points(law)) {
      const AfterLoading at = after_loading(law, x);
      all.push_back({x, eta(x, at), at, works_at(law, x)});
    }
    return all;
  }
  // Returns whether plastic work decreases from one value of x to the next.
  static bool falls(const Sample& from, const Sample& to, double B) {
    return to.plastic_work(B) < from.plastic_work(B) - 1e-13 * to.works[0];
  }
  // Returns whether plastic work increases with x, tested at four fractions of B.
  static bool grows(const std::vector<Sample>& all, double B) {
    for (const double part : {0.1, 0.4, 0.7, 1.0})
      for (std::size_t k = 1; k < all.size(); ++k)
        if (falls(all[k - 1], all[k], part * B)) return false;
    return true;
  }
  // Returns the values of x at which plastic work is compared. They are dense on both sides of each
  // kink.
  static std::vector<double> points(const Law& law) {
    std::vector<double> all;
    const auto kinks = kinks_of(law);
    for (double x = 1 + 1e-9; x < 1e3;) {
      all.push_back(x);
      double last = 1, next = 1e3;
      for (const double kink : kinks) {
        if (kink <= x) last = std::max(last, kink);
        if (kink > x) next = std::min(next, kink);
      }
      const double below = next * (1 - 1e-9);
      const double further = x + std::min(0.003 * x, std::max(0.25 * (x - last), 1e-9 * x));
      x = x >= below ? next * (1 + 1e-9) : std::min(further, below);
    }
    return all;
  }

  // Finds the largest B at which plastic work increases with x. If a law with an energy guard would
  // not reach B = 0.4, increases lost_, the lost fraction of the work per unit of B, until it does.
  void guard(const Law& law) {
    std::vector<Sample> all = samples(law);
    const auto lower_to = [&](double least) {
      for (largest_number_ = 0.8; largest_number_ > least; largest_number_ *= 0.95)
        if (grows(all, largest_number_)) return true;
      return false;
    };
    constexpr double guarded_number = 0.4;
    if (!energy_guarded<Law> || lower_to(guarded_number)) {
      lower_to(0.01);
      return;
    }
    largest_number_ = guarded_number;
    loading_ = works_[0];
    find_intervals(all);
    for (lost_ = 0.02; lost_ < 1; lost_ *= 1.5) {
      tabulate(law, 2);
      all = samples(law);
      if (grows(all, largest_number_)) return;
    }
    lost_ = 0;
    tabulate(law, 2);
    all = samples(law);
    lower_to(0.01);
  }
  // Finds the intervals of x in which plastic work decreases, and extends them by 2 % on each side.
  void find_intervals(const std::vector<Sample>& all) {
    std::size_t count = 0;
    for (std::size_t k = 1; k < all.size(); ++k) {
      if (!falls(all[k - 1], all[k], largest_number_) &&
          !falls(all[k - 1], all[k], 0.1 * largest_number_))
        continue;
      const double begin = std::max(1.0, all[k - 1].x / 1.02);
      const bool is_new = count == 0 || begin > 1.2 * intervals_[count - 1].end;
      if (is_new && count < intervals_.size()) intervals_[count++].begin = begin;
      intervals_[count - 1].end = 1.02 * all[k].x;
    }
  }

  // Interval of x in which the contact loses the fraction lost_ B of the work of loading. eta is
  // this loss per unit B, divided by the elastic energy.
  struct Interval {
    double begin = 0, end = 0;
  };
  Rebound rebound_;
  double largest_number_ = 0;
  std::array<Interval, 4> intervals_{};
  double lost_ = 0;
  Tabulated<1, 9> loading_;  // work of loading without adhesion
  std::array<Tabulated<1, 9>, energy_guarded<Law> ? 4 : 3> works_;  // w_0, w_1, w_2, w_0 + w_3
  double end_ = 0;                                                  // end of the tables
};

}  // namespace plastigran
