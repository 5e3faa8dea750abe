// SPDX-License-Identifier: GPL-2.0-or-later
//
// How the surface of a mesh goes on from one triangle to the next.
#pragma once

#include "tri_mesh.h"

namespace plastigran {

// Whether a particle at `centre` meets triangles `a` and `b` as one surface. They share an edge,
// and the surface turns there by no more than the feature angle, to whichever side; or it bends
// away from the particle, which then touches the nearer of the two alone. Local numbers of
// triangles.
bool one_surface(LAMMPS_NS::TriMesh& mesh, int a, int b, const double* centre,
                 double feature_cosine);

// Whether the two share a node, and their planes differ by no more than the feature angle.
bool around_a_node(LAMMPS_NS::TriMesh& mesh, int a, int b, double feature_cosine);

}  // namespace plastigran
