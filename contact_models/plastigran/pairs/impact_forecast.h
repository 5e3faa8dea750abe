// SPDX-License-Identifier: GPL-2.0-or-later
//
// Forecast of the hardest impacts at the current velocities: one impact for each pair of atom types
// that can touch. In this impact, the smallest and lightest particles collide at the largest
// relative speed. This speed follows from the extremes of the velocity components, so a common
// velocity of all particles does not increase it.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <set>
#include <utility>
#include <vector>

#include "plastigran/impact/elastic_times.h"
#include "plastigran/pairs/impact_times.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

// Statistics of the particles of one atom type on all ranks: number, smallest radius [m] and mass
// [kg], largest speed, and the extremes of each velocity component [m/s].
struct TypeExtremes {
  static constexpr double infinity = std::numeric_limits<double>::infinity();
  double count = 0, radius = infinity, mass = infinity, speed = 0;
  std::array<double, 3> least{infinity, infinity, infinity}, most{-infinity, -infinity, -infinity};

  void add(double particle_radius, double particle_mass, const double* velocity) {
    count += 1;
    radius = std::min(radius, particle_radius);
    mass = std::min(mass, particle_mass);
    speed = std::max(speed, std::sqrt(velocity[0] * velocity[0] + velocity[1] * velocity[1] +
                                      velocity[2] * velocity[2]));
    for (std::size_t axis = 0; axis < 3; ++axis) {
      least[axis] = std::min(least[axis], velocity[axis]);
      most[axis] = std::max(most[axis], velocity[axis]);
    }
  }
};

class ImpactForecast {
 public:
  // Creates the forecast. `types[k]` belongs to atom type k + 1. `partners` are the types that
  // particles can touch: all types, or the types of a wall. `wall_types` are the types of all
  // walls.
  ImpactForecast(const std::vector<TypeExtremes>& types, const std::vector<int>& partners,
                 bool is_wall, const std::set<int>& wall_types)
      : types_(types) {
    const auto reduced = [](double a, double b) { return a * b / (a + b); };
    const auto may_exist = [&](int type) { return of(type).count > 0 || !wall_types.count(type); };
    for (int type = 1; type <= static_cast<int>(types.size()); ++type) {
      const TypeExtremes& one = of(type);
      for (const int partner : partners)
        if (may_exist(type) && (is_wall || may_exist(partner)))
          expected_.push_back({type, partner});
      if (one.count == 0) continue;
      for (const int partner : partners) {
        const TypeExtremes& other = of(partner);
        if (is_wall)
          meetings_.push_back({type, partner, one.radius, one.mass, one.speed});
        else if (other.count > (type == partner ? 1 : 0))
          meetings_.push_back({type, partner, reduced(one.radius, other.radius),
                               reduced(one.mass, other.mass), relative_speed(one, other)});
      }
    }
  }

  const std::vector<Meeting>& meetings() const { return meetings_; }

  // Returns the pairs of atom types that can touch now or later. Particles may get any type later,
  // except a type that only walls have.
  const std::vector<std::pair<int, int>>& expected() const { return expected_; }

  // Returns the shortest Rayleigh time [s] of spheres that have the smallest radius and mass of an
  // atom type; ImpactTimes::unknown if there are no particles. `materials[k]` belongs to atom type
  // k + 1.
  double rayleigh_time(const std::vector<Body>& materials) const {
    double shortest = ImpactTimes::unknown;
    for (std::size_t k = 0; k < types_.size(); ++k) {
      if (types_[k].count == 0) continue;
      const double volume = 4.0 / 3 * pi * std::pow(types_[k].radius, 3);
      shortest = std::min(shortest, plastigran::rayleigh_time(
                                        types_[k].radius, types_[k].mass / volume,
                                        materials[k].youngs_modulus, materials[k].poissons_ratio));
    }
    return shortest;
  }

 private:
  const TypeExtremes& of(int type) const { return types_[static_cast<std::size_t>(type) - 1]; }

  static double relative_speed(const TypeExtremes& one, const TypeExtremes& other) {
    double squared = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const double apart =
          std::max(one.most[axis] - other.least[axis], other.most[axis] - one.least[axis]);
      squared += apart * apart;
    }
    return std::min(std::sqrt(squared), one.speed + other.speed);
  }

  std::vector<TypeExtremes> types_;
  std::vector<Meeting> meetings_;
  std::vector<std::pair<int, int>> expected_;
};

}  // namespace plastigran
