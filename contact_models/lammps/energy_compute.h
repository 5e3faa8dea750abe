// SPDX-License-Identifier: GPL-2.0-or-later
//
// `compute ID all plastigran/energy`: the vector of the terms of the energy balance.
#pragma once

#include "compute.h"

namespace plastigran {

class EnergyCompute : public LAMMPS_NS::Compute {
 public:
  EnergyCompute(LAMMPS_NS::LAMMPS* lammps, int count, char** words);
  ~EnergyCompute() override;
  void init() override;
  void compute_vector() override;
};

}  // namespace plastigran
