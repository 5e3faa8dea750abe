// SPDX-License-Identifier: GPL-2.0-or-later
#include "lammps/energy_compute.h"

#include <mpi.h>

#include <string>

#include "atom.h"
#include "error.h"
#include "fix.h"
#include "lammps/contact_tally.h"
#include "lammps/pair_style.h"
#include "modify.h"
#include "update.h"

namespace plastigran {

EnergyCompute::EnergyCompute(LAMMPS_NS::LAMMPS* lammps, int count, char** words)
    : Compute(lammps, count, words) {
  vector_flag = 1;
  size_vector = 5;
  extvector = 1;
  vector = new double[size_vector];
  std::string fix = "plastigran_energy";
  if (modify->get_fix_by_id(fix)) return;
  fix += " all property/atom";
  for (const char* const value : ContactTally::particle_values) fix += std::string(" d_") + value;
  modify->add_fix(fix + " ghost yes");
}

EnergyCompute::~EnergyCompute() { delete[] vector; }

void EnergyCompute::init() {
  if (!PairStyle::of(lmp))
    error->all(FLERR, "compute plastigran/energy needs `pair_style granular/plastigran`");
}

void EnergyCompute::compute_vector() {
  invoked_vector = update->ntimestep;
  double sums[5] = {0, 0, 0, 0, 0};
  const auto add = [&](const ContactTally& tally) {
    sums[0] += tally.elastic_energy;
    sums[1] += tally.surface_energy;
    sums[4] += tally.contacts;
  };
  add(*PairStyle::of(lmp));
  for (LAMMPS_NS::Fix* const fix : modify->get_fix_list())
    if (const auto* const wall = dynamic_cast<ContactTally*>(fix)) add(*wall);
  for (int k = 0; k < 2; ++k) {
    int is_double, columns;
    const int at = atom->find_custom(ContactTally::particle_values[k], is_double, columns);
    for (int i = 0; i < atom->nlocal; ++i) sums[2 + k] += atom->dvector[at][i];
  }
  MPI_Allreduce(sums, vector, size_vector, MPI_DOUBLE, MPI_SUM, world);
}

}  // namespace plastigran
