// SPDX-License-Identifier: GPL-2.0-or-later
//
// One contact per particle and smooth surface of a mesh.
//
// LIGGGHTS computes a contact with every triangle that a particle overlaps, each with its own
// history. On an edge between two triangles the force would double, and a particle that rolls
// across the edge would lose its residual indentation. This class joins triangles that share edges
// or nodes into surfaces. The deepest triangle of a surface has the contact and takes over its
// history. The other triangles have neither force nor history.
//
// A contact that adhesion stretches lasts although the particle overlaps no triangle. The nearest
// triangle of its surface then has the contact.
//
// The surfaces are computed in each step from the mesh and LIGGGHTS' histories. Therefore no
// further data have to be stored in restart files or sent to other ranks.
#pragma once

#include <utility>
#include <vector>

#include "fix_mesh_surface.h"
#include "lammps.h"
#include "liggghts/meshes/mesh_check.h"

namespace plastigran {

class MeshContacts {
 public:
  // Creates the contacts with one mesh. `springs` are the offsets of tangential and rolling springs
  // in the contact history; each spring is a vector in the tangent plane. `in_contact` is the
  // offset of the history value `in_contact`, or -1 if contacts end with the overlap.
  MeshContacts(LAMMPS_NS::LAMMPS* engine, LAMMPS_NS::FixMeshSurface* mesh, double feature_cosine,
               std::vector<int> springs, int in_contact);

  // Prepares a run. Each setup calls this function.
  void begin_run(MeshCheck* check) {
    check_ = check;
    list_step_ = contact_step_ = -1;
  }

  // Returns whether LIGGGHTS has to compute the contact of a local particle with this triangle: the
  // triangle has the contact of its surface, or the contact ends in this step. `history` is
  // LIGGGHTS' history for this particle and triangle; null if there is none. If the triangle has
  // the contact, this function moves the history of the surface to `history`.
  bool computes(int particle, int triangle, double* history);

 private:
  // An overlap of a particle with a triangle, or a gap across which adhesion may stretch a contact.
  struct Overlap {
    int triangle;       // local index of the triangle
    double to_foot[3];  // from the center of the particle to the nearest point of the triangle
    // Overlap [m], negative for a gap. A gap beyond reach_of() marks an edge or corner that
    // LIGGGHTS assigns to another triangle.
    double depth;
    bool has_history;  // whether LIGGGHTS stores a history for this contact
    int surface;       // index of the first overlap with the same surface
    bool carries;      // whether this overlap has the contact of its surface
    double* history;   // history of the surface to take over; null if none
    int former;        // triangle that had this history
  };

  void list_triangles();
  std::pair<int, int> overlaps_of(int particle);
  void find_overlaps(int particle);
  void add(int particle, int triangle, double gap, const double* to_foot, int surface);
  void join_surfaces(int particle, int first);
  void add_nearer_triangles(int particle, int first);
  bool meet_as_one(int particle, int a, int b) const;
  void choose_carriers(int particle, int first);
  void find_histories(int particle, int first);
  void look_for_seam(int particle, int first) const;
  void look_for_ring(int particle, int first) const;
  MeshCheck::Place place(int particle, const Overlap& a, const Overlap& b) const;
  Overlap* heir_of(int particle, int first, int triangle);
  void take_over(int particle, Overlap& overlap, double* history) const;
  double reach_of(int particle) const;
  bool is_stretched(int particle, int triangle) const;
  bool beyond_its_plane(int particle, int triangle) const;
  double distance(int particle, int triangle, bool as_liggghts, double* to_foot) const;
  bool any(const double* history) const;
  int slot_of(int particle, int triangle) const;

  LAMMPS_NS::LAMMPS* engine_;
  LAMMPS_NS::FixMeshSurface* fix_;
  LAMMPS_NS::TriMesh* mesh_;
  double feature_cosine_;
  std::vector<int> springs_;
  int in_contact_;
  MeshCheck* check_ = nullptr;

  // Triangles near local particle i, in LIGGGHTS' order: elements first_near_[i] to
  // first_near_[i + 1] - 1 of near_. Valid for the neighbor lists built in step list_step_.
  std::vector<int> near_, first_near_;
  LAMMPS_NS::bigint list_step_ = -1;

  // Range of each local particle's overlaps in overlaps_: begin and end, or -1 if they are not yet
  // computed. Valid in step contact_step_.
  std::vector<std::pair<int, int>> spans_;
  std::vector<Overlap> overlaps_;
  LAMMPS_NS::bigint contact_step_ = -1;
};

}  // namespace plastigran
