// SPDX-License-Identifier: GPL-2.0-or-later
//
// Names of the units in a deck. Laws compute in any consistent units, and their messages are in SI.
#pragma once

#include <string>

namespace plastigran {

// The unit of the deck for an SI unit: dyn/cm2 for Pa with `units cgs`, "micro units" with `units
// micro`.
std::string unit_in_deck(const std::string& unit_style, const std::string& si);

// Replaces the units in brackets, "[Pa]", by those of the deck.
std::string sentence_in_deck(const std::string& unit_style, std::string sentence);

// 1 Pa in the unit of the deck; 0 if unknown.
double pascal_in_deck(const std::string& unit_style);

}  // namespace plastigran
