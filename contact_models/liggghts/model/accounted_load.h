// SPDX-License-Identifier: GPL-2.0-or-later
//
// How the normal model of a contact says what became of energy in it: together with the load.
#pragma once

#include "contact_interface.h"

namespace plastigran {

// The load on particle i of a contact, and the normal model's part of the account.
struct AccountedLoad : LIGGGHTS::ContactModels::ForceData {
  explicit AccountedLoad(const ForceData& load) : ForceData(load) {}

  double elastic_energy = 0;  // the law's, at the present overlap [J]
  double plastic_work = 0;    // since the history was last written [J]
  double dashpot_force = 0;   // on particle i, along the normal [N]
};

// A contact model that may ask for accounts. While it does, and forces are computed
// (contact.computeflag), the load on particle i it hands to its normal model is an AccountedLoad.
struct AccountTaker {
  bool takes_accounts = false;
  virtual ~AccountTaker() {}
};

}  // namespace plastigran
