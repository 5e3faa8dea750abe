// SPDX-License-Identifier: GPL-2.0-or-later
//
// Walton & Braun 1986 (J. Rheol. 30:949): two linear springs, plastic from first touch.
//
//   F = k_1 overlap                                first loading
//   F = k_2 (overlap - overlap_res)                unloading and reloading
//   overlap_res = (1 - k_1/k_2) overlap_max,  k_2 = k_2' + S F_max
//
// k_2' is the unloading stiffness at zero load, and S its growth with the largest force. With S =
// 0, restitution is (k_1/k_2)^(1/2) at any speed. With k_2' = k_1 and S > 0, restitution decreases
// with the speed v: (w/(S v + w))^(1/2), w^2 = 2 k_1/m for two spheres of mass m.
// Range: the stiffnesses must be fitted, because they do not depend on size and material.
#pragma once

#include "plastigran/shared/contact.h"
#include "plastigran/shared/largest_overlap.h"

namespace plastigran {

class WaltonBraun : public LargestOverlap {
 public:
  static constexpr const char* name = "walton_braun";
  static constexpr const char* source = "Walton & Braun 1986, J. Rheol. 30:949";
  static constexpr const char* range = "fitted stiffnesses, any load";
  static constexpr bool yields = false;
  static constexpr bool elastic_first = false;

  struct Parameters {
    double loading_stiffness = required;
    double unloading_stiffness = 0;
    double unloading_stiffness_slope = 0;
  };
  static constexpr std::array<Parameter<Parameters>, 3> parameters{{
      {"loading_stiffness", "N/m", &Parameters::loading_stiffness, 1e-6, 1e15,
       "k_1, stiffness of first loading"},
      {"unloading_stiffness", "N/m", &Parameters::unloading_stiffness, 0, 1e18,
       "k_2' (k_2 at zero load), at least k_1; 0 means k_1"},
      {"unloading_stiffness_slope", "1/m", &Parameters::unloading_stiffness_slope, 0, 1e15,
       "S, increase of k_2 per unit of the largest force"},
  }};
  static bool admissible(const MaterialPair&, const Parameters& constants) {
    return constants.unloading_stiffness == 0 ||
           constants.unloading_stiffness >= constants.loading_stiffness;
  }
  static constexpr const char* admissibility =
      "{unloading_stiffness} must be at least {loading_stiffness}, or 0 for the same stiffness";

  WaltonBraun(const MaterialPair&, const Parameters& constants)
      : loading_(constants.loading_stiffness),
        unloading_(std::max(constants.unloading_stiffness, constants.loading_stiffness)),
        slope_(constants.unloading_stiffness_slope) {}

  double overlap_range() const { return 1; }

  // Returns k_1 and the usual tangential stiffness 2/7 k_1 [N/m].
  PLASTIGRAN_DEVICE Stiffness elastic_stiffness(double) const {
    return {loading_, 2.0 / 7.0 * loading_};
  }

  PLASTIGRAN_DEVICE Response respond(double radius_eff, double overlap, State& state) const {
    if (overlap > state.overlap_max) state.overlap_max = overlap;
    const double force_max = loading_ * state.overlap_max;
    const double stiffness = unloading_ + slope_ * force_max;
    const double force = force_max - stiffness * (state.overlap_max - overlap);
    Response response;
    if (force > 0 && overlap > 0) {
      response.force = force;
      response.contact_radius = std::sqrt(radius_eff * overlap);
      response.elastic_energy = 0.5 * force * force / stiffness;
    }
    response.plastic_work = 0.5 * force_max * (state.overlap_max - force_max / stiffness);
    return response;
  }

 private:
  double loading_, unloading_, slope_;
};

}  // namespace plastigran
