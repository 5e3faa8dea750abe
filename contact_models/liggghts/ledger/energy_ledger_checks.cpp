// SPDX-License-Identifier: GPL-2.0-or-later
//
// What a deck must be like for the ledger to be right, and what is said where it is not.
#include <cstring>
#include <string>

#include "comm.h"
#include "error.h"
#include "force.h"
#include "liggghts/ledger/energy_ledger.h"
#include "modify.h"
#include "pair.h"

namespace plastigran {

const char* EnergyLedger::complaint(const EnergyLedger* ledger, bool asked, bool is_wall) {
  if (asked && !ledger)
    return is_wall
               ? "energy_ledger on: the pair_style line must have it too"
               : "energy_ledger on: its fix was removed (unfix energy_ledger). Keep it, or give "
                 "the pair_style and wall lines again without energy_ledger on";
  if (ledger && !asked && !is_wall)
    return "pair_style: an energy ledger is kept, and this line has no energy_ledger on. Add it, "
           "or "
           "end the ledger first: unfix energy_ledger, unfix plastic_work";
  return nullptr;
}

void EnergyLedger::refuse_what_is_not_counted() {
  if (force->newton_pair)
    error->all(FLERR,
               "energy_ledger on: it needs `newton off`, for contacts across the borders "
               "between ranks");
  for (const char* style : {"multisphere", "rigid"})
    if (modify->n_fixes_style(style) > 0)
      error->all(FLERR,
                 (std::string("energy_ledger on: it counts particles, and not the bodies that "
                              "fix ") +
                  style + " makes of them; leave it off")
                     .c_str());
}

// Walls that do not report would show up as drift without a word.
void EnergyLedger::warn_of_strangers() {
  if (LAMMPS_NS::Pair* const pair = force->pair_match("gran", 1); !attached_.count(pair))
    error->all(FLERR, complaint(this, false, false));
  std::string strangers;
  for (int k = 0; k < modify->nfix; ++k) {
    LAMMPS_NS::Fix* const wall = modify->fix[k];
    if (std::strncmp(wall->style, "wall/gran", 9) == 0 && !attached_.count(wall))
      strangers += std::string(strangers.empty() ? "" : ", ") + wall->id;
  }
  attached_.clear();  // all connect before each run
  if (strangers == strangers_) return;
  strangers_ = strangers;
  if (comm->me == 0 && !strangers.empty())
    error->warning(FLERR, ("energy_ledger: what these walls store, dissipate and put in shows as "
                           "drift, they have no energy_ledger on: " +
                           strangers)
                              .c_str());
}

}  // namespace plastigran
