// SPDX-License-Identifier: GPL-2.0-or-later
//
// What any law says about a central impact, by energy: no time integration, no host.
#pragma once

#include <algorithm>
#include <cmath>

#include "contact.h"

namespace plastigran {

struct Impact {
  double overlap_max = 0;                 // [m]
  double force_max = 0;                   // [N]
  double overlap_res = 0;                 // overlap at which the rebound's force vanishes [m]
  double coefficient_of_restitution = 0;  // [-]
  double stiffness_max = 0;               // steepest slope of force over overlap [N/m]
  bool in_range = true;                   // the law is good for that load
};

// Largest overlap over R* a law is good for. No contact law is good for overlaps of the order of
// the radius; a law may narrow that: double overlap_range() const.
constexpr double overlap_limit = 0.1;

template <class Law>
auto overlap_range(const Law& law, int) -> decltype(law.overlap_range()) {
  return std::min(law.overlap_range(), overlap_limit);
}
template <class Law>
double overlap_range(const Law&, long) {
  return overlap_limit;
}

// Bodies of effective mass mass_eff [kg] meet at relative speed `speed` [m/s]: 1/2 m* v^2 equals
// the virgin work at the largest overlap, and what is stored elastically there is given back.
template <class Law>
Impact central_impact(const Law& law, double radius_eff, double mass_eff, double speed) {
  Impact impact;
  const double energy = 0.5 * mass_eff * speed * speed;
  if (!(energy > 0)) return impact;
  const auto virgin = [&](double overlap) {
    typename Law::State state;
    return law.respond(radius_eff, overlap, state);
  };
  const auto excess = [&](double overlap) {
    const Response r = virgin(overlap);
    return r.elastic_energy + r.plastic_work - energy;
  };
  double low = 0, high = 1e-6 * radius_eff;
  for (; excess(high) < 0 && high < 1e6 * radius_eff; high *= 2) low = high;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (excess(middle) < 0 ? low : high) = middle;
  }
  impact.overlap_max = 0.5 * (low + high);

  typename Law::State state;
  const Response peak = law.respond(radius_eff, impact.overlap_max, state);
  impact.force_max = peak.force;
  impact.in_range = impact.overlap_max <= overlap_range(law, 0) * radius_eff;
  impact.coefficient_of_restitution = std::sqrt(peak.elastic_energy / energy);

  const auto force = [&](double overlap) {
    typename Law::State unloading = state;
    return law.respond(radius_eff, overlap, unloading).force;
  };
  low = 0, high = impact.overlap_max;
  for (int i = 0; i < 100; ++i) {
    const double middle = 0.5 * (low + high);
    (force(middle) > 0 ? high : low) = middle;
  }
  impact.overlap_res = high < 1e-9 * impact.overlap_max ? 0 : high;

  const double step = 1e-4 * (impact.overlap_max - impact.overlap_res);
  impact.stiffness_max = (peak.force - force(impact.overlap_max - step)) / step;
  return impact;
}

// The step that resolves that impact's rebound: a fraction of sqrt(m*/k) on the steepest branch.
// The fraction keeps the coefficient of restitution within 1e-3 (docs/time_step.md).
constexpr double time_step_fraction = 0.1;

template <class Law>
double recommended_time_step(const Law& law, double radius_eff, double mass_eff, double speed) {
  const double stiffness = central_impact(law, radius_eff, mass_eff, speed).stiffness_max;
  return time_step_fraction * std::sqrt(mass_eff / stiffness);
}

}  // namespace plastigran
