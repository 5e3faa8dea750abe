// SPDX-License-Identifier: GPL-2.0-or-later
//
// Distribution of the plastic work of a contact between its two bodies, and the fraction of this
// work that becomes heat.
#pragma once

#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace plastigran {

class BodyShares {
 public:
  // Reads the properties of the deck. Messages begin with `caller`. Stops if a Taylor-Quinney
  // factor is not between 0 and 1. Collective.
  void read(LAMMPS_NS::LAMMPS* engine, const std::string& caller);

  // Returns the Taylor-Quinney factors as text, one line per atom type. Each line begins with
  // `caller`.
  std::string describe(const std::string& caller) const;

  // Returns warnings of possible misspellings of properties, as DeckProperties::misspellings()
  // does.
  const std::vector<std::string>& misspellings() const { return misspellings_; }

  // Returns the fraction of the plastic work in the body of atom type `type`: 1 if its yield
  // pressure is the lower one, 0 if it is the higher one, 0.5 if both are equal.
  double of_plastic_work(int type, int other_type) const {
    const double mine = yield_pressures_[type - 1], others = yield_pressures_[other_type - 1];
    return mine < others ? 1 : mine > others ? 0 : 0.5;
  }

  // Returns the fraction of plastic work that becomes heat (Taylor & Quinney 1934, Proc. R. Soc. A
  // 143:307).
  double taylor_quinney_factor(int type) const { return factors_[type - 1]; }

 private:
  std::vector<double> yield_pressures_, factors_;  // [Pa] and [-], of atom type k + 1 at index k
  bool given_ = false;                             // whether the deck defines the factors
  std::vector<std::string> misspellings_;
};

}  // namespace plastigran
