// SPDX-License-Identifier: GPL-2.0-or-later
//
// The tangential model of LAMMPS' granular contacts for a tangential law (plastigran/friction/). It
// takes the place of LAMMPS' model `mindlin`, whose name and coefficients restart files contain.
// The contact history has the state of the law.
#pragma once

#include "lammps/contact_line.h"
#include "lammps/contact_tally.h"
#include "lammps/granular_interface.h"

namespace plastigran {

class NormalModel;

class TangentialModel : public LAMMPS_NS::Granular_NS::GranSubModTangential {
 public:
  // Puts the law of a line in the place of the tangential model that LAMMPS has made.
  static void add(LAMMPS_NS::Granular_NS::GranularModel* model, LAMMPS_NS::LAMMPS* lammps,
                  const NormalModel& normal, const TangentialLine& line, ContactTally& tally);

  ~TangentialModel() override;
  void coeffs_to_local() override {}

 protected:
  TangentialModel(LAMMPS_NS::Granular_NS::GranularModel* model, LAMMPS_NS::LAMMPS* lammps,
                  const NormalModel& normal, std::size_t values, bool (*is_number)(std::size_t),
                  ContactTally& tally);

  const NormalModel& normal_;
  ContactTally& tally_;
};

}  // namespace plastigran
