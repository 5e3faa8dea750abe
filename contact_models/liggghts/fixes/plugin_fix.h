// SPDX-License-Identifier: GPL-2.0-or-later
//
// Fixes that the plugin adds by itself. No deck names them.
#pragma once

#include <string>
#include <vector>

#include "error.h"
#include "fix.h"
#include "lammps.h"
#include "liggghts/fixes/engine_access.h"
#include "modify.h"
#include "update.h"

namespace plastigran {

// For the removal of a fix that contact models point to. A deck may remove it (unfix). The next run
// then needs a setup, also with `pre no`, which finds all pointers again.
inline void require_setup(LAMMPS_NS::Update* update, LAMMPS_NS::Error* error, const char* id) {
  if (update->whichflag)  // within a `run ... every`, whose parts have no setup between them
    error->all(FLERR, (std::string(id) + ": a fix the contact models point to cannot be removed "
                                         "between the parts of one run ... every")
                          .c_str());
  update->first_update = 0;
}

// A derived class has static id() and style().
class PluginFix : public LAMMPS_NS::Fix {
 public:
  using Fix::Fix;
  void pre_delete(bool by_the_deck) override {
    if (by_the_deck) require_setup(update, error, id);
  }
};

inline void add_fix(LAMMPS_NS::Modify* modify, std::vector<std::string> words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  modify->add_fix(pointers.size(), pointers.data());
}

// Stops if a wall replaces another of the same ID. LIGGGHTS would crash, because the list of fixes
// has a null pointer meanwhile.
inline void refuse_replacement(LAMMPS_NS::LAMMPS* engine) {
  LAMMPS_NS::Modify* const modify = engine->modify;
  for (int k = 0; k < modify->nfix; ++k)
    if (!modify->fix[k])
      engine->error->all(FLERR, "fix wall/gran: LIGGGHTS cannot replace a wall. Use `unfix` first");
}

// Registers the style of a class of fixes.
template <class Style>
void add_style(LAMMPS_NS::Modify* modify) {
  add_fix_style(modify, Style::style(),
                [](LAMMPS_NS::LAMMPS* lmp, int count, char** words) -> LAMMPS_NS::Fix* {
                  return new Style(lmp, count, words);
                });
}

// The fix of that class, null if there is none.
template <class Style>
Style* find_fix(LAMMPS_NS::LAMMPS* engine) {
  return static_cast<Style*>(engine->modify->find_fix_id_style(Style::id(), Style::style()));
}

// The fix of that class, added if there is none. Collective.
template <class Style>
Style* ensure_fix(LAMMPS_NS::LAMMPS* engine) {
  if (Style* const found = find_fix<Style>(engine)) return found;
  add_style<Style>(engine->modify);
  add_fix(engine->modify, {Style::id(), "all", Style::style()});
  return find_fix<Style>(engine);
}

}  // namespace plastigran
