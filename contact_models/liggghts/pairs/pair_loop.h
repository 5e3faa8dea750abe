// SPDX-License-Identifier: GPL-2.0-or-later
//
// The engine's pair style with a loop of its own over the contacts, for the steps in which nothing
// but the forces is asked for; in all others the engine's loop runs. Both hand the same contacts in
// the same order to the same models and sum in the same order: they agree in every digit. (Where a
// compiler fuses products and sums, two that graze each other may touch a step later.)
//
// What makes it faster: the pairs that touch are picked out before, so that the processor need not
// guess which do; of pairs that are near without touching it hands on those alone that may remember
// a contact; what an account of energies needs is in the load, and not copied. What the contacts
// store is counted in a pass of its own, where the ledger is asked for it.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <vector>

#include "atom.h"
#include "force.h"
#include "liggghts/model/accounted_load.h"
#include "liggghts/model/stored_energies.h"
#include "liggghts/plugin/engine_styles.h"
#include "modify.h"
#include "neigh_list.h"
#include "neighbor.h"
#include "pair_gran.h"

namespace plastigran {

template <class Contact>
class PairLoop : public LIGGGHTS::PairStyles::Granular<Contact>, private StoredEnergies {
  typedef LIGGGHTS::PairStyles::Granular<Contact> Base;
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData ContactData;
  typedef LIGGGHTS::ContactModels::ForceData Load;

 public:
  // `models`: where the engine's pair style has them.
  PairLoop(LAMMPS_NS::LAMMPS* engine, LAMMPS_NS::PairGran* pair, int64_t hash,
           Contact Base::*models)
      : Base(engine, pair, hash), engine_(engine), pair_(pair), models_(this->*models) {}

  void compute_force(LAMMPS_NS::PairGran* pair, int energies, int virial, int local) override {
    if (energies || virial || local || asks_for_more(pair)) {
      Base::compute_force(pair, energies, virial, local);
      return;
    }
    pair->evflag = pair->vflag_fdotr = 0;
    if (models_.takes_accounts && pair->computeflag()) {
      account_forces();
      models_.defer_stored_energies(*this);
    } else {
      compute_forces();
    }
  }

 private:
  enum Pass { FORCES, ACCOUNTED_FORCES, STORED_ENERGIES };

  // The models are inlined where it matters.
  [[gnu::flatten, gnu::noinline]] void compute_forces() { go_through<FORCES>(); }
  [[gnu::flatten, gnu::noinline]] void account_forces() { go_through<ACCOUNTED_FORCES>(); }

  // Asks the models once more, as set-up does.
  void count_stored_energies() override { go_through<STORED_ENERGIES>(); }

  // Whether this step needs what only the engine's loop does. (Its factor `relax` is 1 in the
  // public engine.)
  bool asks_for_more(LAMMPS_NS::PairGran* pair) const {
    const LAMMPS_NS::Atom* const atom = engine_->atom;
    return pair->storeContactForces() || pair->storeContactForcesStress() ||
           pair->storeSumDelta() || pair->store_sum_normal_force() || pair->fr_pair() ||
           !atom->rmass || !atom->sphere_flag || engine_->force->newton_pair ||
           engine_->modify->n_fixes_style("insert/stream/predefined") > 0 ||
           // It displaces particles before the output: what contacts store cannot wait for it.
           (models_.takes_accounts && engine_->modify->n_fixes_style("deform") > 0);
  }

  template <Pass pass>
  void go_through() {
    const LAMMPS_NS::Atom* const atom = engine_->atom;
    const LAMMPS_NS::NeighList* const list = pair_->list;
    const LAMMPS_NS::NeighList* const histories = pair_->listgranhistory;  // null: no memory
    const int width = pair_->dnum();
    frozen_ = pair_->freeze_group_bit();
    ContactData contact;
    std::memset(static_cast<void*>(&contact), 0, sizeof contact);  // as the engine's loop begins
    contact.area_ratio = 1;
    contact.computeflag = pass == STORED_ENERGIES || pair_->computeflag();
    contact.shearupdate = pass != STORED_ENERGIES && pair_->shearupdate();
    std::conditional_t<pass == FORCES, Load, AccountedLoad> on_i;
    Load on_j;
    models_.beginPass(contact, on_i, on_j);
    for (int k = 0; k < list->inum; ++k) {
      const int i = list->ilist[k];
      const int* const neighbours = list->firstneigh[i];
      int* const flags = histories ? histories->firstneigh[i] : nullptr;
      double* const history = histories ? histories->firstdouble[i] : nullptr;
      const int count = pick(i, neighbours, list->numneigh[i], flags);
      if (count == 0) continue;
      contact.i = i;
      contact.radi = atom->radius[i];
      contact.itype = atom->type[i];
      contact.v_i = atom->v[i];
      contact.omega_i = atom->omega[i];
      contact.mi = atom->rmass[i];
      for (int n = 0; n < count; ++n) {
        const int place = picked_[n];
        contact.j = neighbours[place] & NEIGHMASK;
        contact.contact_flags = flags ? flags + place : nullptr;
        contact.contact_history = history ? history + width * place : nullptr;
        if (pass == STORED_ENERGIES) keep_from_writing(contact, width);
        compute_pair<pass>(contact, on_i, on_j);
      }
    }
    models_.endPass(contact, on_i, on_j);
  }

  // Some models of the engine write whenever they are asked: into a copy, then.
  void keep_from_writing(ContactData& contact, int width) {
    if (contact.contact_history) {
      copied_history_.assign(contact.contact_history, contact.contact_history + width);
      contact.contact_history = copied_history_.data();
    }
    if (contact.contact_flags) {
      copied_flags_ = *contact.contact_flags;
      contact.contact_flags = &copied_flags_;
    }
  }

  // The places in a particle's list of the pairs that touch, and of those near that the models
  // have to hear of: the ones that touched before, and with cohesion all.
  int pick(int i, const int* neighbours, int count, const int* flags) {
    const LAMMPS_NS::Atom* const atom = engine_->atom;
    double** const x = atom->x;
    const double* const radius = atom->radius;
    const double factor = engine_->neighbor->contactDistanceFactor;
    const double squares[] = {1, factor * factor};  // of touch, of nearness; over the radii's sum
    const double xi = x[i][0], yi = x[i][1], zi = x[i][2], radius_i = radius[i];
    if (picked_.size() < std::size_t(count)) picked_.resize(count);
    int* end = picked_.data();
    for (int place = 0; place < count; ++place) {
      const int j = neighbours[place] & NEIGHMASK;
      const double dx = xi - x[j][0], dy = yi - x[j][1], dz = zi - x[j][2];
      const double sum = radius_i + radius[j];
      const bool may_remember = Contact::acts_at_a_distance || (flags && flags[place]);
      *end = place;
      end += dx * dx + dy * dy + dz * dz < squares[may_remember] * sum * sum;
    }
    return end - picked_.data();
  }

  template <Pass pass, class LoadOnI>
  [[gnu::always_inline]] void compute_pair(ContactData& contact, LoadOnI& on_i, Load& on_j) {
    const LAMMPS_NS::Atom* const atom = engine_->atom;
    const int i = contact.i, j = contact.j;
    for (int axis = 0; axis < 3; ++axis) contact.delta[axis] = atom->x[i][axis] - atom->x[j][axis];
    contact.rsq = contact.delta[0] * contact.delta[0] + contact.delta[1] * contact.delta[1] +
                  contact.delta[2] * contact.delta[2];
    contact.radj = atom->radius[j];
    contact.radsum = contact.radi + contact.radj;
    contact.v_j = atom->v[j];
    contact.omega_j = atom->omega[j];
    contact.jtype = atom->type[j];
    on_i = LoadOnI();
    on_j.reset();
    if constexpr (pass != FORCES) on_i.asks_elastic_energy = pass == STORED_ENERGIES;
    if (contact.rsq < contact.radsum * contact.radsum) {
      touch<pass>(contact, on_i, on_j);
      if (pass == STORED_ENERGIES) return;
    } else {
      if (pass == STORED_ENERGIES) return;
      contact.has_force_update = false;
      models_.surfacesClose(contact, on_i, on_j);
      if (!contact.has_force_update) return;
    }
    add(atom->f[i], atom->torque[i], on_i);
    if (j < atom->nlocal) add(atom->f[j], atom->torque[j], on_j);
  }

  template <Pass pass, class LoadOnI>
  [[gnu::always_inline]] void touch(ContactData& contact, LoadOnI& on_i, Load& on_j) {
    const LAMMPS_NS::Atom* const atom = engine_->atom;
    contact.r = std::sqrt(contact.rsq);
    contact.rinv = 1 / contact.r;
    for (int axis = 0; axis < 3; ++axis) contact.en[axis] = contact.delta[axis] * contact.rinv;
    contact.mj = atom->rmass[contact.j];
    contact.meff = contact.mi * contact.mj / (contact.mi + contact.mj);
    if (atom->mask[contact.i] & frozen_) contact.meff = contact.mj;
    if (atom->mask[contact.j] & frozen_) contact.meff = contact.mi;
    models_.checkSurfaceIntersect(contact);  // true of spheres
    if constexpr (pass == FORCES) models_.compute(contact, on_i, on_j);
    if constexpr (pass == ACCOUNTED_FORCES) models_.account(contact, on_i, on_j);
    if constexpr (pass == STORED_ENERGIES) models_.count_stored(contact, on_i, on_j);
    models_.endSurfacesIntersect(contact, nullptr, on_i, on_j);
  }

  static void add(double* force, double* torque, const Load& load) {
    add(force, load.delta_F);
    add(torque, load.delta_torque);
  }

  // All three sums are read before any is written: the compiler may then add two at once.
  static void add(double* sum, const double* part) {
    const double x = sum[0] + part[0], y = sum[1] + part[1], z = sum[2] + part[2];
    sum[0] = x, sum[1] = y, sum[2] = z;
  }

  LAMMPS_NS::LAMMPS* engine_;
  LAMMPS_NS::PairGran* pair_;
  Contact& models_;
  int frozen_ = 0;  // bit of the group that no force moves
  std::vector<int> picked_;
  std::vector<double> copied_history_;
  int copied_flags_ = 0;
};

}  // namespace plastigran
