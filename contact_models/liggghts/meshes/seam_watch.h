// SPDX-License-Identifier: GPL-2.0-or-later
//
// Says once when a particle has two contacts where a mesh looks smooth, but its triangles share
// neither edge nor node: a node of one lies on an edge of the other, or there is a gap.
#pragma once

#include "liggghts/fixes/own_fix.h"

namespace plastigran {

class SeamWatch : public OwnFix {
 public:
  // Two triangles of a mesh whose contacts with a particle pull the same way.
  struct Seam {
    int particle, triangles[2];  // by their numbers in deck and mesh file
    double x[3];                 // of the particle
    double angle;                // between the contacts' directions [degrees]
  };

  SeamWatch(LAMMPS_NS::LAMMPS* engine, int count, char** words) : OwnFix(engine, count, words) {}
  static const char* id() { return "plastigran_seams"; }
  static const char* style() { return "plastigran/seams"; }

  bool found() const { return found_; }
  void note(const Seam& seam) { seam_ = seam, found_ = true; }

  int setmask() override { return 0; }
  void post_run() override;

 private:
  Seam seam_;
  bool found_ = false;  // on this rank
  bool said_ = false;
};

}  // namespace plastigran
