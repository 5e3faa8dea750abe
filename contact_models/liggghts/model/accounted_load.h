// SPDX-License-Identifier: GPL-2.0-or-later
//
// How the normal model of a contact says what became of energy in it: together with the load.
#pragma once

#include <cstring>

#include "contact_interface.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

// The load on particle i of a contact, and the normal model's part of the account.
struct AccountedLoad : LIGGGHTS::ContactModels::ForceData {
  AccountedLoad() {}
  explicit AccountedLoad(const ForceData& load) : ForceData(load) {}

  bool asks_elastic_energy = true;
  double elastic_energy = 0;  // at the present overlap, where it is asked for [J]
  double plastic_work = 0;    // since the history was last written [J]
  double dashpot_force = 0;   // on particle i, along the normal [N]

  // The energies of a law in this step, which took its state from `before` to `now`. Its plastic
  // work is asked for where it changes alone: in most contacts it does not.
  template <class Law>
  void take(const Law& law, double radius_eff, double overlap, const typename Law::State& before,
            const typename Law::State& now) {
    if (asks_elastic_energy) elastic_energy = elastic_energy_of(law, radius_eff, overlap, now);
    if (std::memcmp(&before, &now, Law::state_names.size() * sizeof(double)) != 0)
      plastic_work = plastic_work_between(law, radius_eff, before, now);
  }

 private:
  template <class Law>
  [[gnu::noinline]] static double elastic_energy_of(const Law& law, double radius_eff,
                                                    double overlap, typename Law::State state) {
    return law.respond(radius_eff, overlap, state).elastic_energy;
  }

  // At no overlap a law answers with the plastic work of the state alone. Inlined, it computes
  // little else.
  template <class Law>
  [[gnu::flatten, gnu::noinline]] static double plastic_work_between(const Law& law,
                                                                     double radius_eff,
                                                                     typename Law::State before,
                                                                     typename Law::State now) {
    return law.respond(radius_eff, 0, now).plastic_work -
           law.respond(radius_eff, 0, before).plastic_work;
  }
};

// A contact model that may ask for accounts. While it does, and forces are computed
// (contact.computeflag), the load on particle i it hands to its normal model is an AccountedLoad.
struct AccountTaker {
  bool takes_accounts = false;
  virtual ~AccountTaker() {}
};

}  // namespace plastigran
