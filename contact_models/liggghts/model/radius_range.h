// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace plastigran {

struct RadiusRange {
  double smallest, largest;  // radii; infinity and 0 if there are no particles
};

// Returns the range of radii of the particles on all ranks, and of those that fixes will insert.
// Collective.
RadiusRange radius_range(LAMMPS_NS::LAMMPS* engine);

}  // namespace plastigran
