// SPDX-License-Identifier: GPL-2.0-or-later
//
// Times of the hardest impacts that a host expects, computed with a law.
#pragma once

#include <algorithm>
#include <utility>
#include <vector>

#include "plastigran/impact/central_impact.h"
#include "plastigran/impact/elastic_times.h"
#include "plastigran/pairs/type_pairs.h"
#include "plastigran/shared/complaint.h"
#include "plastigran/shared/rate_factor.h"

namespace plastigran {

// The hardest expected impact of two atom types that can touch.
struct Meeting {
  int type, partner_type;
  double radius_eff, mass_eff;  // R* [m] and m* [kg] of the smallest and lightest particles
  double speed;                 // relative speed [m/s], may be 0
};

// Returns the reason why the law does not support a pair of types that can touch now (`meetings`)
// or later (`expected`); empty if it supports all pairs.
template <class Law>
Complaint refusal(const std::vector<Meeting>& meetings,
                  const std::vector<std::pair<int, int>>& expected, TypePairs<Law>& pairs) {
  for (const Meeting& meeting : meetings) {
    const TypePair<Law>& pair = pairs(meeting.type, meeting.partner_type);
    if (!pair.refusal.empty()) return pair.refusal;
  }
  for (const auto& [type, partner_type] : expected) {
    const TypePair<Law>& pair = pairs(type, partner_type);
    if (!pair.refusal.empty() && !pair.lacking) return pair.refusal;
  }
  return {};
}

struct ImpactTimes {
  static constexpr double unknown = 1e300;  // value of a time [s] if no impact is expected
  double step = unknown;                    // shortest recommended time step [s]
  double step_speed = 0;                    // speed of the impact that needs this step [m/s]
  double hertz = unknown;                   // shortest duration of an elastic impact [s]
  double outside_speed = 0;  // largest speed of an impact beyond the validity range [m/s]
};

template <class Law>
ImpactTimes impact_times(const std::vector<Meeting>& meetings, TypePairs<Law>& pairs) {
  ImpactTimes times;
  for (const Meeting& meeting : meetings) {
    const double radius = meeting.radius_eff, mass = meeting.mass_eff, speed = meeting.speed;
    if (!(speed > 0)) continue;
    const TypePair<Law>& pair = pairs(meeting.type, meeting.partner_type);
    if (!is_cylinder<Law>)
      times.hertz = std::min(times.hertz,
                             hertz_duration(radius, mass, pair.bodies.youngs_modulus_eff, speed));
    const double factor = rate_factor(pair.bodies, radius, speed);
    pair.at_factor(factor, [&](const auto& law, double) {
      const ImpactOutcome impact = central_impact(law, radius, mass, speed);
      const double step = recommended_timestep(law, radius, mass, speed, impact);
      if (step < times.step) times.step = step, times.step_speed = speed;
      if (!impact.in_range) times.outside_speed = std::max(times.outside_speed, speed);
    });
  }
  return times;
}

}  // namespace plastigran
