// SPDX-License-Identifier: GPL-2.0-or-later
//
// Detects constants that are in the allowed range but probably have a wrong unit.
#pragma once

#include <sstream>
#include <utility>

#include "plastigran/shared/complaint.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

// Returns why the constants of a body are implausible; empty if they are plausible. `pascal` is the
// value of 1 Pa in the pressure unit of the constants.
//
// Modulus: LIGGGHTS requires at least 5 MPa, and solids below 1 MPa are gels. Strength: the ideal
// strength of a solid is about a tenth of its modulus and never reaches a third (Kelly & Macmillan,
// Strong Solids, 1986). The yield strength of pure annealed metals is 1e-4 of the modulus; no metal
// is below 2e-5. Bodies beyond `rigid_modulus` are not checked.
inline Complaint implausible(const Body& body, double pascal) {
  const double modulus = body.youngs_modulus, strength = body.yield_strength;
  const double rigid = rigid_modulus * pascal;
  std::ostringstream text;
  if (modulus < 1e6 * pascal) {
    text << "{youngs_modulus} is " << modulus << " [Pa], as soft as a gel";
    for (const auto& [unit, in_pascal] : {std::pair("GPa", 1e9), std::pair("MPa", 1e6)})
      if (modulus * in_pascal < 2e12)  // above the modulus of diamond, 1.2e12 Pa
        text << "; if it is in " << unit << ", write " << modulus * in_pascal * pascal;
  } else if (modulus < rigid && strength < rigid && strength > modulus / 3) {
    text << "{yield_strength} is " << strength << " [Pa], more than a third of {youngs_modulus} "
         << modulus << "; no solid is that strong, so check the units of both";
  } else if (modulus < rigid && strength < 2e-5 * modulus) {
    text << "{yield_strength} is " << strength << " [Pa], less than 2e-5 of {youngs_modulus} "
         << modulus << "; if it is in MPa, write " << 1e6 * pascal * strength;
  }
  return Complaint(text.str());
}

}  // namespace plastigran
