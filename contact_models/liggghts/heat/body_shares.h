// SPDX-License-Identifier: GPL-2.0-or-later
//
// The parts of plastic work that heat the two bodies of a contact.
#pragma once

#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace plastigran {

class BodyShares {
 public:
  // Reads the properties of the deck. `caller` is its name in messages. Stops if a Taylor-Quinney
  // factor is not between 0 and 1. Collective.
  void read(LAMMPS_NS::LAMMPS* engine, const std::string& caller);

  // The Taylor-Quinney factors, a line per atom type that begins with `caller`.
  std::string describe(const std::string& caller) const;

  // DeckProperties::misspellings() of the properties read.
  const std::vector<std::string>& misspellings() const { return misspellings_; }

  // The part of the plastic work in the first of two bodies: the body with the lower yield pressure
  // takes all, and two equal bodies take half each.
  double of_plastic_work(int type, int other_type) const {
    const double mine = yield_pressures_[type - 1], others = yield_pressures_[other_type - 1];
    return mine < others ? 1 : mine > others ? 0 : 0.5;
  }

  // The part of plastic work that becomes heat (Taylor & Quinney 1934, Proc. R. Soc. A 143:307).
  double taylor_quinney_factor(int type) const { return factors_[type - 1]; }

 private:
  std::vector<double> yield_pressures_, factors_;  // by type - 1
  bool given_ = false;                             // whether the deck defines the factors
  std::vector<std::string> misspellings_;
};

}  // namespace plastigran
