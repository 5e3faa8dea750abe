// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/plugin/history_fixes.h"

#include <algorithm>
#include <string>

#include "comm.h"
#include "contact_models.h"
#include "fix_contact_history_mesh.h"
#include "fix_mesh_surface.h"
#include "fix_property_atom.h"
#include "fix_wall_gran.h"
#include "force.h"
#include "lammps.h"
#include "liggghts/fixes/engine_access.h"
#include "liggghts/fixes/history_keeper.h"
#include "liggghts/fixes/kept_fixes.h"
#include "liggghts/fixes/messages.h"
#include "liggghts/model/companions.h"
#include "liggghts/model/contact_owner.h"
#include "modify.h"
#include "pair_gran.h"

namespace plastigran {

using LAMMPS_NS::FixWallGran;
using LAMMPS_NS::LAMMPS;

namespace {

// Pair style or wall whose histories a fix stores.
struct Owner {
  std::string name;  // "pair_style" or "fix ID"; empty: the fix stores something else
  // Names of the contact models as in ContactLine, without options; empty for LIGGGHTS' own models.
  std::string models;
};

std::string models_of(const ContactOwner& owner) {
  const std::string law = owner.law();
  return law.empty() ? "" : "model " + law + owner.other_models();
}

// Returns whether the models in a restart file are `models`; options may follow them.
bool are_models(const std::string& restarted, const std::string& models) {
  if (restarted.compare(0, models.size(), models) != 0) return false;
  const std::string options = restarted.substr(models.size());
  if (!options.empty() && options[0] != ' ') return false;
  return std::none_of(companion_kinds().begin(), companion_kinds().end(),
                      [&options](const CompanionKind& kind) {
                        return options.find(std::string(" ") + kind.keyword + ' ') == 0;
                      });
}

// Prefix of LIGGGHTS' fixes that count the contacts of a particle with a mesh.
const std::string mesh_contacts = "n_neighs_mesh_";

Owner wall_of(LAMMPS* engine, const std::string& fix_id) {
  for (FixWallGran* const wall : fixes_of<FixWallGran>(engine->modify)) {
    bool stores = !wall->is_mesh_wall() && fix_id == std::string("history_") + wall->id;
    for (int mesh = 0; wall->is_mesh_wall() && mesh < wall->n_meshes(); ++mesh) {
      const std::string mesh_id = wall->mesh_list()[mesh]->id;
      stores = stores || fix_id == "tracker_" + mesh_id || fix_id == mesh_contacts + mesh_id;
    }
    if (stores) return {std::string("fix ") + wall->id, models_of(ContactOwner(wall))};
  }
  return {};
}

Owner owner_of(LAMMPS* engine, const std::string& fix_id, const std::string& style) {
  if (style != "contacthistory") return wall_of(engine, fix_id);
  const auto pair = static_cast<LAMMPS_NS::PairGran*>(engine->force->pair_match("gran", 0));
  return pair ? Owner{pair_owner, models_of(ContactOwner(pair))} : Owner();
}

void discard_if_foreign(LAMMPS* engine, const std::string& fix_id, const std::string& style) {
  if (engine->modify->nfix_restart_peratom == 0) return;
  const Owner owner = owner_of(engine, fix_id, style);
  ContactLines restarted = read_restart_text(HistoryKeeper::restarted_lines(engine));
  const std::string models = restarted[owner.name].models;
  if (owner.name.empty()) return;
  if (!owner.models.empty() && !models.empty()) {
    if (!are_models(models, owner.models))
      refuse_other_models(engine, owner.name, models, owner.models);
    return;
  }
  if (owner.models.empty() && models.empty()) return;
  if (!discard_restarted(engine->modify, fix_id, style) || engine->comm->me != 0) return;
  // Print only one message for a mesh: the message about its histories suffices.
  if (fix_id.rfind(mesh_contacts, 0) == 0) return;
  if (owner.models.empty()) {
    warn(engine, owner.name + ": the restart file has contacts of `" + models +
                     "`, which LIGGGHTS' own models cannot continue. Their residual overlaps and "
                     "tangential springs are discarded");
    return;
  }
  print(engine, owner.name +
                    ": the restart file has contacts of one of LIGGGHTS' own models, not of a law "
                    "of this plugin. The contacts begin as first loading to their current overlap, "
                    "without tangential springs\n");
}

template <class Fix>
LAMMPS_NS::Fix* make_history(LAMMPS* engine, int count, char** words) {
  discard_if_foreign(engine, words[0], words[2]);
  return new Fix(engine, count, words);
}

}  // namespace

void replace_history_fixes(LAMMPS* engine) {
  LAMMPS_NS::Modify* const modify = engine->modify;
  add_fix_style(modify, "contacthistory", make_history<PairHistories>);
  add_fix_style(modify, "contacthistory/mesh",
                make_history<KeptFix<LAMMPS_NS::FixContactHistoryMesh>>);
  // LIGGGHTS stores the histories of primitive walls in fixes of this style.
  add_fix_style(modify, "property/atom", make_history<KeptFix<LAMMPS_NS::FixPropertyAtom>>);
}

}  // namespace plastigran
