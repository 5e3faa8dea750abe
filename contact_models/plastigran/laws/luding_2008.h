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
// Beyond overlap_limit the contact follows its unloading line, elastic with k_2. On the adhesive
// limit overlap_max falls so that the contact lies on its unloading line: overlap_max is the
// positive root of x^2 - overlap x = (k_1 + k_c) overlap overlap_limit/(k_2 - k_1). There is no
// force without overlap. In the source 2 R* is 2 a_1 a_2/(a_1 + a_2).
//
//   F |          / |
//     |        /  /        k_1, then k
//     |      /   /
//     |____/____/____ overlap
//     | \      /
//     |   \   /            -k_c
//
// Range: stiffnesses are fitted; overlaps far below R*.
#pragma once

#include "plastigran/shared/contact.h"

namespace plastigran {

class Luding2008 {
 public:
  static constexpr const char* name = "luding_2008";
  static constexpr const char* source = "Luding 2008, Granular Matter 10:235";
  static constexpr const char* range = "fitted stiffnesses, overlap << R*";
  static constexpr bool yields = false;
  static constexpr bool elastic_first = false;
  static constexpr bool adhesive = true;

  struct Parameters {
    double loading_stiffness = required;
    double unloading_stiffness = required;
    double adhesive_stiffness = 0;
    double plasticity_depth = 0.05;
  };
  static constexpr std::array<Parameter<Parameters>, 4> parameters{{
      {"loading_stiffness", "N/m", &Parameters::loading_stiffness, 1e-6, 1e15, "k_1"},
      {"unloading_stiffness", "N/m", &Parameters::unloading_stiffness, 1e-6, 1e18,
       "k_2, largest stiffness of unloading, more than k_1"},
      {"adhesive_stiffness", "N/m", &Parameters::adhesive_stiffness, 0, 1e18,
       "k_c, slope of the adhesive limit"},
      {"plasticity_depth", "-", &Parameters::plasticity_depth, 1e-6, 1,
       "phi, largest residual overlap over 2 R*"},
  }};
  static bool admissible(const MaterialPair&, const Parameters& constants) {
    return constants.unloading_stiffness > constants.loading_stiffness;
  }
  static constexpr const char* admissibility =
      "{unloading_stiffness} must be more than {loading_stiffness}";

  struct State {
    double overlap_max = 0;   // largest overlap, less after the adhesive limit [m]
    double plastic_work = 0;  // [J]
  };
  static constexpr std::array<const char*, 2> state_names{"overlap_max", "plastic_work"};

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
  PLASTIGRAN_DEVICE double plastic_work_in(const State& state) const { return state.plastic_work; }

  PLASTIGRAN_DEVICE Response respond(double radius_eff, double overlap, State& state) const {
    const double limit = limit_ratio_ * radius_eff;
    if (overlap > state.overlap_max)
      load(std::min(overlap, limit), limit, state);
    else
      pull(std::max(overlap, 0.0), limit, state);
    Response response;
    response.plastic_work = state.plastic_work;
    if (!(overlap > 0)) return response;
    response.force = line(overlap, limit, state.overlap_max);
    response.contact_radius = std::sqrt(radius_eff * overlap);
    response.elastic_energy = elastic_energy(overlap, limit, state.overlap_max);
    return response;
  }

 private:
  PLASTIGRAN_DEVICE double stiffness(double limit, double overlap_max) const {
    return loading_ + growth_ * (overlap_max / limit);
  }
  // Force on the unloading line.
  PLASTIGRAN_DEVICE double line(double overlap, double limit, double overlap_max) const {
    return loading_ * overlap_max - stiffness(limit, overlap_max) * (overlap_max - overlap);
  }
  PLASTIGRAN_DEVICE double elastic_energy(double overlap, double limit, double overlap_max) const {
    const double force = line(overlap, limit, overlap_max);
    return 0.5 * force * force / stiffness(limit, overlap_max);
  }

  // First loading to `overlap`, on the line F = k_1 overlap.
  PLASTIGRAN_DEVICE void load(double overlap, double limit, State& state) const {
    if (!(overlap > state.overlap_max)) return;
    const double before = state.overlap_max;
    const double stored = elastic_energy(before, limit, before);
    state.overlap_max = overlap;
    state.plastic_work += 0.5 * loading_ * (overlap * overlap - before * before) -
                          (elastic_energy(overlap, limit, overlap) - stored);
  }

  // Unloading to `overlap`, along the adhesive limit where the contact has reached it.
  PLASTIGRAN_DEVICE void pull(double overlap, double limit, State& state) const {
    const double shift = (loading_ + adhesive_) * limit / growth_;
    const double lower = 0.5 * (overlap + std::sqrt(overlap * overlap + 4 * shift * overlap));
    if (!(lower < state.overlap_max)) return;
    const double stiff = stiffness(limit, state.overlap_max);
    const double begin = (stiff - loading_) * state.overlap_max / (stiff + adhesive_);
    const double stored = elastic_energy(begin, limit, state.overlap_max);
    state.overlap_max = lower;
    state.plastic_work += 0.5 * adhesive_ * (begin * begin - overlap * overlap) -
                          (elastic_energy(overlap, limit, lower) - stored);
  }

  double loading_, growth_, adhesive_;  // k_1, k_2 - k_1, k_c
  double limit_ratio_;                  // overlap_limit/R*
};

}  // namespace plastigran
