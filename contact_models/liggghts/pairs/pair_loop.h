// SPDX-License-Identifier: GPL-2.0-or-later
//
// LIGGGHTS' pair style with a faster loop over the contacts, for steps that need only forces. All
// other steps run LIGGGHTS' loop. Both loops pass the same contacts in the same order to the same
// models, and sum the forces in the same order, so the results are bitwise identical. (If the
// compiler uses fused multiply-add, a contact may begin one step later.)
//
// The loop is faster for four reasons. It selects the touching pairs first, which avoids
// mispredicted branches. It passes near pairs without overlap to the models only if they may have a
// contact history. Its loads contain the energies, so that no load is copied to count them. Stored
// energies are computed only when the ledger needs them, in a separate pass.
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
  // Creates the pair style. `models` is the member of LIGGGHTS' pair style that contains the
  // contact models.
  PairLoop(LAMMPS_NS::LAMMPS* engine, LAMMPS_NS::PairGran* pair, int64_t hash,
           Contact Base::*models)
      : Base(engine, pair, hash), engine_(engine), pair_(pair), models_(this->*models) {}

  void compute_force(LAMMPS_NS::PairGran* pair, int energies, int virial, int local) override {
    if (energies || virial || local || needs_host_loop(pair)) {
      Base::compute_force(pair, energies, virial, local);
      return;
    }
    pair->evflag = pair->vflag_fdotr = 0;
    if (models_.counts_energies() && pair->computeflag()) {
      compute_forces_and_energies();
      models_.defer_stored_energies(*this);
    } else {
      compute_forces();
    }
  }

 private:
  enum Pass { FORCES, ACCOUNTED_FORCES, STORED_ENERGIES };

  [[gnu::flatten, gnu::noinline]] void compute_forces() { visit_contacts<FORCES>(); }
  [[gnu::flatten, gnu::noinline]] void compute_forces_and_energies() {
    visit_contacts<ACCOUNTED_FORCES>();
  }

  // Computes the forces again, as a setup does, to get the stored energies; discards the forces.
  void count_stored_energies() override { visit_contacts<STORED_ENERGIES>(); }

  // Returns whether this step needs an output or a feature that only LIGGGHTS' loop has. (This loop
  // omits LIGGGHTS' factor `relax`, which is 1 in the public version.)
  bool needs_host_loop(LAMMPS_NS::PairGran* pair) const {
    const LAMMPS_NS::Atom* const atom = engine_->atom;
    return pair->storeContactForces() || pair->storeContactForcesStress() ||
           pair->storeSumDelta() || pair->store_sum_normal_force() || pair->fr_pair() ||
           !atom->rmass || !atom->sphere_flag || engine_->force->newton_pair ||
           engine_->modify->n_fixes_style("insert/stream/predefined") > 0 ||
           // Fix deform moves particles before an output. This loop computes stored energies only
           // when they are read, so they would belong to the moved particles.
           (models_.counts_energies() && engine_->modify->n_fixes_style("deform") > 0);
  }

  template <Pass pass>
  void visit_contacts() {
    const LAMMPS_NS::Atom* const atom = engine_->atom;
    const LAMMPS_NS::NeighList* const list = pair_->list;
    // `histories` is null if contacts have no history.
    const LAMMPS_NS::NeighList* const histories = pair_->listgranhistory;
    const int width = pair_->dnum();
    frozen_ = pair_->freeze_group_bit();
    ContactData contact;
    std::memset(static_cast<void*>(&contact), 0, sizeof contact);  // LIGGGHTS' loop does the same
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
      const int count = select_pairs(i, neighbours, list->numneigh[i], flags);
      if (count == 0) continue;
      contact.i = i;
      contact.radi = atom->radius[i];
      contact.itype = atom->type[i];
      contact.v_i = atom->v[i];
      contact.omega_i = atom->omega[i];
      contact.mi = atom->rmass[i];
      for (int n = 0; n < count; ++n) {
        const int place = selected_[n];
        contact.j = neighbours[place] & NEIGHMASK;
        contact.contact_flags = flags ? flags + place : nullptr;
        contact.contact_history = history ? history + width * place : nullptr;
        if (pass == STORED_ENERGIES) protect_history(contact, width);
        compute_pair<pass>(contact, on_i, on_j);
      }
    }
    models_.endPass(contact, on_i, on_j);
  }

  // Passes a copy of the history to the models, because some LIGGGHTS models write to it in every
  // call.
  void protect_history(ContactData& contact, int width) {
    if (contact.contact_history) {
      copied_history_.assign(contact.contact_history, contact.contact_history + width);
      contact.contact_history = copied_history_.data();
    }
    if (contact.contact_flags) {
      copied_flags_ = *contact.contact_flags;
      contact.contact_flags = &copied_flags_;
    }
  }

  // Selects from a particle's neighbor list the touching pairs, and the near pairs that the models
  // need (those that touched before; with cohesion, all). Returns the number of selected pairs.
  int select_pairs(int i, const int* neighbours, int count, const int* flags) {
    const LAMMPS_NS::Atom* const atom = engine_->atom;
    double** const x = atom->x;
    const double* const radius = atom->radius;
    const double factor = engine_->neighbor->contactDistanceFactor;
    // Squared distance limits of touching and of near pairs, divided by the squared sum of radii.
    const double squares[] = {1, factor * factor};
    const double xi = x[i][0], yi = x[i][1], zi = x[i][2], radius_i = radius[i];
    if (selected_.size() < std::size_t(count)) selected_.resize(count);
    int* end = selected_.data();
    for (int place = 0; place < count; ++place) {
      const int j = neighbours[place] & NEIGHMASK;
      const double dx = xi - x[j][0], dy = yi - x[j][1], dz = zi - x[j][2];
      const double sum = radius_i + radius[j];
      const bool may_have_history = Contact::acts_at_a_distance || (flags && flags[place]);
      *end = place;
      end += dx * dx + dy * dy + dz * dz < squares[may_have_history] * sum * sum;
    }
    return end - selected_.data();
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
    if constexpr (pass != FORCES) on_i.needs_elastic_energy = pass == STORED_ENERGIES;
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
    models_.checkSurfaceIntersect(contact);  // ignore the result: always true for spheres
    if constexpr (pass == FORCES) models_.compute(contact, on_i, on_j);
    if constexpr (pass == ACCOUNTED_FORCES) models_.compute_and_count(contact, on_i, on_j);
    if constexpr (pass == STORED_ENERGIES) models_.count_stored(contact, on_i, on_j);
    models_.endSurfacesIntersect(contact, nullptr, on_i, on_j);
  }

  static void add(double* force, double* torque, const Load& load) {
    add(force, load.delta_F);
    add(torque, load.delta_torque);
  }

  // Adds `part` to `sum`. Reads all three components before writing, so that the compiler can
  // vectorize.
  static void add(double* sum, const double* part) {
    const double x = sum[0] + part[0], y = sum[1] + part[1], z = sum[2] + part[2];
    sum[0] = x, sum[1] = y, sum[2] = z;
  }

  LAMMPS_NS::LAMMPS* engine_;
  LAMMPS_NS::PairGran* pair_;
  Contact& models_;
  int frozen_ = 0;  // group bit of fix freeze; 0 if there is none
  std::vector<int> selected_;
  std::vector<double> copied_history_;
  int copied_flags_ = 0;
};

}  // namespace plastigran
