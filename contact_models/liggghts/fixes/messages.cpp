// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/messages.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "error.h"

namespace plastigran {

void print(const LAMMPS_NS::LAMMPS* engine, const std::string& text) {
  for (FILE* const file : {engine->screen, engine->logfile})
    if (file) std::fputs(text.c_str(), file);
}

void warn(const LAMMPS_NS::LAMMPS* engine, const std::string& text) {
  engine->error->warning(FLERR, ("plastigran: " + text).c_str());
}

void stop(const LAMMPS_NS::LAMMPS* engine, const std::string& text) {
  engine->error->all(FLERR, text.c_str());
  std::abort();  // unreachable; for [[noreturn]], because Error::all() lacks the attribute
}

void stop_from_rank(const LAMMPS_NS::LAMMPS* engine, const std::string& text) {
  engine->error->one(FLERR, text.c_str());
  std::abort();  // unreachable; for [[noreturn]], because Error::one() lacks the attribute
}

std::string describe_particle(const LAMMPS_NS::Atom* atom, int i) {
  std::ostringstream text;
  text << "particle " << atom->tag[i] << " at (" << atom->x[i][0] << ' ' << atom->x[i][1] << ' '
       << atom->x[i][2] << ')';
  return text.str();
}

}  // namespace plastigran
