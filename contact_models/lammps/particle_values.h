// SPDX-License-Identifier: GPL-2.0-or-later
//
// Values per particle of the plugin, stored by `fix property/atom`, which moves them between ranks
// and writes them to restart files. LAMMPS leaves the values of new particles unset, so a second
// fix of the style `plastigran/values` sets them to zero.
#pragma once

#include <string>

#include "fix.h"

namespace plastigran {

class ParticleValues : public LAMMPS_NS::Fix {
 public:
  ParticleValues(LAMMPS_NS::LAMMPS* lammps, int count, char** words);

  // Makes the values `name` if there are none, which a deck reads as `d_name`. `words` are further
  // words of fix property/atom.
  static void create(LAMMPS_NS::LAMMPS* lammps, const std::string& name,
                     const std::string& words = "");
  // The values of the particles of this rank and its ghosts.
  static double* of(LAMMPS_NS::LAMMPS* lammps, const char* name);

  int setmask() override { return 0; }
  void set_arrays(int particle) override;

 private:
  std::string name_;
};

}  // namespace plastigran
