// SPDX-License-Identifier: GPL-2.0-or-later
//
// Adds the forces and torques of a contact to the tally of the energy balance. LAMMPS calls its
// heat model last, when all forces of a contact are known. Therefore this class is a heat model. It
// replaces the heat model `none`.
#pragma once

#include "lammps/contact_tally.h"
#include "lammps/granular_interface.h"

namespace plastigran {

class NormalModel;

class LoadModel : public LAMMPS_NS::Granular_NS::GranSubModHeat {
 public:
  LoadModel(LAMMPS_NS::Granular_NS::GranularModel* model, LAMMPS_NS::LAMMPS* lammps,
            const NormalModel& normal, ContactTally& tally);

  // Replaces LAMMPS' heat model by a LoadModel, unless the pair or wall line selects a heat model.
  static void add(LAMMPS_NS::Granular_NS::GranularModel* model, LAMMPS_NS::LAMMPS* lammps,
                  const NormalModel& normal, ContactTally& tally);

  // Sets LAMMPS' flag `heat_defined`, so that LAMMPS calls this model. LAMMPS resets the flag
  // whenever it initializes its models.
  static void enable(LAMMPS_NS::Granular_NS::GranularModel* model);

  double calculate_heat() override;

 private:
  const NormalModel& normal_;
  ContactTally& tally_;
};

}  // namespace plastigran
