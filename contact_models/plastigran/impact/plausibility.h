// SPDX-License-Identifier: GPL-2.0-or-later
//
// Values that are allowed but look like a slip: typed in another unit than the others.
#pragma once

#include <sstream>
#include <utility>

#include "plastigran/shared/complaint.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

// What is odd about a body's constants; empty when nothing is. `pascal` is 1 Pa in their unit.
//
// Modulus: engines ask for 5 MPa at least, and solids softer than 1 MPa are gels. Strength: the
// ideal strength of a solid is about a tenth of its modulus, nothing reaches a third (Kelly &
// Macmillan, Strong Solids, 1986); pure annealed metals have 1e-4 of it, none 2e-5. Bodies beyond
// `rigid_modulus` are left out.
inline Complaint implausible(const Body& body, double pascal) {
  const double modulus = body.youngs_modulus, strength = body.yield_strength;
  const double rigid = rigid_modulus * pascal;
  std::ostringstream text;
  if (modulus < 1e6 * pascal) {
    text << "{youngs_modulus} is " << modulus << " [Pa], as soft as a gel";
    const char* stop = "; ";
    for (const auto& [unit, in_pascal] : {std::pair("GPa", 1e9), std::pair("MPa", 1e6)})
      if (modulus * in_pascal < 2e12) {  // diamond: 1.2e12 Pa
        text << stop << "meant in " << unit << " it is " << modulus * in_pascal * pascal;
        stop = ", ";
      }
  } else if (modulus < rigid && strength < rigid && strength > modulus / 3) {
    text << "{yield_strength} is " << strength << " [Pa], more than a third of {youngs_modulus} "
         << modulus << ": no solid is as strong; one of them may be in another unit";
  } else if (modulus < rigid && strength < 2e-5 * modulus) {
    text << "{yield_strength} is " << strength << " [Pa], less than 2e-5 of {youngs_modulus} "
         << modulus << "; meant in MPa it is " << 1e6 * pascal * strength;
  }
  return Complaint(text.str());
}

}  // namespace plastigran
