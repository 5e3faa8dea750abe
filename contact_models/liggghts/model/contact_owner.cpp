// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/contact_owner.h"

#include <numeric>

#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "modify.h"
#include "pair_gran.h"

namespace plastigran {

using LAMMPS_NS::FixWallGran;
using LAMMPS_NS::PairGran;

bool ContactOwner::tangential_model_is(const std::string& name) const {
  return is_wall_ ? static_cast<FixWallGran*>(owner_)->contact_match("tangential", name)
                  : static_cast<PairGran*>(owner_)->contact_match("tangential", name);
}

std::vector<int> ContactOwner::partner_types(int type_count) const {
  std::vector<int> types;
  if (!is_wall_) {
    types.resize(type_count);
    std::iota(types.begin(), types.end(), 1);
    return types;
  }
  FixWallGran* const wall = static_cast<FixWallGran*>(owner_);
  if (!wall->is_mesh_wall()) return {wall->atom_type_wall()};
  for (int mesh = 0; mesh < wall->n_meshes(); ++mesh)
    types.push_back(wall->mesh_list()[mesh]->atomTypeWall());
  return types;
}

std::set<int> ContactOwner::wall_types(LAMMPS_NS::Modify* modify) {
  std::set<int> types;
  for (int k = 0; k < modify->nfix; ++k)
    if (const auto wall = dynamic_cast<FixWallGran*>(modify->fix[k]))
      for (int type : ContactOwner(wall, true).partner_types(0)) types.insert(type);
  return types;
}

}  // namespace plastigran
