// SPDX-License-Identifier: GPL-2.0-or-later
//
// Tests whether two triangles of a mesh form one smooth surface.
#pragma once

#include "tri_mesh.h"

namespace plastigran {

// Returns whether the triangles `a` and `b` (local indices) form one surface for a particle at
// `centre`. They do if they share an edge where the surface bends by at most the feature angle, or
// bends away from the particle. In the second case, the particle touches only the nearer triangle.
bool one_surface(LAMMPS_NS::TriMesh& mesh, int a, int b, const double* centre,
                 double feature_cosine);

// Returns whether the triangles share a node and their planes differ by at most the feature angle.
bool around_a_node(LAMMPS_NS::TriMesh& mesh, int a, int b, double feature_cosine);

}  // namespace plastigran
