// SPDX-License-Identifier: GPL-2.0-or-later
//
// A deck may read a restart file of LIGGGHTS' own models and continue with a law, for example after
// a bed has settled with `hertz`. It may also continue with LIGGGHTS' own models after a law.
// LIGGGHTS would stop, because the history values differ. The plugin discards such histories with a
// message. The contacts then begin as first loading to their current overlap.
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace plastigran {

// Replaces the functions with which LIGGGHTS creates fixes for contact histories. The new functions
// check the restart file and create the fixes of kept_fixes.h.
void replace_history_fixes(LAMMPS_NS::LAMMPS* engine);

}  // namespace plastigran
