// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/describe_particle.h"

#include <sstream>

namespace plastigran {

std::string describe_particle(const LAMMPS_NS::Atom* atom, int i) {
  std::ostringstream text;
  text << "particle " << atom->tag[i] << " at (" << atom->x[i][0] << ' ' << atom->x[i][1] << ' '
       << atom->x[i][2] << ')';
  return text.str();
}

}  // namespace plastigran
