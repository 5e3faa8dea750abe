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

  double elastic_energy = 0;  // the law's, at the present overlap [J]
  double plastic_work = 0;    // since the history was last written [J]
  double dashpot_force = 0;   // on particle i, along the normal [N]

  // What a law answered in this step, which took its state from `before` to `now`. Its plastic work
  // is asked for where it changes alone: in most contacts it does not.
  template <class Law>
  void take(const Law& law, double radius_eff, const Response& response,
            const typename Law::State& before, const typename Law::State& now) {
    elastic_energy = response.elastic_energy;
    if (std::memcmp(&before, &now, Law::state_names.size() * sizeof(double)) != 0)
      plastic_work =
          plastic_work_of(law, radius_eff, now) - plastic_work_of(law, radius_eff, before);
  }

 private:
  // At no overlap a law answers with the plastic work of the state alone.
  template <class Law>
  [[gnu::noinline]] static double plastic_work_of(const Law& law, double radius_eff,
                                                  typename Law::State state) {
    return law.respond(radius_eff, 0, state).plastic_work;
  }
};

// A contact model that may ask for accounts. While it does, and forces are computed
// (contact.computeflag), the load on particle i it hands to its normal model is an AccountedLoad.
struct AccountTaker {
  bool takes_accounts = false;
  virtual ~AccountTaker() {}
};

}  // namespace plastigran
