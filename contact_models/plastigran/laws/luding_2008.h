// SPDX-License-Identifier: GPL-2.0-or-later
//
// Luding 2008 (Granular Matter 10:235): linear springs with plasticity and adhesion.
//
//   F = k_1 overlap                                       first loading, to overlap_limit
//   F = k (overlap - overlap_0),  overlap_0 = (1 - k_1/k) overlap_max   unloading and reloading
//   F = -k_c overlap                                      adhesive limit
//   k = k_1 + (k_2 - k_1) overlap_max/overlap_limit
//   overlap_limit = k_2/(k_2 - k_1) phi 2 R*
//
// Beyond overlap_limit, the contact is elastic: it follows its unloading line with the stiffness
// k_2. On the adhesive limit, overlap_max decreases so that the contact stays on its unloading
// line: overlap_max is the positive root x of x^2 - overlap x = (k_1 + k_c) overlap
// overlap_limit/(k_2 - k_1). phi is the largest residual overlap divided by 2 R*. The force is zero
// without overlap. In the source, 2 R* is 2 a_1 a_2/(a_1 + a_2), with the radii a_1, a_2.
//
//   F |          / |
//     |        /  /        k_1, then k
//     |      /   /
//     |____/____/____ overlap
//     | \      /
//     |   \   /            -k_c
//
// Range: the stiffnesses must be fitted; overlaps far below R*.
#pragma once

#include "plastigran/shared/adhesive_limit.h"

namespace plastigran {

class Luding2008 : public AdhesiveLimit<Luding2008> {
 public:
  static constexpr const char* name = "luding_2008";
  static constexpr const char* source = "Luding 2008, Granular Matter 10:235";
  static constexpr const char* range = "fitted stiffnesses, overlap << R*";

  struct Parameters {
    double loading_stiffness = required;
    double unloading_stiffness = required;
    double adhesive_stiffness = 0;
    double plasticity_depth = 0.05;
  };
  static constexpr std::array<Parameter<Parameters>, 4> parameters{{
      {"loading_stiffness", "N/m", &Parameters::loading_stiffness, 1e-6, 1e15,
       "k_1, stiffness of first loading"},
      {"unloading_stiffness", "N/m", &Parameters::unloading_stiffness, 1e-6, 1e18,
       "k_2, largest stiffness of unloading, above k_1"},
      {"adhesive_stiffness", "N/m", &Parameters::adhesive_stiffness, 0, 1e18,
       "k_c, slope of the largest adhesive force versus overlap"},
      {"plasticity_depth", "-", &Parameters::plasticity_depth, 1e-6, 1,
       "phi, largest residual overlap divided by 2 R*"},
  }};
  static bool admissible(const MaterialPair&, const Parameters& constants) {
    return constants.unloading_stiffness > constants.loading_stiffness;
  }
  static constexpr const char* admissibility =
      "{unloading_stiffness} must be more than {loading_stiffness}";

  Luding2008(const MaterialPair&, const Parameters& constants)
      : loading_(constants.loading_stiffness),
        growth_(constants.unloading_stiffness - constants.loading_stiffness),
        adhesive_(constants.adhesive_stiffness),
        limit_ratio_(2 * constants.plasticity_depth * constants.unloading_stiffness / growth_) {}

  PLASTIGRAN_DEVICE Stiffness elastic_stiffness(double) const {
    return {loading_, 2.0 / 7.0 * loading_};
  }
  PLASTIGRAN_DEVICE double pull_off_force(double, double overlap, const State&) const {
    return overlap > 0 ? adhesive_ * overlap : 0;
  }

 private:
  friend AdhesiveLimit<Luding2008>;

  PLASTIGRAN_DEVICE double scale(double radius_eff) const {  // returns overlap_limit [m]
    return limit_ratio_ * radius_eff;
  }
  PLASTIGRAN_DEVICE static double limited(double limit, double overlap) {
    return std::min(overlap, limit);
  }
  PLASTIGRAN_DEVICE double stiffness(double limit, double max) const {  // returns k [N/m]
    return loading_ + growth_ * (max / limit);
  }
  PLASTIGRAN_DEVICE double force(double limit, double overlap, double max) const {
    return loading_ * max - stiffness(limit, max) * (max - overlap);
  }
  PLASTIGRAN_DEVICE double elastic_energy(double limit, double overlap, double max) const {
    const double on_line = force(limit, overlap, max);
    return 0.5 * on_line * on_line / stiffness(limit, max);
  }
  PLASTIGRAN_DEVICE double loading_work(double, double overlap) const {
    return 0.5 * loading_ * overlap * overlap;
  }
  PLASTIGRAN_DEVICE double limit_work(double, double overlap) const {
    return 0.5 * adhesive_ * overlap * overlap;
  }
  PLASTIGRAN_DEVICE double limit_begins(double limit, double max) const {
    const double unloading = stiffness(limit, max);
    return (unloading - loading_) * max / (unloading + adhesive_);
  }
  PLASTIGRAN_DEVICE double max_on_limit(double limit, double overlap) const {
    const double shift = (loading_ + adhesive_) * limit / growth_;
    return 0.5 * (overlap + std::sqrt(overlap * overlap + 4 * shift * overlap));
  }

  double loading_, growth_, adhesive_;  // k_1, k_2 - k_1, k_c [N/m]
  double limit_ratio_;                  // overlap_limit/R* [-]
};

}  // namespace plastigran
