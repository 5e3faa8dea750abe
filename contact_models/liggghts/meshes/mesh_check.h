// SPDX-License-Identifier: GPL-2.0-or-later
//
// Says once of each kind where particles meet a mesh in a way that its contacts are not made for:
//
//   seam   a particle has two contacts where the mesh looks smooth, but its triangles share neither
//          edge nor node: a node of one lies on an edge of the other, or there is a gap
//   ring   a particle leans on opposite sides of one smooth surface, as in a cone or in a pipe
//          hardly wider than itself: the one contact it has with it cannot hold it
#pragma once

#include <optional>

#include "liggghts/fixes/plugin_fix.h"

namespace plastigran {

class MeshCheck : public PluginFix {
 public:
  enum Kind { seam, ring };

  // A particle on two triangles of a mesh.
  struct Place {
    int particle, triangles[2];  // by their numbers in deck and mesh file
    double x[3];                 // of the particle
    double angle;                // between the directions to the triangles [degrees]
  };

  MeshCheck(LAMMPS_NS::LAMMPS* engine, int count, char** words) : PluginFix(engine, count, words) {}
  static const char* id() { return "plastigran_meshes"; }
  static const char* style() { return "plastigran/meshes"; }

  bool found(Kind kind) const { return found_[kind].has_value(); }
  void note(Kind kind, const Place& place) { found_[kind] = place; }

  int setmask() override { return 0; }
  void post_run() override;

 private:
  void say(Kind kind);

  std::optional<Place> found_[2];  // on this rank, the first of each kind
  bool said_[2] = {false, false};
};

}  // namespace plastigran
