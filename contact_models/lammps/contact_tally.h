// SPDX-License-Identifier: GPL-2.0-or-later
//
// Sums of the energies, forces and torques of all contacts of a pair style or a wall, for the
// energy balance. The sums refer to one computation of the forces. If two ranks compute a contact,
// each rank counts half of its energies.
#pragma once

#include "lammps/energy_balance.h"
#include "lammps/granular_interface.h"
#include "lammps/runtime_law.h"
#include "plastigran/pairs/range_account.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

class ContactTally {
 public:
  virtual ~ContactTally() noexcept(false) = default;  // noexcept(false), as in LAMMPS

  // Call begin() before a force computation and end() after it. The other functions ignore contacts
  // that LAMMPS computes at other times, for example for a command such as `compute pair/local`.
  void begin(LAMMPS_NS::LAMMPS* lammps);
  void end() { active_ = false; }

  // Returns whether the energies of the current contact enter the energy balance.
  bool counts_energies() const { return active_ && balance_; }

  // Adds the energies of a contact that enter the energy balance. `plastic_work` and
  // `adhesion_loss` are dissipated in this step [J].
  void add(const LAMMPS_NS::Granular_NS::GranularModel& contact, const Response& response,
           double plastic_work, double adhesion_loss) {
    const double share = is_shared(contact) ? 0.5 : 1;
    if (contact.delta > 0 || response.contact_radius > 0) contacts += share;
    elastic_energy += share * response.elastic_energy;
    surface_energy += share * response.surface_energy;
    if (plastic_work != 0 || adhesion_loss != 0)
      add_dissipated(contact, plastic_work, adhesion_loss);
  }

  // Counts a contact beyond the validity range of its law, whose state changes from `before` to
  // `now`.
  void add_deep(const LAMMPS_NS::Granular_NS::GranularModel& contact, const RuntimeLaw& law,
                RangeAccount& account, double factor, const double* before, const double* now);

  // Adds the forces and torques of a contact. `viscous` is the rate-dependent part of the normal
  // force on the first particle [N].
  void add_loads(const LAMMPS_NS::Granular_NS::GranularModel& contact, double viscous);

  // Adds the energy of a tangential spring [J].
  void add_spring(const LAMMPS_NS::Granular_NS::GranularModel& contact, double energy) {
    if (counts_energies()) spring_energy += (is_shared(contact) ? 0.5 : 1) * energy;
  }

  // Number of contacts on this rank, and sums of their energies [J].
  double contacts = 0, elastic_energy = 0, surface_energy = 0, spring_energy = 0;
  bool lacks_loads = false;  // true if a heat model of the deck replaces LoadModel

 protected:
  // Sum of the forces of a wall on the particles of this rank. `lossy` is the part that dissipates
  // energy without plastic flow.
  struct WallLoad {
    double force[3]{};  // [N]
    ParticleLoad lossy;
  };
  WallLoad wall_load_;
  EnergyBalance* balance_ = nullptr;

 private:
  // Returns the local index of a particle from the address of its velocity in LAMMPS' contact.
  int index(const double* velocity) const { return static_cast<int>((velocity - velocities_) / 3); }
  // Returns whether another rank also computes this contact.
  bool is_shared(const LAMMPS_NS::Granular_NS::GranularModel& contact) const {
    return contact.contact_type == LAMMPS_NS::Granular_NS::PAIR && !newton_ &&
           index(contact.vj) >= nlocal_;
  }
  void add_dissipated(const LAMMPS_NS::Granular_NS::GranularModel& contact, double plastic_work,
                      double adhesion_loss);

  bool active_ = false, newton_ = true, run_begins_ = false;
  int nlocal_ = 0;
  const double* velocities_ = nullptr;  // address of the velocity of particle 0
};

}  // namespace plastigran
