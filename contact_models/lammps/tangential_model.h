// SPDX-License-Identifier: GPL-2.0-or-later
//
// Tangential model of LAMMPS' granular contacts for a tangential law (plastigran/friction/). This
// model replaces LAMMPS' model `mindlin`. It keeps the name and the coefficients of `mindlin`,
// because restart files contain them. The contact history contains the state of the law.
#pragma once

#include "lammps/contact_line.h"
#include "lammps/contact_tally.h"
#include "lammps/granular_interface.h"

namespace plastigran {

class NormalModel;

class TangentialModel : public LAMMPS_NS::Granular_NS::GranSubModTangential {
 public:
  // Replaces the tangential model of LAMMPS with the tangential law of a line.
  static void add(LAMMPS_NS::Granular_NS::GranularModel* model, LAMMPS_NS::LAMMPS* lammps,
                  const NormalModel& normal, const TangentialLine& line, ContactTally& tally);

  ~TangentialModel() override;
  void coeffs_to_local() override {}

 protected:
  TangentialModel(LAMMPS_NS::Granular_NS::GranularModel* model, LAMMPS_NS::LAMMPS* lammps,
                  const NormalModel& normal, std::size_t values, bool (*changes_sign)(std::size_t),
                  ContactTally& tally);

  const NormalModel& normal_;
  ContactTally& tally_;
};

}  // namespace plastigran
