// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/ledger/energy_ledger.h"

#include <mpi.h>

#include <cmath>
#include <cstring>
#include <sstream>
#include <utility>

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_gravity.h"
#include "liggghts/fixes/print.h"
#include "liggghts/model/deck_units.h"
#include "modify.h"
#include "update.h"

namespace plastigran {

EnergyLedger::EnergyLedger(LAMMPS_NS::LAMMPS* engine, int count, char** words)
    : PluginFix(engine, count, words) {
  vector_flag = scalar_flag = 1;
  size_vector = ENTRIES;
  global_freq = 1;
  extvector = extscalar = 1;
  restart_global = 1;
}

void EnergyLedger::open(LAMMPS_NS::LAMMPS* engine) {
  if (!engine->domain->box_exist)
    engine->error->all(FLERR, "energy_ledger on: give the pair_style line after create_box");
  if (find_fix<EnergyLedger>(engine)) return;
  ensure_fix<EnergyLedger>(engine);
  // Restarts with the particles, needs no values on ghosts, and starts at zero.
  add_style<ParticlePlasticWork>(engine->modify);
  add_fix(engine->modify, {ParticlePlasticWork::id(), "all", ParticlePlasticWork::style(),
                           "plastic_work", "scalar", "yes", "no", "no", "0.0"});
}

int EnergyLedger::setmask() {
  using namespace LAMMPS_NS::FixConst;
  return PRE_INITIAL_INTEGRATE | POST_INTEGRATE | PRE_EXCHANGE | PRE_NEIGHBOR | PRE_FORCE |
         PRE_FINAL_INTEGRATE | POST_RUN;
}

void EnergyLedger::init() {
  refuse_what_is_not_counted();
  acts_first_ = is_first_before_exchange();
  particle_plastic_work_ = find_fix<ParticlePlasticWork>(lmp);
  if (!particle_plastic_work_)
    error->all(
        FLERR,
        "energy_ledger on: its fix plastic_work was removed (unfix plastic_work). Keep it, or "
        "remove energy_ledger too and give the pair_style and wall lines again without it");
}

bool EnergyLedger::is_first_before_exchange() const {
  int k = 0;
  while (modify->fix[k] != this && !(modify->fmask[k] & LAMMPS_NS::FixConst::PRE_EXCHANGE)) ++k;
  return modify->fix[k] == this;
}

void EnergyLedger::setup_pre_exchange() {
  warn_of_strangers();
  if (ran_) book_changes();
}

// Books what the deck has changed in the motion of the particles since the last run.
void EnergyLedger::book_changes() {
  const double now = mechanical_energy();
  inserted_ += now - before_;
  before_ = now;  // commands that write files set up, too, and the next run once more
}

// Elastic energy and plastic work that the deck's changes since the last run have added to the
// contacts, known once set-up has computed all forces: other positions, diameters, atom types or
// constants, particles and walls that came or went. On this rank; only the sum over ranks counts.
double EnergyLedger::change_of_contacts() const {
  return ran_ && phase_ == SET_UP ? contact_energy() - contacts_before_ : 0;
}

// Where it is more than rounding.
void EnergyLedger::report_change_of_contacts() const {
  const double local[] = {change_of_contacts(), contact_energy()};
  double sums[2];
  MPI_Allreduce(local, sums, 2, MPI_DOUBLE, MPI_SUM, world);
  if (comm->me != 0 || std::abs(sums[0]) <= 1e-6 * sums[1]) return;
  std::ostringstream text;
  text << "energy_ledger: between the runs the deck changed the energy of contacts by " << sums[0]
       << ' ' << unit_in_deck(update->unit_style, "J") << " (part of the entry inserted)\n";
  print(lmp, text.str());
}

// All forces of the set-up are known, walls' too.
void EnergyLedger::end_set_up() {
  count_deferred();
  inserted_ += change_of_contacts();
  report_change_of_contacts();
  phase_ = BETWEEN_RUNS;
  summed_ = false;
  if (!started_) start();
}

void EnergyLedger::begin_without_set_up() {
  int changed = losses_.size() != std::size_t(atom->nlocal), anywhere = 0;
  MPI_Allreduce(&changed, &anywhere, 1, MPI_INT, MPI_MAX, world);
  if (anywhere)
    error->all(FLERR,
               "energy_ledger: particles have come or gone since the last run, and this one has no "
               "set-up: leave out `pre no`");
  book_changes();
  summed_ = false;
}

void EnergyLedger::add_stored(const Contact& contact, double elastic_energy, double surface_energy,
                              double spring_energy) {
  const bool has_local_partner = !contact.is_wall && contact.j < atom->nlocal;
  const double share = share_of(contact, has_local_partner);
  Stored& stored = contact.is_wall ? by_walls_ : by_pairs_;
  stored.elastic += share * elastic_energy;
  stored.surface += share * surface_energy;
  stored.springs += share * spring_energy;
}

double EnergyLedger::compute_vector(int entry) {
  if (phase_ == STEP)
    error->all(FLERR,
               "energy_ledger: a term was read within a step, before all forces are known. Read it "
               "at the end of a step, or take the term of the previous step from a fix ave/time 1 "
               "1 1");
  if (!summed_) sum();
  return sums_[entry];
}

void EnergyLedger::start() {
  sum();
  started_ = true;
  initial_ = total_;
  sums_[DRIFT] = 0;
}

// On this rank alone.
void EnergyLedger::count_deferred() {
  if (deferred_) std::exchange(deferred_, nullptr)->count_stored_energies();
}

void EnergyLedger::add_plastic_work(const Contact& contact, double work, bool has_local_partner) {
  const double share = share_of(contact, has_local_partner) * work;
  if (update->nsteps == 0) {  // `run 0` writes no history: the next set-up asks again
    plastic_work_of_run_0_ += share;
    return;
  }
  plastic_work_ += share;
  double* const of_particle = particle_plastic_work_->vector_atom;
  of_particle[contact.i] += contact.is_wall ? work : 0.5 * work;
  if (has_local_partner) of_particle[contact.j] += 0.5 * work;
}

void EnergyLedger::add_adhesion_loss(const Contact& contact, double loss, bool has_local_partner) {
  // `run 0` writes no history: the next set-up counts the loss again.
  double& sum = update->nsteps == 0 ? adhesion_loss_of_run_0_ : adhesion_loss_;
  sum += share_of(contact, has_local_partner) * loss;
}

void EnergyLedger::add_dashpot(const Contact& contact, double force, bool has_local_partner) {
  if (dashpots_.empty()) dashpots_.assign(atom->nlocal, Vector());
  for (int axis = 0; axis < 3; ++axis) {
    dashpots_[contact.i][axis] += force * contact.en[axis];
    if (has_local_partner) dashpots_[contact.j][axis] -= force * contact.en[axis];
  }
}

void EnergyLedger::add_wall(const Contact& contact, const AccountedLoad& on_i,
                            const Vector& friction) {
  const Vector force{on_i.delta_F[0], on_i.delta_F[1], on_i.delta_F[2]};
  Vector dashpot;
  for (int axis = 0; axis < 3; ++axis) dashpot[axis] = on_i.dashpot_force * contact.en[axis];
  walls_.push_back({WallPoint(contact, atom->x[contact.i]), force, friction, dashpot});
}

void EnergyLedger::begin_pass() {
  by_pairs_ = by_walls_ = Stored();
  plastic_work_of_run_0_ = adhesion_loss_of_run_0_ = 0;
  summed_ = false;
  deferred_ = nullptr;
  walls_.clear();
  losses_.assign(atom->nlocal, Losses());
  dashpots_.clear();
}

// Half a step's work of the forces at hand.
void EnergyLedger::add_work() {
  double friction = 0, viscous = 0, wall = 0;
  for (const WallContact& contact : walls_) {
    const Vector velocity = contact.point.velocity();
    wall += dot(contact.force, velocity);
    friction += dot(contact.friction, velocity);
    viscous += dot(contact.dashpot, velocity);
  }
  for (std::size_t i = 0; i < losses_.size(); ++i)
    friction -= dot(losses_[i].friction, atom->v[i]) + dot(losses_[i].torque, atom->omega[i]);
  for (std::size_t i = 0; i < dashpots_.size(); ++i) viscous -= dot(dashpots_[i], atom->v[i]);
  summed_ = false;
  const double half_step = 0.5 * update->dt;
  friction_ += half_step * friction;
  viscous_ += half_step * viscous;
  wall_work_ += half_step * wall;
}

double EnergyLedger::kinetic_energy() const {
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

double EnergyLedger::gravitational_energy() const {
  double energy = 0;
  for (int k = 0; k < modify->n_fixes_style_strict("gravity"); ++k) {
    const auto field =
        static_cast<LAMMPS_NS::FixGravity*>(modify->find_fix_style_strict("gravity", k));
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

void EnergyLedger::sum() {
  count_deferred();
  const double local[ENTRIES] = {kinetic_energy(),
                                 gravitational_energy(),
                                 by_pairs_.elastic + by_walls_.elastic,
                                 plastic_work_ + plastic_work_of_run_0_,
                                 friction_,
                                 viscous_,
                                 wall_work_,
                                 inserted_ + change_of_contacts(),
                                 0,
                                 by_pairs_.springs + by_walls_.springs,
                                 by_pairs_.surface + by_walls_.surface,
                                 adhesion_loss_ + adhesion_loss_of_run_0_};
  MPI_Allreduce(local, sums_, ENTRIES, MPI_DOUBLE, MPI_SUM, world);
  total_ = sums_[SURFACE] + sums_[ADHESION] - sums_[WALL_WORK] - sums_[INSERTED];
  for (int entry = KINETIC; entry < WALL_WORK; ++entry) total_ += sums_[entry];
  sums_[DRIFT] = started_ ? total_ - initial_ : 0;
  summed_ = phase_ != SET_UP && (ran_ || phase_ != BETWEEN_RUNS);
}

void EnergyLedger::write_restart(FILE* file) {
  double local[4] = {plastic_work_, friction_, viscous_, wall_work_}, kept[7];
  MPI_Reduce(local, kept, 4, MPI_DOUBLE, MPI_SUM, 0, world);
  MPI_Reduce(&inserted_, &kept[4], 1, MPI_DOUBLE, MPI_SUM, 0, world);
  kept[5] = initial_;
  MPI_Reduce(&adhesion_loss_, &kept[6], 1, MPI_DOUBLE, MPI_SUM, 0, world);
  if (comm->me != 0) return;
  const int size = sizeof kept;
  fwrite(&size, sizeof size, 1, file);
  fwrite(kept, sizeof kept, 1, file);
}

void EnergyLedger::restart(char* data) {
  double kept[7];
  std::memcpy(kept, data, sizeof kept);
  initial_ = kept[5];
  started_ = true;
  if (comm->me != 0) return;  // a sum over ranks: the first one has it all
  plastic_work_ = kept[0], friction_ = kept[1], viscous_ = kept[2], wall_work_ = kept[3];
  inserted_ = kept[4], adhesion_loss_ = kept[6];
}

}  // namespace plastigran
