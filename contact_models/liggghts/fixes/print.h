// SPDX-License-Identifier: GPL-2.0-or-later
//
// Text for screen and log. To be called on one rank.
#pragma once

#include <cstdio>
#include <string>

#include "error.h"
#include "lammps.h"

namespace plastigran {

inline void print(const LAMMPS_NS::LAMMPS* engine, const std::string& text) {
  for (FILE* const file : {engine->screen, engine->logfile})
    if (file) std::fputs(text.c_str(), file);
}

// The Python package finds the warnings of this plugin by their first word.
inline void warn(const LAMMPS_NS::LAMMPS* engine, const std::string& text) {
  engine->error->warning(FLERR, ("plastigran: " + text).c_str());
}

}  // namespace plastigran
