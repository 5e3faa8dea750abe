// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/history_keeper.h"

#include "liggghts/fixes/engine_access.h"
#include "modify.h"
#include "update.h"

namespace plastigran {

HistoryKeeper::HistoryKeeper(LAMMPS_NS::LAMMPS* engine, int count, char** words)
    : Fix(engine, count, words) {
  nevery = 1;
}

int HistoryKeeper::setmask() { return LAMMPS_NS::FixConst::END_OF_STEP; }

void HistoryKeeper::end_of_step() {
  if (next_restart(output) != update->ntimestep) return;
  for (int k = 0; k < modify->n_fixes_style_strict("contacthistory"); ++k)
    modify->find_fix_style_strict("contacthistory", k)->setup_pre_exchange();
}

}  // namespace plastigran
