// SPDX-License-Identifier: GPL-2.0-or-later
//
// The law of two atom types and its data.
#pragma once

#include <algorithm>

#include "plastigran/pairs/rate_tables.h"
#include "plastigran/shared/complaint.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

template <class Law>
struct TypePair {
  typedef typename Law::Parameters Constants;

  double checked_from = 0;  // a host checks contacts beyond this overlap/R*
  Complaint refusal;        // why the law does not support the two types; empty if it does
  bool lacking = false;     // both bodies lack a constant, which matters only if they touch
  Law law;
  MaterialPair bodies;
  double checked_to = 0;  // largest overlap/R* checked so far, plus 10 %
  double range;           // validity range: largest overlap/R*, at rate factor 1
  Constants constants;
  RateTables<Law> rates;

  TypePair(const MaterialPair& bodies_, const Constants& constants_)
      : law(bodies_, constants_),
        bodies(bodies_),
        range(overlap_range(law)),
        constants(constants_),
        rates(bodies_, constants_) {}

  // Whether a contact is deeper than `checked_to`, which then grows. Contacts beyond the range or
  // `limit` are always checked. Depths are overlaps/R*.
  bool deepens(double depth, double limit) {
    if (depth <= checked_to) return false;
    checked_to = 1.1 * depth;
    checked_from = std::min({checked_to, range, limit});
    return true;
  }

  // Calls `use` with the law at a rate factor and its range.
  template <class Use>
  decltype(auto) at_factor(double factor, const Use& use) const {
    if constexpr (yields<Law>)
      if (factor != 1) {
        const LawAtFactor<Law> stronger(law, range, rates, factor);
        return use(stronger, stronger.overlap_range());
      }
    return use(law, range);
  }
};

}  // namespace plastigran
