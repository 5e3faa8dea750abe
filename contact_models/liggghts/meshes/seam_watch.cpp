// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/meshes/seam_watch.h"

#include <mpi.h>

#include <sstream>

#include "comm.h"
#include "error.h"

namespace plastigran {

// The first rank that has found one says it.
void SeamWatch::post_run() {
  int rank = found_ ? comm->me : comm->nprocs, first;
  MPI_Allreduce(&rank, &first, 1, MPI_INT, MPI_MIN, world);
  if (said_ || first == comm->nprocs) return;
  said_ = true;
  MPI_Bcast(&seam_, sizeof seam_, MPI_BYTE, first, world);
  if (comm->me != 0) return;
  std::ostringstream text;
  text << "fix wall/gran: particle " << seam_.particle << " at (" << seam_.x[0] << ' ' << seam_.x[1]
       << ' ' << seam_.x[2] << ") has contacts with triangles " << seam_.triangles[0] << " and "
       << seam_.triangles[1] << " of a mesh at once, in directions " << seam_.angle
       << " degrees apart: less than feature_angle, but no edge or node joins them. Its force is "
          "that of "
          "both, and neither remembers the other. Triangles of a smooth surface must share edges";
  error->warning(FLERR, text.str().c_str());
}

}  // namespace plastigran
