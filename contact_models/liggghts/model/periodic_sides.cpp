// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/periodic_sides.h"

#include <algorithm>
#include <array>
#include <sstream>
#include <vector>

#include "atom.h"
#include "domain.h"
#include "fix_insert.h"
#include "lammps.h"
#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/fixes/ranks.h"
#include "neighbor.h"

namespace plastigran {

namespace {

typedef std::array<double, 2> TwoLargest;

void take(TwoLargest& largest, double diameter) {
  if (diameter > largest[0])
    largest = {diameter, largest[0]};
  else if (diameter > largest[1])
    largest[1] = diameter;
}

// Returns the diameters of the two largest particles on all ranks; 0 for missing particles.
TwoLargest largest_diameters(LAMMPS_NS::LAMMPS* engine) {
  TwoLargest largest{};
  for (int i = 0; i < engine->atom->nlocal; ++i) take(largest, 2 * engine->atom->radius[i]);
  const std::vector<double> of_ranks =
      gather_all(std::vector<double>(largest.begin(), largest.end()), engine->world);
  largest = {};
  for (const double diameter : of_ranks) take(largest, diameter);
  for (LAMMPS_NS::FixInsert* const insertion : fixes_of<LAMMPS_NS::FixInsert>(engine->modify)) {
    double radius = 0;
    for (int type = 1; type <= engine->atom->ntypes; ++type)
      radius = std::max(radius, insertion->max_rad(type));
    for (int left = std::min(2, particles_to_insert(insertion)); left > 0; --left)
      take(largest, 2 * radius);
  }
  return largest;
}

}  // namespace

std::string short_periodic_side(LAMMPS_NS::LAMMPS* engine) {
  const LAMMPS_NS::Domain* const domain = engine->domain;
  const TwoLargest diameters = largest_diameters(engine);
  const double shortest = diameters[0] + diameters[1] + engine->neighbor->skin;
  for (int axis = 0; axis < domain->dimension; ++axis) {
    if (!domain->periodicity[axis] || domain->prd[axis] >= shortest || diameters[0] == 0) continue;
    std::ostringstream text;
    text
        << "the periodic side "
        << "xyz"[axis] << " is " << domain->prd[axis] << " long; it must be at least " << shortest
        << ", the sum of the two largest particle diameters (" << diameters[0] << " and "
        << diameters[1] << ") and the neighbor skin (" << engine->neighbor->skin
        << "). In a shorter box a pair can touch across both ends of the side, and LIGGGHTS stores "
           "one contact history per pair. Enlarge the box, or reduce the skin";
    return text.str();
  }
  return {};
}

}  // namespace plastigran
