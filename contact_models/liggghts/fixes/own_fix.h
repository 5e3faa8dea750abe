// SPDX-License-Identifier: GPL-2.0-or-later
//
// Adds a fix of the plugin's own to an engine; no deck names it. A class of such a fix has static
// id() and style().
#pragma once

#include <string>
#include <vector>

#include "fix.h"
#include "liggghts/fixes/engine_access.h"
#include "modify.h"

namespace plastigran {

inline void add_fix(LAMMPS_NS::Modify* modify, std::vector<std::string> words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  modify->add_fix(pointers.size(), pointers.data());
}

// The engine's one fix of that class, null when there is none.
template <class OwnFix>
OwnFix* find_own_fix(LAMMPS_NS::LAMMPS* engine) {
  return static_cast<OwnFix*>(engine->modify->find_fix_id_style(OwnFix::id(), OwnFix::style()));
}

// The same, made when there is none. All ranks together.
template <class OwnFix>
OwnFix* own_fix(LAMMPS_NS::LAMMPS* engine) {
  if (OwnFix* const found = find_own_fix<OwnFix>(engine)) return found;
  add_fix_style(engine->modify, OwnFix::style(),
                [](LAMMPS_NS::LAMMPS* lmp, int count, char** words) -> LAMMPS_NS::Fix* {
                  return new OwnFix(lmp, count, words);
                });
  add_fix(engine->modify, {OwnFix::id(), "all", OwnFix::style()});
  return find_own_fix<OwnFix>(engine);
}

}  // namespace plastigran
