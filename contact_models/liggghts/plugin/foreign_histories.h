// SPDX-License-Identifier: GPL-2.0-or-later
//
// A restart file may hold contact histories of LIGGGHTS' own models where the deck now has a law of
// this package, or the reverse: a bed that settled with `hertz` continues with a law, for example.
// Their values mean something else, and LIGGGHTS would stop. They are discarded, the contacts begin
// with their present overlap, and the log says so.
#pragma once

namespace LAMMPS_NS {
class LAMMPS;
}

namespace plastigran {

// Looks from now on at each fix that stores contact histories as it is made.
void discard_foreign_histories(LAMMPS_NS::LAMMPS* engine);

}  // namespace plastigran
