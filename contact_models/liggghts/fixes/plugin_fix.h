// SPDX-License-Identifier: GPL-2.0-or-later
//
// Fixes that the plugin adds by itself. No deck names them.
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

// For the removal of a fix that contact models point to. A deck may remove it (unfix). The next run
// then needs a setup, also with `pre no`, which finds all pointers again.
inline void require_setup(LAMMPS_NS::LAMMPS* engine, const char* id) {
  // The parts of a `run ... every` have no setup between them.
  if (engine->update->whichflag)
    stop(engine, std::string(id) +
                     ": the contact models need this fix. It cannot be removed between "
                     "the parts of one run ... every");
  engine->update->first_update = 0;
}

// A derived class has static id() and style().
class PluginFix : public LAMMPS_NS::Fix {
 public:
  using Fix::Fix;
  void pre_delete(bool by_the_deck) override {
    if (by_the_deck) require_setup(lmp, id);
  }

 protected:
  // Writes a state for restart() from the first rank. LIGGGHTS needs its size first.
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

// All fixes of a class.
template <class Type>
std::vector<Type*> fixes_of(const LAMMPS_NS::Modify* modify) {
  std::vector<Type*> fixes;
  for (int k = 0; k < modify->nfix; ++k)
    if (const auto fix = dynamic_cast<Type*>(modify->fix[k])) fixes.push_back(fix);
  return fixes;
}

// Stops if a wall replaces another of the same ID. LIGGGHTS would crash, because the list of fixes
// has a null pointer meanwhile.
inline void refuse_replacement(LAMMPS_NS::LAMMPS* engine) {
  LAMMPS_NS::Modify* const modify = engine->modify;
  for (int k = 0; k < modify->nfix; ++k)
    if (!modify->fix[k])
      stop(engine, "fix wall/gran: LIGGGHTS cannot replace a wall. Use `unfix` first");
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
  if (Style* const fix = find_fix<Style>(engine)) return fix;
  add_style<Style>(engine->modify);
  add_fix(engine->modify, {Style::id(), "all", Style::style()});
  return find_fix<Style>(engine);
}

}  // namespace plastigran
