// SPDX-License-Identifier: GPL-2.0-or-later
//
// A contact under way, as far as collision spectra know it.
#pragma once

#include <cmath>
#include <cstddef>
#include <limits>
#include <utility>

#include "liggghts/observers/lossy_load.h"

namespace plastigran {

// Of an impact whose first touch was not seen.
constexpr double unknown_speed = std::numeric_limits<double>::quiet_NaN();

// A particle holds it: of two particles the one with the lower number. All doubles: they travel
// with the particle.
struct Impact {
  double partner = 0;            // the other particle's number, or wall_partner()
  double type = 0;               // atom types at first touch: of the holder
  double other_type = 0;         // of its partner
  double speed = unknown_speed;  // of approach along the normal at first touch [m/s]
  double energy = 0;             // dissipated so far [J]
  double largest_force = 0;      // along the normal so far [N]
  double force = 0;              // along the normal in this step, of all triangles of a wall [N]
  double touched = 0;            // in this step
  LossyLoad load;                // of the last step, i being the holder

  bool counts() const { return !std::isnan(speed); }
  bool is_with_wall() const { return partner < 0; }
  std::size_t wall() const { return -1 - partner; }
  static double wall_partner(std::size_t wall) { return -1 - static_cast<double>(wall); }

  // As the other particle holds it.
  void turn(int holder) {
    partner = holder;
    std::swap(type, other_type);
    load = load.turned();
  }
};

}  // namespace plastigran
