// SPDX-License-Identifier: GPL-2.0-or-later
//
// The hardest impacts the present velocities allow, before a run: of each two types that can meet,
// the smallest particles at the largest relative speed. Particles that fly side by side do not
// meet: the relative speed is at most what the extremes of each component of velocity allow.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <utility>
#include <vector>

#include "liggghts/model/contact_owner.h"
#include "plastigran/pairs/impact_times.h"
#include "plastigran/shared/contact.h"
#include "pointers.h"

namespace plastigran {

class ImpactForecast : protected LAMMPS_NS::Pointers {
 public:
  // Looks at the particles of all ranks, which do so together.
  ImpactForecast(LAMMPS_NS::LAMMPS* engine, const ContactOwner& owner, int type_count);

  bool is_wall() const { return is_wall_; }
  const std::vector<Meeting>& meetings() const { return meetings_; }

  // Pairs of types that can meet or may come to: all but those of a type with walls and no
  // particle.
  const std::vector<std::pair<int, int>>& expected() const { return expected_; }

  // The shortest Rayleigh time of the particles, spheres of these materials (by type - 1) [s];
  // ImpactTimes::unknown when there are none.
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

}  // namespace plastigran
