// SPDX-License-Identifier: GPL-2.0-or-later
//
// How messages call a particle.
#pragma once

#include <string>

#include "atom.h"

namespace plastigran {

// The number and the place of a particle of this rank, by its index.
std::string describe_particle(const LAMMPS_NS::Atom* atom, int i);

}  // namespace plastigran
