// SPDX-License-Identifier: GPL-2.0-or-later
//
// Loads that dissipate energy without plastic flow: friction, rolling friction and dashpots.
#pragma once

#include <array>

#include "liggghts/model/accounted_load.h"

namespace plastigran {

typedef std::array<double, 3> Vector;

template <class A, class B>
double dot(const A& a, const B& b) {
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

// Load of a contact minus the force of the law.
struct LossyLoad {
  Vector force{};  // force on particle i; the other body has the opposite force
  Vector torque_i{}, torque_j{};

  LossyLoad() {}
  LossyLoad(const LIGGGHTS::ContactModels::SurfacesIntersectData& contact,
            const AccountedLoad& on_i, const LIGGGHTS::ContactModels::ForceData& on_j) {
    const double of_law = dot(on_i.delta_F, contact.en) - on_i.dashpot_force;
    for (int axis = 0; axis < 3; ++axis) {
      force[axis] = on_i.delta_F[axis] - of_law * contact.en[axis];
      torque_i[axis] = on_i.delta_torque[axis];
      torque_j[axis] = contact.is_wall ? 0 : on_j.delta_torque[axis];
    }
  }

  // Returns the load with the two bodies exchanged.
  LossyLoad exchanged() const {
    LossyLoad other;
    other.force = {-force[0], -force[1], -force[2]};
    other.torque_i = torque_j;
    other.torque_j = torque_i;
    return other;
  }

  void operator+=(const LossyLoad& other) {
    for (int axis = 0; axis < 3; ++axis) {
      force[axis] += other.force[axis];
      torque_i[axis] += other.torque_i[axis];
      torque_j[axis] += other.torque_j[axis];
    }
  }
};

}  // namespace plastigran
