// SPDX-License-Identifier: GPL-2.0-or-later
//
// A deck may read a restart file of LIGGGHTS' own models and continue with a law, for example after
// a bed has settled with `hertz`, or the reverse. LIGGGHTS would stop, because the history values
// differ. This file discards these histories with a message, and the contacts start as first
// contacts with their current overlap.
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace plastigran {

// Makes LIGGGHTS check every new fix that stores contact histories, when the fix is created.
void discard_foreign_histories(LAMMPS_NS::LAMMPS* engine);

}  // namespace plastigran
