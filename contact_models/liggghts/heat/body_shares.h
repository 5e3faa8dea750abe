// SPDX-License-Identifier: GPL-2.0-or-later
//
// Who is warmed by the plastic work of a contact, and by how much of it.
#pragma once

#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace plastigran {

class BodyShares {
 public:
  // From the deck's properties, by atom type. `caller` words who asks, in messages. Stops when a
  // Taylor-Quinney factor is outside 0 to 1. All ranks together.
  void read(LAMMPS_NS::LAMMPS* engine, const std::string& caller);

  // A line for each atom type: its Taylor-Quinney factor. `caller` begins each.
  std::string describe(const std::string& caller) const;

  // Sentences on properties whose name is nearly one that was asked for.
  const std::vector<std::string>& misspellings() const { return misspellings_; }

  // The part of a contact's plastic work done in the first of two bodies: all of it in the one that
  // yields at the lower pressure, half in each of two alike.
  double of_plastic_work(int type, int other_type) const {
    const double mine = yield_pressures_[type - 1], others = yield_pressures_[other_type - 1];
    return mine < others ? 1 : mine > others ? 0 : 0.5;
  }

  // The part of plastic work that becomes heat (Taylor & Quinney 1934, Proc. R. Soc. A 143:307).
  double taylor_quinney_factor(int type) const { return factors_[type - 1]; }

 private:
  std::vector<double> yield_pressures_, factors_;  // by type - 1
  bool given_ = false;                             // the factors, by the deck
  std::vector<std::string> misspellings_;
};

}  // namespace plastigran
