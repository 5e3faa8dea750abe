// SPDX-License-Identifier: GPL-2.0-or-later
//
// Warns once each of two problems in contacts between a particle and a mesh. The class MeshContacts
// cannot solve them:
//
//   seam   a particle has two contacts with a smooth surface, because two triangles share no edge
//          or node: there is a gap between them, or a node of one lies on an edge of the other
//   ring   a smooth surface such as a cone or a narrow pipe touches a particle on opposite sides,
//          but one contact cannot hold the particle
#pragma once

#include <optional>

#include "liggghts/fixes/plugin_fix.h"

namespace plastigran {

class MeshCheck : public PluginFix {
 public:
  enum Problem { seam, ring };

  // A particle that touches two triangles of a mesh. Ranks send it as bytes.
  struct Place {
    int particle, triangles[2];  // IDs of the particle and of both triangles
    double x[3];                 // position of the particle
    double angle;                // angle between the directions to the triangles [degrees]
  };

  MeshCheck(LAMMPS_NS::LAMMPS* engine, int count, char** words) : PluginFix(engine, count, words) {}
  static const char* id() { return "plastigran_meshes"; }
  static const char* style() { return "plastigran/meshes"; }

  bool seen(Problem problem) const { return seen_[problem].has_value(); }
  void note(Problem problem, const Place& place) { seen_[problem] = place; }

  int setmask() override { return 0; }
  void post_run() override;

 private:
  void report(Problem problem);

  std::optional<Place> seen_[2];  // first contact with each problem on this rank
  bool reported_[2] = {false, false};
};

}  // namespace plastigran
