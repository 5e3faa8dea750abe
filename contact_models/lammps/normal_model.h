// SPDX-License-Identifier: GPL-2.0-or-later
//
// Normal model of LAMMPS' granular contacts for any law. Plugins cannot register a normal model.
// LAMMPS therefore creates its own model `hertz/material`, and this model replaces it. This model
// keeps the name and the coefficients of `hertz/material`, because restart files and LAMMPS'
// damping models use them.
//
// The contact history contains LAMMPS' flag for bodies that touch, the state of the law, and the
// rate factor. The flag exists only for laws whose contacts can last without overlap. The rate
// factor exists only for bodies with a rate coefficient. LAMMPS may later store the history with
// the other particle of the pair. It then multiplies each value by a transfer factor. The default
// of this factor is -1; this model sets 1, because the values do not depend on the order of the
// particles.
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

  // Replaces LAMMPS' normal model with a NormalModel. If the line has a tangential law, also
  // replaces LAMMPS' tangential model with this law.
  static void replace(LAMMPS_NS::Granular_NS::GranularModel* model, LAMMPS_NS::LAMMPS* lammps,
                      Laws laws, const TangentialLine& tangential, ContactTally& tally);

  // Sets the account that counts contacts beyond the validity range.
  void count_in(RangeAccount* account) { account_ = account; }
  const Laws& laws() const { return laws_; }

  void coeffs_to_local() override {}
  bool touch() override;
  double pulloff_distance(double radius, double other_radius) override;
  // Also computes the force and all other results, because LAMMPS calls this function before
  // calculate_forces() and set_fncrit().
  double calculate_contact_radius() override;
  double calculate_forces() override { return force_; }

  // Values of the last computed contact: the force without its viscous part, the force that limits
  // friction, and the tangential stiffness without slip.
  double conservative_force() const { return force_ - viscous_force_; }  // [N]
  double limiting_force() const { return force_ + pull_off_force_; }     // [N]
  double tangential_stiffness() const {                                  // [N/m]
    return law().tangential_stiffness(gm->contact_radius);
  }
  void set_fncrit() override;

 private:
  const RuntimeLaw& law() const;
  double largest_reach(double radius_eff) const;

  Laws laws_;
  ContactTally& tally_;
  RangeAccount* account_ = nullptr;
  std::size_t state_at_, factor_at_;  // offsets in the history values of this model
  bool has_rate_;
  double force_ = 0, viscous_force_ = 0, pull_off_force_ = 0;
};

}  // namespace plastigran
