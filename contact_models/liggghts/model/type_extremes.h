// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <vector>

#include "plastigran/pairs/impact_forecast.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace plastigran {

// The extremes of the particles of each atom type (by type - 1) on all ranks. Collective.
std::vector<TypeExtremes> type_extremes(LAMMPS_NS::LAMMPS* engine, int type_count);

}  // namespace plastigran
