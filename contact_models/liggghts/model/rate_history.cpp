// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/rate_history.h"

#include "atom.h"
#include "force.h"
#include "liggghts/model/deck_properties.h"
#include "pair_gran.h"

namespace plastigran {

// Decided once: the engine does not count again while the pair style lives.
int RateHistory::n_history_extra() {
  if (needed_ == Needed::unknown) {
    const DeckProperties deck(lmp, style(), atom->ntypes);
    needed_ = deck.positive("rate_coefficient") ? Needed::yes : Needed::no;
  }
  return needed_ == Needed::yes ? 1 : 0;
}

bool RateHistory::history_args(char** words) {
  static char name[] = "rate_factor", same_from_either_side[] = "0";
  words[0] = name;
  words[1] = same_from_either_side;
  return true;
}

int RateHistory::offset() const {
  if (needed_ != Needed::yes) return -1;
  const auto pair = static_cast<LAMMPS_NS::PairGran*>(force->pair_match("gran", 0));
  return pair->fix_extra_dnum_index(const_cast<RateHistory*>(this));
}

}  // namespace plastigran
