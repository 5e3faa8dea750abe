// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/meshes/fold.h"

#include <cmath>

#include "vector_liggghts.h"

namespace plastigran {

using LAMMPS_NS::TriMesh;

namespace {

// Start point of an edge of a triangle, and the unit vector from the edge into the triangle, in its
// plane and normal to the edge.
struct Leaf {
  double start[3], away[3];

  Leaf(TriMesh& mesh, int triangle, int edge) {
    double along[3], opposite[3];
    mesh.node(triangle, edge, start);
    mesh.node(triangle, (edge + 2) % 3, opposite);
    mesh.edgeVec(triangle, edge, along);
    vectorSubtract3D(opposite, start, away);
    const double covered = vectorDot3D(away, along);
    for (int axis = 0; axis < 3; ++axis) away[axis] -= covered * along[axis];
    vectorNormalize3D(away);
  }
};

// Returns whether the neighboring triangle `other` lies in the plane of `triangle`, or behind this
// plane as seen from the particle center `centre`.
bool behind(TriMesh& mesh, int triangle, const Leaf& leaf, const Leaf& other,
            const double* centre) {
  double normal[3], to_centre[3];
  mesh.surfaceNorm(triangle, normal);
  vectorSubtract3D(centre, leaf.start, to_centre);
  return vectorDot3D(to_centre, normal) * vectorDot3D(other.away, normal) <= 0;
}

// Returns whether two triangles share a node. Nodes of neighboring triangles may differ by
// round-off.
bool share_a_node(TriMesh& mesh, int a, int b) {
  const double tolerance = 1e-6 * mesh.edgeLen(a, 0);
  for (int node_a = 0; node_a < 3; ++node_a)
    for (int node_b = 0; node_b < 3; ++node_b) {
      double at_a[3], at_b[3];
      mesh.node(a, node_a, at_a);
      mesh.node(b, node_b, at_b);
      if (pointDistance(at_a, at_b) < tolerance) return true;
    }
  return false;
}

}  // namespace

bool one_surface(TriMesh& mesh, int a, int b, const double* centre, double feature_cosine) {
  int edge_a, edge_b;
  if (!mesh.shareEdge(a, b, edge_a, edge_b)) return false;
  const Leaf leaf_a(mesh, a, edge_a), leaf_b(mesh, b, edge_b);
  return -vectorDot3D(leaf_a.away, leaf_b.away) >= feature_cosine ||
         behind(mesh, a, leaf_a, leaf_b, centre) || behind(mesh, b, leaf_b, leaf_a, centre);
}

bool around_a_node(TriMesh& mesh, int a, int b, double feature_cosine) {
  if (!share_a_node(mesh, a, b)) return false;
  double normal_a[3], normal_b[3];
  mesh.surfaceNorm(a, normal_a);
  mesh.surfaceNorm(b, normal_b);
  // Use the absolute value, because normals in STL files may point to either side.
  return std::fabs(vectorDot3D(normal_a, normal_b)) >= feature_cosine;
}

}  // namespace plastigran
