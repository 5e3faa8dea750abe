// SPDX-License-Identifier: GPL-2.0-or-later
//
// Fixes in which LIGGGHTS stores contact histories by particle, extended so that HistoryKeeper gets
// the histories before LIGGGHTS discards them.
#pragma once

#include "fix_contact_history.h"
#include "liggghts/fixes/history_keeper.h"
#include "liggghts/fixes/plugin_fix.h"

namespace plastigran {

// Fix of the LIGGGHTS class `Base`. LIGGGHTS deletes it when the deck gives the line of its
// contacts again.
template <class Base>
class KeptFix : public Base {
 public:
  using Base::Base;
  void pre_delete(bool by_the_deck) override {
    if (HistoryKeeper* const keeper = find_fix<HistoryKeeper>(this->lmp)) keeper->copy(this);
    Base::pre_delete(by_the_deck);
  }
};

// Fix for the histories of pairs.
class PairHistories : public KeptFix<LAMMPS_NS::FixContactHistory> {
 public:
  using KeptFix::KeptFix;

  // Copies the histories from the neighbor lists, unless they have been copied since the last
  // forces. The command delete_atoms calls this function each time, although an earlier command may
  // have changed the particle indices.
  void pre_exchange() override {
    if (*computeflag_) FixContactHistory::pre_exchange();
  }

 protected:
  // Moves the histories to new memory if the deck has changed `page` or `one` by neigh_modify.
  // LIGGGHTS would free the old memory.
  void allocate_pages() override;
};

}  // namespace plastigran
