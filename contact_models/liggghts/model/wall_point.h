// SPDX-License-Identifier: GPL-2.0-or-later
//
// Contact point on a wall, and the velocity of the wall at this point. A mesh moves before the
// forces of a step are computed. Its velocity at that time is its displacement in this step,
// divided by the time step.
#pragma once

#include <array>

#include "contact_interface.h"
#include "tri_mesh.h"

namespace plastigran {

class WallPoint {
 public:
  // Creates the contact point for a particle with its center at `centre`. The point is valid until
  // ranks exchange triangles.
  WallPoint(const LIGGGHTS::ContactModels::SurfacesIntersectData& contact, double* centre)
      : mesh_(contact.mesh),
        triangle_(contact.j),
        velocity_{contact.v_j[0], contact.v_j[1], contact.v_j[2]} {
    double delta[3];
    int where;
    if (mesh_)
      mesh_->resolveTriSphereContactBary(contact.i, triangle_, contact.radi, centre, delta,
                                         weights_, where);
  }

  std::array<double, 3> velocity() const {
    if (!mesh_) return velocity_;
    const auto moving =
        mesh_->prop().getElementProperty<LAMMPS_NS::MultiVectorContainer<double, 3, 3>>("v");
    std::array<double, 3> velocity{0, 0, 0};
    if (!moving) return velocity;
    for (int node = 0; node < 3; ++node)
      for (int axis = 0; axis < 3; ++axis)
        velocity[axis] += weights_[node] * moving->begin()[triangle_][node][axis];
    return velocity;
  }

 private:
  LAMMPS_NS::TriMesh* mesh_;  // mesh of the wall; null for a primitive wall
  int triangle_;
  double weights_[3] = {0, 0, 0};   // barycentric coordinates of the point in the triangle
  std::array<double, 3> velocity_;  // velocity of a primitive wall
};

}  // namespace plastigran
