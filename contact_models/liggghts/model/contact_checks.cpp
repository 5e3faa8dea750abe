// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/contact_checks.h"

#include <sstream>

#include "liggghts/fixes/describe_particle.h"

namespace plastigran {

std::string describe_overlap(const LAMMPS_NS::Atom* atom,
                             const LIGGGHTS::ContactModels::SurfacesIntersectData& contact,
                             double overlap, double overlap_limit) {
  std::ostringstream text;
  text << describe_particle(atom, contact.i) << " overlaps "
       << (contact.is_wall ? "a wall" : describe_particle(atom, contact.j)) << " by " << overlap
       << " of the smaller radius, more than overlap_limit " << overlap_limit
       << ". Look for particles inserted into each other or in a wall, a time step that is too "
          "long, or bodies too soft for their load";
  return text.str();
}

std::string describe_passage(const LAMMPS_NS::Atom* atom,
                             const LIGGGHTS::ContactModels::SurfacesIntersectData& contact) {
  std::ostringstream text;
  text
      << describe_particle(atom, contact.i)
      << " is about to pass through a wall: it overlaps it by " << contact.deltan / contact.radi
      << " of its radius, and a wall pushes out to either side. Look for bodies too soft for their "
         "load (is youngsModulus in the deck's units?), or a time step that is too long";
  return text.str();
}

}  // namespace plastigran
