// SPDX-License-Identifier: GPL-2.0-or-later
//
// The normal model of LAMMPS' granular contacts for any law. Plugins cannot register such a model.
// LAMMPS therefore reads the line of its own model `hertz/material`, which this model replaces. It
// keeps the name and the coefficients of that model, because restart files and LAMMPS' damping
// models use them.
//
// Contact history: a flag that LAMMPS sets for contacts that outlast the overlap, the state of the
// law, the plastic work, and, for bodies with a rate coefficient, the rate factor. LAMMPS changes
// the sign of history values if it stores a pair from the side of the other particle, unless their
// transfer factor is 1.
#pragma once

#include <memory>
#include <vector>

#include "lammps/contact_tally.h"
#include "lammps/granular_interface.h"
#include "lammps/runtime_law.h"

namespace plastigran {

class NormalModel : public LAMMPS_NS::Granular_NS::GranSubModNormal {
 public:
  typedef std::vector<std::shared_ptr<const RuntimeLaw>> Laws;

  // `laws`: one law, or one for each atom type of the particles at a wall.
  NormalModel(LAMMPS_NS::Granular_NS::GranularModel* model, LAMMPS_NS::LAMMPS* lammps, Laws laws,
              ContactTally& tally);
  ~NormalModel() override;

  // Puts a new NormalModel in the place of the one that LAMMPS has made.
  static void replace(LAMMPS_NS::Granular_NS::GranularModel* model, LAMMPS_NS::LAMMPS* lammps,
                      Laws laws, ContactTally& tally);

  void coeffs_to_local() override {}
  bool touch() override;
  double pulloff_distance(double radius, double other_radius) override;
  // LAMMPS asks for the contact radius first, and then for the force and the limit of friction.
  double calculate_contact_radius() override;
  double calculate_forces() override { return force_; }
  double conservative_force() const { return force_ - viscous_force_; }  // of the last contact [N]
  void set_fncrit() override;

 private:
  const RuntimeLaw& law() const;

  Laws laws_;
  ContactTally& tally_;
  std::size_t state_at_, work_at_, factor_at_;  // in the values of this model
  bool has_rate_;
  double force_ = 0, viscous_force_ = 0, pull_off_force_ = 0;
};

}  // namespace plastigran
