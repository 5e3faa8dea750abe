// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/contact_owner.h"

#include <numeric>
#include <string_view>

#include "contact_models.h"
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "liggghts/model/companions.h"
#include "modify.h"
#include "pair_gran.h"

namespace plastigran {

using LAMMPS_NS::FixWallGran;
using LAMMPS_NS::PairGran;

bool ContactOwner::has_model(const std::string& kind, const std::string& name) const {
  return is_wall_ ? static_cast<FixWallGran*>(owner_)->contact_match(kind, name)
                  : static_cast<PairGran*>(owner_)->contact_match(kind, name);
}

bool ContactOwner::tangential_model_is(const std::string& name) const {
  return has_model("tangential", name);
}

std::string ContactOwner::name() const {
  return is_wall_ ? std::string("fix ") + static_cast<FixWallGran*>(owner_)->id : "pair_style";
}

std::string ContactOwner::other_models() const {
  std::string text;
  for (const CompanionKind& kind : companion_kinds())
    for (const Companion& companion : kind.models)
      if (companion.id != 0 && has_model(kind.keyword, companion.name))
        text += std::string(" ") + kind.keyword + ' ' + companion.name;
  return text;
}

bool ContactOwner::is_mesh_wall() const {
  return is_wall_ && static_cast<FixWallGran*>(owner_)->is_mesh_wall();
}

std::string ContactOwner::unsuitable_model(bool is_cylinder, bool is_adhesive) const {
  std::string text;
  for (const CompanionKind& kind : companion_kinds())
    for (const Companion& companion : kind.models) {
      if (companion.id == 0 || !has_model(kind.keyword, companion.name)) continue;
      const std::string name = std::string(kind.keyword) + ' ' + companion.name;
      if (is_wall_ && name.find("easo") != std::string::npos)
        text = name + " on a wall takes the wall's velocity from some particle; leave it off here";
      if (is_adhesive && std::string_view(kind.keyword) == "cohesion")
        text = name + " adds to the adhesion of this law. Remove it from the line";
      if (is_adhesive && name == "surface multicontact")
        text = name + " is not supported with adhesion. Remove it from the line";
      const bool is_friction =
          name.rfind("tangential", 0) == 0 || name.rfind("rolling_friction", 0) == 0;
      if (is_cylinder && !is_friction)
        text = name + " is for spheres; this model is for cylinders, the discs of a 2D deck";
    }
  return text;
}

std::vector<std::string> ContactOwner::histories() const {
  if (!is_wall_) {
    if (static_cast<PairGran*>(owner_)->dnum() == 0) return {};
    return {"contacthistory"};
  }
  FixWallGran* const wall = static_cast<FixWallGran*>(owner_);
  if (wall->dnum() == 0) return {};
  if (!wall->is_mesh_wall()) return {std::string("history_") + wall->id};
  std::vector<std::string> ids;
  for (int mesh = 0; mesh < wall->n_meshes(); ++mesh)
    ids.push_back(std::string("tracker_") + wall->mesh_list()[mesh]->id);
  return ids;
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
