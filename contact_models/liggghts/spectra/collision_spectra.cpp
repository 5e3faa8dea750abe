// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/spectra/collision_spectra.h"

#include <algorithm>

#include "atom.h"
#include "comm.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "liggghts/fixes/ranks.h"
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
  just_created = 0;  // prevents LIGGGHTS from clearing the records in the first setup
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
  for (LAMMPS_NS::FixWallGran* const wall : fixes_of<LAMMPS_NS::FixWallGran>(modify)) {
    const std::size_t number =
        std::find(wall_ids_.begin(), wall_ids_.end(), wall->id) - wall_ids_.begin();
    if (number == wall_ids_.size()) wall_ids_.push_back(wall->id), walls_.push_back(nullptr);
    walls_[number] = wall;
  }
}

std::size_t CollisionSpectra::wall_number(const void* owner) const {
  return std::find(walls_.begin(), walls_.end(), owner) - walls_.begin();
}

void CollisionSpectra::add(const Contact& contact, const AccountedLoad& on_i, const Load& on_j,
                           const void* owner) {
  most_contacts_ = std::max(most_contacts_, ++contacts_[contact.i]);
  if (!contact.is_wall && contact.j < atom->nlocal)
    most_contacts_ = std::max(most_contacts_, ++contacts_[contact.j]);
  const bool exchanged = !contact.is_wall && atom->tag[contact.j] < atom->tag[contact.i];
  const int holder = exchanged ? contact.j : contact.i;
  // The impact is stored with one of the two particles, the holder. Skip contacts whose holder is a
  // ghost, because the rank that owns the holder reports them too.
  if (holder >= atom->nlocal) return;
  const Partner partner = contact.is_wall ? wall_partner(wall_number(owner))
                                          : atom->tag[exchanged ? contact.i : contact.j];
  const LossyLoad load(contact, on_i, on_j);
  int place = records_.find(holder, partner);
  if (place < 0) {
    Impact begun;
    begun.type = exchanged ? contact.jtype : contact.itype;
    begun.other_type = exchanged ? contact.itype : contact.jtype;
    if (contact.shearupdate)
      begun.speed = -contact.vn;
    else
      begun.load = exchanged ? load.exchanged() : load;
    place = records_.begin(holder, partner, begun);
  }
  if (!contact.shearupdate) {  // in the setup, in which no time passes
    const double energy = on_i.plastic_work + on_i.adhesion_loss;
    records_.at(holder, place).energy += energy;
    energy_ += energy;
    return;
  }
  // A particle can touch several triangles of one wall in a step. Only the first triangle adds the
  // work of the previous step's load.
  const bool first = !records_.touch(holder, place);
  advance(records_.at(holder, place), contact, on_i, load, exchanged, first);
}

// Adds the work of one step to an impact, with velocities at mid-step. The stored load of the
// previous step acts on the holder; the new load `load` acts on particle i.
void CollisionSpectra::advance(Impact& impact, const Contact& contact, const AccountedLoad& on_i,
                               const LossyLoad& load, bool exchanged, bool first) {
  const Vector between{contact.v_i[0] - contact.v_j[0], contact.v_i[1] - contact.v_j[1],
                       contact.v_i[2] - contact.v_j[2]};
  const auto lost = [&](const LossyLoad& lossy) {
    double power = -dot(lossy.force, between) - dot(lossy.torque_i, contact.omega_i);
    if (!contact.is_wall) power -= dot(lossy.torque_j, contact.omega_j);
    return 0.5 * update->dt * power;
  };
  double energy = lost(load) + on_i.plastic_work + on_i.adhesion_loss;
  if (first) {
    energy += lost(exchanged ? impact.load.exchanged() : impact.load);
    impact.load = LossyLoad();
    impact.force = 0;
  }
  impact.energy += energy;
  energy_ += energy;
  impact.load += exchanged ? load.exchanged() : load;
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
  if (particle_total_ > 0) records_.renumber(atom->tag, atom->nlocal, particle_total_, world);
  pre_exchange();
}

// Enlarges the exchange buffers, because particles move to other ranks with their impacts and
// contact histories.
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
  records_.store_ids(atom->tag, atom->nlocal);
  particle_total_ = sum_over_ranks(static_cast<long>(atom->nlocal), world);
}

double CollisionSpectra::compute_vector(int entry) {
  const double contacts = records_.count(atom->nlocal);
  const double local[ENTRIES] = {impacts_, contacts, impact_energy_, energy_ - impact_energy_};
  return sum_over_ranks(local[entry], world);
}

}  // namespace plastigran
