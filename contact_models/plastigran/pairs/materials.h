// SPDX-License-Identifier: GPL-2.0-or-later
//
// The materials of a simulation, as a host reads them from its deck, and how the host words them.
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
  // Constants of the law, by field: a value per type if the constant is `per_body`, else a value
  // per pair of types, row by row. A field that is left out has its default.
  std::map<std::string, std::vector<double>> constants;
  std::set<std::string> given;  // fields of bodies and constants that are no defaults
};

// What a host calls a field of the laws and an SI unit.
struct Words {
  std::function<std::string(const std::string&)> name, unit;
};

// A sentence and the atom types it is about (other_type 0: one).
inline std::string about_types(const std::string& sentence, int type, int other_type = 0) {
  std::string types = (other_type ? " (atom types " : " (atom type ") + std::to_string(type);
  if (other_type) types += " and " + std::to_string(other_type);
  return sentence + types + ')';
}
inline Complaint about_types(const Complaint& complaint, int type, int other_type = 0) {
  if (complaint.empty()) return {};
  return Complaint(about_types(complaint.sentence(), type, other_type));
}

// About the first body whose constants are refused; empty when none is.
inline Complaint validate(const std::vector<Body>& bodies) {
  for (std::size_t k = 0; k < bodies.size(); ++k) {
    const Complaint complaint = validate(bodies[k]);
    if (!complaint.empty()) return about_types(complaint, static_cast<int>(k) + 1);
  }
  return {};
}

}  // namespace plastigran
