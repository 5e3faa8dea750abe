// SPDX-License-Identifier: GPL-2.0-or-later
//
// Thornton 1997 (J. Appl. Mech. 64:383): Hertz contact whose pressure is limited to the yield
// pressure p_y. The equations are those of Zhang & Vu-Quoc 2002 (Int. J. Impact Eng. 27:317), eqs
// 4.10-4.11. Unloading follows Hertz' law and starts with the contact radius a_max at overlap_max.
//
//   overlap_y = R* (pi p_y/(2 E*))^2                      yield
//   F = 4/3 E* sqrt(R*) overlap^(3/2)                     overlap <= overlap_y
//   F = pi p_y R* (overlap - overlap_y / 3)               beyond (force and slope continuous)
//   overlap_max - overlap_res = 3 F_max / (4 E* a_max),   a_max^2 = R* overlap_max
//   F = F_max x^(3/2),  a = a_max x^(1/2),  x = (overlap - overlap_res)/(overlap_max - overlap_res)
//
//   F |           /            first loading: Hertz, then a straight line
//     |         //             unloading and reloading: one curve up to F_max,
//     |       / /              where first loading continues
//     |    _/  |
//     |__/____/______ overlap
//          overlap_res
//
// Range: a << R*. The constant pressure underestimates hardness: at 120 times the yield speed the
// peak force is 43 % below finite elements (docs/validation_spheres.md).
#pragma once

#include "plastigran/shared/contact.h"
#include "plastigran/shared/hertz_contact.h"
#include "plastigran/shared/largest_overlap.h"
#include "plastigran/tables/unloading.h"

namespace plastigran {

class Thornton : public NoConstants, public LargestOverlap {
 public:
  static constexpr const char* name = "thornton";
  static constexpr const char* source = "Thornton 1997, J. Appl. Mech. 64:383";
  static constexpr const char* range =
      "a << R*; force too low well beyond yield (-43 % at 120 v_Y)";
  static constexpr bool self_similar = true;

  explicit Thornton(const MaterialPair& pair, const Parameters&)
      : modulus_(4.0 / 3.0 * pair.youngs_modulus_eff),
        slope_(pi * pair.yield_pressure),
        yield_overlap_ratio_(yield_radius_ratio(pair) * yield_radius_ratio(pair)) {}

  PLASTIGRAN_DEVICE Response respond(double radius_eff, double overlap, State& state) const {
    if (!(overlap > 0)) return {0, 0, 0, plastic_work(radius_eff, state.overlap_max)};
    const double overlap_y = radius_eff * yield_overlap_ratio_;
    if (overlap <= overlap_y && state.overlap_max == 0)
      return hertz_response(modulus_, radius_eff, overlap);
    if (overlap > state.overlap_max) state.overlap_max = overlap;
    const double radius_max = std::sqrt(radius_eff * state.overlap_max);
    const double force_max = slope_ * radius_eff * (state.overlap_max - overlap_y / 3);
    const double x = 1 - (state.overlap_max - overlap) * (modulus_ * radius_max / force_max);
    Response response;
    if (x > 0) {
      const double root = std::sqrt(x);
      response.contact_radius = radius_max * root;
      response.force = force_max * x * root;
      response.elastic_energy = 0.4 * response.force * x * force_max / (modulus_ * radius_max);
    }
    response.plastic_work = plastic_work(radius_eff, state.overlap_max);
    return response;
  }

  // Members that tables/adhesive.h needs, in yield units (overlap/overlap_y and F/F_y).
  typedef PowerOfOverlap<Thornton> Rebound;
  static constexpr bool closed_form = true;
  double elastic_range() const { return yield_overlap_ratio_; }
  PLASTIGRAN_DEVICE static Peak after_loading(double x) {
    const double force = 1.5 * x - 0.5, root = std::sqrt(x);
    return {force, root, root / force, Rebound::usual_shape, 0};
  }

 private:
  // Returns the work of first loading to overlap_max minus the energy released by unloading [J].
  PLASTIGRAN_DEVICE double plastic_work(double radius_eff, double overlap_max) const {
    if (overlap_max == 0) return 0;
    const double overlap_y = radius_eff * yield_overlap_ratio_;
    const double stiffness = slope_ * radius_eff;
    const double force_max = stiffness * (overlap_max - overlap_y / 3);
    const double beyond = overlap_max - overlap_y;
    const double yield_work = 0.4 * (2.0 / 3.0) * stiffness * overlap_y * overlap_y;
    const double loading_work =
        yield_work + stiffness * beyond * (0.5 * beyond + 2.0 / 3.0 * overlap_y);
    const double recovery = force_max / (modulus_ * std::sqrt(radius_eff * overlap_max));
    return loading_work - 0.4 * force_max * recovery;
  }

  double modulus_;              // 4/3 E* [Pa]
  double slope_;                // pi p_y [Pa]: dF/d(overlap)/R* beyond yield
  double yield_overlap_ratio_;  // overlap_y/R* [-]
};

}  // namespace plastigran
