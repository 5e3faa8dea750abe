// SPDX-License-Identifier: GPL-2.0-or-later
#include "lammps/energy_balance.h"

#include <mpi.h>

#include <algorithm>
#include <cstring>
#include <string>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "lammps.h"
#include "lammps/contact_tally.h"
#include "lammps/load_model.h"
#include "lammps/pair_style.h"
#include "lammps/particle_values.h"
#include "modify.h"
#include "update.h"

namespace plastigran {

using LAMMPS_NS::Fix;

namespace {

constexpr const char* fix_id = "plastigran_energy";

double dot(const double* a, const double* b) { return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]; }

}  // namespace

EnergyBalance::EnergyBalance(LAMMPS_NS::LAMMPS* lammps, int count, char** words)
    : Fix(lammps, count, words) {
  restart_global = 1;
  nevery = 1;
}

void EnergyBalance::create(LAMMPS_NS::LAMMPS* lammps) {
  LAMMPS_NS::Modify* const modify = lammps->modify;
  if (of(lammps)) return;
  ParticleValues::create(lammps, particle_work, " ghost yes");
  modify->add_fix(std::string(fix_id) + " all plastigran/energy");
}

EnergyBalance* EnergyBalance::of(LAMMPS_NS::LAMMPS* lammps) {
  return static_cast<EnergyBalance*>(lammps->modify->get_fix_by_id(fix_id));
}

int EnergyBalance::setmask() {
  using namespace LAMMPS_NS::FixConst;
  return POST_INTEGRATE | PRE_NEIGHBOR | PRE_FORCE | END_OF_STEP | POST_RUN;
}

void EnergyBalance::init() {
  if (!PairStyle::of(lmp))
    error->all(FLERR, "compute plastigran/energy needs `pair_style granular/plastigran`");
  for (const ContactTally* const tally : tallies())
    if (tally->lacks_loads)
      error->all(FLERR,
                 "compute plastigran/energy does not support LAMMPS' model `heat`; remove `heat` "
                 "from the lines of pairs and walls, or remove the compute");
}

std::vector<const ContactTally*> EnergyBalance::tallies() const {
  std::vector<const ContactTally*> all{PairStyle::of(lmp)};
  for (Fix* const fix : modify->get_fix_list())
    if (const auto* const wall = dynamic_cast<ContactTally*>(fix)) all.push_back(wall);
  return all;
}

void EnergyBalance::begin_pass() {
  work_ = ParticleValues::of(lmp, particle_work);
  std::fill_n(work_ + atom->nlocal, atom->nghost, 0.0);
  loads_.assign(static_cast<std::size_t>(atom->nlocal + atom->nghost), ParticleLoad());
  wall_power_ = Power();
}

void EnergyBalance::add_load(int particle, const ParticleLoad& load) {
  ParticleLoad& sum = loads_[static_cast<std::size_t>(particle)];
  for (int k = 0; k < 3; ++k) {
    sum.friction[k] += load.friction[k];
    sum.torque[k] += load.torque[k];
    sum.dashpot[k] += load.dashpot[k];
  }
}

void EnergyBalance::add_wall(const double* force, const ParticleLoad& load,
                             const double* wall_velocity) {
  wall_power_.wall += dot(force, wall_velocity);
  wall_power_.friction += dot(load.friction, wall_velocity);
  wall_power_.viscous += dot(load.dashpot, wall_velocity);
}

void EnergyBalance::add_wall_change(const double* force, const ParticleLoad& load,
                                    const double* change) {
  const double half_step = 0.5 * update->dt;
  sums_.wall_work += half_step * dot(force, change);
  sums_.friction += half_step * dot(load.friction, change);
  sums_.viscous += half_step * dot(load.dashpot, change);
}

void EnergyBalance::pack_ghost(int particle, double* buffer) const {
  buffer[0] = work_[particle];
  std::memcpy(buffer + 1, &loads_[static_cast<std::size_t>(particle)], sizeof(ParticleLoad));
}

void EnergyBalance::add_ghost(int particle, const double* buffer) {
  work_[particle] += buffer[0];
  ParticleLoad load;
  std::memcpy(static_cast<void*>(&load), buffer + 1, sizeof load);
  add_load(particle, load);
}

EnergyBalance::Power EnergyBalance::power() const {
  Power power = wall_power_;
  for (int i = 0; i < atom->nlocal; ++i) {
    const ParticleLoad& load = loads_[static_cast<std::size_t>(i)];
    power.friction -= dot(load.friction, atom->v[i]) + dot(load.torque, atom->omega[i]);
    power.viscous -= dot(load.dashpot, atom->v[i]);
  }
  return power;
}

EnergyBalance::ContactEnergies EnergyBalance::contact_energies() const {
  ContactEnergies sums;
  for (const ContactTally* const tally : tallies()) {
    sums.elastic += tally->elastic_energy;
    sums.surface += tally->surface_energy;
    sums.springs += tally->spring_energy;
    sums.contacts += tally->contacts;
  }
  return sums;
}

double EnergyBalance::kinetic_energy() const {
  double energy = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    const double* const v = atom->v[i];
    const double* const omega = atom->omega[i];
    energy += 0.5 * atom->rmass[i] *
              (dot(v, v) + 0.4 * atom->radius[i] * atom->radius[i] * dot(omega, omega));
  }
  return energy;
}

double EnergyBalance::gravitational_energy() const {
  double energy = 0;
  for (Fix* const fix : modify->get_fix_by_style("^gravity")) {
    int dimension;
    const auto* const acceleration = static_cast<const double*>(fix->extract("gvec", dimension));
    for (int i = 0; i < atom->nlocal; ++i) {
      if (!(atom->mask[i] & fix->groupbit)) continue;
      double position[3];  // unwrapped across periodic boundaries
      domain->unmap(atom->x[i], atom->image[i], position);
      energy -= atom->rmass[i] * dot(acceleration, position);
    }
  }
  return energy;
}

double EnergyBalance::state_energy() const {
  const ContactEnergies now = contact_energies();
  return mechanical_energy() + now.elastic + now.surface;
}

// At this point of the setup, LAMMPS has not yet computed the forces of some walls. Therefore
// end_setup() is called later, when all forces are known.
void EnergyBalance::setup(int) {
  mechanical_ = mechanical_energy();
  in_setup_ = true;
}

// Since the last run, the deck may have changed the energy, for example by removing a wall. The
// change counts as inserted energy.
void EnergyBalance::end_setup() {
  if (!in_setup_) return;
  in_setup_ = false;
  const ContactEnergies now = contact_energies();
  const double state = mechanical_ + now.elastic + now.surface;
  if (!started_) sums_.initial = state;
  if (has_run_) sums_.inserted += state - last_state_;
  started_ = true;
  power_ = power();
}

void EnergyBalance::post_integrate() {
  end_setup();
  mechanical_ = mechanical_energy();
}

// LAMMPS calls this function after particles were inserted, deleted or moved to other ranks. The
// energy of this rank has then changed without work of a force.
void EnergyBalance::pre_neighbor() { sums_.inserted += mechanical_energy() - mechanical_; }

void EnergyBalance::end_of_step() {
  const Power before = power_;
  power_ = power();
  const double half_step = 0.5 * update->dt;
  sums_.friction += half_step * (before.friction + power_.friction);
  sums_.viscous += half_step * (before.viscous + power_.viscous);
  sums_.wall_work += half_step * (before.wall + power_.wall);
}

void EnergyBalance::post_run() {
  end_setup();  // has an effect only in a run of zero steps
  last_state_ = state_energy();
  has_run_ = true;
}

EnergyBalance::Terms EnergyBalance::terms() {
  end_setup();
  const ContactEnergies now = contact_energies();
  Terms local{}, all;
  local[KINETIC] = kinetic_energy();
  local[GRAVITATIONAL] = gravitational_energy();
  local[ELASTIC] = now.elastic;
  local[PLASTIC] = sums_.plastic_work;
  local[FRICTION] = sums_.friction;
  local[VISCOUS] = sums_.viscous;
  local[WALL_WORK] = sums_.wall_work;
  local[INSERTED] = sums_.inserted;
  local[TANGENTIAL_SPRINGS] = now.springs;
  local[SURFACE] = now.surface;
  local[ADHESION] = sums_.adhesion_loss;
  local[CONTACTS] = now.contacts;
  local[BALANCE_ERROR] = -sums_.initial - sums_.wall_work - sums_.inserted;
  for (const Term term :
       {KINETIC, GRAVITATIONAL, ELASTIC, PLASTIC, FRICTION, VISCOUS, SURFACE, ADHESION})
    local[BALANCE_ERROR] += local[term];
  MPI_Allreduce(local.data(), all.data(), TERMS, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

void EnergyBalance::write_restart(FILE* file) {
  Sums sums, own = sums_;
  own.begun = started_;
  own.last_state = started_ ? state_energy() : 0;
  MPI_Reduce(&own, &sums, sizeof sums / sizeof(double), MPI_DOUBLE, MPI_SUM, 0, world);
  if (comm->me != 0) return;
  const int size = sizeof sums;
  std::fwrite(&size, sizeof size, 1, file);
  std::fwrite(&sums, sizeof sums, 1, file);
}

void EnergyBalance::restart(char* data) {
  Sums stored;
  std::memcpy(&stored, data, sizeof stored);
  started_ = has_run_ = stored.begun > 0;
  // After a restart, rank 0 holds the sums over all ranks, and the other ranks start at zero.
  if (comm->me != 0) return;
  sums_ = stored;
  last_state_ = stored.last_state;
}

}  // namespace plastigran
