// SPDX-License-Identifier: GPL-2.0-or-later
//
// The law of two atom types, with what belongs to that pair alone.
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <vector>

#include "plastigran/shared/complaint.h"
#include "plastigran/shared/contact.h"
#include "plastigran/shared/rate_factor.h"

namespace plastigran {

template <class Law>
struct TypePair {
  typedef typename Law::Parameters Constants;

  double watched = 0;    // overlap over R* from which on a host looks at contacts
  Complaint refusal;     // why the law is none for these two; empty when it is
  bool lacking = false;  // neither body brings what one must: refused once two particles can meet
  Law law;
  MaterialPair bodies;
  double noted = 0;  // overlap over R* up to which a host has looked
  double range;      // largest overlap over R* the law is good for
  Constants constants;

  TypePair(const MaterialPair& bodies_, const Constants& constants_)
      : law(bodies_, constants_),
        bodies(bodies_),
        range(overlap_range(law)),
        constants(constants_) {}

  // Whether a contact is a tenth deeper than those before, over R*. Contacts are then looked at
  // from the new depth on, or from the end of the range or a limit.
  bool deepens(double depth, double limit) {
    if (depth <= noted) return false;
    noted = 1.1 * depth;
    watched = std::min({noted, range, limit});
    return true;
  }

  // The two with their strength at a rate factor; made when first asked for. A new one counts as
  // watched as deeply as the others.
  TypePair& strengthened(double factor) {
    const std::size_t steps = rate_factor_steps(factor);
    if (steps == 0) return *this;
    if (steps >= stronger_.size()) stronger_.resize(steps + 1);
    if (!stronger_[steps]) stronger_[steps] = make(factor);
    return *stronger_[steps];
  }

 private:
  std::shared_ptr<TypePair> make(double factor) const {
    auto made = std::make_shared<TypePair>(*this);
    made->stronger_.clear();
    made->bodies = plastigran::strengthened(bodies, factor);
    made->constants = strengthened_constants<Law>(constants, factor);
    made->law = Law(made->bodies, made->constants);
    made->range = overlap_range(made->law);
    for (const auto& other : stronger_)
      if (other && other->noted > made->noted)
        made->noted = other->noted, made->watched = other->watched;
    return made;
  }

  std::vector<std::shared_ptr<TypePair>> stronger_;  // by steps of the rate factor
};

}  // namespace plastigran
