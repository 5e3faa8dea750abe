// SPDX-License-Identifier: GPL-2.0-or-later
//
// Messages for screen and log. Only one rank may call print() and warn().
#pragma once

#include <string>

#include "atom.h"
#include "lammps.h"

namespace plastigran {

void print(const LAMMPS_NS::LAMMPS* engine, const std::string& text);

// Prints a warning with the prefix "plastigran", by which the Python package finds it in the log.
void warn(const LAMMPS_NS::LAMMPS* engine, const std::string& text);

// Stops the run with an error message. Collective.
[[noreturn]] void stop(const LAMMPS_NS::LAMMPS* engine, const std::string& text);

// Stops the run with an error message from one rank; other ranks need not call this function.
[[noreturn]] void stop_from_rank(const LAMMPS_NS::LAMMPS* engine, const std::string& text);

// Returns "particle ID at (X Y Z)" for the particle with local index `i`.
std::string describe_particle(const LAMMPS_NS::Atom* atom, int i);

}  // namespace plastigran
