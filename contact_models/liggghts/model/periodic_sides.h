// SPDX-License-Identifier: GPL-2.0-or-later
//
// Check of the periodic box size. LIGGGHTS stores one contact history per pair of particles. If a
// periodic side is too short, a pair can have two contacts, one across each end of the side. Both
// would share this history.
#pragma once

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace plastigran {

// Returns a message if a periodic side of the box is too short for the present particles and those
// that fixes will insert; otherwise an empty string. Collective.
std::string short_periodic_side(LAMMPS_NS::LAMMPS* engine);

}  // namespace plastigran
