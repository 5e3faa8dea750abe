// SPDX-License-Identifier: GPL-2.0-or-later
//
// Extremes of size and velocity of the particles on all ranks, for the forecast of impacts.
#pragma once

#include <vector>

#include "lammps.h"
#include "plastigran/pairs/impact_forecast.h"

namespace plastigran {

// Returns the extremes of atom type k + 1 at index k, for the particles of a group, whose bit is
// `group`.
std::vector<TypeExtremes> type_extremes(LAMMPS_NS::LAMMPS* lammps, int group);

std::vector<int> all_types(int count);

}  // namespace plastigran
