// SPDX-License-Identifier: GPL-2.0-or-later
//
// Counts the contacts that leave the range of their law, and keeps the largest overlap.
#pragma once

#include <algorithm>
#include <cstring>

namespace plastigran {

// A contact beyond the range, in one step.
template <class State>
struct DeepContact {
  double radius_eff, overlap;  // [m]
  double closing;              // how far the two close in on each other in a step [m]
  const State &before, &now;   // its state before and after the step
  bool has_moved_freely;       // its particles may have been moved since the last step
  double share;                // of the contact in this account; the rest is another rank's
};

struct RangeAccount {
  double contacts = 0;  // that have passed the end of their range
  double furthest = 0;  // largest overlap over the range's

  // A contact is counted when it passes the end of its law's range, an overlap over R*, for the
  // first time: when what it had reached before this step is less than loading to that end makes of
  // it. The law is asked only where that can be so: a contact that nothing new has been reached in,
  // or that was well beyond the end a step ago, has passed before.
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
