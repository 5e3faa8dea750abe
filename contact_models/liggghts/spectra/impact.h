// SPDX-License-Identifier: GPL-2.0-or-later
//
// The data of a current contact for the collision spectra.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "liggghts/model/lossy_load.h"

namespace plastigran {

// The speed of a contact that began before the counting.
constexpr double unknown_speed = std::numeric_limits<double>::quiet_NaN();

// The other body of an impact: the ID of a particle, or a negative number for a wall.
typedef int Partner;
inline Partner wall_partner(std::size_t wall) { return -1 - static_cast<int>(wall); }
inline bool is_wall(Partner partner) { return partner < 0; }
inline int wall_of(Partner partner) { return -1 - partner; }

// One particle holds an impact, of two particles the one with the lower ID. All members are
// doubles, so that ranks can exchange them with the particle.
struct Impact {
  double type = 0;               // atom types at first touch: of the holder
  double other_type = 0;         // atom type of the partner
  double speed = unknown_speed;  // normal speed at first touch [m/s]
  double energy = 0;             // dissipated so far [J]
  double largest_force = 0;      // along the normal so far [N]
  double force = 0;              // along the normal in this step, of all triangles of a wall [N]
  LossyLoad load;                // load of the last step; particle i is the holder

  bool counts() const { return !std::isnan(speed); }

  // The impact for exchanged bodies.
  Impact exchanged() const {
    Impact other = *this;
    std::swap(other.type, other.other_type);
    other.load = load.exchanged();
    return other;
  }
};

}  // namespace plastigran
