// SPDX-License-Identifier: GPL-2.0-or-later
//
// Restart files with the contacts of their own step. At a step of the `restart` command the engine
// stores the pairs' histories for the file at the step's beginning, before its forces have advanced
// them: the file would lack what the last step added to tangential springs and to what a law has
// reached. This fix stores them again at the step's end. (The command `write_restart` has no such
// gap, walls neither.)
#ifndef PLASTIGRAN_HISTORY_KEEPER_H
#define PLASTIGRAN_HISTORY_KEEPER_H

#include "fix.h"
#include "modify.h"
#include "output.h"
#include "own_fix.h"
#include "update.h"

namespace plastigran {

class HistoryKeeper : public LAMMPS_NS::Fix {
 public:
  HistoryKeeper(LAMMPS_NS::LAMMPS* engine, int count, char** words) : Fix(engine, count, words) {
    nevery = 1;
  }
  static const char* id() { return "plastigran_history"; }
  static const char* style() { return "plastigran/history"; }

  int setmask() override { return LAMMPS_NS::FixConst::END_OF_STEP; }

  void end_of_step() override {
    if (output->*reach(EngineNextRestart()) != update->ntimestep) return;
    for (int k = 0; k < modify->n_fixes_style_strict("contacthistory"); ++k)
      modify->find_fix_style_strict("contacthistory", k)->setup_pre_exchange();
  }
};

}  // namespace plastigran

#endif
