// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/normal_models.h"

#include <map>
#include <string>
#include <vector>

#include "contact_models.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "lammps.h"
#include "modify.h"
#include "pair_gran.h"

namespace plastigran {

using LAMMPS_NS::FixWallGran;
using LAMMPS_NS::PairGran;

namespace {

template <class Owner>
std::string law_of_owner(Owner* owner) {
#define LAW(name) \
  if (owner->contact_match("normal", #name)) return #name;
#define COMBINATION(number)
#include "registered.inc"
#undef LAW
#undef COMBINATION
  return {};
}

}  // namespace

std::string law_of(PairGran* pair) { return law_of_owner(pair); }
std::string law_of(FixWallGran* wall) { return law_of_owner(wall); }

MixedModels mixed_models(LAMMPS_NS::LAMMPS* engine) {
  MixedModels found;
  std::vector<std::string> laws;             // in the order of their first line
  std::map<std::string, std::string> lines;  // of each law
  const auto add = [&](const std::string& line, const std::string& law) {
    if (law.empty()) found.has_foreign = true;
    if (!law.empty() && found.first.empty()) found.first = line;
    std::string& of_law = lines[law];
    if (of_law.empty()) laws.push_back(law);
    of_law += (of_law.empty() ? "" : ", ") + line;
  };
  if (const auto pair = static_cast<PairGran*>(engine->force->pair_match("gran", 0)))
    add("pair_style", law_of(pair));
  LAMMPS_NS::Modify* const modify = engine->modify;
  for (int k = 0; k < modify->n_fixes_style("wall/gran"); ++k)
    if (const auto wall = dynamic_cast<FixWallGran*>(modify->find_fix_style("wall/gran", k)))
      add(std::string("fix ") + wall->id, law_of(wall));
  if (laws.size() < 2) return found;
  for (const std::string& law : laws)
    found.text += (found.text.empty() ? "" : "; ") + lines[law] + " has " +
                  (law.empty() ? "a model of LIGGGHTS" : law);
  return found;
}

}  // namespace plastigran
