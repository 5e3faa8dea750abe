// SPDX-License-Identifier: GPL-2.0-or-later
//
// Fixes of the plugin's own; no deck names them.
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

// To be called where a fix that others point to is deleted. A deck may take it away (unfix): the
// next run is then set up anew, also with `pre no`, and all pointers are found again.
inline void set_up_anew(LAMMPS_NS::Update* update, LAMMPS_NS::Error* error, const char* id) {
  if (update->whichflag)  // between the parts of one `run` that no set-up need part
    error->all(FLERR, (std::string(id) + ": a fix the contact models point to cannot be removed "
                                         "between the parts of one run ... every")
                          .c_str());
  update->first_update = 0;
}

// A class of such a fix has static id() and style().
class OwnFix : public LAMMPS_NS::Fix {
 public:
  using Fix::Fix;
  void pre_delete(bool by_the_deck) override {
    if (by_the_deck) set_up_anew(update, error, id);
  }
};

inline void add_fix(LAMMPS_NS::Modify* modify, std::vector<std::string> words) {
  std::vector<char*> pointers;
  for (std::string& word : words) pointers.push_back(word.data());
  modify->add_fix(pointers.size(), pointers.data());
}

// Stops when a wall is made in the place of another with its ID: the engine would crash next, it
// looks through all fixes and the place is empty.
inline void refuse_replacement(LAMMPS_NS::LAMMPS* engine) {
  LAMMPS_NS::Modify* const modify = engine->modify;
  for (int k = 0; k < modify->nfix; ++k)
    if (!modify->fix[k])
      engine->error->all(FLERR, "fix wall/gran: LIGGGHTS cannot replace a wall. Use `unfix` first");
}

// Makes the engine know the class's style.
template <class Style>
void add_style(LAMMPS_NS::Modify* modify) {
  add_fix_style(modify, Style::style(),
                [](LAMMPS_NS::LAMMPS* lmp, int count, char** words) -> LAMMPS_NS::Fix* {
                  return new Style(lmp, count, words);
                });
}

// The engine's one fix of that class, null when there is none.
template <class Style>
Style* find_own_fix(LAMMPS_NS::LAMMPS* engine) {
  return static_cast<Style*>(engine->modify->find_fix_id_style(Style::id(), Style::style()));
}

// The same, made when there is none. All ranks together.
template <class Style>
Style* own_fix(LAMMPS_NS::LAMMPS* engine) {
  if (Style* const found = find_own_fix<Style>(engine)) return found;
  add_style<Style>(engine->modify);
  add_fix(engine->modify, {Style::id(), "all", Style::style()});
  return find_own_fix<Style>(engine);
}

}  // namespace plastigran
