// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/contact_owner.h"

#include <map>
#include <numeric>

#include "contact_models.h"
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/model/companions.h"
#include "pair_gran.h"

namespace plastigran {

using LAMMPS_NS::FixWallGran;
using LAMMPS_NS::PairGran;

ContactOwner::ContactOwner(LIGGGHTS::IContactHistorySetup* owner, bool is_wall)
    : pair_(is_wall ? nullptr : static_cast<PairGran*>(owner)),
      wall_(is_wall ? static_cast<FixWallGran*>(owner) : nullptr) {}

std::string ContactOwner::name() const {
  return wall_ ? std::string("fix ") + wall_->id : "pair_style";
}

bool ContactOwner::has_model(const std::string& keyword, const std::string& name) const {
  return wall_ ? wall_->contact_match(keyword, name) : pair_->contact_match(keyword, name);
}

std::string ContactOwner::law() const {
#define LAW(name)                 \
  if (has_model("normal", #name)) \
    return has_model("adhesion", "jkr") ? #name " adhesion jkr" : #name;
#define COMBINATION(number)
#include "registered.inc"
#undef LAW
#undef COMBINATION
  if (has_model("normal", "hertz"))
    for (const Companion& companion : companion_kinds()[0].models)
      if (is_tangential_law(companion.id) && has_model("tangential", companion.name))
        return "hertz";
  return {};
}

std::string ContactOwner::other_models() const {
  std::string text;
  for (const CompanionKind& kind : companion_kinds())
    for (const Companion& companion : kind.models)
      if (companion.id != 0 && has_model(kind.keyword, companion.name))
        text += std::string(" ") + kind.keyword + ' ' + companion.name;
  for (int rings = least_rings; rings <= most_rings; ++rings)
    if (has_model("rings", std::to_string(rings))) text += " rings " + std::to_string(rings);
  return text;
}

bool ContactOwner::is_mesh_wall() const { return wall_ && wall_->is_mesh_wall(); }

std::string ContactOwner::unsuitable_model(const std::string& law, bool is_cylinder,
                                           bool is_adhesive) const {
  std::string text;
  for (const CompanionKind& kind : companion_kinds())
    for (const Companion& companion : kind.models) {
      if (companion.id == 0 || !has_model(kind.keyword, companion.name)) continue;
      const std::string keyword = kind.keyword, name = keyword + ' ' + companion.name;
      const std::string remedy = ". Remove " + name + " from the line";
      if (wall_ && name.find("easo") != std::string::npos)
        text = name + " does not support walls, because it takes the velocity of the wall from a " +
               "particle" + remedy;
      if (is_adhesive && keyword == "cohesion")
        text = name + " adds to the adhesion of this law" + remedy;
      const bool is_stiff_rolling =
          companion.name == std::string("epsd") || companion.name == std::string("epsd3");
      if (is_adhesive && (name == "surface multicontact" || is_stiff_rolling))
        text = name + " is not supported with adhesion" + remedy;
      if (is_cylinder && keyword != "tangential" && keyword != "rolling_friction")
        text =
            name + " supports only spheres, but " + law + " is a law for cylinders (2D)" + remedy;
    }
  return text;
}

std::vector<std::string> ContactOwner::histories() const {
  if ((wall_ ? wall_->dnum() : pair_->dnum()) == 0) return {};
  if (!wall_) return {"contacthistory"};
  if (!wall_->is_mesh_wall()) return {std::string("history_") + wall_->id};
  std::vector<std::string> ids;
  for (int mesh = 0; mesh < wall_->n_meshes(); ++mesh)
    ids.push_back(std::string("tracker_") + wall_->mesh_list()[mesh]->id);
  return ids;
}

int ContactOwner::group() const {
  // All particles can touch a mesh wall, because LIGGGHTS ignores the group of the wall.
  return wall_ && !wall_->is_mesh_wall() ? wall_->groupbit : 1;
}

std::vector<int> ContactOwner::partner_types(int type_count) const {
  std::vector<int> types;
  if (!wall_) {
    types.resize(type_count);
    std::iota(types.begin(), types.end(), 1);
  } else if (!wall_->is_mesh_wall()) {
    types.push_back(wall_->atom_type_wall());
  } else {
    for (int mesh = 0; mesh < wall_->n_meshes(); ++mesh)
      types.push_back(wall_->mesh_list()[mesh]->atomTypeWall());
  }
  return types;
}

std::set<int> wall_types(LAMMPS_NS::Modify* modify) {
  std::set<int> types;
  for (FixWallGran* const wall : fixes_of<FixWallGran>(modify))
    for (const int type : ContactOwner(wall).partner_types(0)) types.insert(type);
  return types;
}

MixedModels mixed_models(LAMMPS_NS::LAMMPS* engine) {
  MixedModels mixed;
  std::vector<std::string> laws;             // laws in the order of their first line
  std::map<std::string, std::string> lines;  // names of the lines, for each law
  const auto add = [&](const ContactOwner& owner) {
    const std::string law = owner.law();
    if (law.empty()) mixed.has_foreign = true;
    if (!law.empty() && mixed.first.empty()) mixed.first = owner.name();
    if (!lines.count(law)) laws.push_back(law);
    lines[law] += (lines[law].empty() ? "" : ", ") + owner.name();
  };
  if (const auto pair = static_cast<PairGran*>(engine->force->pair_match("gran", 0)))
    add(ContactOwner(pair));
  for (FixWallGran* const wall : fixes_of<FixWallGran>(engine->modify)) add(ContactOwner(wall));
  if (laws.size() < 2) return mixed;
  for (const std::string& law : laws)
    mixed.text += (mixed.text.empty() ? "" : "; ") + lines[law] + " has " +
                  (law.empty() ? "one of LIGGGHTS' own models" : law);
  return mixed;
}

}  // namespace plastigran
