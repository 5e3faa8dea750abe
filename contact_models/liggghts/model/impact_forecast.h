// SPDX-License-Identifier: GPL-2.0-or-later
//
// The hardest impacts the present velocities allow, before a run: of each two types that can meet,
// the smallest particles at the largest relative speed. Particles that fly side by side do not
// meet: the relative speed is at most what the extremes of each component of velocity allow.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "liggghts/fixes/step_watch.h"
#include "liggghts/model/contact_owner.h"
#include "liggghts/model/type_pair.h"
#include "plastigran/impact/central_impact.h"
#include "plastigran/impact/elastic_times.h"
#include "plastigran/shared/contact.h"
#include "pointers.h"

namespace plastigran {

class ImpactForecast : protected LAMMPS_NS::Pointers {
 public:
  // Two types that can meet.
  struct Meeting {
    int type, partner_type;
    double radius_eff, mass_eff;  // of the smallest and lightest particles [m], [kg]
    double speed;                 // may be 0 [m/s]
  };

  // Looks at the particles of all ranks, which do so together.
  ImpactForecast(LAMMPS_NS::LAMMPS* engine, const ContactOwner& owner, int type_count);

  bool is_wall() const { return is_wall_; }
  const std::vector<Meeting>& meetings() const { return meetings_; }

  // Pairs of types that can meet or may come to: all but those of a type with walls and no
  // particle.
  const std::vector<std::pair<int, int>>& expected() const { return expected_; }

  // The shortest Rayleigh time of the particles, spheres of these materials (by type - 1) [s];
  // StepWatch::unknown when there are none.
  double rayleigh_time(const std::vector<Body>& materials) const;

 private:
  // Of the particles of one type: how many, the smallest, the lightest, the fastest, and by axis
  // the least and the largest velocity.
  struct Extremes {
    static constexpr double infinity = std::numeric_limits<double>::infinity();
    double count = 0, radius = infinity, mass = infinity, speed = 0;
    std::array<double, 3> least{infinity, infinity, infinity},
        most{-infinity, -infinity, -infinity};
  };
  void gather();
  static double relative_speed(const Extremes& one, const Extremes& other);

  bool is_wall_;
  std::vector<Extremes> types_;  // by type
  std::vector<Meeting> meetings_;
  std::vector<std::pair<int, int>> expected_;
};

// Why the law is none for types that can meet, or for such as may come to; empty when it is one.
template <class Law>
std::string refusal(const ImpactForecast& forecast, TypePairs<Law>& pairs) {
  for (const auto& meeting : forecast.meetings()) {
    const TypePair<Law>& pair = pairs(meeting.type, meeting.partner_type);
    if (!pair.refusal.empty()) return pair.refusal;
  }
  for (const auto& [type, partner_type] : forecast.expected()) {
    const TypePair<Law>& pair = pairs(type, partner_type);
    if (!pair.refusal.empty() && !pair.lacking) return pair.refusal;
  }
  return {};
}

// What a law says of the impacts of a forecast.
struct ImpactTimes {
  StepWatch::Recommended fastest;        // of the steps the impacts ask for, the shortest
  double hertz = StepWatch::unknown;     // shortest duration of an elastic impact [s]
  double rayleigh = StepWatch::unknown;  // [s]
  double outside_speed = 0;              // largest that leaves the law's range [m/s]
};

template <class Law>
ImpactTimes impact_times(const ImpactForecast& forecast, TypePairs<Law>& pairs) {
  ImpactTimes times;
  times.fastest.wall = forecast.is_wall();
  if (!is_cylinder<Law>) times.rayleigh = forecast.rayleigh_time(pairs.bodies());
  for (const auto& [type, partner_type, radius_eff, mass_eff, speed] : forecast.meetings()) {
    if (!(speed > 0)) continue;
    TypePair<Law>& at_rest = pairs(type, partner_type);
    const TypePair<Law>& pair =
        at_rest.strengthened(rate_factor(at_rest.bodies, radius_eff, speed));
    const double step = recommended_timestep(pair.law, radius_eff, mass_eff, speed);
    if (step < times.fastest.step) times.fastest.step = step, times.fastest.speed = speed;
    if (!is_cylinder<Law>)
      times.hertz = std::min(
          times.hertz, hertz_duration(radius_eff, mass_eff, pair.bodies.youngs_modulus_eff, speed));
    if (!central_impact(pair.law, radius_eff, mass_eff, speed).in_range)
      times.outside_speed = std::max(times.outside_speed, speed);
  }
  return times;
}

}  // namespace plastigran
