// SPDX-License-Identifier: GPL-2.0-or-later
//
// What the deck's `units` are called. Laws compute in any consistent units and speak in SI.
#pragma once

#include <string>

namespace plastigran {

// The deck's unit for an SI unit: dyn/cm2 for Pa under `units cgs`, "micro units" under `units
// micro` and the like.
std::string unit_in_deck(const std::string& unit_style, const std::string& si);

// A sentence with units in brackets, "[Pa]", in the deck's units.
std::string sentence_in_deck(const std::string& unit_style, std::string sentence);

// 1 Pa in the deck's unit; 0 when it is not known.
double pascal_in_deck(const std::string& unit_style);

}  // namespace plastigran
