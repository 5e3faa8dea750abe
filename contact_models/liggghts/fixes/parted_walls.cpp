// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/parted_walls.h"

#include <algorithm>
#include <string>

#include "atom.h"
#include "fix_wall_gran.h"
#include "neighbor.h"
#include "primitive_wall.h"

namespace plastigran {

int PartedWalls::setmask() { return LAMMPS_NS::FixConst::PRE_NEIGHBOR; }

void PartedWalls::pre_neighbor() {
  for (LAMMPS_NS::FixWallGran* const wall : fixes_of<LAMMPS_NS::FixWallGran>(modify)) {
    if (wall->is_mesh_wall() || wall->dnum() == 0) continue;
    const auto state = states_.find(std::string("fix ") + wall->id);
    LAMMPS_NS::Fix* const fix = modify->find_fix_id((std::string("history_") + wall->id).c_str());
    if (!fix || state == states_.end()) continue;
    // The surface model multicontact also stores surface positions in the history. They stay valid
    // between contacts, so only the state of the law is cleared.
    const bool keeps_surfaces = wall->contact_match("surface", "multicontact");
    const auto [first, count] = keeps_surfaces ? state->second : std::pair(0, wall->dnum());
    for (int i = 0; i < atom->nlocal; ++i)
      if (!wall->primitiveWall()->isNear(i, neighbor->skin))
        std::fill_n(fix->array_atom[i] + first, count, 0.0);
  }
}

}  // namespace plastigran
