// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/type_extremes.h"

#include <mpi.h>

#include "atom.h"
#include "lammps.h"

namespace plastigran {

std::vector<TypeExtremes> type_extremes(LAMMPS_NS::LAMMPS* engine, int type_count, int group) {
  const LAMMPS_NS::Atom* const atom = engine->atom;
  std::vector<TypeExtremes> types(type_count);
  for (int i = 0; i < atom->nlocal; ++i)
    if (atom->mask[i] & group)
      types[atom->type[i] - 1].add(atom->radius[i], atom->rmass[i], atom->v[i]);
  const auto over_ranks = [&](MPI_Op operation, auto value) {
    std::vector<double> values;
    for (TypeExtremes& type : types) values.push_back(value(type));
    MPI_Allreduce(MPI_IN_PLACE, values.data(), values.size(), MPI_DOUBLE, operation, engine->world);
    for (int k = 0; k < type_count; ++k) value(types[k]) = values[k];
  };
  over_ranks(MPI_SUM, [](TypeExtremes& type) -> double& { return type.count; });
  over_ranks(MPI_MIN, [](TypeExtremes& type) -> double& { return type.radius; });
  over_ranks(MPI_MIN, [](TypeExtremes& type) -> double& { return type.mass; });
  over_ranks(MPI_MAX, [](TypeExtremes& type) -> double& { return type.speed; });
  for (int axis = 0; axis < 3; ++axis) {
    over_ranks(MPI_MIN, [=](TypeExtremes& type) -> double& { return type.least[axis]; });
    over_ranks(MPI_MAX, [=](TypeExtremes& type) -> double& { return type.most[axis]; });
  }
  return types;
}

}  // namespace plastigran
