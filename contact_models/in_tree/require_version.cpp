// SPDX-License-Identifier: GPL-2.0-or-later
//
// In the engine's own source tree: what is compiled with the engine fits it.
#include "liggghts/plugin/registered.h"

namespace plastigran {

void require_version(LAMMPS_NS::LAMMPS*) {}

}  // namespace plastigran
