// SPDX-License-Identifier: GPL-2.0-or-later
//
// Interface of tangential laws. This header and the laws neither allocate nor throw, do not read
// mutable globals, and do not depend on a host program.
//
// A law is a class with these members:
//
//   name         name in decks; source: the publication; range: where the law is valid
//   State        struct of doubles, zero before first touch
//   state_size(rings)                   number of leading doubles of State that the law uses
//   changes_sign(k)                     whether value k of the state changes its sign if the two
//                                       bodies are exchanged
//   respond(load, motion, state)        advances the state by one step and returns the Response
//
// A law needs two values of the normal contact: the normal force F, and the tangential stiffness
// 8 G* a, where a is the contact radius. The law assumes that unloading is elastic with a^3
// proportional to F. If the tangential traction is everywhere D times the normal traction, the
// tangential displacement is then 3/2 D F/(8 G* a). The assumption is exact for the Hertz contact
// and for the unloading of most laws.
//
// SI units throughout.
#pragma once

#include <cmath>

#include "plastigran/shared/device.h"

namespace plastigran {

struct Vector3 {
  double x = 0, y = 0, z = 0;
};

PLASTIGRAN_DEVICE inline Vector3 operator+(const Vector3& a, const Vector3& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
PLASTIGRAN_DEVICE inline Vector3 operator-(const Vector3& a, const Vector3& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
PLASTIGRAN_DEVICE inline Vector3 operator*(double factor, const Vector3& a) {
  return {factor * a.x, factor * a.y, factor * a.z};
}
PLASTIGRAN_DEVICE inline double dot(const Vector3& a, const Vector3& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
PLASTIGRAN_DEVICE inline Vector3 cross(const Vector3& a, const Vector3& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
PLASTIGRAN_DEVICE inline double length(const Vector3& a) { return std::sqrt(dot(a, a)); }

// The normal contact at the end of a step.
struct NormalLoad {
  double force = 0;  // force that limits friction: normal force of the law plus pull-off force [N]
  double stiffness = 0;  // tangential stiffness of the law without slip [N/m]
};

// Relative motion of the two bodies in a step.
struct TangentialMotion {
  Vector3 displacement;   // displacement of the first body's surface relative to the second's [m]
  Vector3 normal;         // unit vector of the contact at the end of the step
  double spin = 0;        // rotation of the contact about the normal, mean of both bodies [rad]
  double separation = 0;  // displacement along the normal, positive if the bodies separate [m]
};

// Returns the displacement of a step without the part that is due to separation. With velocity
// Verlet, the displacement belongs to the contact plane in the middle of the step, but `normal` is
// the normal at the end of the step. Therefore a part of the separation appears as tangential
// displacement. Without this correction, the error of the force is of first order in the step
// (Vyas, Ottino, Lueptow & Umbanhowar 2025, Comput. Phys. Commun. 310:109524). The caller removes
// the part along the new normal. `before` is the normal of the previous step, zero before first
// touch.
PLASTIGRAN_DEVICE inline Vector3 centered_displacement(const Vector3& before,
                                                       const TangentialMotion& motion) {
  return motion.displacement - 0.5 * motion.separation * before;
}

struct TangentialResponse {
  Vector3 force;             // along the displacement; -force acts on the first body [N]
  double stored_energy = 0;  // energy of the tangential deformation [J]
  // Energy dissipated in this step [J]. The trapezoidal rule leaves an error of third order in the
  // step.
  double friction_work = 0;
};

// Rotation of the contact plane in a step: the shortest rotation between the two normals, followed
// by the spin about the new normal.
class FrameRotation {
 public:
  // `before` is the normal of the previous step, zero before first touch.
  PLASTIGRAN_DEVICE FrameRotation(const Vector3& before, const TangentialMotion& motion)
      : normal_(motion.normal), sum_(before + motion.normal), spin_(motion.spin) {
    const double divisor = 1 + dot(before, motion.normal);
    factor_ = 1 / (divisor > 0.5 ? divisor : 0.5);
  }

  // Returns the vector `old` of the old plane, rotated to the new plane. The result is
  // perpendicular to the new normal even if `old` was not exactly in the old plane, so round-off
  // does not accumulate.
  PLASTIGRAN_DEVICE Vector3 operator()(const Vector3& old) const {
    Vector3 turned = old - factor_ * dot(old, normal_) * sum_;
    if (spin_ != 0) turned = spun(turned);
    return turned;
  }

 private:
  // Returns the vector `a` of the new plane, rotated by the spin.
  PLASTIGRAN_DEVICE Vector3 spun(const Vector3& a) const {
    double sine, cosine;
    if (std::abs(spin_) < 0.03) {  // both series are exact to round-off
      const double square = spin_ * spin_;
      sine = spin_ * (1 - square * (1.0 / 6 - 1.0 / 120 * square));
      cosine = 1 - square * (0.5 - square * (1.0 / 24 - 1.0 / 720 * square));
    } else {
      sine = std::sin(spin_), cosine = std::cos(spin_);
    }
    return cosine * a + sine * cross(normal_, a);
  }

  Vector3 normal_, sum_;
  double factor_, spin_;
};

}  // namespace plastigran
