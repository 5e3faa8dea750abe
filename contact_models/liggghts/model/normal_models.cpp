// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/normal_models.h"

#include <map>
#include <vector>

#include "fix_wall_gran.h"
#include "force.h"
#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/model/contact_owner.h"
#include "pair_gran.h"

namespace plastigran {

MixedModels mixed_models(LAMMPS_NS::LAMMPS* engine) {
  MixedModels mixed;
  std::vector<std::string> laws;             // in the order of their first line
  std::map<std::string, std::string> lines;  // of each law
  const auto add = [&](const ContactOwner& owner) {
    const std::string law = owner.law();
    if (law.empty()) mixed.has_foreign = true;
    if (!law.empty() && mixed.first.empty()) mixed.first = owner.name();
    if (!lines.count(law)) laws.push_back(law);
    lines[law] += (lines[law].empty() ? "" : ", ") + owner.name();
  };
  if (const auto pair = static_cast<LAMMPS_NS::PairGran*>(engine->force->pair_match("gran", 0)))
    add(ContactOwner(pair));
  for (LAMMPS_NS::FixWallGran* const wall : fixes_of<LAMMPS_NS::FixWallGran>(engine->modify))
    add(ContactOwner(wall));
  if (laws.size() < 2) return mixed;
  for (const std::string& law : laws)
    mixed.text += (mixed.text.empty() ? "" : "; ") + lines[law] + " has " +
                  (law.empty() ? "a model of LIGGGHTS" : law);
  return mixed;
}

}  // namespace plastigran
