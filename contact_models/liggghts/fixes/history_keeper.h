// SPDX-License-Identifier: GPL-2.0-or-later
//
// Restart files with the contacts of their own step. At a step of the `restart` command the engine
// stores the pairs' histories for the file at the step's beginning, before its forces have advanced
// them: the file would lack what the last step added to tangential springs and to what a law has
// reached. This fix stores them again at the step's end. (The command `write_restart` has no such
// gap, walls neither.)
#pragma once

#include "fix.h"

namespace plastigran {

class HistoryKeeper : public LAMMPS_NS::Fix {
 public:
  HistoryKeeper(LAMMPS_NS::LAMMPS* engine, int count, char** words);
  static const char* id() { return "plastigran_history"; }
  static const char* style() { return "plastigran/history"; }

  int setmask() override;
  void end_of_step() override;
};

}  // namespace plastigran
