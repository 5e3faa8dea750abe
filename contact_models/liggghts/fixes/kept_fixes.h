// SPDX-License-Identifier: GPL-2.0-or-later
//
// Fixes in which LIGGGHTS stores contact histories by particle, extended so that HistoryKeeper gets
// the histories before LIGGGHTS discards them.
#pragma once

#include "fix_contact_history.h"
#include "liggghts/fixes/history_keeper.h"
#include "liggghts/fixes/plugin_fix.h"

namespace plastigran {

// Base class by which HistoryKeeper recognizes fixes of the class KeptFix.
struct AnyKeptFix {
  virtual ~AnyKeptFix() = default;
};

// Fix of the LIGGGHTS class `Base`. LIGGGHTS deletes the fix if the deck repeats the `pair_style`
// or wall line. HistoryKeeper copies the histories before that.
template <class Base>
class KeptFix : public Base, public AnyKeptFix {
 public:
  using Base::Base;
  void pre_delete(bool is_unfixed) override {
    if (HistoryKeeper* const keeper = find_fix<HistoryKeeper>(this->lmp)) keeper->copy(this);
    Base::pre_delete(is_unfixed);
  }
};

// Fix in which LIGGGHTS stores the contact histories of pairs.
class PairHistories : public KeptFix<LAMMPS_NS::FixContactHistory> {
 public:
  using KeptFix::KeptFix;

  // Copies the histories from the neighbor lists, but only once after a force computation. Each
  // command delete_atoms calls this function, and a second copy would be wrong, because the first
  // command may have changed the particle indices.
  void pre_exchange() override {
    if (*computeflag_) FixContactHistory::pre_exchange();
  }

 protected:
  // Moves the histories to new memory if the deck has changed `page` or `one` by neigh_modify.
  // LIGGGHTS would free the old memory.
  void allocate_pages() override;
};

}  // namespace plastigran
