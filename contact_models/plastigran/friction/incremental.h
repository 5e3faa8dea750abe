// SPDX-License-Identifier: GPL-2.0-or-later
//
// Incremental tangential force T without slip at the edge of the contact: Thornton, Cummins &
// Cleary 2013 (Powder Technol. 233:30), eq. 18b. In LAMMPS, this law is `mindlin_rescale/force`.
//
//   T += 8 G* a ds              displacement increment ds
//   T *= a_new/a_old            while the contact radius a decreases
//   |T| <= mu F                 Coulomb
//   U = |T|^2/(16 G* a)         stored energy
//
// Range: contacts that slide, or whose tangential force is small. Below the angle of gross sliding,
// the tangential restitution of an oblique elastic impact is up to 0.12 too high
// (docs/friction.md).
#pragma once

#include <cmath>
#include <cstddef>

#include "plastigran/friction/tangential.h"

namespace plastigran {

class Incremental {
 public:
  static constexpr const char* name = "incremental";
  static constexpr const char* source =
      "Thornton, Cummins & Cleary 2013, Powder Technol. 233:30, eq. 18b";
  static constexpr const char* range = "no slip at the edge of the contact";

  struct State {
    Vector3 normal;
    double stiffness = 0;  // 8 G* a of the last step
    Vector3 force;
  };
  // Returns whether value k of the state changes its sign if the two bodies are exchanged.
  static constexpr bool changes_sign(std::size_t k) { return k != 3; }
  PLASTIGRAN_DEVICE static std::size_t state_size(int) { return sizeof(State) / sizeof(double); }

  explicit Incremental(double coefficient_of_friction = 0, int = 0)
      : friction_(coefficient_of_friction) {}

  PLASTIGRAN_DEVICE TangentialResponse respond(const NormalLoad& load,
                                               const TangentialMotion& motion, State& state) const {
    const Vector3 before = FrameRotation(state.normal, motion)(state.force);
    const Vector3 centered = centered_displacement(state.normal, motion);
    const Vector3 displacement = centered - dot(centered, motion.normal) * motion.normal;
    const double energy_before =
        state.stiffness > 0 ? dot(before, before) / (2 * state.stiffness) : 0;
    TangentialResponse response;
    if (load.force > 0 && load.stiffness > 0) {
      const double scale = load.stiffness < state.stiffness ? load.stiffness / state.stiffness : 1;
      response.force = scale * before + load.stiffness * displacement;
      const double square = dot(response.force, response.force);
      const double limit = friction_ * load.force;
      if (square > limit * limit) response.force = limit / std::sqrt(square) * response.force;
      response.stored_energy = dot(response.force, response.force) / (2 * load.stiffness);
      state = {motion.normal, load.stiffness, response.force};
    } else {
      state = State();
    }
    response.friction_work =
        0.5 * dot(before + response.force, displacement) - (response.stored_energy - energy_before);
    return response;
  }

 private:
  double friction_;  // mu
};

}  // namespace plastigran
