// SPDX-License-Identifier: GPL-2.0-or-later
//
// The plastic work of every particle [J], as a fix property/atom with the ID `plastic_work`.
#pragma once

#include "atom.h"
#include "fix_property_atom.h"
#include "liggghts/fixes/plugin_fix.h"

namespace plastigran {

class ParticlePlasticWork : public LAMMPS_NS::FixPropertyAtom {
 public:
  using FixPropertyAtom::FixPropertyAtom;
  static const char* id() { return "plastic_work"; }
  static const char* style() { return "property/atom/plastic_work"; }

  // Clears a new fix before the forces of the first setup. LIGGGHTS would clear it after the pair
  // forces, which already add plastic work.
  void begin() {
    if (!just_created) return;
    just_created = 0;
    for (int i = 0; i < atom->nlocal && !recent_restart; ++i) set_arrays(i);
  }

  void pre_delete(bool is_unfixed) override {
    if (is_unfixed) require_setup(lmp, Fix::id);
  }
};

}  // namespace plastigran
