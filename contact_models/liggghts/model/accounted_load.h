// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include <cstring>

#include "contact_interface.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

// The load on particle i of a contact, with the energies that the normal model counts.
struct AccountedLoad : LIGGGHTS::ContactModels::ForceData {
  AccountedLoad() {}
  explicit AccountedLoad(const ForceData& load) : ForceData(load) {}

  bool needs_elastic_energy = true;
  double elastic_energy = 0;  // at the current overlap, if needed [J]
  double plastic_work = 0;    // since the history was last written [J]
  double dashpot_force = 0;   // on particle i, along the normal [N]

  // Counts the energies of a law in a step that changes its state from `before` to `now`. Most
  // contacts keep their state, and then their plastic work needs no call of the law.
  template <class Law>
  void count(const Law& law, double radius_eff, double overlap, const typename Law::State& before,
             const typename Law::State& now) {
    if (needs_elastic_energy) elastic_energy = elastic_energy_of(law, radius_eff, overlap, now);
    if (std::memcmp(&before, &now, Law::state_names.size() * sizeof(double)) != 0)
      plastic_work = plastic_work_between(law, radius_eff, before, now);
  }

 private:
  template <class Law>
  [[gnu::noinline]] static double elastic_energy_of(const Law& law, double radius_eff,
                                                    double overlap, typename Law::State state) {
    return law.respond(radius_eff, overlap, state).elastic_energy;
  }

  // At zero overlap the response contains only the plastic work of the state. The attribute
  // `flatten` lets the compiler remove the rest.
  template <class Law>
  [[gnu::flatten, gnu::noinline]] static double plastic_work_between(const Law& law,
                                                                     double radius_eff,
                                                                     typename Law::State before,
                                                                     typename Law::State now) {
    return law.respond(radius_eff, 0, now).plastic_work -
           law.respond(radius_eff, 0, before).plastic_work;
  }
};

}  // namespace plastigran
