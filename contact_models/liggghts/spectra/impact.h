// SPDX-License-Identifier: GPL-2.0-or-later
//
// Data of a current contact for the collision spectra.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "liggghts/model/lossy_load.h"

namespace plastigran {

// Speed of a contact that began before the fix was created.
constexpr double unknown_speed = std::numeric_limits<double>::quiet_NaN();

// Other body of an impact: the ID of a particle, or a negative number for a wall.
typedef int Partner;
inline Partner wall_partner(std::size_t wall) { return -1 - static_cast<int>(wall); }
inline bool is_wall(Partner partner) { return partner < 0; }
inline int wall_of(Partner partner) { return -1 - partner; }

// An impact in progress. Its data are stored with one particle, the holder: of two particles, the
// one with the lower ID. All members are doubles, so that ranks can exchange them with the
// particle.
struct Impact {
  double type = 0;               // atom type of the holder at first touch
  double other_type = 0;         // atom type of the partner at first touch
  double speed = unknown_speed;  // closing speed along the normal at first touch [m/s]
  double energy = 0;             // energy dissipated so far [J]
  double largest_force = 0;      // largest normal force so far [N]
  double force = 0;              // normal force in this step, summed over triangles of a wall [N]
  LossyLoad load;                // load of the last step; particle i is the holder

  bool counts() const { return !std::isnan(speed); }

  // Returns the impact with the two bodies exchanged.
  Impact exchanged() const {
    Impact other = *this;
    std::swap(other.type, other.other_type);
    other.load = load.exchanged();
    return other;
  }
};

}  // namespace plastigran
