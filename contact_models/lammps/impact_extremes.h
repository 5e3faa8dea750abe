// SPDX-License-Identifier: GPL-2.0-or-later
//
// Smallest size and extreme velocities of the particles of each atom type, on all ranks. The
// run-time checks estimate the speeds of impacts from them.
#pragma once

#include <vector>

#include "lammps.h"
#include "plastigran/pairs/impact_forecast.h"

namespace plastigran {

// Returns the extreme sizes and velocities of each atom type; index k holds atom type k + 1. Only
// the particles of one group count. `group` is the bit mask of this group in LAMMPS.
std::vector<TypeExtremes> type_extremes(LAMMPS_NS::LAMMPS* lammps, int group);

std::vector<int> all_types(int count);

}  // namespace plastigran
