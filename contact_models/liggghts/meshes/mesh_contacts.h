// SPDX-License-Identifier: GPL-2.0-or-later
//
// One contact for each particle and smooth surface of a mesh.
//
// The engine computes a contact with every triangle a particle overlaps, and each remembers for
// itself: on a fold the force doubles, and behind it a dent is forgotten. Here the triangles a
// particle overlaps at the same time are joined to surfaces, over their edges and nodes; the
// deepest of a surface carries its contact and takes over what the surface remembers. The others
// have no force and no memory.
//
// All is found anew at each step from the mesh and from what the engine stores of the contacts:
// nothing has to go with a particle to another rank, or into a restart file.
#pragma once

#include <utility>
#include <vector>

#include "fix_mesh_surface.h"
#include "lammps.h"
#include "liggghts/meshes/mesh_check.h"

namespace plastigran {

class MeshContacts {
 public:
  // `springs`: the offset of each spring in the contact history, a vector in the tangent plane.
  MeshContacts(LAMMPS_NS::LAMMPS* engine, LAMMPS_NS::FixMeshSurface* mesh, double feature_cosine,
               std::vector<int> springs);

  // Before a run.
  void begin_run(MeshCheck* check) {
    check_ = check;
    list_step_ = contact_step_ = -1;
  }

  // Whether the engine has to compute what it asks for: the contact of a local particle with a
  // triangle, if it overlaps it, or else its end. A contact that carries a surface's has taken over
  // the surface's memory then. `history` is the engine's for this contact, null when there is none.
  bool computes(int particle, int triangle, bool overlaps, double* history);

 private:
  // An overlap of a particle with a triangle.
  struct Overlap {
    int triangle;       // its local number
    double to_foot[3];  // from the particle's centre to the triangle's nearest point
    double depth;       // below 0: the engine leaves this edge or corner to another triangle
    bool known;         // the engine stores a history for it already
    int surface;        // the first overlap of the same surface
    bool carries;       // the contact of its surface
    double* memory;     // of its surface, to be taken over; null: nothing to remember
    int former;         // the triangle that had it
  };

  void list_triangles();
  std::pair<int, int> overlaps_of(int particle);
  void find_overlaps(int particle);
  void join_surfaces(int particle, int first);
  bool meet_as_one(int particle, int a, int b) const;
  void choose_carriers(int particle, int first);
  void find_memory(int particle, int first);
  void look_for_seam(int particle, int first) const;
  void look_for_ring(int particle, int first) const;
  MeshCheck::Place place(int particle, const Overlap& a, const Overlap& b) const;
  Overlap* heir_of(int particle, int first, int triangle);
  void take_over(int particle, Overlap& overlap, double* history) const;
  bool beyond_its_plane(int particle, int triangle) const;
  double distance(int particle, int triangle, bool of_the_engine, double* to_foot) const;
  bool remembers(const double* history) const;
  int slot_of(int particle, int triangle) const;

  LAMMPS_NS::LAMMPS* engine_;
  LAMMPS_NS::FixMeshSurface* fix_;
  LAMMPS_NS::TriMesh* mesh_;
  double feature_cosine_;
  std::vector<int> springs_;
  MeshCheck* check_ = nullptr;

  // The triangles near each local particle, in the engine's order: those of particle i stand from
  // first_near_[i] to first_near_[i + 1]. From the neighbour lists of that step.
  std::vector<int> near_, first_near_;
  LAMMPS_NS::bigint list_step_ = -1;

  // Of that step's force computation: by local particle, where its overlaps begin and end; -1: it
  // has not been looked at yet.
  std::vector<std::pair<int, int>> found_;
  std::vector<Overlap> overlaps_;
  LAMMPS_NS::bigint contact_step_ = -1;
};

}  // namespace plastigran
