// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/meshes/mesh_check.h"

#include <mpi.h>

#include <sstream>

namespace plastigran {

namespace {

std::string sentence(MeshCheck::Problem problem, const MeshCheck::Place& place) {
  std::ostringstream text;
  text << "fix wall/gran: particle " << place.particle << " at (" << place.x[0] << ' ' << place.x[1]
       << ' ' << place.x[2] << ')';
  if (problem == MeshCheck::seam)
    text << " touches mesh triangles " << place.triangles[0] << " and " << place.triangles[1]
         << ", which share no edge or node. Their contact directions differ by " << place.angle
         << " degrees, less than feature_angle. The contact is counted twice, with separate "
            "histories. Repair the mesh so that neighboring triangles share edges";
  else
    text << " touches triangles " << place.triangles[0] << " and " << place.triangles[1]
         << " of one smooth surface, in directions " << place.angle
         << " degrees apart. The surface gives only one contact, so the particle may never come to "
            "rest there. For one contact per facet, use a feature_angle below the angle between "
            "neighboring facets";
  return text.str();
}

}  // namespace

void MeshCheck::post_run() {
  report(seam);
  report(ring);
}

// Warns of a problem at the place that was noted by the lowest rank with this problem. Collective.
void MeshCheck::report(Problem problem) {
  int rank = seen(problem) ? comm->me : comm->nprocs, first;
  MPI_Allreduce(&rank, &first, 1, MPI_INT, MPI_MIN, world);
  if (reported_[problem] || first == comm->nprocs) return;
  reported_[problem] = true;
  Place place = seen_[problem].value_or(Place());
  MPI_Bcast(&place, sizeof place, MPI_BYTE, first, world);
  if (comm->me == 0) warn(lmp, sentence(problem, place));
}

}  // namespace plastigran
