// SPDX-License-Identifier: GPL-2.0-or-later
//
// Adhesive elastic spheres: Johnson, Kendall & Roberts 1971 (Proc. R. Soc. Lond. A 324:301).
// Equations in shared/adhesion.h. The contact forms at first touch, at zero overlap, and lasts
// until pull-off. F_c is the pull-off force, Gamma the work of adhesion:
//
//   F |                 /        forms: overlap 0, F = -8/9 F_c
//     |               /          largest attraction: F_c = 3/2 pi Gamma R*
//     |_____________/__ overlap  breaks: F = -5/9 F_c,
//     |    |      /              overlap = -3/4 (pi^2 Gamma^2 R*/E*^2)^(1/3)
//     |   /     _/
//     |   `---'
//
// Forming and breaking a contact dissipates the energy 1.0524 (pi^5 Gamma^5 R*^4/E*^2)^(1/3).
// Range: a << R*; soft or large bodies: (R* Gamma^2/E*^2)^(1/3) much larger than the distance
// between atoms.
#pragma once

#include "plastigran/shared/adhesion.h"

namespace plastigran {

class Jkr {
 public:
  static constexpr const char* name = "jkr";
  static constexpr const char* source =
      "Johnson, Kendall & Roberts 1971, Proc. R. Soc. Lond. A 324:301";
  static constexpr const char* range = "adhesive elastic contact, a << R*";
  static constexpr bool yields = false;
  static constexpr bool adhesive = true;

  struct Parameters {
    double surface_energy = required;
  };
  static constexpr std::array<Parameter<Parameters>, 1> parameters{
      {{"surface_energy", "J/m^2", &Parameters::surface_energy, 0, 1e3,
        "work of adhesion Gamma of the two surfaces"}}};

  struct State {
    double in_contact = 0;  // 1 from first touch to pull-off
  };
  static constexpr std::array<const char*, 1> state_names{"in_contact"};

  Jkr(const MaterialPair& pair, const Parameters& constants)
      : contact_(pair.youngs_modulus_eff, constants.surface_energy) {}

  double pull_off_distance(double radius_eff) const {
    return -contact_.pull_off_overlap(radius_eff);
  }

  PLASTIGRAN_DEVICE double pull_off_force(double radius_eff, double, const State&) const {
    return contact_.pull_off_force(radius_eff);
  }
  double energy_at_end(double radius_eff, const State&, bool forms) const {
    return contact_.energy_at_end(radius_eff, forms);
  }

  PLASTIGRAN_DEVICE Response respond(double radius_eff, double overlap, State& state) const {
    if (!(overlap > 0) &&
        (state.in_contact == 0 || !(overlap >= contact_.pull_off_overlap(radius_eff)))) {
      state.in_contact = 0;
      return {};
    }
    state.in_contact = 1;
    return contact_.at(radius_eff, contact_.root(radius_eff, overlap));
  }

 private:
  JkrContact contact_;
};

}  // namespace plastigran
