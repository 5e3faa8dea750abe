// SPDX-License-Identifier: GPL-2.0-or-later
//
// `compute ID all plastigran/energy`: a vector of elastic energy, surface energy, plastic work,
// loss by adhesion [J], and the number of contacts, of all pairs and walls of the laws. Plastic
// work and loss are sums over the particles since the compute was first defined.
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
