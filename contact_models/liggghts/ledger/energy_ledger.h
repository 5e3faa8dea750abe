// SPDX-License-Identifier: GPL-2.0-or-later
//
// Energy balance of the particles, as a fix with the ID `energy_ledger`. `energy_ledger on` in the
// pair_style line adds this fix and a second one for the plastic work of every particle (ID
// `plastic_work`). docs/energy_balance.md defines the energy terms.
//
// No term is computed as the remainder of the others. Elastic energy and plastic work are state
// functions of each contact. The work of friction and damping is integrated as velocity Verlet
// moves the particles: half a step of the old force and half a step of the new one, along the
// displacement between them. Work is linear in the forces, so it suffices to sum the forces by
// particle. The sums of one force computation are used in the displacement of the next step: no
// particle changes its index in between.
#pragma once

#include <vector>

#include "atom.h"
#include "contact_interface.h"
#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/ledger/particle_plastic_work.h"
#include "liggghts/model/accounted_load.h"
#include "liggghts/model/lossy_load.h"
#include "liggghts/model/stored_energies.h"
#include "liggghts/model/wall_point.h"
#include "liggghts/observers/contact_observer.h"

namespace plastigran {

class EnergyLedger : public PluginFix {
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;
  typedef LIGGGHTS::ContactModels::ForceData Load;

 public:
  // Elements of the fix's vector f_energy_ledger[1], [2], ...: energy terms [J].
  enum Entry {
    KINETIC,             // kinetic energy of translation and rotation
    GRAVITATIONAL,       // potential energy -m g.x for every fix gravity
    ELASTIC,             // elastic energy of the contacts, from the laws
    PLASTIC,             // plastic work of the contacts, from the laws
    FRICTION,            // work of tangential and rolling models, with springs and dashpots
    VISCOUS,             // work of the normal dashpot, and of the viscous force of a law
    WALL_WORK,           // work of moving walls on the particles
    INSERTED,            // energy of inserted minus deleted particles, and changes between runs
    DRIFT,               // balance error: change of terms 1-6, 11 and 12, minus terms 7 and 8
    TANGENTIAL_SPRINGS,  // elastic energy of tangential springs, a part of FRICTION
    SURFACE,             // surface energy of the contacts, relative to separated bodies
    ADHESION,            // energy lost when contacts with adhesion form and break
    ENTRIES
  };

  EnergyLedger(LAMMPS_NS::LAMMPS* engine, int count, char** words);
  static const char* id() { return "energy_ledger"; }
  static const char* style() { return "plastigran/energy_ledger"; }

  // Adds the energy ledger if there is none. Collective.
  static void open(LAMMPS_NS::LAMMPS* engine);

  // Returns why a line with or without `energy_ledger on` conflicts with `ledger`; null if there is
  // no conflict. `ledger` is null if no line has opened a ledger.
  static const char* complaint(const EnergyLedger* ledger, bool requested, bool is_wall);

  // Registers the pair style or wall `owner`, which will report its contacts. Called in each setup.
  void attach(const void* owner) { owners_.add(owner); }

  // Adds the loads of a contact. All torques, and all forces that are not along the normal, come
  // from the tangential and rolling models.
  void add(const Contact& contact, const AccountedLoad& on_i, const Load& on_j);

  // Adds the energies that a contact and its tangential spring store [J].
  void add_stored(const Contact& contact, double elastic_energy, double surface_energy,
                  double spring_energy);

  // Registers contacts whose stored energies are computed when an energy term is read.
  void defer(StoredEnergies& contacts) { deferred_ = &contacts; }

  int setmask() override;
  void init() override;

  void setup_pre_exchange() override;

  void setup_pre_force(int) override {
    particle_plastic_work_->begin();
    begin_pass();
    phase_ = SETUP;
  }
  void pre_force(int) override { begin_pass(); }

  // Ends the setup: at this time all its forces are known, including wall forces.
  void pre_initial_integrate() override {
    if (phase_ == BETWEEN_RUNS) begin_without_setup();
    if (phase_ == SETUP) end_setup();
    phase_ = STEP;
  }

  // Adds the work of the old forces. Positions are new, and velocities are at mid-step. If another
  // fix acts before pre_exchange() of this fix, also saves the mechanical energy here.
  void post_integrate() override {
    add_work();
    if (!acts_first_) mechanical_before_ = mechanical_energy();
  }

  // Saves the mechanical energy before LIGGGHTS inserts or deletes particles, or moves them to
  // other ranks.
  void pre_exchange() override {
    if (acts_first_) mechanical_before_ = mechanical_energy();
  }

  void pre_neighbor() override { sums_.inserted += mechanical_energy() - mechanical_before_; }

  // Adds the work of the new forces. Velocities are at mid-step.
  void pre_final_integrate() override {
    add_work();
    phase_ = STEP_END;
  }

  void post_run() override {
    if (phase_ == BETWEEN_RUNS) begin_without_setup();  // true for `run 0`
    if (phase_ == SETUP) end_setup();
    phase_ = BETWEEN_RUNS;
    ran_ = true;
    if (!terms_are_current_) sum();
    mechanical_before_ = mechanical_energy();
    contacts_before_ = contact_energy();
  }

  double compute_scalar() override { return compute_vector(DRIFT); }

  // Returns an energy term [J]; between runs, its value at the end of the last run. Collective.
  double compute_vector(int entry) override;

  void write_restart(FILE* file) override;
  void restart(char* data) override;

 private:
  // Sum of the loads of tangential and rolling models on one particle.
  struct FrictionLoad {
    Vector force{}, torque{};
  };

  // Contact with a wall, and its forces on the particle. The wall velocity is read when needed,
  // because a mesh moves between two force computations.
  struct WallContact {
    WallPoint point;
    Vector force, friction, dashpot;
  };

  struct Stored {
    double elastic = 0, surface = 0, springs = 0;
  };

  // Sums on this rank since the ledger was opened, and the total energy of all ranks at that time
  // [J]. Restart files contain them in this order.
  struct Sums {
    double plastic_work = 0, friction = 0, viscous = 0, wall_work = 0, inserted = 0;
    double initial_total = 0, adhesion_loss = 0;
  };

  // Returns the fraction of a contact's energies to count: 1/2 with a ghost, because the rank of
  // the other particle reports the contact too.
  static double share_of(const Contact& contact, bool has_local_partner) {
    return contact.is_wall || has_local_partner ? 1 : 0.5;
  }

  // Phase of the simulation. In phase STEP, energy terms are unknown until all forces are computed.
  enum Phase { BETWEEN_RUNS, SETUP, STEP, STEP_END };

  void count_deferred();
  void count_changes();
  void end_setup();
  void begin_without_setup();
  void add_plastic_work(const Contact& contact, double work, bool has_local_partner);
  void add_adhesion_loss(const Contact& contact, double loss, bool has_local_partner);
  void add_dashpot(const Contact& contact, double force, bool has_local_partner);
  void add_wall(const Contact& contact, const AccountedLoad& on_i, const Vector& friction);
  void begin_pass();
  void add_work();
  double kinetic_energy() const;
  double gravitational_energy() const;
  double mechanical_energy() const { return kinetic_energy() + gravitational_energy(); }
  double contact_energy() const {
    return by_pairs_.elastic + by_walls_.elastic + by_pairs_.surface + by_walls_.surface +
           sums_.plastic_work + plastic_work_of_run_0_ + sums_.adhesion_loss +
           adhesion_loss_of_run_0_;
  }
  double change_of_contacts() const;
  void report_change_of_contacts() const;
  void sum();
  bool is_first_before_exchange() const;
  void refuse_unsupported();
  void check_owners();

  ParticlePlasticWork* particle_plastic_work_ = nullptr;
  ReportingOwners owners_;
  Phase phase_ = BETWEEN_RUNS;
  bool ran_ = false;
  bool acts_first_ = false;  // whether pre_exchange() of this fix runs before that of other fixes

  // Energies stored in contacts in the last force computation, on this rank. Pairs and walls have
  // separate sums, so that the results do not depend on which of them LIGGGHTS computes first.
  Stored by_pairs_, by_walls_;
  StoredEnergies* deferred_ = nullptr;  // contacts to add to these sums when needed
  // Plastic work and adhesion loss in `run 0`. They are not in sums_, because `run 0` writes no
  // contact history and the next setup reports them again.
  double plastic_work_of_run_0_ = 0, adhesion_loss_of_run_0_ = 0;
  std::vector<WallContact> walls_;
  std::vector<FrictionLoad> friction_;  // by local particle index
  std::vector<Vector> dashpots_;        // forces by local particle index; empty without dashpots

  Sums sums_;
  double mechanical_before_ = 0;  // energy before LIGGGHTS or the deck changes particles [J]
  double contacts_before_ = 0;    // contact_energy() at the end of the last run

  // Energy terms over all ranks [J], and whether they belong to the current step.
  double terms_[ENTRIES] = {};
  bool terms_are_current_ = false;
  double total_ = 0;
  bool started_ = false;
};

// Inline, because this function is called for every contact in every step.
inline void EnergyLedger::add(const Contact& contact, const AccountedLoad& on_i, const Load& on_j) {
  const bool has_local_partner = !contact.is_wall && contact.j < atom->nlocal;
  const double along = dot(on_i.delta_F, contact.en);
  Vector friction;
  for (int axis = 0; axis < 3; ++axis)
    friction[axis] = on_i.delta_F[axis] - along * contact.en[axis];
  FrictionLoad& of_i = friction_[contact.i];
  for (int axis = 0; axis < 3; ++axis) {
    of_i.force[axis] += friction[axis];
    of_i.torque[axis] += on_i.delta_torque[axis];
  }
  if (has_local_partner) {
    FrictionLoad& of_j = friction_[contact.j];
    for (int axis = 0; axis < 3; ++axis) {
      of_j.force[axis] -= friction[axis];
      of_j.torque[axis] += on_j.delta_torque[axis];
    }
  }
  if (on_i.plastic_work != 0) add_plastic_work(contact, on_i.plastic_work, has_local_partner);
  if (on_i.adhesion_loss != 0) add_adhesion_loss(contact, on_i.adhesion_loss, has_local_partner);
  if (on_i.dashpot_force != 0) add_dashpot(contact, on_i.dashpot_force, has_local_partner);
  if (contact.is_wall) add_wall(contact, on_i, friction);
}

}  // namespace plastigran
