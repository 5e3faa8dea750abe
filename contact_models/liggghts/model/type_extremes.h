// SPDX-License-Identifier: GPL-2.0-or-later
//
// The extremes of the particles of each type, over all ranks.
#pragma once

#include <vector>

#include "plastigran/pairs/impact_forecast.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace plastigran {

// By type - 1. All ranks together.
std::vector<TypeExtremes> type_extremes(LAMMPS_NS::LAMMPS* engine, int type_count);

}  // namespace plastigran
