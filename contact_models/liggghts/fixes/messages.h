// SPDX-License-Identifier: GPL-2.0-or-later
//
// Messages for screen and log. Only one rank may call print() and warn().
#pragma once

#include <string>

#include "atom.h"
#include "lammps.h"

namespace plastigran {

void print(const LAMMPS_NS::LAMMPS* engine, const std::string& text);

// The Python package finds the warnings of this plugin by their first word, "plastigran".
void warn(const LAMMPS_NS::LAMMPS* engine, const std::string& text);

// Stops the run. Collective.
[[noreturn]] void stop(const LAMMPS_NS::LAMMPS* engine, const std::string& text);

// Stops the run from one rank, while the others may be elsewhere.
[[noreturn]] void stop_from_rank(const LAMMPS_NS::LAMMPS* engine, const std::string& text);

// "particle ID at (X Y Z)", for a particle of this rank.
std::string describe_particle(const LAMMPS_NS::Atom* atom, int i);

}  // namespace plastigran
