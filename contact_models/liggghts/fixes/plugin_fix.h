// SPDX-License-Identifier: GPL-2.0-or-later
//
// Base class of the plugin's fixes, and functions to add and find fixes.
#pragma once

#include <cstdio>
#include <string>
#include <vector>

#include "comm.h"
#include "error.h"
#include "fix.h"
#include "lammps.h"
#include "liggghts/fixes/engine_access.h"
#include "liggghts/fixes/messages.h"
#include "modify.h"
#include "update.h"

namespace plastigran {

// Forces a setup of the next run, even with `pre no`. Fixes of the plugin call this function when a
// deck removes them by `unfix`: contact models have pointers to them, and only a setup renews these
// pointers.
inline void require_setup(LAMMPS_NS::LAMMPS* engine, const char* id) {
  // Stop inside a `run ... every` command, because its parts have no setup between them.
  if (engine->update->whichflag)
    stop(engine, std::string(id) +
                     ": the contact models need this fix. A command in `run ... every` cannot "
                     "remove it. Use `unfix` after the run");
  engine->update->first_update = 0;
}

// Base class of the plugin's fixes. A derived class defines static style(), and static id() if the
// plugin adds the fix without a line in the deck.
class PluginFix : public LAMMPS_NS::Fix {
 public:
  using Fix::Fix;
  void pre_delete(bool is_unfixed) override {
    if (is_unfixed) require_setup(lmp, id);
  }

 protected:
  // Writes the state that restart() reads to the restart file, on rank 0. LIGGGHTS expects the size
  // before the data.
  void write_state(FILE* file, const void* state, int size) const {
    if (comm->me != 0) return;
    fwrite(&size, sizeof size, 1, file);
    fwrite(state, 1, size, file);
  }
};

inline void add_fix(LAMMPS_NS::Modify* modify, std::vector<std::string> words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  modify->add_fix(pointers.size(), pointers.data());
}

// Returns all fixes of the class `Type`.
template <class Type>
std::vector<Type*> fixes_of(const LAMMPS_NS::Modify* modify) {
  std::vector<Type*> fixes;
  for (int k = 0; k < modify->nfix; ++k)
    if (const auto fix = dynamic_cast<Type*>(modify->fix[k])) fixes.push_back(fix);
  return fixes;
}

// Stops if a wall replaces a wall with the same ID. LIGGGHTS would crash, because its list of fixes
// contains a null pointer during the replacement.
inline void refuse_replacement(LAMMPS_NS::LAMMPS* engine) {
  LAMMPS_NS::Modify* const modify = engine->modify;
  for (int k = 0; k < modify->nfix; ++k)
    if (!modify->fix[k])
      stop(engine,
           "fix wall/gran: LIGGGHTS cannot replace a wall with the same ID. Remove the earlier "
           "wall first: `unfix ID`");
}

// Registers the fix style of the class `Style`.
template <class Style>
void add_style(LAMMPS_NS::Modify* modify) {
  add_fix_style(modify, Style::style(),
                [](LAMMPS_NS::LAMMPS* lmp, int count, char** words) -> LAMMPS_NS::Fix* {
                  return new Style(lmp, count, words);
                });
}

// Returns the fix of the class `Style`, or null if there is none.
template <class Style>
Style* find_fix(LAMMPS_NS::LAMMPS* engine) {
  return static_cast<Style*>(engine->modify->find_fix_id_style(Style::id(), Style::style()));
}

// Returns the fix of the class `Style`; adds it if there is none. Collective.
template <class Style>
Style* ensure_fix(LAMMPS_NS::LAMMPS* engine) {
  if (Style* const fix = find_fix<Style>(engine)) return fix;
  add_style<Style>(engine->modify);
  add_fix(engine->modify, {Style::id(), "all", Style::style()});
  return find_fix<Style>(engine);
}

}  // namespace plastigran
