// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/deck_units.h"

#include <map>

namespace plastigran {

std::string unit_in_deck(const std::string& unit_style, const std::string& si) {
  static const std::map<std::string, std::string> cgs{
      {"Pa", "dyn/cm2"}, {"m", "cm"}, {"m/s", "cm/s"}, {"s", "s"}, {"1/s", "1/s"}, {"-", "-"}};
  if (unit_style == "si" || si == "-") return si;
  const auto unit = cgs.find(si);
  return unit_style == "cgs" && unit != cgs.end() ? unit->second : unit_style + " units";
}

std::string sentence_in_deck(const std::string& unit_style, std::string sentence) {
  for (const char* si : {"Pa", "m", "m/s", "s", "1/s"}) {
    const std::string bracket = std::string("[") + si + "]";
    const std::string unit = '[' + unit_in_deck(unit_style, si) + ']';
    for (std::size_t at = 0; (at = sentence.find(bracket, at)) != std::string::npos;
         at += unit.size())
      sentence.replace(at, bracket.size(), unit);
  }
  return sentence;
}

double pascal_in_deck(const std::string& unit_style) {
  return unit_style == "si" ? 1 : unit_style == "cgs" ? 10 : 0;
}

}  // namespace plastigran
