// SPDX-License-Identifier: GPL-2.0-or-later
//
// LIGGGHTS stores one contact history for each pair of particles. In a box whose periodic side is
// too short, a pair can touch across both ends of the side at once, and two contacts share it.
#pragma once

#include <string>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace plastigran {

// Returns why a periodic side of the box is too short for the particles present and those that
// fixes insert; empty if none is. Collective.
std::string short_periodic_side(LAMMPS_NS::LAMMPS* engine);

}  // namespace plastigran
