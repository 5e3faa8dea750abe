// SPDX-License-Identifier: GPL-2.0-or-later
#include "lammps/particle_values.h"

#include "atom.h"
#include "error.h"
#include "lammps.h"
#include "modify.h"

namespace plastigran {

ParticleValues::ParticleValues(LAMMPS_NS::LAMMPS* lammps, int count, char** words)
    : Fix(lammps, count, words), name_(words[3]) {
  create_attribute = 1;
}

void ParticleValues::create(LAMMPS_NS::LAMMPS* lammps, const std::string& name,
                            const std::string& words) {
  if (lammps->modify->get_fix_by_id(name)) return;
  lammps->modify->add_fix(name + " all property/atom d_" + name + words);
  lammps->modify->add_fix(name + "_new all plastigran/values " + name);
}

double* ParticleValues::of(LAMMPS_NS::LAMMPS* lammps, const char* name) {
  int is_double, columns;
  const int index = lammps->atom->find_custom(name, is_double, columns);
  if (index < 0)
    lammps->error->one(FLERR,
                       "granular/plastigran: `unfix` has removed the fix {}, which stores values "
                       "of the particles; keep this fix",
                       name);
  return lammps->atom->dvector[index];
}

void ParticleValues::set_arrays(int particle) { of(lmp, name_.c_str())[particle] = 0; }

}  // namespace plastigran
