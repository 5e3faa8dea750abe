// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/contact_rates.h"

#include "atom.h"
#include "force.h"
#include "pair_gran.h"

namespace plastigran {

// Returns the number of history values to add: 1 if a yield strength depends on the strain rate,
// else 0. LIGGGHTS calls this function once per pair style, in the setup of its first run.
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

void ContactRates::begin(LIGGGHTS::IContactHistorySetup& setup, const DeckProperties& deck,
                         bool has_types) {
  if (!is_wall_ && has_types)
    ensure_fix<RateHistory>(engine_)->begin();
  else if (is_wall_ && deck.positive("rate_coefficient"))
    offset_ = setup.add_history_value("rate_factor", "0");
}

void ContactRates::connect(const DeckProperties& deck, bool rate_matters) {
  if (!is_wall_) offset_ = ensure_fix<RateHistory>(engine_)->offset();
  if (offset_ < 0 && rate_matters)
    deck.fail(property_name("rate_coefficient") + " must be given before " +
              (is_wall_ ? "the wall" : "the first run") +
              ", which sets the size of the contact history. Move the line of the property up");
}

}  // namespace plastigran
