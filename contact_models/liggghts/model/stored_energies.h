// SPDX-License-Identifier: GPL-2.0-or-later
//
// Interface of contacts that can compute their stored energies again, until their particles move.
#pragma once

namespace plastigran {

class StoredEnergies {
 public:
  virtual ~StoredEnergies() {}
  virtual void count_stored_energies() = 0;  // calls EnergyLedger::add_stored() for each contact
};

}  // namespace plastigran
