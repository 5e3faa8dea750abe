// SPDX-License-Identifier: GPL-2.0-or-later
//
// Values that the plugin keeps for each particle. `fix property/atom` stores them, moves them
// between ranks and writes them to restart files. LAMMPS leaves the values of new particles unset,
// so another fix, of the style `plastigran/values`, sets them to zero.
#pragma once

#include <string>

#include "fix.h"

namespace plastigran {

class ParticleValues : public LAMMPS_NS::Fix {
 public:
  ParticleValues(LAMMPS_NS::LAMMPS* lammps, int count, char** words);

  // Creates per-particle values with the name `name`, unless they exist. A deck reads them as
  // `d_name`. `words` are appended to the command fix property/atom.
  static void create(LAMMPS_NS::LAMMPS* lammps, const std::string& name,
                     const std::string& words = "");
  // Returns the values of the particles of this rank and of its ghosts; stops the run if the values
  // have been removed.
  static double* of(LAMMPS_NS::LAMMPS* lammps, const char* name);

  int setmask() override { return 0; }
  void set_arrays(int particle) override;

 private:
  std::string name_;
};

}  // namespace plastigran
