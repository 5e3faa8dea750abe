// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace plastigran {

struct RadiusRange {
  double smallest, largest;  // infinity and 0 without particles
};

// Range of the radii of the particles on all ranks and of those that fixes will insert. All ranks
// must call it together.
RadiusRange radius_range(LAMMPS_NS::LAMMPS* engine);

}  // namespace plastigran
