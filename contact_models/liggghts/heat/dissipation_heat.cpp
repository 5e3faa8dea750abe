// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/heat/dissipation_heat.h"

#include <algorithm>
#include <cstring>

#include "atom.h"
#include "liggghts/fixes/ranks.h"

namespace plastigran {

DissipationHeat::DissipationHeat(LAMMPS_NS::LAMMPS* engine, int count, char** words)
    : ContactObserver(engine, count, words) {
  if (count > 3)
    fail(std::string("unknown word ") + words[3] + ". Nothing may follow heat/dissipation");
  comm_reverse = 1;
  scalar_flag = vector_flag = 1;
  size_vector = ENTRIES;
  global_freq = 1;
  extscalar = extvector = 1;
  restart_global = 1;
}

int DissipationHeat::setmask() {
  using namespace LAMMPS_NS::FixConst;
  return POST_INTEGRATE | PRE_EXCHANGE | PRE_FORCE | PRE_FINAL_INTEGRATE;
}

void DissipationHeat::init() {
  ContactObserver::init();
  for (const DissipationHeat* const other : fixes_of<DissipationHeat>(modify))
    if (other != this)
      fail(std::string("fix ") + other->id +
           " heats the particles already. Remove one of these fixes");
  const std::string caller = name();
  shares_.read(lmp, caller);
  if (!modify->find_fix_scalar_transport_equation("heattransfer"))
    fail(
        "fix heat/gran, which computes the particle temperatures, is missing. Add `fix ID all "
        "heat/gran initial_temperature T`");
  flux_ = static_cast<LAMMPS_NS::FixPropertyAtom*>(
      modify->find_fix_property("heatFlux", "property/atom", "scalar", 0, 0, style()));
  if (comm->me == 0 && !described_) {
    print(lmp, shares_.describe(caller));
    for (const std::string& sentence : shares_.misspellings()) warn(lmp, caller + ": " + sentence);
  }
  described_ = true;
}

void DissipationHeat::add(const Contact& contact, const AccountedLoad& on_i, const Load& on_j,
                          const void*) {
  add_plastic_work(contact, on_i.plastic_work);
  const LossyLoad load(contact, on_i, on_j);
  if (contact.is_wall)
    walls_.push_back({contact.i, load, WallPoint(contact, atom->x[contact.i])});
  else
    pairs_.push_back({contact.i, contact.j, load});
}

// Adds the heat of plastic work to local particles only, because a contact with a ghost is also
// reported on the rank that owns the ghost's particle.
void DissipationHeat::add_plastic_work(const Contact& contact, double work) {
  const double part = shares_.of_plastic_work(contact.itype, contact.jtype);
  const double mine = part * work, others = (1 - part) * work;
  const double factor = shares_.taylor_quinney_factor(contact.itype);
  const double other_factor = shares_.taylor_quinney_factor(contact.jtype);
  heat_[contact.i] += factor * mine;
  sums_[FROM_PLASTIC_WORK] += factor * mine;
  sums_[STORED] += (1 - factor) * mine;
  if (!contact.is_wall && contact.j >= atom->nlocal) return;
  sums_[STORED] += (1 - other_factor) * others;
  sums_[contact.is_wall ? TO_WALLS : FROM_PLASTIC_WORK] += other_factor * others;
  if (!contact.is_wall) heat_[contact.j] += other_factor * others;
}

void DissipationHeat::begin_pass() {
  pairs_.clear();
  walls_.clear();
  heat_.assign(atom->nlocal + atom->nghost, 0);
}

// Returns the work of a force and a torque on particle `i` in half a time step [J].
double DissipationHeat::work_on(int i, const Vector& force, const Vector& torque) const {
  return 0.5 * update->dt * (dot(force, atom->v[i]) + dot(torque, atom->omega[i]));
}

void DissipationHeat::add_lossy_work() {
  for (const PairContact& pair : pairs_) {
    const Vector& force = pair.load.force;
    double lost = -work_on(pair.i, force, pair.load.torque_i);
    if (pair.j < atom->nlocal)
      lost -= work_on(pair.j, {-force[0], -force[1], -force[2]}, pair.load.torque_j);
    heat_[pair.i] += 0.5 * lost;
    heat_[pair.j] += 0.5 * lost;
    sums_[FROM_FRICTION] += lost;
  }
  for (const WallContact& wall : walls_) {
    const double lost = 0.5 * update->dt * dot(wall.load.force, wall.point.velocity()) -
                        work_on(wall.i, wall.load.force, wall.load.torque_i);
    heat_[wall.i] += 0.5 * lost;
    sums_[FROM_FRICTION] += 0.5 * lost;
    sums_[TO_WALLS] += 0.5 * lost;
  }
}

// Adds the work of the current forces in half a time step, and new plastic work, to the heat flux.
void DissipationHeat::deliver() {
  add_lossy_work();
  comm->reverse_comm_fix(this);
  double* const flux = flux_->vector_atom;
  for (int i = 0; i < atom->nlocal; ++i) flux[i] += heat_[i] / update->dt;
  heat_.assign(heat_.size(), 0);
}

int DissipationHeat::pack_reverse_comm(int count, int first, double* buffer) {
  std::copy_n(heat_.begin() + first, count, buffer);
  return 1;  // one value per particle: its heat
}

void DissipationHeat::unpack_reverse_comm(int count, int* list, double* buffer) {
  for (int k = 0; k < count; ++k) heat_[list[k]] += buffer[k];
}

double DissipationHeat::compute_scalar() {
  return compute_vector(FROM_PLASTIC_WORK) + compute_vector(FROM_FRICTION);
}

double DissipationHeat::compute_vector(int entry) { return sum_over_ranks(sums_[entry], world); }

void DissipationHeat::write_restart(FILE* file) {
  double sums[ENTRIES];
  MPI_Reduce(sums_, sums, ENTRIES, MPI_DOUBLE, MPI_SUM, 0, world);
  write_state(file, sums, sizeof sums);
}

void DissipationHeat::restart(char* data) {
  if (comm->me == 0) std::memcpy(sums_, data, sizeof sums_);  // rank 0 takes the sums of all ranks
}

}  // namespace plastigran
