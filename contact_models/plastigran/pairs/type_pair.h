// SPDX-License-Identifier: GPL-2.0-or-later
//
// Law of a pair of atom types, with the data of its run-time checks.
#pragma once

#include <algorithm>

#include "plastigran/pairs/rate_tables.h"
#include "plastigran/shared/complaint.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

template <class Law>
struct TypePair {
  typedef typename Law::Parameters Constants;

  double checked_from = 0;  // overlap/R* beyond which a host checks contacts
  Complaint refusal;        // reason why the law does not support the two types; empty if it does
  bool lacking = false;     // whether both bodies lack the same constant; an error if they touch
  Law law;
  MaterialPair bodies;
  double checked_to = 0;  // 1.1 times the largest overlap/R* checked so far
  double range;           // validity range: largest overlap/R*, at rate factor 1
  Constants constants;
  RateTables<Law> rates;

  TypePair(const MaterialPair& bodies_, const Constants& constants_)
      : law(bodies_, constants_),
        bodies(bodies_),
        range(overlap_range(law)),
        constants(constants_),
        rates(bodies_, constants_) {}

  // Returns whether a contact at `depth` = overlap/R* must be checked, because it exceeds
  // `checked_to`. If so, increases `checked_to`, so that most later contacts need no check.
  bool deepens(double depth, double limit) {
    if (depth <= checked_to) return false;
    checked_to = 1.1 * depth;
    checked_from = std::min({checked_to, range, limit});
    return true;
  }

  // Calls use(law, range) with the law at a rate factor and with its validity range. Returns the
  // result of `use`.
  template <class Use>
  decltype(auto) at_factor(double factor, const Use& use) const {
    if constexpr (takes_rate_factor<Law>)
      if (factor != 1) {
        const LawAtFactor<Law> stronger(law, range, rates, factor);
        return use(stronger, stronger.overlap_range());
      }
    return use(law, range);
  }
};

}  // namespace plastigran
