// SPDX-License-Identifier: GPL-2.0-or-later
//
// The Edinburgh elasto-plastic adhesive model: Thakur, Morrissey, Sun, Chen & Ooi 2014 (Granular
// Matter 16:383). Plastic from first touch, with the exponent n = 3/2 or 1:
//
//   F = f_0 + k_1 overlap^n                             first loading
//   F = f_0 + k_2 (overlap^n - overlap_0^n)             unloading and reloading
//   F = f_0 - k_adh overlap^n                           adhesive limit
//   overlap_0^n = (1 - k_1/k_2) overlap_max^n
//   k_1 = 4/3 E* R*^(1/2) for n = 3/2,  k_1 = 2 E* R* for n = 1
//
// On the adhesive limit, overlap_max decreases so that the contact stays on its unloading line. The
// constant force f_0 <= 0 acts while the bodies overlap; its potential is the surface energy.
// Morrissey 2013 (PhD thesis, Edinburgh) instead derives k_adh from a surface energy and the
// largest contact.
//
// Range: the stiffness ratios must be fitted; overlaps below R*.
#pragma once

#include "plastigran/shared/adhesive_limit.h"

namespace plastigran {

class Edinburgh2014 : public AdhesiveLimit<Edinburgh2014> {
 public:
  static constexpr const char* name = "edinburgh_2014";
  static constexpr const char* source = "Thakur et al. 2014, Granular Matter 16:383";
  static constexpr const char* range = "fitted ratios of stiffness, overlap < R*";

  enum Exponent { three_halves, one };
  struct Parameters {
    double stiffness_ratio = required;
    double adhesion_ratio = 0;
    double constant_force = 0;
    int exponent = three_halves;
  };
  static constexpr std::array<Parameter<Parameters>, 3> parameters{{
      {"stiffness_ratio", "-", &Parameters::stiffness_ratio, 1.0001, 1e6,
       "k_2/k_1, ratio of unloading to loading stiffness"},
      {"adhesion_ratio", "-", &Parameters::adhesion_ratio, 0, 1e6, "k_adh/k_1"},
      {"constant_force", "N", &Parameters::constant_force, -1e6, 0,
       "f_0, constant attractive force"},
  }};
  static constexpr std::array<Option<Parameters>, 1> options{{{"exponent",
                                                               &Parameters::exponent,
                                                               {"three_halves", "one", nullptr},
                                                               "n, exponent of the overlap"}}};

  Edinburgh2014(const MaterialPair& pair, const Parameters& constants)
      : modulus_(pair.youngs_modulus_eff),
        linear_(constants.exponent == one),
        exponent_(linear_ ? 1 : 1.5),
        ratio_(constants.stiffness_ratio),
        adhesion_(constants.adhesion_ratio),
        constant_(constants.constant_force),
        residual_(std::pow(1 - 1 / ratio_, 1 / exponent_)),
        begin_(std::pow((ratio_ - 1) / (ratio_ + adhesion_), 1 / exponent_)) {}

  double overlap_range() const { return 1; }

  PLASTIGRAN_DEVICE double pull_off_force(double radius_eff, double overlap, const State&) const {
    return overlap > 0 ? scale(radius_eff) * adhesion_ * power(overlap) - constant_ : 0;
  }

  PLASTIGRAN_DEVICE Response respond(double radius_eff, double overlap, State& state) const {
    Response response = AdhesiveLimit::respond(radius_eff, overlap, state);
    if (overlap > 0) response.force += constant_, response.surface_energy = constant_ * overlap;
    return response;
  }

 private:
  friend AdhesiveLimit<Edinburgh2014>;

  PLASTIGRAN_DEVICE double scale(double radius_eff) const {  // returns k_1 [N/m^n]
    return linear_ ? 2 * modulus_ * radius_eff : 4.0 / 3.0 * modulus_ * std::sqrt(radius_eff);
  }
  PLASTIGRAN_DEVICE static double limited(double, double overlap) { return overlap; }
  PLASTIGRAN_DEVICE double power(double overlap) const {
    return linear_ ? overlap : overlap * std::sqrt(overlap);
  }
  PLASTIGRAN_DEVICE double integral(double overlap) const {  // integral of overlap^n from 0
    return power(overlap) * overlap / (exponent_ + 1);
  }
  PLASTIGRAN_DEVICE double force(double first, double overlap, double max) const {
    return first * ratio_ * (power(overlap) - power(residual_ * max));
  }
  PLASTIGRAN_DEVICE double elastic_energy(double first, double overlap, double max) const {
    const double rest = residual_ * max;
    return first * ratio_ * (integral(overlap) - integral(rest) - power(rest) * (overlap - rest));
  }
  PLASTIGRAN_DEVICE double loading_work(double first, double overlap) const {
    return first * integral(overlap);
  }
  PLASTIGRAN_DEVICE double limit_work(double first, double overlap) const {
    return first * adhesion_ * integral(overlap);
  }
  PLASTIGRAN_DEVICE double limit_begins(double, double max) const { return begin_ * max; }
  PLASTIGRAN_DEVICE double max_on_limit(double, double overlap) const { return overlap / begin_; }

  double modulus_;  // E* [Pa]
  bool linear_;
  double exponent_, ratio_, adhesion_, constant_;
  double residual_;  // overlap_0/overlap_max [-]
  double begin_;     // overlap where unloading meets the adhesive limit, divided by overlap_max [-]
};

}  // namespace plastigran
