// SPDX-License-Identifier: GPL-2.0-or-later
//
// The energy ledger: where the energy of the particles is and where it went, as a fix with the
// fixed ID `energy_ledger`. `energy_ledger on` in the pair_style line adds it, with a second fix
// that keeps every particle's plastic work (ID `plastic_work`). docs/energy_balance.md says what is
// counted.
//
// No entry is the remainder of others. Elastic energy and plastic work are state functions of each
// contact, from its law. Friction and damping have no such function: their work is summed as
// velocity Verlet does it, half a step of the old force and half a step of the new one along the
// displacement between them. Work is linear in the forces, so the forces of each kind are summed by
// particle first and nothing has to be kept by contact; a sum lives from one force computation to
// the next step's displacement, and no particle changes its index in between.
#pragma once

#include <cstdio>
#include <set>
#include <string>
#include <vector>

#include "atom.h"
#include "contact_interface.h"
#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/ledger/particle_plastic_work.h"
#include "liggghts/model/accounted_load.h"
#include "liggghts/model/lossy_load.h"
#include "liggghts/model/stored_energies.h"
#include "liggghts/model/wall_point.h"

namespace plastigran {

class EnergyLedger : public PluginFix {
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;
  typedef LIGGGHTS::ContactModels::ForceData Load;

 public:
  // Elements of the fix's vector, in the order users see, from 1 on [J].
  enum Entry {
    KINETIC,             // translation and rotation
    GRAVITATIONAL,       // -m g.x in every fix gravity
    ELASTIC,             // stored by the laws in the contacts
    PLASTIC,             // plastic work
    FRICTION,            // taken by tangential and rolling models, springs and dashpots included
    VISCOUS,             // taken by the normal dashpot
    WALL_WORK,           // put in by moving walls
    INSERTED,            // came with inserted particles, less what left with deleted ones
    DRIFT,               // the first six, surface and adhesion - their sum at the start - wall work
                         // - inserted
    TANGENTIAL_SPRINGS,  // the part of friction that tangential springs hold at present
    SURFACE,             // surface energy of the contacts, relative to separated bodies
    ADHESION,            // lost where contacts with adhesion formed and broke
    ENTRIES
  };

  EnergyLedger(LAMMPS_NS::LAMMPS* engine, int count, char** words);
  static const char* id() { return "energy_ledger"; }
  static const char* style() { return "plastigran/energy_ledger"; }

  // Adds the ledger unless there is one. All ranks together.
  static void open(LAMMPS_NS::LAMMPS* engine);

  // What is wrong with a pair style's or wall's line that asks for this ledger (null: there is
  // none), or does not ask; null when nothing is.
  static const char* complaint(const EnergyLedger* ledger, bool asked, bool is_wall);

  // The pair style or wall `owner` reports to the ledger.
  void attach(const void* owner) { attached_.insert(owner); }

  // What all models of a contact did together, and what its normal model says of that. All of the
  // force that is not along the normal, and all torques, are the work of tangential and rolling
  // models.
  void add(const Contact& contact, const AccountedLoad& on_i, const Load& on_j);

  // What a contact stores, and its tangential spring does [J].
  void add_stored(const Contact& contact, double elastic_energy, double surface_energy,
                  double spring_energy);

  // What these contacts store is not added, and will be asked for when an entry is.
  void defer(StoredEnergies& contacts) { deferred_ = &contacts; }

  int setmask() override;
  void init() override;

  // Between two runs a deck may have added, deleted or set particles.
  void setup_pre_exchange() override;

  void setup_pre_force(int) override {
    particle_plastic_work_->begin();
    begin_pass();
    phase_ = SET_UP;
  }
  void pre_force(int) override { begin_pass(); }

  // The sum at the start is taken when all forces of the first set-up are there, walls' too.
  void pre_initial_integrate() override {
    if (phase_ == BETWEEN_RUNS) begin_without_set_up();
    if (phase_ == SET_UP) end_set_up();
    phase_ = STEP;
  }

  // Positions are new, velocities those at mid-step, forces still the old ones.
  void post_integrate() override {
    add_work();
    if (!acts_first_) before_ = mechanical_energy();
  }

  // Before particles are inserted, deleted and handed to other ranks.
  void pre_exchange() override {
    if (acts_first_) before_ = mechanical_energy();
  }

  void pre_neighbor() override { inserted_ += mechanical_energy() - before_; }

  // The new forces, and still the velocities at mid-step.
  void pre_final_integrate() override {
    add_work();
    phase_ = STEP_END;
  }

  void post_run() override {
    if (phase_ == BETWEEN_RUNS) begin_without_set_up();  // a run of no steps
    if (phase_ == SET_UP) end_set_up();
    phase_ = BETWEEN_RUNS;
    ran_ = true;
    if (!summed_) sum();
    before_ = mechanical_energy();
    contacts_before_ = contact_energy();
  }

  double compute_scalar() override { return compute_vector(DRIFT); }

  // All ranks together. Between runs the entries are those the last one ended with.
  double compute_vector(int entry) override;

  void write_restart(FILE* file) override;
  void restart(char* data) override;

 private:
  // What takes energy from a particle's motion beside dashpots: forces of friction, and all
  // torques.
  struct Losses {
    Vector friction{}, torque{};
  };

  // A contact on a wall: its forces on the particle, and where the wall's velocity is found. A mesh
  // moves with the particles, between two force computations: its nodes are asked when needed.
  struct WallContact {
    WallPoint point;
    Vector force, friction, dashpot;
  };

  // What laws and tangential springs store.
  struct Stored {
    double elastic = 0, surface = 0, springs = 0;
  };

  // Of a contact's energies. One with a ghost is seen from its other side as well.
  static double share_of(const Contact& contact, bool has_local_partner) {
    return contact.is_wall || has_local_partner ? 1 : 0.5;
  }

  // Where the engine is. Entries are known when all forces are: not within a step. In set-up walls
  // may be to come, and before the first run anything, so that nothing is kept.
  enum Phase { BETWEEN_RUNS, SET_UP, STEP, STEP_END };

  void count_deferred();
  void start();
  void book_changes();
  void end_set_up();
  void begin_without_set_up();  // of a run with `pre no`
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
           plastic_work_ + plastic_work_of_run_0_ + adhesion_loss_ + adhesion_loss_of_run_0_;
  }
  double change_of_contacts() const;
  void report_change_of_contacts() const;
  void sum();
  bool is_first_before_exchange() const;
  void refuse_what_is_not_counted();
  void warn_of_strangers();

  ParticlePlasticWork* particle_plastic_work_ = nullptr;
  std::set<const void*> attached_;  // for the coming run
  std::string strangers_;

  // Of the last force computation, on this rank.
  Stored by_pairs_, by_walls_;          // apart: sums do not depend on which is asked first
  StoredEnergies* deferred_ = nullptr;  // of contacts that are not in these sums yet
  Phase phase_ = BETWEEN_RUNS;
  std::vector<WallContact> walls_;
  std::vector<Losses> losses_;    // by local particle
  std::vector<Vector> dashpots_;  // forces, by local particle; of no length where none acted

  // Since the ledger was opened, on this rank.
  double plastic_work_ = 0, friction_ = 0, viscous_ = 0, wall_work_ = 0, inserted_ = 0;
  double adhesion_loss_ = 0;
  // Of the last force computation, not in the sums above.
  double plastic_work_of_run_0_ = 0, adhesion_loss_of_run_0_ = 0;
  double before_ = 0;  // kinetic and gravitational energy when the particles were last known
  double contacts_before_ = 0;  // elastic energy and plastic work at the end of the last run
  bool acts_first_ = false;     // no fix that acts in pre_exchange() stands before this one
  bool ran_ = false;

  double total_ = 0, initial_ = 0;  // over all ranks: now, and at the start
  bool started_ = false;
  double sums_[ENTRIES] = {};
  bool summed_ = false;  // sums_ are those of the present forces and velocities
};

// For every contact of every step.
inline void EnergyLedger::add(const Contact& contact, const AccountedLoad& on_i, const Load& on_j) {
  const bool has_local_partner = !contact.is_wall && contact.j < atom->nlocal;
  const double along = dot(on_i.delta_F, contact.en);
  Vector friction;
  for (int axis = 0; axis < 3; ++axis)
    friction[axis] = on_i.delta_F[axis] - along * contact.en[axis];
  Losses& of_i = losses_[contact.i];
  for (int axis = 0; axis < 3; ++axis) {
    of_i.friction[axis] += friction[axis];
    of_i.torque[axis] += on_i.delta_torque[axis];
  }
  if (has_local_partner) {
    Losses& of_j = losses_[contact.j];
    for (int axis = 0; axis < 3; ++axis) {
      of_j.friction[axis] -= friction[axis];
      of_j.torque[axis] += on_j.delta_torque[axis];
    }
  }
  if (on_i.plastic_work != 0) add_plastic_work(contact, on_i.plastic_work, has_local_partner);
  if (on_i.adhesion_loss != 0) add_adhesion_loss(contact, on_i.adhesion_loss, has_local_partner);
  if (on_i.dashpot_force != 0) add_dashpot(contact, on_i.dashpot_force, has_local_partner);
  if (contact.is_wall) add_wall(contact, on_i, friction);
}

}  // namespace plastigran
