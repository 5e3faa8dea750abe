// SPDX-License-Identifier: GPL-2.0-or-later
//
// Version check for builds in the LIGGGHTS source tree: always passes, because the laws are
// compiled with LIGGGHTS itself.
#include "liggghts/plugin/registered.h"

namespace plastigran {

void require_version(LAMMPS_NS::LAMMPS*) {}

}  // namespace plastigran
