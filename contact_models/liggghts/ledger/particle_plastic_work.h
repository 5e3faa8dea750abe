// SPDX-License-Identifier: GPL-2.0-or-later
//
// Every particle's plastic work [J], as a fix with the fixed ID `plastic_work`: an engine's
// property of atoms that the ledger writes to. It restarts with the particles.
#pragma once

#include "atom.h"
#include "fix_property_atom.h"
#include "liggghts/fixes/plugin_fix.h"

namespace plastigran {

class ParticlePlasticWork : public LAMMPS_NS::FixPropertyAtom {
 public:
  ParticlePlasticWork(LAMMPS_NS::LAMMPS* engine, int count, char** words)
      : FixPropertyAtom(engine, count, words) {
    static char before[] = "property/atom";  // the style of it in older restart files
    accepts_restart_data_from_style = before;
  }
  static const char* id() { return "plastic_work"; }
  static const char* style() { return "property/atom/plastic_work"; }

  // To be called before the first forces: otherwise LIGGGHTS blanks a new fix after the forces of
  // the pairs in set-up.
  void begin() {
    if (!just_created) return;
    just_created = 0;
    for (int i = 0; i < atom->nlocal && !recent_restart; ++i) set_arrays(i);
  }

  void pre_delete(bool by_the_deck) override {
    if (by_the_deck) require_setup(update, error, Fix::id);
  }
};

}  // namespace plastigran
