// SPDX-License-Identifier: GPL-2.0-or-later
//
// Interface of a pair style that can compute the stored energies of its contacts again, as long as
// the particles have not moved.
#pragma once

namespace plastigran {

class StoredEnergies {
 public:
  virtual ~StoredEnergies() {}
  virtual void count_stored_energies() = 0;  // calls EnergyLedger::add_stored() for each contact
};

}  // namespace plastigran
