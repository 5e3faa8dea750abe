// SPDX-License-Identifier: GPL-2.0-or-later
#include "lammps/impact_extremes.h"

#include <mpi.h>

#include <numeric>

#include "atom.h"

namespace plastigran {

std::vector<TypeExtremes> type_extremes(LAMMPS_NS::LAMMPS* lammps, int group) {
  const LAMMPS_NS::Atom* const atom = lammps->atom;
  std::vector<TypeExtremes> types(static_cast<std::size_t>(atom->ntypes));
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->mask[i] & group)
      types[static_cast<std::size_t>(atom->type[i]) - 1].add(atom->radius[i], atom->rmass[i],
                                                             atom->v[i]);
  const auto over_ranks = [&](MPI_Op operation, double* first, std::size_t size) {
    MPI_Allreduce(MPI_IN_PLACE, first, static_cast<int>(size), MPI_DOUBLE, operation,
                  lammps->world);
  };
  for (TypeExtremes& type : types) {
    over_ranks(MPI_SUM, &type.count, 1);
    over_ranks(MPI_MIN, &type.radius, 1);
    over_ranks(MPI_MIN, &type.mass, 1);
    over_ranks(MPI_MAX, &type.speed, 1);
    over_ranks(MPI_MIN, type.least.data(), type.least.size());
    over_ranks(MPI_MAX, type.most.data(), type.most.size());
  }
  return types;
}

std::vector<int> all_types(int count) {
  std::vector<int> types(static_cast<std::size_t>(count));
  std::iota(types.begin(), types.end(), 1);
  return types;
}

}  // namespace plastigran
