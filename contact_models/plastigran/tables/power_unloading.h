// SPDX-License-Identifier: GPL-2.0-or-later
//
// Base of laws that unload along F = F_max y^n, y = (overlap - overlap_res)/(overlap_max -
// overlap_res). The exponent n is 3/2 unless the curve (curve_table.h) defines exponent(x). A curve
// may also define overlap_range(), its largest valid overlap/R*. Example of a law:
//
//   using KogutEtsion = PowerUnloading<KogutEtsionCurve>;
#pragma once

#include "plastigran/tables/curve_table.h"
#include "plastigran/tables/unloading.h"

namespace plastigran {

template <class Curve>
class PowerUnloading : public GuardedTable<Curve, PowerOfOverlap<Curve>> {
 public:
  using GuardedTable<Curve, PowerOfOverlap<Curve>>::GuardedTable;

  // Returns the values of overlap/R* at which the formula changes; the force of first loading may
  // jump there.
  auto overlap_breaks() const {
    auto overlaps = Curve::breaks;
    for (double& overlap : overlaps)
      overlap *= Curve::yield_radius_ratio * Curve::yield_radius_ratio;
    return overlaps;
  }
};

}  // namespace plastigran
