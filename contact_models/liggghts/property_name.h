// SPDX-License-Identifier: GPL-2.0-or-later
//
// What decks call a field of the laws: LIGGGHTS names properties in camel case.
#ifndef PLASTIGRAN_PROPERTY_NAME_H
#define PLASTIGRAN_PROPERTY_NAME_H

#include <cctype>
#include <string>

#include "plastigran/shared/complaint.h"

namespace plastigran {

// yieldStrength for yield_strength: the name in `fix property/global`.
inline std::string property_name(const std::string& field) {
  std::string name;
  bool capital = false;
  for (const char letter : field) {
    if (letter != '_') name += capital ? static_cast<char>(std::toupper(letter)) : letter;
    capital = letter == '_';
  }
  return name;
}

inline std::string in_property_names(const Complaint& complaint) {
  return complaint.worded(property_name);
}

}  // namespace plastigran

#endif
