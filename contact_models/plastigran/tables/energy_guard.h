// SPDX-License-Identifier: GPL-2.0-or-later
//
// Energy guard. Some published curves release more energy than loading took. There, the guard
// reduces the recovered overlap, so that plastic work never decreases during loading.
//
// The search follows the published plastic work from yield to larger overlaps. An interval begins
// where plastic work starts to decrease, and ends where it is again as large as before. A decrease
// is likely just beyond an overlap at which the formula changes. Therefore the first point of the
// search beyond such an overlap is at a distance of 1e-9 of it. From point to point, the distance
// grows by a quarter, until the steps are 2 % of the overlap.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "plastigran/shared/device.h"
#include "plastigran/shared/numerics.h"

namespace plastigran {

// At most breaks + 2 intervals need the guard: one per break, one on the smooth curve from yield,
// and one beyond the last break.
template <std::size_t breaks>
class EnergyGuard {
 public:
  // Creates an inactive guard.
  EnergyGuard() = default;

  // Finds the intervals of the overlap in which the guard acts. `edges` are the overlaps at which
  // the formula changes, ascending, beginning with yield. `reach` is the largest overlap of the
  // search. taken(overlap) is the work of loading; loss(overlap) is the published plastic work.
  template <class Taken, class Loss>
  EnergyGuard(const std::array<double, breaks>& edges, double reach, const Taken& taken,
              const Loss& loss) {
    double before = edges[0], top = before, lost = std::max(0.0, loss(top));
    std::size_t interval_count = 0;
    for (double last = top, x = next(edges, last);
         x < reach && interval_count < stretches_.size();) {
      const double now = loss(x);
      if (now >= lost) {
        before = last, top = x, lost = now;
      } else if (now < lost - rounding * taken(x)) {
        const double summit = golden_section(loss, before, x, 50);
        if (loss(summit) > lost) top = summit, lost = loss(summit);
        double low = x, high = x;
        while (high < reach && loss(high) < lost) low = high, high = next(edges, high);
        halve(low, high, [&](double middle) { return !(loss(middle) < lost); });
        stretches_[interval_count++] = {top, high, lost};
        before = top = x = high;
      }
      last = x;
      x = next(edges, x);
    }
  }

  // Returns the lower limit of the plastic work after loading to an overlap.
  PLASTIGRAN_DEVICE double least_loss(double overlap) const {
    for (const Stretch& stretch : stretches_)
      if (overlap >= stretch.begin && overlap < stretch.end) return stretch.lost;
    return -infinite;
  }

 private:
  struct Stretch {
    double begin, end, lost;
  };

  static constexpr double infinite = std::numeric_limits<double>::infinity();
  static constexpr double close = 1e-9;
  static constexpr double rounding = 1e-14;  // round-off, relative to the work of loading

  // Returns the next overlap of the search; points are dense on both sides of each break.
  static double next(const std::array<double, breaks>& edges, double x) {
    double step = 0.02 * x;
    for (double edge : edges) {
      const double below = edge * (1 - close), above = edge * (1 + close);
      if (x >= below && x < above) return above;
      step = std::min(step, x < below ? below - x : 0.25 * (x - edge));
    }
    return x + step;
  }

  std::array<Stretch, breaks + 2> stretches_{};
};

}  // namespace plastigran
