// SPDX-License-Identifier: GPL-2.0-or-later
//
// Tangential contact with partial slip: the middle of the contact sticks, and its edge slips.
//
// The contact is a sum of rings. A ring is the part of the contact area that is added while the
// normal force grows from F1 to F2. Each ring has a vector D, its tangential force divided by its
// normal force, with |D| <= mu:
//
//   T = sum of D (F2 - F1)                           tangential force
//   s = sum of D (h(F2) - h(F1))                     tangential displacement
//   h(F) = integral of dF/(8 G* a) = c F^(2/3)       with a^3 proportional to F on unloading
//   U = integral of T(F).D dh                        stored energy, T(F) of the rings below F
//
// docs/friction.md describes how a step changes the rings, and the accuracy.
//
// Sources: Cattaneo 1938 and Mindlin & Deresiewicz 1953 (partial slip); Jaeger 1993, Arch. Appl.
// Mech. 63:402; Ciavarella 1998, Int. J. Solids Struct. 35:2363; Aleshin, Bou Matar & Van Den
// Abeele 2015, Int. J. Solids Struct. 60:14 (rings).
#pragma once

#include <cmath>
#include <cstddef>

#include "plastigran/friction/tangential.h"

namespace plastigran {

// Tangential law with partial slip. `capacity` is the largest number of rings of the contact area
// that the state can store.
template <int capacity = 8>
class PartialSlip {
 public:
  static constexpr const char* name = "partial_slip";
  static constexpr const char* source =
      "Jaeger 1993, Arch. Appl. Mech. 63:402; Aleshin, Bou Matar & Van Den Abeele 2015, Int. J. "
      "Solids Struct. 60:14";
  static constexpr const char* range = "with many rings, exact for elastic spheres";
  static constexpr int least_rings = 2, most_rings = capacity, default_rings = 4;

  // Ring of the contact area. Its outer edge is stored as p = F^(1/3), where F is the normal force
  // at which the contact area reaches this edge. The displacement function h of the file header is
  // then c p^2. D is the tangential force of the ring divided by its normal force, as a vector in
  // the frame of the contact.
  struct Ring {
    double edge;  // p = F^(1/3) at the outer edge; 0 if there is no ring
    double x, y;  // D
  };
  // The frame of the contact has the axes x, normal cross x, and normal. It turns with the contact
  // plane, so D does not change when the contact turns.
  struct State {
    Vector3 normal, x_axis;
    double compliance = 0;      // c [m/N^(2/3)]: h = c p^2
    Ring rings[capacity] = {};  // from the middle outward
  };
  // Returns whether value k of the state changes its sign if the two bodies are exchanged. The
  // exchange changes the signs of the normal, the x axis and the force. The y axis, normal cross x,
  // stays the same, so the y components of D change their signs, but the x components do not.
  static constexpr bool changes_sign(std::size_t k) { return k < 6 || (k > 6 && (k - 7) % 3 == 2); }
  PLASTIGRAN_DEVICE static constexpr std::size_t state_size(int rings) {
    return 7 + 3 * std::size_t(rings);
  }

  explicit PartialSlip(double coefficient_of_friction = 0, int rings = default_rings)
      : friction_(coefficient_of_friction), kept_(rings) {}

  PLASTIGRAN_DEVICE TangentialResponse respond(const NormalLoad& load,
                                               const TangentialMotion& motion, State& state) const {
    if (!(load.force > 0 && load.stiffness > 0)) return end(motion, state);
    Diagram rings = rings_of(state);
    const int count_before = rings.count;
    const Frame frame(state, motion);
    const Plane along = frame.in_plane(centered_displacement(state.normal, motion));
    const double edge = cube_root(load.force, rings.edge(rings.count - 1));
    const Sum before = rings.sum();
    const double compliance = rings.follow(state.compliance, 1.5 * edge / load.stiffness);
    rings.limit(friction_);  // a deck may reduce the coefficient of friction between two runs
    if (friction_ > 0) move(rings, edge, 1 / compliance * along);
    const Sum after = rings.sum();
    TangentialResponse response;
    response.force = frame.in_space(after.force);
    response.stored_energy = compliance * after.energy;
    response.friction_work = 0.5 * dot(before.force + after.force, along) -
                             (response.stored_energy - state.compliance * before.energy);
    state.normal = motion.normal;
    state.x_axis = frame.x;
    state.compliance = compliance;
    for (int k = count_before - 1; k >= rings.count; --k) state.rings[k] = Ring();
    return response;
  }

 private:
  // Vector in the contact plane, in the frame of the contact.
  struct Plane {
    double x = 0, y = 0;
    friend PLASTIGRAN_DEVICE Plane operator+(Plane a, Plane b) { return {a.x + b.x, a.y + b.y}; }
    friend PLASTIGRAN_DEVICE Plane operator-(Plane a, Plane b) { return {a.x - b.x, a.y - b.y}; }
    friend PLASTIGRAN_DEVICE Plane operator*(double f, Plane a) { return {f * a.x, f * a.y}; }
    friend PLASTIGRAN_DEVICE double dot(Plane a, Plane b) { return a.x * b.x + a.y * b.y; }
  };

  // Axes of the contact plane at the end of a step.
  struct Frame {
    Vector3 x, y;

    PLASTIGRAN_DEVICE Frame(const State& state, const TangentialMotion& motion)
        : x(turned(state, motion)), y(cross(motion.normal, x)) {}

    PLASTIGRAN_DEVICE Plane in_plane(const Vector3& a) const { return {dot(a, x), dot(a, y)}; }
    PLASTIGRAN_DEVICE Vector3 in_space(Plane a) const { return a.x * x + a.y * y; }

    // Returns the axis x at the end of the step. Before first touch, any direction in the plane
    // serves.
    PLASTIGRAN_DEVICE static Vector3 turned(const State& state, const TangentialMotion& motion) {
      if (state.compliance == 0) {
        const Vector3& n = motion.normal;
        const Vector3 any = std::abs(n.x) < 0.6 ? Vector3{1, 0, 0} : Vector3{0, 1, 0};
        const Vector3 axis = any - dot(any, n) * n;
        return 1 / length(axis) * axis;
      }
      // The factor restores the unit length, which round-off of many rotations would change.
      const double factor = 1.5 - 0.5 * dot(state.x_axis, state.x_axis);
      return factor * FrameRotation(state.normal, motion)(state.x_axis);
    }
  };

  // Ends the contact in this step, and counts its stored energy as dissipated.
  PLASTIGRAN_DEVICE TangentialResponse end(const TangentialMotion& motion, State& state) const {
    TangentialResponse response;
    if (state.compliance > 0) {
      const Sum before = rings_of(state).sum();
      response.friction_work =
          0.5 * dot(before.force, Frame(state, motion).in_plane(motion.displacement)) +
          state.compliance * before.energy;
      state = State();
    }
    return response;
  }

  PLASTIGRAN_DEVICE static Plane share(const Ring& ring) { return {ring.x, ring.y}; }
  PLASTIGRAN_DEVICE static double cube(double p) { return p * p * p; }

  // Returns force^(1/3), starting from the estimate `near`. If the relative difference of force and
  // near^3 is below 1/64, a series about near^3 is exact to round-off. Up to a difference of 0.45,
  // a step of Halley's method first improves `near`.
  PLASTIGRAN_DEVICE static double cube_root(double force, double near) {
    double x = near > 0 ? force / cube(near) - 1 : 1;
    if (std::abs(x) > 1.0 / 64) {
      if (std::abs(x) > 0.45) return std::cbrt(force);
      near *= (3 + 2 * x) / (3 + x);
      x = force / cube(near) - 1;
    }
    constexpr double a1 = 1.0 / 3, a2 = -1.0 / 9, a3 = 5.0 / 81, a4 = -10.0 / 243, a5 = 22.0 / 729,
                     a6 = -154.0 / 6561, a7 = 374.0 / 19683;
    // Group the terms in pairs, because a processor computes independent products in parallel.
    const double x2 = x * x, low = a1 + a2 * x, high = a3 + a4 * x, highest = a5 + a6 * x;
    return near + near * (x * (low + x2 * (high + x2 * (highest + x2 * a7))));
  }

  // Tangential force T of rings, and their stored energy divided by the compliance c. The rings are
  // summed from the middle outward.
  struct Sum {
    Plane force;
    double energy = 0;
    double square = 0, cube = 0;  // p^2 and p^3 at the outer edge

    PLASTIGRAN_DEVICE void add(const Ring& ring) {
      const Plane d = share(ring);
      const double outer_2 = ring.edge * ring.edge, outer_3 = outer_2 * ring.edge;
      const double width = outer_2 - square;
      energy += dot(force, d) * width +
                dot(d, d) * (0.4 * (outer_3 * outer_2 - cube * square) - cube * width);
      force = force + (outer_3 - cube) * d;
      square = outer_2, cube = outer_3;
    }
  };

  // The rings of one contact, from the middle outward.
  struct Diagram {
    Ring* ring;
    int count;

    PLASTIGRAN_DEVICE double edge(int k) const { return k < 0 ? 0 : ring[k].edge; }
    PLASTIGRAN_DEVICE double square(int k) const { return edge(k) * edge(k); }

    PLASTIGRAN_DEVICE Sum sum(int first_left_out) const {
      Sum sum;
      for (int k = 0; k < first_left_out; ++k) sum.add(ring[k]);
      return sum;
    }
    PLASTIGRAN_DEVICE Sum sum() const { return sum(count); }

    PLASTIGRAN_DEVICE void scale(double factor) {
      for (int k = 0; k < count; ++k) ring[k].x *= factor, ring[k].y *= factor;
    }
    // Limits the vector D of every ring to the length `largest`, with a tolerance for round-off. D
    // is the tangential force of the ring divided by its normal force.
    PLASTIGRAN_DEVICE void limit(double largest) {
      for (int k = 0; k < count; ++k) {
        const double square = dot(share(ring[k]), share(ring[k]));
        if (square <= largest * largest * (1 + 1e-9)) continue;
        const double factor = largest / std::sqrt(square);
        ring[k].x *= factor, ring[k].y *= factor;
      }
    }

    // Returns the compliance c of this step, and adapts the rings to it. The stored energy is
    // proportional to c. A lower c, as in plastic loading, keeps the forces and releases energy. A
    // higher c would create energy. Therefore the old c remains until the new c exceeds 1.5 times
    // the old one. Then c grows to the new value divided by 1.5, and every D (tangential/normal
    // force of a ring) decreases so that the stored energy stays the same.
    PLASTIGRAN_DEVICE double follow(double old, double now) {
      constexpr double hysteresis = 1.5;
      if (count == 0 || now <= old) return now;
      if (now <= hysteresis * old) return old;
      scale(std::sqrt(hysteresis * old / now));
      return now / hysteresis;
    }

    // Removes the rings outside the edge F^(1/3) = `top`, where F is the normal force. Returns the
    // tangential displacement of the removed rings, divided by the compliance c.
    PLASTIGRAN_DEVICE Plane cut(double top) {
      Plane held;
      while (count > 0 && edge(count - 1) > top) {
        Ring& last = ring[count - 1];
        const double inner = edge(count - 2), bottom = inner > top ? inner : top;
        held = held + (last.edge * last.edge - bottom * bottom) * share(last);
        if (inner >= top)
          --count;
        else
          last.edge = top;
      }
      return held;
    }

    // Returns the change of the stored energy, divided by the compliance c, if rings k and k + 1
    // merge and keep their tangential force.
    PLASTIGRAN_DEVICE double rise(int k) const {
      const Sum below = sum(k);
      Sum apart = below, merged = below;
      apart.add(ring[k]);
      apart.add(ring[k + 1]);
      merged.add(merger(k));
      return merged.energy - apart.energy;
    }

    // Returns the ring that replaces rings k and k + 1 and has the same tangential force.
    PLASTIGRAN_DEVICE Ring merger(int k) const {
      const double start = cube(edge(k - 1)), middle = cube(edge(k)), end = cube(edge(k + 1));
      const double weight = (middle - start) / (end - start);
      const Ring &inner = ring[k], &outer = ring[k + 1];
      return {outer.edge, outer.x + weight * (inner.x - outer.x),
              outer.y + weight * (inner.y - outer.y)};
    }

    // Returns a measure of the displacement error if rings k and k + 1 merge: the squared product
    // of two factors, the difference of their vectors D and the width of both rings together. With
    // the width of the thinner ring alone, the outer ring would absorb all thin rings, however
    // small the step is.
    PLASTIGRAN_DEVICE double change(int k) const {
      const Plane difference = share(ring[k + 1]) - share(ring[k]);
      const double width = square(k + 1) - square(k - 1);
      return dot(difference, difference) * (width * width);
    }

    // Merges two neighboring rings: among the pairs whose merger raises the stored energy by at
    // most 1/1000, the pair whose displacement changes least. If there is no such pair, merges the
    // pair that raises the energy least. A small slip then removes the added energy: every D
    // decreases until the energy is as before.
    PLASTIGRAN_DEVICE void merge_one() {
      int best = 0;
      double least = change(0);
      for (int k = 1; k + 1 < count; ++k) {
        const double next = change(k);
        if (next < least) best = k, least = next;
      }
      double raised = rise(best);
      if (raised > 0) {
        const double energy = sum().energy, admissible = 1e-3 * energy;
        if (raised > admissible) best = admissible_pair(admissible, raised);
        if (raised > 0) scale(std::sqrt(energy / (energy + raised)));
      }
      ring[best] = merger(best);
      for (int k = best + 1; k + 1 < count; ++k) ring[k] = ring[k + 1];
      --count;
    }

    // Returns the index k of the pair of rings k and k + 1 that merge_one() merges. Sets `raised`
    // to the energy that the merger adds.
    PLASTIGRAN_DEVICE int admissible_pair(double admissible, double& raised) const {
      int best = 0;
      double least = change(0);
      raised = rise(0);
      for (int k = 1; k + 1 < count; ++k) {
        const double next = change(k), next_rise = rise(k);
        const bool better =
            next_rise <= admissible ? raised > admissible || next < least : next_rise < raised;
        if (better) best = k, least = next, raised = next_rise;
      }
      return best;
    }
  };

  // Changes the normal force to edge^3 and adds the tangential displacement c * `wanted`. Loading
  // adds a ring, unloading removes rings, and slip sets |D| = mu in the outer rings.
  PLASTIGRAN_DEVICE void move(Diagram& rings, double edge, Plane wanted) const {
    if (edge < rings.edge(rings.count - 1)) wanted = wanted + rings.cut(edge);
    // The displacement of a ring, divided by c, is at most mu times its width.
    const double limit = friction_ * friction_, square = edge * edge;
    double width = square - rings.square(rings.count - 1);  // width of the ring that loading adds
    double excess = dot(wanted, wanted) - limit * (width * width);
    if (!(excess > 0)) {
      if (width > 0) add(rings, edge, 1 / width * wanted);
      return;
    }
    // Slip: the outer rings, together with the new ring, get D = mu n with the same direction n.
    // The loop includes ring after ring from the outside, until the included rings can take the
    // displacement.
    while (rings.count > 0) {
      Ring& last = rings.ring[rings.count - 1];
      const Plane d = share(last);
      const double outer = rings.square(rings.count - 1);
      const double thickness = outer - rings.square(rings.count - 2);
      const Plane whole = wanted + thickness * d;
      const double wider = width + thickness;
      const double remaining = dot(whole, whole) - limit * (wider * wider);
      if (remaining <= 0) {
        // Slip ends inside this ring, at the depth t from its outer edge where |wanted + D t| = mu
        // (width + t).
        const double a = dot(d, d) - limit, b = dot(wanted, d) - limit * width;
        const double root = b * b - a * excess;
        const double depth = excess / (std::sqrt(root > 0 ? root : 0) - b);
        if (depth < thickness) {
          last.edge = std::sqrt(outer - depth);
          return add(rings, edge, 1 / (width + depth) * (wanted + depth * d));
        }
      }
      --rings.count;
      wanted = whole, width = wider, excess = remaining;
      if (remaining <= 0) break;
    }
    add(rings, edge, friction_ / std::sqrt(dot(wanted, wanted)) * wanted);
  }

  // Adds a ring outside the others. If the state has no room for it, two rings merge.
  PLASTIGRAN_DEVICE void add(Diagram& rings, double edge, Plane share) const {
    const Ring outer{edge, share.x, share.y};
    if (rings.count < kept_) {
      rings.ring[rings.count++] = outer;
      return;
    }
    Ring room[capacity + 1];
    for (int k = 0; k < kept_; ++k) room[k] = rings.ring[k];
    room[kept_] = outer;
    Diagram{room, kept_ + 1}.merge_one();
    for (int k = 0; k < kept_; ++k) rings.ring[k] = room[k];
  }

  PLASTIGRAN_DEVICE Diagram rings_of(State& state) const {
    Diagram rings{state.rings, 0};
    while (rings.count < kept_ && state.rings[rings.count].edge > 0) ++rings.count;
    return rings;
  }

  double friction_;  // mu
  int kept_;         // number of rings that the state stores
};

}  // namespace plastigran
