// SPDX-License-Identifier: GPL-2.0-or-later
//
// Warns once of each kind of contact with a mesh that the class MeshContacts does not support:
//
//   seam   a particle has two contacts where the mesh is smooth, but the triangles share no edge or
//          node, because of a gap or a node on an edge
//   ring   one smooth surface touches a particle on opposite sides, as a cone or a narrow pipe
//   does;
//          its one contact cannot hold the particle
#pragma once

#include <optional>

#include "liggghts/fixes/plugin_fix.h"

namespace plastigran {

class MeshCheck : public PluginFix {
 public:
  enum Kind { seam, ring };

  // A particle that touches two triangles of a mesh. Ranks send it as bytes.
  struct Place {
    int particle, triangles[2];  // IDs of the particle and of both triangles
    double x[3];                 // position of the particle
    double angle;                // angle between the directions to the triangles [degrees]
  };

  MeshCheck(LAMMPS_NS::LAMMPS* engine, int count, char** words) : PluginFix(engine, count, words) {}
  static const char* id() { return "plastigran_meshes"; }
  static const char* style() { return "plastigran/meshes"; }

  bool found(Kind kind) const { return found_[kind].has_value(); }
  void note(Kind kind, const Place& place) { found_[kind] = place; }

  int setmask() override { return 0; }
  void post_run() override;

 private:
  void report(Kind kind);

  std::optional<Place> found_[2];  // first unsupported contact of each kind on this rank
  bool reported_[2] = {false, false};
};

}  // namespace plastigran
