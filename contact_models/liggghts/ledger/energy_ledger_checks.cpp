// SPDX-License-Identifier: GPL-2.0-or-later
//
// What a deck must be like for the ledger to be right, and what is said where it is not.
#include <string>

#include "comm.h"
#include "error.h"
#include "force.h"
#include "liggghts/ledger/energy_ledger.h"
#include "liggghts/observers/contact_observer.h"
#include "pair.h"
#include "update.h"
#include "liggghts/fixes/print.h"

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
  if (std::string(update->integrate_style) != "verlet")
    error->all(FLERR, ("energy_ledger on: run_style " + std::string(update->integrate_style) +
                       " is not supported, because work is summed as velocity Verlet moves the "
                       "particles. Use `run_style verlet`, or remove energy_ledger on")
                          .c_str());
  const std::string reason = uncountable(lmp);
  if (!reason.empty()) error->all(FLERR, ("energy_ledger on: " + reason).c_str());
}

// Walls that do not report would show up as drift without a word.
void EnergyLedger::warn_of_strangers() {
  if (LAMMPS_NS::Pair* const pair = force->pair_match("gran", 1); !attached_.count(pair))
    error->all(FLERR, complaint(this, false, false));
  const std::string strangers = strange_walls(modify, attached_);
  attached_.clear();  // all connect before each run
  if (strangers == strangers_) return;
  strangers_ = strangers;
  if (comm->me == 0 && !strangers.empty())
    warn(lmp,
         "energy_ledger: the balance error includes the energies of these walls, which have no "
         "energy_ledger on: " +
             strangers);
}

}  // namespace plastigran
