// SPDX-License-Identifier: GPL-2.0-or-later
//
// Names of the units in a deck. Laws compute in any consistent units. Their messages name SI units,
// which these functions replace by the units of the deck.
#pragma once

#include <string>

namespace plastigran {

// Returns the deck's unit for an SI unit: dyn/cm2 for Pa with `units cgs`, "micro units" with
// `units micro`.
std::string unit_in_deck(const std::string& unit_style, const std::string& si);

// Returns the sentence with SI units in brackets, such as "[Pa]", replaced by the deck's units.
std::string sentence_in_deck(const std::string& unit_style, std::string sentence);

// Returns the value of 1 Pa in the pressure unit of the deck; 0 if the unit style is unknown.
double pascal_in_deck(const std::string& unit_style);

}  // namespace plastigran
