// SPDX-License-Identifier: GPL-2.0-or-later
//
// Checks of constants before anything runs.
#pragma once

#include <cmath>
#include <sstream>
#include <string>

#include "plastigran/shared/complaint.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

inline Complaint validate(const Body& body) {
  const auto positive = [](double value) { return value > 0 && std::isfinite(value); };
  if (!positive(body.youngs_modulus))
    return Complaint::about("youngs_modulus", body.youngs_modulus, "positive and finite [Pa]");
  if (!(body.poissons_ratio > -1 && body.poissons_ratio <= 0.5))
    return Complaint::about("poissons_ratio", body.poissons_ratio, "above -1 and at most 0.5");
  if (!positive(body.yield_strength) && body.yield_strength != unlimited)
    return Complaint::about("yield_strength", body.yield_strength, "positive and finite [Pa]");
  if (!(body.yield_pressure_factor == 0 ||
        (body.yield_pressure_factor >= 0.5 && body.yield_pressure_factor <= 10)))
    return Complaint::about("yield_pressure_factor", body.yield_pressure_factor,
                            "between 0.5 and 10, or 0 for the Hertz-von Mises value");
  if (!(body.tangent_modulus >= 0 && body.tangent_modulus < body.youngs_modulus)) {
    std::ostringstream allowed;
    allowed << "0 or more and less than {youngs_modulus}, " << body.youngs_modulus << " [Pa]";
    return Complaint::about("tangent_modulus", body.tangent_modulus, allowed.str());
  }
  if (!(body.rate_coefficient >= 0 && body.rate_coefficient <= 1))
    return Complaint::about("rate_coefficient", body.rate_coefficient, "between 0 and 1 [-]");
  if (!positive(body.reference_rate))
    return Complaint::about("reference_rate", body.reference_rate, "positive and finite [1/s]");
  return {};
}

// A law may add a joint condition on its constants and the pair: static bool admissible(const
// MaterialPair&, const Parameters&) with a sentence `admissibility` that names fields in braces.
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

// About one constant's value; empty when it is in range.
template <class Parameters>
Complaint complaint(const Parameter<Parameters>& parameter, double value) {
  if (value >= parameter.lower && value <= parameter.upper) return {};
  std::ostringstream allowed;
  allowed << "between " << parameter.lower << " and " << parameter.upper << " [" << parameter.unit
          << "]: " << parameter.meaning;
  if (std::isnan(value))
    return Complaint('{' + std::string(parameter.name) + "} is missing; it must be given, " +
                     allowed.str());
  return Complaint::about(parameter.name, value, allowed.str());
}

template <class Law>
Complaint validate(const MaterialPair& pair, const typename Law::Parameters& constants) {
  if (yields<Law> && !std::isfinite(pair.yield_strength))
    return Complaint(
        "{yield_strength} is missing; one of the bodies at least must have it, positive and finite "
        "[Pa]");
  const typename Law::Parameters defaults;
  for (const auto& parameter : parameters_of<Law>) {
    const double value = constants.*parameter.value;
    if (value == defaults.*parameter.value) continue;
    const Complaint found = complaint(parameter, value);
    if (!found.empty()) return found;
  }
  return joint_complaint<Law>(pair, constants, 0);
}

}  // namespace plastigran
