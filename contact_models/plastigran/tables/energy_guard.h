// SPDX-License-Identifier: GPL-2.0-or-later
//
// Energy guard: some published curves return more energy than loading put in. There the guard
// shortens the rebound, so that the work lost never falls as a contact is pressed further.
//
// The search follows the published loss upwards from yield. A stretch begins where the loss is
// largest so far and ends where the loss reaches that value again. Published curves lose too little
// just beyond a break of the formula, so the distance of the points from the last break grows from
// 1e-9 of the break by a quarter each, up to steps of 2 %.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <limits>

#include "plastigran/shared/device.h"
#include "plastigran/shared/numerics.h"

namespace plastigran {

// At most one stretch per break, one on the smooth curve from yield on, one beyond the last break.
template <std::size_t breaks>
class EnergyGuard {
 public:
  // The guard that is off.
  EnergyGuard() = default;

  // Arguments: the overlaps at which the formula changes, ascending, the first at yield; the
  // largest overlap of the search; taken(overlap) and loss(overlap), the work of loading and the
  // part of it that the published curve does not return.
  template <class Taken, class Loss>
  EnergyGuard(const std::array<double, breaks>& edges, double reach, const Taken& taken,
              const Loss& loss) {
    double before = edges[0], top = before, lost = std::max(0.0, loss(top));
    std::size_t found = 0;
    for (double last = top, x = next(edges, last); x < reach && found < stretches_.size();) {
      const double now = loss(x);
      if (now >= lost) {
        before = last, top = x, lost = now;
      } else if (now < lost - rounding * taken(x)) {
        const double summit = golden_section(loss, before, x, 50);
        if (loss(summit) > lost) top = summit, lost = loss(summit);
        double low = x, high = x;
        while (high < reach && loss(high) < lost) low = high, high = next(edges, high);
        halve(low, high, [&](double middle) { return !(loss(middle) < lost); });
        stretches_[found++] = {top, high, lost};
        before = top = x = high;
      }
      last = x;
      x = next(edges, x);
    }
  }

  // The work that loading to an overlap loses at least.
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

  // The next point of the search: close to both sides of each break.
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
