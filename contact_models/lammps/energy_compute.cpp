// SPDX-License-Identifier: GPL-2.0-or-later
#include "lammps/energy_compute.h"

#include <algorithm>

#include "error.h"
#include "lammps/energy_balance.h"
#include "update.h"

namespace plastigran {

EnergyCompute::EnergyCompute(LAMMPS_NS::LAMMPS* lammps, int count, char** words)
    : Compute(lammps, count, words) {
  if (count > 3)
    error->all(FLERR, "compute {} {} plastigran/energy: unknown word {}; remove it", words[0],
               words[1], words[3]);
  vector_flag = 1;
  size_vector = EnergyBalance::TERMS;
  extvector = 1;
  vector = new double[EnergyBalance::TERMS];
  EnergyBalance::create(lammps);
}

EnergyCompute::~EnergyCompute() { delete[] vector; }

void EnergyCompute::init() {
  if (!EnergyBalance::of(lmp))
    error->all(FLERR,
               "compute {} plastigran/energy: `unfix` has removed its fix plastigran_energy; "
               "remove the compute by `uncompute {}`, and give it again",
               id, id);
}

void EnergyCompute::compute_vector() {
  invoked_vector = update->ntimestep;
  const EnergyBalance::Terms terms = EnergyBalance::of(lmp)->terms();
  std::copy(terms.begin(), terms.end(), vector);
}

}  // namespace plastigran
