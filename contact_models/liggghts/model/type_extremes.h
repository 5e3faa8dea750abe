// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "plastigran/pairs/impact_forecast.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace plastigran {

// Returns the extremes of size and velocity of the particles of a group on all ranks, for atom type
// k + 1 at index k. `group`: bit of the group. Collective.
std::vector<TypeExtremes> type_extremes(LAMMPS_NS::LAMMPS* engine, int type_count, int group);

}  // namespace plastigran
