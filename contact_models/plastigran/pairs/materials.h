// SPDX-License-Identifier: GPL-2.0-or-later
//
// Materials of a simulation, which a host reads from its deck, and the names that the host uses for
// fields and units.
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

// Constants of all atom types, which are numbered from 1.
struct Materials {
  std::vector<Body> bodies;  // constants of atom type k + 1 at index k
  // Constants of the law by field name: one value per atom type if the constant is `per_body`,
  // otherwise one value per pair of types, row by row. A missing field has its default value.
  std::map<std::string, std::vector<double>> constants;
  std::set<std::string> given;  // fields that the deck defines
};

// Functions that translate field names and SI units to the names that the host uses.
struct Words {
  std::function<std::string(const std::string&)> name, unit;
};

// Returns a sentence with the atom types appended; only `type` if other_type is 0.
inline std::string about_types(const std::string& sentence, int type, int other_type = 0) {
  std::string types = (other_type ? " (atom types " : " (atom type ") + std::to_string(type);
  if (other_type) types += " and " + std::to_string(other_type);
  return sentence + types + ')';
}
inline Complaint about_types(const Complaint& complaint, int type, int other_type = 0) {
  if (complaint.empty()) return {};
  return Complaint(about_types(complaint.sentence(), type, other_type));
}

// Returns a complaint about the first body with an invalid constant; empty if all are valid.
inline Complaint validate(const std::vector<Body>& bodies) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Complaint complaint = validate(bodies[k]);
    if (!complaint.empty()) return about_types(complaint, static_cast<int>(k) + 1);
  }
  return {};
}

}  // namespace plastigran
