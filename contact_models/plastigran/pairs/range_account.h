// SPDX-License-Identifier: GPL-2.0-or-later
//
// Counts contacts that exceed the validity range of their law, and records the largest overlap.
#pragma once

#include <algorithm>
#include <cstring>

namespace plastigran {

// Contact whose overlap exceeds the validity range of its law in the present time step.
template <class State>
struct DeepContact {
  double radius_eff, overlap;  // R* and overlap [m]
  double closing;              // approach of the two bodies in one time step [m]
  const State &before, &now;   // state before and after the step
  bool has_moved_freely;       // whether a command may have moved the particles before this step
  double share;  // fraction of the contact that this rank counts; another rank counts the rest
};

struct RangeAccount {
  double contacts = 0;  // number of contacts beyond the range
  double furthest = 0;  // largest ratio of overlap to limit

  // Counts a contact when its overlap exceeds the limit (range times R*) for the first time. The
  // state stores the largest earlier overlap. It is therefore the first time if loading the
  // previous state up to the limit would change this state. The law is not called if this step left
  // the state unchanged, or if the overlap was well beyond the limit before this step.
  template <class Law>
  void add(const Law& law, double range, const DeepContact<typename Law::State>& contact) {
    typedef typename Law::State State;
    const double limit = range * contact.radius_eff;
    furthest = std::max(furthest, contact.overlap / limit);
    const auto same = [](const State& one, const State& other) {
      return std::memcmp(&one, &other, Law::state_names.size() * sizeof(double)) == 0;
    };
    if (same(contact.before, contact.now)) return;
    const bool far = contact.overlap > 1.001 * limit + 2 * contact.closing;
    if (far && !same(contact.before, State()) && !contact.has_moved_freely) return;
    State reached = contact.before;
    law.respond(contact.radius_eff, limit, reached);
    if (!same(contact.before, reached)) contacts += contact.share;
  }
};

}  // namespace plastigran
