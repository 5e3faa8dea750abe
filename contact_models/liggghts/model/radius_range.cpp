// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/radius_range.h"

#include <mpi.h>

#include <algorithm>
#include <limits>

#include "atom.h"
#include "fix_insert.h"
#include "lammps.h"
#include "modify.h"

namespace plastigran {

RadiusRange radius_range(LAMMPS_NS::LAMMPS* engine) {
  const LAMMPS_NS::Atom* const atom = engine->atom;
  double smallest = std::numeric_limits<double>::infinity(), largest = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    smallest = std::min(smallest, atom->radius[i]);
    largest = std::max(largest, atom->radius[i]);
  }
  for (int k = 0; k < engine->modify->nfix; ++k) {
    const auto insertion = dynamic_cast<LAMMPS_NS::FixInsert*>(engine->modify->fix[k]);
    for (int type = 1; insertion && type <= atom->ntypes; ++type) {
      if (!(insertion->max_rad(type) > 0)) continue;
      smallest = std::min(smallest, insertion->min_rad(type));
      largest = std::max(largest, insertion->max_rad(type));
    }
  }
  RadiusRange range;
  MPI_Allreduce(&smallest, &range.smallest, 1, MPI_DOUBLE, MPI_MIN, engine->world);
  MPI_Allreduce(&largest, &range.largest, 1, MPI_DOUBLE, MPI_MAX, engine->world);
  return range;
}

}  // namespace plastigran
