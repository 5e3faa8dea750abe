// SPDX-License-Identifier: GPL-2.0-or-later
//
// Contacts that can be asked what they store, at any time between two displacements of their
// particles.
#pragma once

namespace plastigran {

class StoredEnergies {
 public:
  virtual ~StoredEnergies() {}
  virtual void count_stored_energies() = 0;  // hands each to EnergyLedger::add_stored()
};

}  // namespace plastigran
