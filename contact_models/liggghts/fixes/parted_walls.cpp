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
  for (int k = 0; k < modify->nfix; ++k) {
    const auto wall = dynamic_cast<LAMMPS_NS::FixWallGran*>(modify->fix[k]);
    if (!wall || wall->is_mesh_wall() || wall->dnum() == 0) continue;
    // Its histories also hold the places of surfaces, which LIGGGHTS keeps between contacts.
    if (wall->contact_match("surface", "multicontact")) continue;
    const int found = modify->find_fix((std::string("history_") + wall->id).c_str());
    if (found < 0) continue;
    double** const histories = modify->fix[found]->array_atom;
    for (int i = 0; i < atom->nlocal; ++i)
      if (!wall->primitiveWall()->isNear(i, neighbor->skin))
        std::fill_n(histories[i], wall->dnum(), 0.0);
  }
}

}  // namespace plastigran
