// SPDX-License-Identifier: GPL-2.0-or-later
//
// The energy ledger: where the energy of the particles is and where it went, as a fix with the
// fixed ID `energy_ledger`. `energy_ledger on` in the pair_style line adds it, with a second fix
// that keeps every particle's plastic work (ID `plastic_work`). docs/energy_ledger.md says what is
// counted.
//
// No entry is the remainder of others. Elastic energy and plastic work are state functions of each
// contact, from its law. Friction and damping have no such function: their work is summed as
// velocity Verlet does it, half a step of the old force and half a step of the new one along the
// displacement between them. Work is linear in the forces, so the forces of each kind are summed by
// particle first and nothing has to be kept by contact; a sum lives from one force computation to
// the next step's displacement, and no particle changes its index in between.
#ifndef PLASTIGRAN_ENERGY_LEDGER_H
#define PLASTIGRAN_ENERGY_LEDGER_H

#include <mpi.h>

#include <array>
#include <cstdio>
#include <cstring>
#include <set>
#include <string>
#include <vector>

#include "atom.h"
#include "comm.h"
#include "contact_interface.h"
#include "domain.h"
#include "error.h"
#include "fix.h"
#include "fix_gravity.h"
#include "fix_property_atom.h"
#include "modify.h"
#include "own_fix.h"
#include "update.h"
#include "wall_point.h"

namespace plastigran {

typedef std::array<double, 3> Vector;

template <class A, class B>
double dot(const A& a, const B& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

class EnergyLedger : public LAMMPS_NS::Fix {
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
    DRIFT,               // the first six - their sum at the start - wall work - inserted
    TANGENTIAL_SPRINGS,  // the part of friction that tangential springs hold at present
    ENTRIES
  };

  EnergyLedger(LAMMPS_NS::LAMMPS* engine, int count, char** words) : Fix(engine, count, words) {
    vector_flag = scalar_flag = 1;
    size_vector = ENTRIES;
    global_freq = 1;
    extvector = extscalar = 1;
    restart_global = 1;
  }

  static const char* id() { return "energy_ledger"; }
  static const char* style() { return "plastigran/energy_ledger"; }

  // Adds the ledger unless there is one. All ranks together.
  static void open(LAMMPS_NS::LAMMPS* engine) {
    if (!engine->domain->box_exist)
      engine->error->all(FLERR, "energy_ledger on: give the pair_style line after create_box");
    if (find_own_fix<EnergyLedger>(engine)) return;
    own_fix<EnergyLedger>(engine);
    // Restarts with the particles, needs no values on ghosts, and starts at zero.
    add_fix(engine->modify, {"plastic_work", "all", "property/atom", "plastic_work", "scalar",
                             "yes", "no", "no", "0.0"});
  }

  // The pair style or wall `owner` reports to the ledger.
  void attach(const void* owner) { attached_.insert(owner); }

  // A contact's law at the present overlap: energy stored, and plastic work since the history was
  // last written.
  void add_law(const Contact& contact, double elastic_energy, double plastic_work) {
    const double share = local_share(contact);
    elastic_ += share * elastic_energy;
    if (contact.shearupdate) {
      plastic_work_ += share * plastic_work;
      double* const of_particle = particle_plastic_work_->vector_atom;
      of_particle[contact.i] += contact.is_wall ? plastic_work : 0.5 * plastic_work;
      if (has_local_partner(contact)) of_particle[contact.j] += 0.5 * plastic_work;
    } else {
      unwritten_plastic_work_ += share * plastic_work;
    }
  }

  // The normal dashpot's force on particle i, along the normal. Before add_forces().
  void add_dashpot(const Contact& contact, double force) {
    for (int axis = 0; axis < 3; ++axis) dashpot_[axis] = force * contact.en[axis];
  }

  // What all models of a contact did together. All of the force that is not along the normal, and
  // all torques, are the work of tangential and rolling models.
  void add_forces(const Contact& contact, const Load& on_i, const Load& on_j,
                  double spring_energy) {
    const double along = dot(on_i.delta_F, contact.en);
    Vector friction;
    for (int axis = 0; axis < 3; ++axis)
      friction[axis] = on_i.delta_F[axis] - along * contact.en[axis];
    add(friction_force_[contact.i], friction, 1);
    add(friction_torque_[contact.i], on_i.delta_torque, 1);
    add(damping_force_[contact.i], dashpot_, 1);
    if (has_local_partner(contact)) {
      add(friction_force_[contact.j], friction, -1);
      add(friction_torque_[contact.j], on_j.delta_torque, 1);
      add(damping_force_[contact.j], dashpot_, -1);
    }
    if (contact.is_wall) {
      const Vector force{on_i.delta_F[0], on_i.delta_F[1], on_i.delta_F[2]};
      walls_.push_back({WallPoint(contact, atom->x[contact.i]), force, friction, dashpot_});
    }
    tangential_springs_ += local_share(contact) * spring_energy;
    dashpot_ = {0, 0, 0};
  }

  int setmask() override {
    using namespace LAMMPS_NS::FixConst;
    return PRE_INITIAL_INTEGRATE | POST_INTEGRATE | PRE_EXCHANGE | PRE_NEIGHBOR | PRE_FORCE |
           PRE_FINAL_INTEGRATE | POST_RUN;
  }

  void init() override {
    particle_plastic_work_ = static_cast<LAMMPS_NS::FixPropertyAtom*>(modify->find_fix_property(
        "plastic_work", "property/atom", "scalar", 0, 0, "energy_ledger"));
    gravity_.clear();
    for (int k = 0; k < modify->n_fixes_style_strict("gravity"); ++k)
      gravity_.push_back(
          static_cast<LAMMPS_NS::FixGravity*>(modify->find_fix_style_strict("gravity", k)));
  }

  // Between two runs a deck may have added, deleted or set particles.
  void setup_pre_exchange() override {
    warn_of_strangers();
    if (ran_) inserted_ += mechanical_energy() - before_;
  }

  void setup_pre_force(int) override { begin_pass(); }
  void pre_force(int) override { begin_pass(); }

  void pre_initial_integrate() override { start(); }

  // Positions are new, velocities those at mid-step, forces still the old ones.
  void post_integrate() override {
    add_work();
    before_ = mechanical_energy();
  }

  void pre_neighbor() override { inserted_ += mechanical_energy() - before_; }

  // The new forces, and still the velocities at mid-step.
  void pre_final_integrate() override { add_work(); }

  void post_run() override {
    before_ = mechanical_energy();
    ran_ = true;
  }

  double compute_scalar() override { return compute_vector(DRIFT); }

  // All ranks together.
  double compute_vector(int entry) override {
    if (!summed_) sum();
    return sums_[entry];
  }

  void write_restart(FILE* file) override {
    double local[4] = {plastic_work_, friction_, viscous_, wall_work_}, kept[6];
    MPI_Reduce(local, kept, 4, MPI_DOUBLE, MPI_SUM, 0, world);
    MPI_Reduce(&inserted_, &kept[4], 1, MPI_DOUBLE, MPI_SUM, 0, world);
    kept[5] = initial_;
    if (comm->me != 0) return;
    const int size = sizeof kept;
    fwrite(&size, sizeof size, 1, file);
    fwrite(kept, sizeof kept, 1, file);
  }

  void restart(char* data) override {
    double kept[6];
    std::memcpy(kept, data, sizeof kept);
    initial_ = kept[5];
    started_ = true;
    if (comm->me != 0) return;  // a sum over ranks: the first one has it all
    plastic_work_ = kept[0], friction_ = kept[1], viscous_ = kept[2], wall_work_ = kept[3];
    inserted_ = kept[4];
  }

 private:
  // A contact on a wall: its forces on the particle, and where the wall's velocity is found. A mesh
  // moves with the particles, between two force computations: its nodes are asked when needed.
  struct WallContact {
    WallPoint point;
    Vector force, friction, dashpot;
  };

  template <class Term>
  static void add(Vector& sum, const Term& term, double sign) {
    for (int axis = 0; axis < 3; ++axis) sum[axis] += sign * term[axis];
  }

  bool has_local_partner(const Contact& contact) const {
    return !contact.is_wall && contact.j < atom->nlocal;
  }

  // A contact with a ghost is seen from its other side as well.
  double local_share(const Contact& contact) const {
    return contact.is_wall || contact.j < atom->nlocal ? 1 : 0.5;
  }

  void begin_pass() {
    elastic_ = unwritten_plastic_work_ = tangential_springs_ = 0;
    summed_ = false;
    walls_.clear();
    for (std::vector<Vector>* sum : {&friction_force_, &friction_torque_, &damping_force_})
      sum->assign(atom->nlocal, Vector{0, 0, 0});
  }

  // Half a step's work of the forces at hand.
  void add_work() {
    double friction = 0, viscous = 0, wall = 0;
    for (const WallContact& contact : walls_) {
      const Vector velocity = contact.point.velocity();
      wall += dot(contact.force, velocity);
      friction += dot(contact.friction, velocity);
      viscous += dot(contact.dashpot, velocity);
    }
    for (std::size_t i = 0; i < friction_force_.size(); ++i) {
      friction -= dot(friction_force_[i], atom->v[i]) + dot(friction_torque_[i], atom->omega[i]);
      viscous -= dot(damping_force_[i], atom->v[i]);
    }
    summed_ = false;
    const double half_step = 0.5 * update->dt;
    friction_ += half_step * friction;
    viscous_ += half_step * viscous;
    wall_work_ += half_step * wall;
  }

  double kinetic_energy() const {
    const double inertia =
        domain->dimension == 2 ? 0.5 : 0.4;  // over m R^2: as fix nve/sphere has it
    double energy = 0;
    for (int i = 0; i < atom->nlocal; ++i) {
      const double* const v = atom->v[i];
      const double* const omega = atom->omega[i];
      energy += 0.5 * atom->rmass[i] *
                (dot(v, v) + inertia * atom->radius[i] * atom->radius[i] * dot(omega, omega));
    }
    return energy;
  }

  double gravitational_energy() const {
    double energy = 0;
    for (LAMMPS_NS::FixGravity* field : gravity_) {
      double acceleration[3];
      field->get_gravity(acceleration);
      for (int i = 0; i < atom->nlocal; ++i) {
        if (!(atom->mask[i] & field->groupbit)) continue;
        double position[3];  // as if the box had no periodic sides
        domain->unmap(atom->x[i], atom->image[i], position);
        energy -= atom->rmass[i] * dot(acceleration, position);
      }
    }
    return energy;
  }

  double mechanical_energy() const { return kinetic_energy() + gravitational_energy(); }

  void sum() {
    const double local[ENTRIES] = {kinetic_energy(),
                                   gravitational_energy(),
                                   elastic_,
                                   plastic_work_ + unwritten_plastic_work_,
                                   friction_,
                                   viscous_,
                                   wall_work_,
                                   inserted_,
                                   0,
                                   tangential_springs_};
    MPI_Allreduce(local, sums_, ENTRIES, MPI_DOUBLE, MPI_SUM, world);
    double total = -sums_[WALL_WORK] - sums_[INSERTED];
    for (int entry = KINETIC; entry < WALL_WORK; ++entry) total += sums_[entry];
    if (!started_ && update->whichflag) started_ = true, initial_ = total;
    sums_[DRIFT] = started_ ? total - initial_ : 0;
    summed_ = true;
  }

  // The sum at the start is taken when all forces of the first set-up are there, walls' too.
  void start() {
    if (!started_) sum();
  }

  // Walls that do not report would show up as drift without a word.
  void warn_of_strangers() {
    std::string strangers;
    for (int k = 0; k < modify->nfix; ++k) {
      LAMMPS_NS::Fix* const wall = modify->fix[k];
      if (std::strncmp(wall->style, "wall/gran", 9) == 0 && !attached_.count(wall))
        strangers += std::string(strangers.empty() ? "" : ", ") + wall->id;
    }
    if (strangers == strangers_) return;
    strangers_ = strangers;
    if (comm->me == 0 && !strangers.empty())
      error->warning(FLERR, ("energy_ledger: what these walls store, dissipate and put in shows as "
                             "drift, they have no energy_ledger on: " +
                             strangers)
                                .c_str());
  }

  LAMMPS_NS::FixPropertyAtom* particle_plastic_work_ = nullptr;
  std::vector<LAMMPS_NS::FixGravity*> gravity_;
  std::set<const void*> attached_;
  std::string strangers_;

  // Of the last force computation, on this rank.
  double elastic_ = 0, tangential_springs_ = 0;
  double unwritten_plastic_work_ = 0;  // set-up computes forces, and writes no history
  Vector dashpot_{};                   // of the contact at hand
  std::vector<WallContact> walls_;
  std::vector<Vector> friction_force_, friction_torque_, damping_force_;  // by local particle

  // Since the ledger was opened, on this rank.
  double plastic_work_ = 0, friction_ = 0, viscous_ = 0, wall_work_ = 0, inserted_ = 0;
  double before_ = 0;  // kinetic and gravitational energy when the particles were last known
  bool ran_ = false;

  double initial_ = 0;  // over all ranks
  bool started_ = false;
  double sums_[ENTRIES] = {};
  bool summed_ = false;  // sums_ are those of the present forces and velocities
};

// A contact model that may report to the ledger: the way from it to its normal model.
struct LedgerUser {
  EnergyLedger* ledger = nullptr;
  virtual ~LedgerUser() {}
};

}  // namespace plastigran

#endif
