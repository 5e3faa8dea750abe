// SPDX-License-Identifier: GPL-2.0-or-later
//
// Tangential contact with partial slip: the middle sticks and the edge slips (Cattaneo 1938,
// Mindlin & Deresiewicz 1953). The contact is a superposition of normal contacts, in rings: Jaeger
// 1993, Arch. Appl. Mech. 63:402; Ciavarella 1998, Int. J. Solids Struct. 35:2363; method of memory
// diagrams, Aleshin, Bou Matar & Van Den Abeele 2015, Int. J. Solids Struct. 60:14.
//
// A ring between the normal forces F1 and F2 has the share of friction D, a vector, |D| <= mu:
//
//   T = sum of D (F2 - F1)                           tangential force
//   s = sum of D (h(F2) - h(F1))                     tangential displacement
//   h(F) = integral of dF/(8 G* a) = c F^(2/3)       with a^3 proportional to F on unloading
//   U = integral of T(F).D dh                        stored energy, T(F) of the rings below F
//
// A step with the displacement increment w:
//
//   loading     adds a ring with D = w/dh, cut at mu; w loses what the ring takes
//   unloading   removes the rings above F; w gains their displacement
//   slip        where w remains: all rings above a force get D = mu n, with one direction n, such
//               that they take w; if no force is low enough, the contact slides
//   merger      of neighboring rings, where there are more than the law keeps
//
// Range: exact for elastic spheres with many rings; with four, the tangential restitution is within
// 0.008. Plastic contacts keep the forces at the edges of their rings: a construction.
#pragma once

#include <cmath>
#include <cstddef>

#include "plastigran/friction/tangential.h"

namespace plastigran {

// `capacity` rings fit into the state.
template <int capacity = 8>
class PartialSlip {
 public:
  static constexpr const char* name = "partial_slip";
  static constexpr const char* source =
      "Jaeger 1993, Arch. Appl. Mech. 63:402; Aleshin, Bou Matar & Van Den Abeele 2015, Int. J. "
      "Solids Struct. 60:14";
  static constexpr const char* range = "exact for elastic spheres with many rings";
  static constexpr int most_rings = capacity, default_rings = 4;

  // Forces are cubes of their roots p = F^(1/3), so that h = c p^2.
  struct Ring {
    double edge = 0;  // p at the outer edge; 0 where there is no ring
    Vector3 share;    // D
  };
  struct State {
    Vector3 normal;
    double compliance = 0;  // c
    Ring rings[capacity];   // from the middle outward
  };
  PLASTIGRAN_DEVICE static std::size_t state_size(int rings) { return 4 + 4 * std::size_t(rings); }

  explicit PartialSlip(double coefficient_of_friction = 0, int rings = default_rings)
      : friction_(coefficient_of_friction), kept_(rings) {}

  PLASTIGRAN_DEVICE TangentialResponse respond(const NormalLoad& load,
                                               const TangentialMotion& motion, State& state) const {
    Diagram rings;
    const FrameRotation rotate(state.normal, motion);
    for (; rings.count < kept_ && state.rings[rings.count].edge > 0; ++rings.count) {
      const Ring& old = state.rings[rings.count];
      rings.ring[rings.count] = {old.edge, rotate(old.share)};
    }
    const Sum before = rings.sum();
    TangentialResponse response;
    double compliance = 0;
    if (load.force > 0 && load.stiffness > 0) {
      const double edge = std::cbrt(load.force);
      compliance = rings.follow(state.compliance, 1.5 * edge / load.stiffness);
      if (friction_ > 0) move(rings, edge, 1 / compliance * motion.displacement);
      const Sum after = rings.sum();
      response.force = after.force;
      response.stored_energy = compliance * after.energy;
      state.normal = motion.normal;
    } else {
      rings.count = 0;
      state.normal = Vector3();
    }
    response.friction_work = 0.5 * dot(before.force + response.force, motion.displacement) -
                             (response.stored_energy - state.compliance * before.energy);
    state.compliance = compliance;
    for (int k = 0; k < kept_; ++k) state.rings[k] = k < rings.count ? rings.ring[k] : Ring();
    return response;
  }

 private:
  // T and U/c of some rings.
  struct Sum {
    Vector3 force;
    double energy = 0;

    PLASTIGRAN_DEVICE void add(double inner, const Ring& ring) {
      const double outer = ring.edge, inner_2 = inner * inner, outer_2 = outer * outer;
      const double inner_3 = inner_2 * inner, outer_3 = outer_2 * outer;
      const double width = outer_2 - inner_2;
      energy += dot(force, ring.share) * width +
                dot(ring.share, ring.share) *
                    (0.4 * (outer_3 * outer_2 - inner_3 * inner_2) - inner_3 * width);
      force = force + (outer_3 - inner_3) * ring.share;
    }
  };

  // The rings of a contact during a step, with room for those that the step adds.
  struct Diagram {
    Ring ring[capacity + 2];
    int count = 0;

    PLASTIGRAN_DEVICE double edge(int k) const { return k < 0 ? 0 : ring[k].edge; }
    PLASTIGRAN_DEVICE double square(int k) const { return edge(k) * edge(k); }

    PLASTIGRAN_DEVICE Sum sum() const {
      Sum sum;
      for (int k = 0; k < count; ++k) sum.add(edge(k - 1), ring[k]);
      return sum;
    }

    PLASTIGRAN_DEVICE void scale(double factor) {
      for (int k = 0; k < count; ++k) ring[k].share = factor * ring[k].share;
    }

    // The compliance c of this step, and the rings at it. The stored energy is proportional to c.
    // A lower c, as in plastic loading, keeps the forces and releases energy. A higher c would
    // create energy: the old one remains, unless it is less than 1/1.5 of the new one. It then
    // follows, and the shares fall as far as keeps the energy.
    PLASTIGRAN_DEVICE double follow(double old, double now) {
      constexpr double hysteresis = 1.5;
      if (count == 0 || now <= old) return now;
      if (now <= hysteresis * old) return old;
      scale(std::sqrt(hysteresis * old / now));
      return now / hysteresis;
    }

    // Removes the rings above `top` and returns their displacement over c.
    PLASTIGRAN_DEVICE Vector3 cut(double top) {
      Vector3 held;
      while (count > 0 && edge(count - 1) > top) {
        Ring& last = ring[count - 1];
        const double inner = edge(count - 2), bottom = inner > top ? inner : top;
        held = held + (last.edge * last.edge - bottom * bottom) * last.share;
        if (inner >= top)
          --count;
        else
          last.edge = top;
      }
      return held;
    }

    // Merges rings k and k + 1. The force remains.
    PLASTIGRAN_DEVICE Ring merger(int k) const {
      const double inner = edge(k - 1), middle = edge(k), outer = edge(k + 1);
      const double start = inner * inner * inner, cube = middle * middle * middle;
      const double weight = (cube - start) / (outer * outer * outer - start);
      return {outer, ring[k + 1].share + weight * (ring[k].share - ring[k + 1].share)};
    }

    // Merges the pair whose displacement changes least, among those whose merger raises the energy
    // by at most 1/1000. If there is none, merges the pair that raises the energy least. Where the
    // energy rises, all shares fall until it is as before, by a small slip.
    //
    // The measure is the difference of the shares times the width of both rings. A smaller measure
    // for thin rings would let the outer ring absorb all thin ones, at any small step.
    PLASTIGRAN_DEVICE void merge_one() {
      const double energy = sum().energy, admissible = 1e-3 * energy;
      int best = 0;
      double least = 0, rise = 0;
      Sum below;
      for (int k = 0; k + 1 < count; ++k) {
        Sum apart = below, merged = below;
        apart.add(edge(k - 1), ring[k]);
        const Sum next = apart;
        apart.add(edge(k), ring[k + 1]);
        merged.add(edge(k - 1), merger(k));
        const double raised = merged.energy - apart.energy;
        const double change =
            length(ring[k + 1].share - ring[k].share) * (square(k + 1) - square(k - 1));
        const bool admits = raised <= admissible;
        if (k == 0 || (admits ? rise > admissible || change < least : raised < rise)) {
          best = k;
          least = change;
          rise = raised;
        }
        below = next;
      }
      ring[best] = merger(best);
      for (int k = best + 1; k + 1 < count; ++k) ring[k] = ring[k + 1];
      --count;
      if (rise > 0) scale(std::sqrt(energy / (energy + rise)));
    }
  };

  // Moves the contact to the force edge^3, and by `wanted` c along the surface.
  PLASTIGRAN_DEVICE void move(Diagram& rings, double edge, Vector3 wanted) const {
    const double top = rings.edge(rings.count - 1);
    if (edge > top) {
      const double width = edge * edge - top * top, size = length(wanted);
      const double most = friction_ * width;
      const double taken = size > most ? most / size : 1;
      rings.ring[rings.count++] = {edge, taken / width * wanted};
      wanted = size > most ? (1 - taken) * wanted : Vector3();
    } else {
      wanted = wanted + rings.cut(edge);
    }
    if (dot(wanted, wanted) > 0) slip(rings, wanted);
    while (rings.count > kept_) rings.merge_one();
  }

  // Gives the rings above a force the share mu n, so that they take the displacement `wanted` c.
  PLASTIGRAN_DEVICE void slip(Diagram& rings, Vector3 wanted) const {
    const double edge = rings.edge(rings.count - 1), square = edge * edge;
    const double limit = friction_ * friction_;
    while (rings.count > 0) {
      // Within the ring, at the depth t in p^2: |wanted + D t| = mu (above + t).
      Ring& last = rings.ring[rings.count - 1];
      const double top = last.edge * last.edge, inner = rings.square(rings.count - 2);
      const double above = square - top;
      const double a = dot(last.share, last.share) - limit;
      const double b = dot(wanted, last.share) - limit * above;
      const double c = dot(wanted, wanted) - limit * above * above;
      if (c <= 0) break;
      const double root = b * b - a * c, divisor = std::sqrt(root > 0 ? root : 0) - b;
      const double bottom = divisor * (top - inner) > c ? top - c / divisor : inner;
      wanted = wanted + (top - bottom) * last.share;
      if (bottom > inner) {
        last.edge = std::sqrt(bottom);
        break;
      }
      --rings.count;
    }
    const double size = length(wanted);
    rings.ring[rings.count++] = {edge, friction_ / size * wanted};
  }

  double friction_;  // mu
  int kept_;         // number of rings after a step
};

}  // namespace plastigran
