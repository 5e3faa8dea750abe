// SPDX-License-Identifier: GPL-2.0-or-later
//
// A deck may read a restart file of LIGGGHTS' own models and continue with a law, for example after
// a bed has settled with `hertz`, or the reverse. LIGGGHTS would stop, because the history values
// differ. They are discarded with a message, and the contacts start with their current overlap.
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace plastigran {

// Checks every fix that stores contact histories from now on, when it is made.
void discard_foreign_histories(LAMMPS_NS::LAMMPS* engine);

}  // namespace plastigran
