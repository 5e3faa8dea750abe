// SPDX-License-Identifier: GPL-2.0-or-later
//
// Every particle's plastic work [J], as a fix with the fixed ID `plastic_work`: an engine's
// property of atoms that the ledger writes to. It restarts with the particles.
#pragma once

#include "fix_property_atom.h"
#include "liggghts/fixes/own_fix.h"

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

  void pre_delete(bool by_the_deck) override {
    if (by_the_deck) set_up_anew(update, error, Fix::id);
  }
};

}  // namespace plastigran
