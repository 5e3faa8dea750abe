// SPDX-License-Identifier: GPL-2.0-or-later
//
// Energy balance of the particles. `compute plastigran/energy` creates this fix with the ID
// `plastigran_energy`. docs/energy_balance.md defines the energy terms, which are the same as in
// LIGGGHTS.
//
// No term is computed as the remainder of the other terms. The laws give elastic energy and plastic
// work. The work of friction, dashpots and walls is the integral of their power by the trapezoidal
// rule, with the velocities at the end of each step. With velocity Verlet, the work of all forces
// then equals the change of the kinetic energy, except for the change of dt^2 F^2/(8 m) with the
// time step dt, and the force F and the mass m of a particle. This difference does not accumulate.
// Power is linear in forces and torques, so their sums for each particle suffice.
#pragma once

#include <array>
#include <vector>

#include "fix.h"

namespace plastigran {

class ContactTally;

// Sum of the forces [N] and torques [N m] on one particle that dissipate energy without plastic
// flow.
struct ParticleLoad {
  double friction[3]{}, torque[3]{};  // from the tangential, rolling and twisting models
  double dashpot[3]{};                // rate-dependent parts of the normal forces
};

class EnergyBalance : public LAMMPS_NS::Fix {
 public:
  // Energy terms [J], in the same order as f_energy_ledger in LIGGGHTS. CONTACTS is the number of
  // contacts [-].
  enum Term {
    KINETIC,
    GRAVITATIONAL,
    ELASTIC,
    PLASTIC,
    FRICTION,
    VISCOUS,
    WALL_WORK,
    INSERTED,
    BALANCE_ERROR,
    TANGENTIAL_SPRINGS,
    SURFACE,
    ADHESION,
    CONTACTS,
    TERMS
  };
  typedef std::array<double, TERMS> Terms;

  // Name of the plastic work of each particle [J] in `fix property/atom`.
  static constexpr const char* particle_work = "plastigran_work";

  EnergyBalance(LAMMPS_NS::LAMMPS* lammps, int count, char** words);

  // Creates the fix of the energy balance if the simulation has none.
  static void create(LAMMPS_NS::LAMMPS* lammps);
  // Returns the fix of the energy balance; null if the simulation has none.
  static EnergyBalance* of(LAMMPS_NS::LAMMPS* lammps);

  // Adds energies dissipated in this step on this rank [J].
  void add_dissipated(double plastic_work, double adhesion_loss) {
    sums_.plastic_work += plastic_work;
    sums_.adhesion_loss += adhesion_loss;
  }
  void add_to_particle(int particle, double plastic_work) { work_[particle] += plastic_work; }
  void add_load(int particle, const ParticleLoad& load);
  // Adds the force of a wall on a particle [N]. `load` is the part that dissipates energy.
  void add_wall(const double* force, const ParticleLoad& load, const double* wall_velocity);
  // Corrects the work of wall forces after the velocity of the wall has changed by `change` [m/s].
  // The forces computed in one step also act in the first half of the next step, at the new
  // velocity.
  void add_wall_change(const double* force, const ParticleLoad& load, const double* change);

  // Number of values that each ghost particle sends to the rank that owns the particle.
  static constexpr int reverse_size = 1 + sizeof(ParticleLoad) / sizeof(double);
  void pack_ghost(int particle, double* buffer) const;
  void add_ghost(int particle, const double* buffer);

  // Returns the energy terms of all ranks. All ranks must call this function.
  Terms terms();

  int setmask() override;
  void init() override;
  void setup_pre_force(int) override { begin_pass(); }
  void setup(int) override;
  void pre_force(int) override { begin_pass(); }
  void post_integrate() override;
  void pre_neighbor() override;
  void end_of_step() override;
  void post_run() override;
  void write_restart(FILE* file) override;
  void restart(char* data) override;

 private:
  // Sums on this rank since the fix was created [J]. Restart files contain the sums of all ranks.
  struct Sums {
    double plastic_work = 0, adhesion_loss = 0, friction = 0, viscous = 0, wall_work = 0;
    double inserted = 0, initial = 0;
    // Used only in restart files: `begun` is 1 if the balance has begun, and `last_state` is the
    // energy when the file was written.
    double begun = 0, last_state = 0;
  };
  struct Power {
    double friction = 0, viscous = 0, wall = 0;  // [W]
  };
  struct ContactEnergies {
    double elastic = 0, surface = 0, springs = 0, contacts = 0;
  };

  std::vector<const ContactTally*> tallies() const;
  void begin_pass();
  void end_setup();
  Power power() const;
  ContactEnergies contact_energies() const;
  double kinetic_energy() const;
  double gravitational_energy() const;
  double mechanical_energy() const { return kinetic_energy() + gravitational_energy(); }
  double state_energy() const;

  Sums sums_;
  Power power_, wall_power_;
  std::vector<ParticleLoad> loads_;
  double* work_ = nullptr;
  // mechanical_: kinetic plus gravitational energy in the setup, or before ranks exchange particles
  // [J]. last_state_: this energy plus the elastic and surface energy of the contacts, at the end
  // of the last run [J].
  double mechanical_ = 0, last_state_ = 0;
  bool started_ = false, in_setup_ = false, has_run_ = false;
};

}  // namespace plastigran
