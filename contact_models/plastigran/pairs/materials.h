// SPDX-License-Identifier: GPL-2.0-or-later
//
// The materials of a simulation, which a host reads from its deck, and the names that it uses.
#pragma once

#include <functional>
#include <map>
#include <set>
#include <string>
#include <vector>

#include "plastigran/impact/validate.h"
#include "plastigran/shared/complaint.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

// Atom types count from 1.
struct Materials {
  std::vector<Body> bodies;  // by type - 1
  // Constants of the law by field: a value per type if the constant is `per_body`, else a value per
  // pair of types, row by row. A missing field has its default.
  std::map<std::string, std::vector<double>> constants;
  std::set<std::string> given;  // fields that the deck defines
};

// The host's names of fields and SI units.
struct Words {
  std::function<std::string(const std::string&)> name, unit;
};

// Adds the atom types to a sentence (other_type 0: one type).
inline std::string about_types(const std::string& sentence, int type, int other_type = 0) {
  std::string types = (other_type ? " (atom types " : " (atom type ") + std::to_string(type);
  if (other_type) types += " and " + std::to_string(other_type);
  return sentence + types + ')';
}
inline Complaint about_types(const Complaint& complaint, int type, int other_type = 0) {
  if (complaint.empty()) return {};
  return Complaint(about_types(complaint.sentence(), type, other_type));
}

// The complaint about the first body with a wrong constant; empty if there is none.
inline Complaint validate(const std::vector<Body>& bodies) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Complaint complaint = validate(bodies[k]);
    if (!complaint.empty()) return about_types(complaint, static_cast<int>(k) + 1);
  }
  return {};
}

}  // namespace plastigran
