// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/spectra/collision_spectra.h"

#include <mpi.h>

#include <algorithm>

#include "atom.h"
#include "comm.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "pair_gran.h"

namespace plastigran {

CollisionSpectra::CollisionSpectra(LAMMPS_NS::LAMMPS* engine, int count, char** words)
    : ContactObserver(engine, count, words), file_(nullptr, std::fclose) {
  read_words(count, words);
  nevery = 1;
  scalar_flag = vector_flag = 1;
  size_vector = ENTRIES;
  global_freq = 1;
  extscalar = extvector = 1;
  restart_global = restart_peratom = 1;
  create_attribute = 1;
  just_created = 0;  // LIGGGHTS would clear the records in the first set-up, between its forces
  grow_arrays(atom->nmax);
  atom->add_callback(0);
  atom->add_callback(1);
}

CollisionSpectra::~CollisionSpectra() {
  atom->delete_callback(Fix::id, 0);
  atom->delete_callback(Fix::id, 1);
}

int CollisionSpectra::setmask() {
  using namespace LAMMPS_NS::FixConst;
  return PRE_EXCHANGE | END_OF_STEP;
}

void CollisionSpectra::init() {
  ContactObserver::init();
  walls_.assign(wall_ids_.size(), nullptr);
  for (int k = 0; k < modify->nfix; ++k) {
    const auto wall = dynamic_cast<LAMMPS_NS::FixWallGran*>(modify->fix[k]);
    if (!wall) continue;
    const auto known = std::find(wall_ids_.begin(), wall_ids_.end(), wall->id);
    const std::size_t number = known - wall_ids_.begin();
    if (known == wall_ids_.end()) wall_ids_.push_back(wall->id), walls_.push_back(nullptr);
    walls_[number] = wall;
  }
}

std::size_t CollisionSpectra::number_of(const void* owner) const {
  return std::find(walls_.begin(), walls_.end(), owner) - walls_.begin();
}

void CollisionSpectra::add(const Contact& contact, const AccountedLoad& on_i, const Load& on_j,
                           const void* owner) {
  most_contacts_ = std::max(most_contacts_, ++contacts_[contact.i]);
  if (!contact.is_wall && contact.j < atom->nlocal)
    most_contacts_ = std::max(most_contacts_, ++contacts_[contact.j]);
  const bool turned = !contact.is_wall && atom->tag[contact.j] < atom->tag[contact.i];
  const int holder = turned ? contact.j : contact.i;
  if (holder >= atom->nlocal) return;  // reported from the other side as well
  const Partner partner =
      contact.is_wall ? wall_partner(number_of(owner)) : atom->tag[turned ? contact.i : contact.j];
  const LossyLoad load(contact, on_i, on_j);
  int place = records_.find(holder, partner);
  if (place < 0) {
    Impact begun;
    begun.type = turned ? contact.jtype : contact.itype;
    begun.other_type = turned ? contact.itype : contact.jtype;
    if (contact.shearupdate)
      begun.speed = -contact.vn;
    else
      begun.load = turned ? load.turned() : load;
    place = records_.begin(holder, partner, begun);
  }
  if (!contact.shearupdate) {  // set-up
    records_.at(holder, place).energy += on_i.plastic_work;
    energy_ += on_i.plastic_work;
    return;
  }
  const bool first = !records_.touch(holder, place);  // else of several triangles of the wall
  go_on(records_.at(holder, place), contact, on_i, load, turned, first);
}

// A step of an impact. Power is that of the forces at velocities of mid-step; the forces of the
// step before belong to the holder, the new ones to particle i.
void CollisionSpectra::go_on(Impact& impact, const Contact& contact, const AccountedLoad& on_i,
                             const LossyLoad& load, bool turned, bool first) {
  const Vector between{contact.v_i[0] - contact.v_j[0], contact.v_i[1] - contact.v_j[1],
                       contact.v_i[2] - contact.v_j[2]};
  const auto lost = [&](const LossyLoad& each) {
    double power = -dot(each.force, between) - dot(each.torque_i, contact.omega_i);
    if (!contact.is_wall) power -= dot(each.torque_j, contact.omega_j);
    return 0.5 * update->dt * power;
  };
  double energy = lost(load) + on_i.plastic_work;
  if (first) {
    energy += lost(turned ? impact.load.turned() : impact.load);
    impact.load = LossyLoad();
    impact.force = 0;
  }
  impact.energy += energy;
  energy_ += energy;
  impact.load += turned ? load.turned() : load;
  impact.force += dot(on_i.delta_F, contact.en);
  impact.largest_force = std::max(impact.largest_force, impact.force);
}

void CollisionSpectra::count(Partner partner, const Impact& impact) {
  if (!impact.counts()) return;
  int type = static_cast<int>(impact.type), other_type = static_cast<int>(impact.other_type);
  if (!is_wall(partner) && type > other_type) std::swap(type, other_type);
  const int wall = is_wall(partner) ? wall_of(partner) : -1;
  const double values[] = {impact.speed, impact.energy, impact.largest_force};
  for (const int quantity : {NORMAL_SPEED, DISSIPATED_ENERGY, LARGEST_FORCE}) {
    const double value = values[quantity];
    tally_.add({quantity, wall, type, other_type, Tally::bin_of(value, per_decade_)}, {1, value});
  }
  ++impacts_;
  impact_energy_ += impact.energy;
}

void CollisionSpectra::setup_pre_exchange() {
  ContactObserver::setup_pre_exchange();
  if (total_ > 0) records_.follow(atom->tag, atom->nlocal, total_, world);
  pre_exchange();
}

// A particle takes its impacts along. The engine's fixes reserve room for the one that needs most,
// and one particle may need it for all of them: its contact history comes on top.
void CollisionSpectra::pre_exchange() {
  const auto pair = static_cast<LAMMPS_NS::PairGran*>(force->pair_match("gran", 1));
  const int history = (pair->dnum() + 1) * most_contacts_ + 1;
  comm->maxexchange_fix =
      std::max(comm->maxexchange_fix, records_.largest_size(atom->nlocal) + history);
}

void CollisionSpectra::end_of_step() {
  std::fill(contacts_.begin(), contacts_.end(), 0);
  for (int i = 0; i < atom->nlocal; ++i)
    records_.advance(i, [this](Partner partner, const Impact& impact) { count(partner, impact); });
  if (update->ntimestep % every_ == 0) write_table();
}

void CollisionSpectra::post_run() {
  records_.remember(atom->tag, atom->nlocal);
  total_ = atom->nlocal;
  MPI_Allreduce(MPI_IN_PLACE, &total_, 1, MPI_LONG, MPI_SUM, world);
}

double CollisionSpectra::compute_vector(int entry) {
  const double contacts = records_.count(atom->nlocal);
  const double local[ENTRIES] = {impacts_, contacts, impact_energy_, energy_ - impact_energy_};
  double sum;
  MPI_Allreduce(&local[entry], &sum, 1, MPI_DOUBLE, MPI_SUM, world);
  return sum;
}

}  // namespace plastigran
