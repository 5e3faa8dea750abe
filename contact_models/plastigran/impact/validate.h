// SPDX-License-Identifier: GPL-2.0-or-later
//
// Range checks of material and law constants, before a simulation starts.
#pragma once

#include <cmath>
#include <sstream>
#include <string>

#include "plastigran/shared/adhesion.h"
#include "plastigran/shared/complaint.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

// Returns the allowed range of a constant in words, for example "positive and finite [Pa]".
inline std::string allowed_values(const BodyConstant& constant) {
  std::ostringstream words;
  if (!std::isfinite(constant.upper))
    words << (constant.above ? "positive and finite" : "0 or more and finite");
  else if (constant.above)
    words << "above " << constant.lower << " and at most " << constant.upper;
  else
    words << "between " << constant.lower << " and " << constant.upper;
  if (constant.standard < constant.lower) words << ", or " << constant.standard;
  words << " [" << constant.unit << ']';
  return words.str();
}

inline Complaint validate(const Body& body) {
  if (body.youngs_modulus > 0 &&
      !(body.tangent_modulus >= 0 && body.tangent_modulus < body.youngs_modulus)) {
    std::ostringstream allowed;
    allowed << "0 or more and less than {youngs_modulus}, " << body.youngs_modulus << " [Pa]";
    return Complaint::about("tangent_modulus", body.tangent_modulus, allowed.str());
  }
  for (const BodyConstant& constant : body_constants) {
    const double value = body.*constant.value;
    const bool above = constant.above ? value > constant.lower : value >= constant.lower;
    if (value == constant.standard || (above && value <= constant.upper && std::isfinite(value)))
      continue;
    return Complaint::about(constant.name, value, allowed_values(constant));
  }
  return {};
}

// Checks the condition that a law may define for its constants and the pair together. Such a law
// has a function static bool admissible(const MaterialPair&, const Parameters&), and the error
// message `admissibility` with field names in braces.
template <class Law>
auto joint_complaint(const MaterialPair& pair, const typename Law::Parameters& constants, int)
    -> decltype(Law::admissible(pair, constants), Complaint()) {
  if (Law::admissible(pair, constants)) return {};
  std::ostringstream given;
  for (const auto& parameter : parameters_of<Law>)
    given << (given.tellp() > 0 ? ", " : "with ") << '{' << parameter.name << "} "
          << constants.*parameter.value << " [" << parameter.unit << ']';
  if (given.tellp() > 0) given << ": ";
  return Complaint(given.str() + Law::admissibility);
}
template <class Law>
Complaint joint_complaint(const MaterialPair&, const typename Law::Parameters&, long) {
  return {};
}

// Returns the allowed range of a constant in words, with its unit and meaning.
template <class Parameters>
std::string allowed_values(const Parameter<Parameters>& parameter) {
  std::ostringstream words;
  words << "between " << parameter.lower << " and " << parameter.upper << " [" << parameter.unit
        << "]: " << parameter.meaning;
  return words.str();
}

// Returns a complaint about the value of a constant; empty if the value is in range. NaN marks a
// missing constant.
template <class Parameters>
Complaint complaint(const Parameter<Parameters>& parameter, double value) {
  if (value >= parameter.lower && value <= parameter.upper) return {};
  const std::string allowed = allowed_values(parameter);
  if (std::isnan(value))
    return Complaint('{' + std::string(parameter.name) + "} is missing. Add a value " + allowed);
  return Complaint::about(parameter.name, value, allowed);
}

template <class Law>
Complaint validate(const MaterialPair& pair, const typename Law::Parameters& constants) {
  if (yields<Law> && !std::isfinite(pair.yield_strength))
    return Complaint(
        "{yield_strength} is missing. At least one of the bodies needs it, positive and finite "
        "[Pa]");
  if (yields<Law> && !takes_rate_factor<Law> && pair.rate_coefficient > 0)
    return Complaint::about("rate_coefficient", pair.rate_coefficient, "0 with adhesion");
  const typename Law::Parameters defaults;
  for (const auto& parameter : parameters_of<Law>) {
    const double value = constants.*parameter.value;
    if (value == defaults.*parameter.value) continue;
    const Complaint problem = complaint(parameter, value);
    if (!problem.empty()) return problem;
  }
  return joint_complaint<Law>(pair, constants, 0);
}

}  // namespace plastigran
