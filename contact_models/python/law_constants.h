// SPDX-License-Identifier: GPL-2.0-or-later
//
// Constants and options of a law in Python. Parses the keyword arguments, and creates the tables,
// the signature and the docstring of the constructor.
#pragma once

#include <nanobind/stl/string.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <string>

#include "arguments.h"
#include "plastigran/impact/validate.h"

namespace plastigran {

template <class Parameters>
int parse_choice(const Option<Parameters>& option, const std::string& word) {
  std::string allowed;
  for (int k = 0; k < static_cast<int>(option.choices.size()) && option.choices[k]; ++k) {
    if (word == option.choices[k]) return k;
    allowed += (k ? ", " : "") + std::string(option.choices[k]);
  }
  throw std::invalid_argument(std::string(option.name) + " is '" + word + "'; it must be one of " +
                              allowed);
}

template <class Law>
typename Law::Parameters parse_constants(const MaterialPair& pair, const nb::dict& given) {
  typename Law::Parameters constants;
  for (auto [key, value] : given) {
    const std::string name = nb::cast<std::string>(key);
    const auto is_named = [&](const auto& candidate) { return name == candidate.name; };
    const auto option = std::find_if(options_of<Law>.begin(), options_of<Law>.end(), is_named);
    if (option != options_of<Law>.end()) {
      constants.*(option->value) = parse_choice(*option, nb::cast<std::string>(nb::str(value)));
      continue;
    }
    const auto known = std::find_if(parameters_of<Law>.begin(), parameters_of<Law>.end(), is_named);
    if (known == parameters_of<Law>.end()) {
      std::string message = std::string(Law::name) + " has no constant '" + name + "'; it takes";
      for (const auto& p : parameters_of<Law>) message += std::string(" ") + p.name;
      for (const auto& o : options_of<Law>) message += std::string(" ") + o.name;
      throw std::invalid_argument(
          message + (parameters_of<Law>.empty() && options_of<Law>.empty() ? " none" : ""));
    }
    if (!nb::try_cast<double>(value, constants.*(known->value)))
      throw std::invalid_argument(name + " is " + nb::cast<std::string>(nb::repr(value)) +
                                  "; it must be a number [" + known->unit + "]");
    const double number = constants.*(known->value);
    if (std::isnan(number))  // for `validate`, NaN means that a constant is missing
      raise_if(Complaint::about(name, number, allowed_values(*known)),
               std::string(Law::name) + ": ");
  }
  raise_if(validate<Law>(pair, constants), std::string(Law::name) + ": ");
  return constants;
}

// Returns a table of a law as a list of dicts, one per row. `fill` adds the columns that only this
// table has.
template <class Table, class Fill>
nb::list rows(const Table& table, const Fill& fill) {
  nb::list all;
  for (const auto& entry : table) {
    nb::dict row;
    row["name"] = entry.name;
    fill(entry, row);
    row["meaning"] = entry.meaning;
    all.append(row);
  }
  return all;
}

// Returns the table of a law's constants with their defaults; None marks a required constant.
template <class Law>
nb::list parameter_table() {
  return rows(parameters_of<Law>, [](const auto& p, nb::dict& row) {
    const double value = typename Law::Parameters().*p.value;
    row["unit"] = p.unit;
    row["default"] = std::isnan(value) ? nb::object(nb::none()) : nb::object(nb::float_(value));
    row["per_body"] = p.per_body;
    row["lower"] = p.lower;
    row["upper"] = p.upper;
  });
}

template <class Law>
nb::list option_table() {
  return rows(options_of<Law>, [](const auto& o, nb::dict& row) {
    nb::list choices;
    for (const char* choice : o.choices)
      if (choice) choices.append(choice);
    row["choices"] = choices;
    row["default"] = o.choices[typename Law::Parameters().*o.value];
  });
}

// Returns the Python signature of the constructor, for the stub file.
template <class Law>
std::string constructor_signature() {
  std::string text, star = ", *";
  const typename Law::Parameters defaults;
  for (const auto& p : parameters_of<Law>) {
    const double value = defaults.*p.value;
    text += star + ", " + p.name + ": float";
    if (!std::isnan(value)) text += " = " + nb::cast<std::string>(nb::repr(nb::float_(value)));
    star.clear();
  }
  for (const auto& o : options_of<Law>) {
    text += star + ", " + o.name + ": Literal[";
    for (const char* choice : o.choices)
      if (choice) text += (choice == o.choices[0] ? "'" : ", '") + std::string(choice) + "'";
    text += std::string("] = '") + o.choices[defaults.*o.value] + "'";
    star.clear();
  }
  return "def __init__(self, pair: MaterialPair" + text + ") -> None";
}

template <class Law>
std::string constructor_doc() {
  std::string text =
      "Create the law for two bodies.\n\nArgs:\n    pair: Constants of the two bodies.\n";
  for (const auto& p : parameters_of<Law>)
    text += std::string("    ") + p.name + ": " + p.meaning + " [" + p.unit + "].\n";
  for (const auto& o : options_of<Law>)
    text += std::string("    ") + o.name + ": " + o.meaning + ".\n";
  return text +
         "\nRaises:\n    ValueError: A constant is missing, unknown or out of range. The message\n "
         "       names it, its value and the range.";
}

}  // namespace plastigran
