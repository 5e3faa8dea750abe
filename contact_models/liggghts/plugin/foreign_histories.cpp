// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/plugin/foreign_histories.h"

#include <algorithm>
#include <string>

#include "comm.h"
#include "contact_models.h"
#include "error.h"
#include "fix_mesh_surface.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "lammps.h"
#include "liggghts/fixes/engine_access.h"
#include "liggghts/fixes/history_keeper.h"
#include "liggghts/fixes/print.h"
#include "liggghts/model/companions.h"
#include "liggghts/model/contact_owner.h"
#include "liggghts/model/normal_models.h"
#include "modify.h"
#include "pair_gran.h"

namespace plastigran {

using LAMMPS_NS::FixWallGran;
using LAMMPS_NS::LAMMPS;

namespace {

// Styles of the fixes in which LIGGGHTS stores contact histories of pairs, meshes and primitive
// walls, and its creators of them.
struct HistoryStyle {
  const char* style;
  FixCreator creator;
} styles[] = {
    {"contacthistory", nullptr}, {"contacthistory/mesh", nullptr}, {"property/atom", nullptr}};

// The pair style or wall whose histories a fix stores.
struct Owner {
  std::string name;    // as HistoryKeeper has it; empty: the fix stores something else
  std::string models;  // of this package, as HistoryKeeper has them without options; or empty
};

template <class Style>
std::string models_of(Style* owner, bool is_wall) {
  const std::string law = law_of(owner);
  return law.empty() ? "" : "model " + law + ContactOwner(owner, is_wall).other_models();
}

// Whether models that a restart file names, with options behind them, are these.
bool are_models(const std::string& restarted, const std::string& models) {
  if (restarted.compare(0, models.size(), models) != 0) return false;
  const std::string options = restarted.substr(models.size());
  if (!options.empty() && options[0] != ' ') return false;
  return std::none_of(companion_kinds().begin(), companion_kinds().end(),
                      [&options](const CompanionKind& kind) {
                        return options.find(std::string(" ") + kind.keyword + ' ') == 0;
                      });
}

// LIGGGHTS counts a particle's contacts with a mesh in a fix of its own, which goes with them.
const std::string mesh_contacts = "n_neighs_mesh_";

Owner wall_of(LAMMPS* engine, const std::string& fix_id) {
  for (int k = 0; k < engine->modify->n_fixes_style("wall/gran"); ++k) {
    const auto wall = dynamic_cast<FixWallGran*>(engine->modify->find_fix_style("wall/gran", k));
    if (!wall) continue;
    bool stores = !wall->is_mesh_wall() && fix_id == std::string("history_") + wall->id;
    for (int mesh = 0; wall->is_mesh_wall() && mesh < wall->n_meshes(); ++mesh) {
      const std::string mesh_id = wall->mesh_list()[mesh]->id;
      stores = stores || fix_id == "tracker_" + mesh_id || fix_id == mesh_contacts + mesh_id;
    }
    if (stores) return {std::string("fix ") + wall->id, models_of(wall, true)};
  }
  return {};
}

Owner owner_of(LAMMPS* engine, const std::string& fix_id, const std::string& style) {
  if (style != "contacthistory") return wall_of(engine, fix_id);
  const auto pair = static_cast<LAMMPS_NS::PairGran*>(engine->force->pair_match("gran", 0));
  return pair ? Owner{"pair_style", models_of(pair, false)} : Owner();
}

void discard_if_foreign(LAMMPS* engine, const std::string& fix_id, const std::string& style) {
  if (engine->modify->nfix_restart_peratom == 0) return;
  const Owner owner = owner_of(engine, fix_id, style);
  const std::string models = HistoryKeeper::restarted_models(engine, owner.name);
  if (owner.name.empty()) return;
  if (!owner.models.empty() && !models.empty()) {
    if (!are_models(models, owner.models))
      HistoryKeeper::refuse_other_models(engine, owner.name, models, owner.models);
    return;
  }
  if (owner.models.empty() && models.empty()) return;
  if (!discard_restarted(engine->modify, fix_id, style) || engine->comm->me != 0) return;
  if (fix_id.rfind(mesh_contacts, 0) == 0) return;  // the log has the line of the histories
  if (owner.models.empty()) {
    warn(engine, owner.name + ": the restart file has contacts of `" + models +
                     "`, which a model of LIGGGHTS cannot continue. Their residual overlaps and "
                     "tangential springs are discarded");
    return;
  }
  print(engine, owner.name +
                    ": the restart file has contacts of a model of LIGGGHTS. They begin as first "
                    "contacts, loaded to their present overlap, without tangential springs\n");
}

LAMMPS_NS::Fix* make_history(LAMMPS* engine, int count, char** words) {
  const std::string style = words[2];
  discard_if_foreign(engine, words[0], style);
  for (const HistoryStyle& known : styles)
    if (style == known.style) return known.creator(engine, count, words);
  return nullptr;
}

}  // namespace

void discard_foreign_histories(LAMMPS* engine) {
  for (HistoryStyle& known : styles) {
    const FixCreator creator = fix_creator(engine->modify, known.style);
    if (!creator || creator == make_history) continue;
    known.creator = creator;
    add_fix_style(engine->modify, known.style, make_history);
  }
}

}  // namespace plastigran
