// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstring>

#include "contact_interface.h"
#include "plastigran/shared/adhesion.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

// Load on particle i of a contact, with the energies that the contact models report.
struct AccountedLoad : LIGGGHTS::ContactModels::ForceData {
  AccountedLoad() {}
  explicit AccountedLoad(const ForceData& load) : ForceData(load) {}

  bool needs_elastic_energy = true;
  double elastic_energy = 0;     // elastic energy at the current overlap, if needed [J]
  double surface_energy = 0;     // surface energy at the current overlap, if needed [J]
  double adhesion_loss = 0;      // energy lost when the contact formed or broke in this step [J]
  double plastic_work = 0;       // plastic work since the last update of the history [J]
  double tangential_energy = 0;  // energy that a tangential law stores [J]
  double dashpot_force = 0;      // normal dashpot and viscous force on particle i [N]

  // Counts the energies of a law in a step that changes its state from `before` to `now`. If the
  // state is unchanged, as in most contacts, plastic work needs no call of the law.
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

  // The attribute `flatten` inlines the law, so that the compiler can remove all results except the
  // plastic work.
  template <class Law>
  [[gnu::flatten, gnu::noinline]] static double plastic_work_between(const Law& law,
                                                                     double radius_eff,
                                                                     typename Law::State before,
                                                                     typename Law::State now) {
    return plastic_work_of(law, radius_eff, now) - plastic_work_of(law, radius_eff, before);
  }
};

}  // namespace plastigran
