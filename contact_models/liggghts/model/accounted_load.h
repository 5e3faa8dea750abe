// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstring>

#include "contact_interface.h"
#include "plastigran/shared/adhesion.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

// The load on particle i of a contact, with the energies that the normal model counts.
struct AccountedLoad : LIGGGHTS::ContactModels::ForceData {
  AccountedLoad() {}
  explicit AccountedLoad(const ForceData& load) : ForceData(load) {}

  bool needs_elastic_energy = true;
  double elastic_energy = 0;  // at the current overlap, if needed [J]
  double surface_energy = 0;  // likewise
  double adhesion_loss = 0;   // where the contact formed or broke since then [J]
  double plastic_work = 0;    // since the history was last written [J]
  double dashpot_force = 0;   // on particle i, along the normal [N]

  // Counts the energies of a law in a step that changes its state from `before` to `now`. Most
  // contacts keep their state, and then their plastic work needs no call of the law.
  template <class Law>
  void count(const Law& law, double radius_eff, double overlap, const typename Law::State& before,
             const typename Law::State& now) {
    if (needs_elastic_energy) {
      const Response stored = stored_by(law, radius_eff, overlap, now);
      elastic_energy = stored.elastic_energy;
      surface_energy = stored.surface_energy;
    }
    adhesion_loss = lost_at_ends(law, radius_eff, before, now);
    if (std::memcmp(&before, &now, Law::state_names.size() * sizeof(double)) != 0)
      plastic_work = plastic_work_between(law, radius_eff, before, now);
  }

 private:
  template <class Law>
  [[gnu::noinline]] static Response stored_by(const Law& law, double radius_eff, double overlap,
                                              typename Law::State state) {
    return law.respond(radius_eff, overlap, state);
  }

  // The attribute `flatten` lets the compiler remove everything but the plastic work.
  template <class Law>
  [[gnu::flatten, gnu::noinline]] static double plastic_work_between(const Law& law,
                                                                     double radius_eff,
                                                                     typename Law::State before,
                                                                     typename Law::State now) {
    return plastic_work_of(law, radius_eff, now) - plastic_work_of(law, radius_eff, before);
  }
};

}  // namespace plastigran
