// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/contact_checks.h"

namespace plastigran {

std::string describe_overlap(const LAMMPS_NS::Atom* atom,
                             const LIGGGHTS::ContactModels::SurfacesIntersectData& contact,
                             double overlap, double overlap_limit) {
  std::ostringstream text;
  text << describe_particle(atom, contact.i) << " and "
       << (contact.is_wall ? "a wall" : describe_particle(atom, contact.j)) << " overlap by "
       << overlap << " times the smaller radius; overlap_limit is " << overlap_limit
       << ". Check for particles inserted into each other or into a wall, a time step that is too "
          "long, or a youngsModulus too low for the load";
  return text.str();
}

std::string describe_crossing(const LAMMPS_NS::Atom* atom,
                              const LIGGGHTS::ContactModels::SurfacesIntersectData& contact) {
  std::ostringstream text;
  text << describe_particle(atom, contact.i) << " is about to cross a wall: the overlap is "
       << contact.deltan / contact.radi
       << " times its radius. Beyond 1, the wall would push the particle out on the other side. "
          "Check the value and unit of youngsModulus, and the time step";
  return text.str();
}

}  // namespace plastigran
