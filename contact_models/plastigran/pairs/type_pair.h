// SPDX-License-Identifier: GPL-2.0-or-later
//
// The law of two atom types, with what belongs to that pair alone.
#pragma once

#include <algorithm>

#include "plastigran/pairs/rate_tables.h"
#include "plastigran/shared/complaint.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

template <class Law>
struct TypePair {
  typedef typename Law::Parameters Constants;

  double checked_from = 0;  // overlap over R* from which on a host looks at contacts
  Complaint refusal;        // why the law is none for these two; empty when it is
  bool lacking = false;  // neither body brings what one must: refused once two particles can meet
  Law law;
  MaterialPair bodies;
  double checked_to = 0;  // overlap over R* up to which a host has looked
  double range;  // largest overlap over R* the law is good for, at rest; grows with the strength
  Constants constants;
  RateTables<Law> rates;

  TypePair(const MaterialPair& bodies_, const Constants& constants_)
      : law(bodies_, constants_),
        bodies(bodies_),
        range(overlap_range(law)),
        constants(constants_),
        rates(bodies_, constants_) {}

  // Whether a contact is a tenth deeper than those before, over R*. Contacts are then looked at
  // from the new depth on, or from the end of the range or a limit.
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
