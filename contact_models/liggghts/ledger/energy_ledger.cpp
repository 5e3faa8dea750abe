// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/ledger/energy_ledger.h"

#include <mpi.h>

#include <cmath>
#include <cstring>
#include <sstream>
#include <utility>

#include "domain.h"
#include "fix_gravity.h"
#include "force.h"
#include "liggghts/fixes/ranks.h"
#include "liggghts/model/deck_units.h"
#include "pair.h"

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
    stop(engine,
         "energy_ledger on: the simulation box is missing. Move the pair_style line after "
         "create_box");
  if (find_fix<EnergyLedger>(engine)) return;
  ensure_fix<EnergyLedger>(engine);
  // The last words of the fix property/atom mean: saved in restart files (yes), not sent to ghosts
  // (no, no), initial value 0.
  add_style<ParticlePlasticWork>(engine->modify);
  add_fix(engine->modify, {ParticlePlasticWork::id(), "all", ParticlePlasticWork::style(),
                           "plastic_work", "scalar", "yes", "no", "no", "0.0"});
}

int EnergyLedger::setmask() {
  using namespace LAMMPS_NS::FixConst;
  return PRE_INITIAL_INTEGRATE | POST_INTEGRATE | PRE_EXCHANGE | PRE_NEIGHBOR | PRE_FORCE |
         PRE_FINAL_INTEGRATE | POST_RUN;
}

const char* EnergyLedger::complaint(const EnergyLedger* ledger, bool requested, bool is_wall) {
  if (requested && !ledger)
    return is_wall
               ? "energy_ledger on: a wall has this setting, so the pair_style line needs it too"
               : "energy_ledger on: its fix was removed (unfix energy_ledger). Keep this fix, or "
                 "give the pair_style and wall lines again without energy_ledger on";
  if (ledger && !requested && !is_wall)
    return "pair_style: the line has no energy_ledger on, but an earlier line has opened the "
           "energy ledger. Add `energy_ledger on`, or close the ledger first: unfix energy_ledger, "
           "unfix plastic_work";
  return nullptr;
}

void EnergyLedger::refuse_unsupported() {
  if (std::string(update->integrate_style) != "verlet")
    stop(lmp, "energy_ledger on: run_style " + std::string(update->integrate_style) +
                  " is not supported, because work is computed from the displacements of velocity "
                  "Verlet. Use `run_style verlet`, or remove energy_ledger on");
  const std::string reason = uncountable(lmp);
  if (!reason.empty()) stop(lmp, "energy_ledger on: " + reason);
}

// Stops if the pair style does not report its contacts; warns of walls that do not report theirs.
void EnergyLedger::check_owners() {
  if (!owners_.has(force->pair_match("gran", 1))) stop(lmp, complaint(this, false, false));
  const std::string walls = owners_.new_missing_walls(modify);
  if (comm->me == 0 && !walls.empty())
    warn(lmp,
         "energy_ledger: the walls " + walls +
             " have no `energy_ledger on`. Their energy terms are missing and appear as balance "
             "error (`drift`). Add `energy_ledger on` to these lines");
}

void EnergyLedger::init() {
  refuse_unsupported();
  acts_first_ = is_first_before_exchange();
  particle_plastic_work_ = find_fix<ParticlePlasticWork>(lmp);
  if (!particle_plastic_work_)
    stop(lmp,
         "energy_ledger on: its fix plastic_work was removed (unfix plastic_work). Keep this "
         "fix, or also remove energy_ledger and give the pair_style and wall lines again without "
         "energy_ledger on");
}

bool EnergyLedger::is_first_before_exchange() const {
  int k = 0;
  while (modify->fix[k] != this && !(modify->fmask[k] & LAMMPS_NS::FixConst::PRE_EXCHANGE)) ++k;
  return modify->fix[k] == this;
}

void EnergyLedger::setup_pre_exchange() {
  check_owners();
  if (ran_) count_changes();
}

// Adds the energy change caused by deck commands since the last run to the term `inserted`.
void EnergyLedger::count_changes() {
  const double now = mechanical_energy();
  sums_.inserted += now - mechanical_before_;
  // Store the new energy, so that the change counts only once: a command that writes a file runs a
  // setup, too, before the setup of the next run.
  mechanical_before_ = now;
}

// Returns the contact energy that deck commands have added since the last run [J]: by changed
// positions, diameters, atom types or constants, or by new and deleted particles and walls. The
// value is known when the setup has computed all forces. Only its sum over ranks is meaningful.
double EnergyLedger::change_of_contacts() const {
  return ran_ && phase_ == SETUP ? contact_energy() - contacts_before_ : 0;
}

void EnergyLedger::report_change_of_contacts() const {
  const double change = sum_over_ranks(change_of_contacts(), world);
  const double energy = sum_over_ranks(contact_energy(), world);
  if (comm->me != 0 || std::abs(change) <= 1e-6 * std::abs(energy)) return;  // round-off only
  std::ostringstream text;
  text << "energy_ledger: since the last run, the deck changed the energy of contacts by " << change
       << ' ' << unit_in_deck(update->unit_style, "J")
       << ". The term `inserted` includes this change\n";
  print(lmp, text.str());
}

void EnergyLedger::end_setup() {
  count_deferred();
  sums_.inserted += change_of_contacts();
  report_change_of_contacts();
  phase_ = BETWEEN_RUNS;
  terms_are_current_ = false;
  if (started_) return;
  sum();
  started_ = true;
  sums_.initial_total = total_;
  terms_[DRIFT] = 0;
}

void EnergyLedger::begin_without_setup() {
  if (on_any_rank(friction_.size() != std::size_t(atom->nlocal), world))
    stop(
        lmp,
        "energy_ledger: particles were added or deleted since the last run, but `pre no` skips the "
        "setup of this run. Remove `pre no` from the run command");
  count_changes();
  terms_are_current_ = false;
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
    stop(lmp,
         "energy_ledger: f_energy_ledger was read within a step, before all forces are known. Read "
         "it at the end of a step (thermo, dump). A fix that acts within a step can use the value "
         "of the previous step: `fix ID all ave/time 1 1 1 f_energy_ledger[N]`");
  if (!terms_are_current_) sum();
  return terms_[entry];
}

void EnergyLedger::count_deferred() {
  if (deferred_) std::exchange(deferred_, nullptr)->count_stored_energies();
}

void EnergyLedger::add_plastic_work(const Contact& contact, double work, bool has_local_partner) {
  const double share = share_of(contact, has_local_partner) * work;
  // Sum the plastic work of `run 0` separately: this run writes no contact history, so the next
  // setup reports the work again.
  if (update->nsteps == 0) {
    plastic_work_of_run_0_ += share;
    return;
  }
  sums_.plastic_work += share;
  double* const of_particle = particle_plastic_work_->vector_atom;
  of_particle[contact.i] += contact.is_wall ? work : 0.5 * work;
  if (has_local_partner) of_particle[contact.j] += 0.5 * work;
}

void EnergyLedger::add_adhesion_loss(const Contact& contact, double loss, bool has_local_partner) {
  // Sum the adhesion loss of `run 0` separately: this run writes no contact history, so the next
  // setup reports the loss again.
  double& sum = update->nsteps == 0 ? adhesion_loss_of_run_0_ : sums_.adhesion_loss;
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
  terms_are_current_ = false;
  deferred_ = nullptr;
  walls_.clear();
  friction_.assign(atom->nlocal, FrictionLoad());
  dashpots_.clear();
}

// Adds the work of the current forces in half a time step to the sums.
void EnergyLedger::add_work() {
  double friction = 0, viscous = 0, wall = 0;
  for (const WallContact& contact : walls_) {
    const Vector velocity = contact.point.velocity();
    wall += dot(contact.force, velocity);
    friction += dot(contact.friction, velocity);
    viscous += dot(contact.dashpot, velocity);
  }
  for (std::size_t i = 0; i < friction_.size(); ++i)
    friction -= dot(friction_[i].force, atom->v[i]) + dot(friction_[i].torque, atom->omega[i]);
  for (std::size_t i = 0; i < dashpots_.size(); ++i) viscous -= dot(dashpots_[i], atom->v[i]);
  terms_are_current_ = false;
  const double half_step = 0.5 * update->dt;
  sums_.friction += half_step * friction;
  sums_.viscous += half_step * viscous;
  sums_.wall_work += half_step * wall;
}

double EnergyLedger::kinetic_energy() const {
  // Moment of inertia of a disc or sphere, divided by m R^2.
  const double inertia = domain->dimension == 2 ? 0.5 : 0.4;
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
      double position[3];  // unwrapped coordinates across periodic boundaries
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
                                 sums_.plastic_work + plastic_work_of_run_0_,
                                 sums_.friction,
                                 sums_.viscous,
                                 sums_.wall_work,
                                 sums_.inserted + change_of_contacts(),
                                 0,
                                 by_pairs_.springs + by_walls_.springs,
                                 by_pairs_.surface + by_walls_.surface,
                                 sums_.adhesion_loss + adhesion_loss_of_run_0_};
  MPI_Allreduce(local, terms_, ENTRIES, MPI_DOUBLE, MPI_SUM, world);
  total_ = terms_[SURFACE] + terms_[ADHESION] - terms_[WALL_WORK] - terms_[INSERTED];
  for (int entry = KINETIC; entry < WALL_WORK; ++entry) total_ += terms_[entry];
  terms_[DRIFT] = started_ ? total_ - sums_.initial_total : 0;
  terms_are_current_ = phase_ != SETUP && (ran_ || phase_ != BETWEEN_RUNS);
}

void EnergyLedger::write_restart(FILE* file) {
  Sums sums;
  MPI_Reduce(&sums_, &sums, sizeof sums / sizeof(double), MPI_DOUBLE, MPI_SUM, 0, world);
  sums.initial_total = sums_.initial_total;
  write_state(file, &sums, sizeof sums);
}

void EnergyLedger::restart(char* data) {
  Sums sums;
  std::memcpy(static_cast<void*>(&sums), data, sizeof sums);
  started_ = true;
  if (comm->me == 0) sums_ = sums;  // rank 0 takes the sums of all ranks
  sums_.initial_total = sums.initial_total;
}

}  // namespace plastigran
