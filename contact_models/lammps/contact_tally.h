// SPDX-License-Identifier: GPL-2.0-or-later
//
// The energies of the contacts of a pair style or a wall. Dissipated energy goes to the particles,
// so it moves with them between ranks, and restart files contain it. If ranks share a contact, each
// counts half.
#pragma once

#include "lammps/granular_interface.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

class ContactTally {
 public:
  // Values per particle, in this order, of the fix `property/atom` of `compute plastigran/energy`.
  static constexpr const char* particle_values[2] = {"plastigran_work", "plastigran_loss"};

  virtual ~ContactTally() noexcept(false) = default;  // as LAMMPS' base classes

  // The contacts of one force computation lie between `begin` and `end`.
  void begin(LAMMPS_NS::LAMMPS* lammps, bool clears_ghosts);
  void end() { active_ = false; }

  // Adds a contact; `dissipated`: plastic work and loss by adhesion in this step [J].
  void add(const LAMMPS_NS::Granular_NS::GranularModel& contact, const Response& response,
           double overlap_limit, double plastic_work, double adhesion_loss) {
    if (!active_) return;
    const double share = is_shared(contact) ? 0.5 : 1;
    if (contact.delta > 0 || response.contact_radius > 0) contacts += share;
    elastic_energy += share * response.elastic_energy;
    surface_energy += share * response.surface_energy;
    if (contact.delta > furthest * overlap_limit) furthest = contact.delta / overlap_limit;
    if (dissipated_[0] && (plastic_work != 0 || adhesion_loss != 0))
      add_dissipated(contact, {plastic_work, adhesion_loss});
  }

  bool counts_particles() const { return dissipated_[0] != nullptr; }
  double* dissipated(int k) const { return dissipated_[k]; }

  // Sums of this rank.
  double contacts = 0, elastic_energy = 0, surface_energy = 0;
  double furthest = 1;  // largest overlap divided by the limit of the law, if above 1

 private:
  struct Dissipated {
    double energy[2];
  };

  int index(const double* velocity) const { return static_cast<int>((velocity - velocities_) / 3); }
  bool is_shared(const LAMMPS_NS::Granular_NS::GranularModel& contact) const {
    return contact.contact_type == LAMMPS_NS::Granular_NS::PAIR && !newton_ &&
           index(contact.vj) >= nlocal_;
  }
  void add_dissipated(const LAMMPS_NS::Granular_NS::GranularModel& contact,
                      const Dissipated& dissipated);

  bool active_ = false, newton_ = true;
  int nlocal_ = 0;
  const double* velocities_ = nullptr;
  double* dissipated_[2] = {nullptr, nullptr};
};

}  // namespace plastigran
