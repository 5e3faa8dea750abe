// SPDX-License-Identifier: GPL-2.0-or-later
//
// State of laws whose contact history consists only of the largest overlap.
#pragma once

#include <array>

namespace plastigran {

struct LargestOverlap {
  struct State {
    double overlap_max = 0;  // largest overlap [m]; 0 while elastic
  };
  static constexpr std::array<const char*, 1> state_names{"overlap_max"};
};

}  // namespace plastigran
