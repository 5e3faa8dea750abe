// SPDX-License-Identifier: GPL-2.0-or-later
//
// Binds one law to Python: a class named as in C++, with its State, constants and options.
#pragma once

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <stdexcept>
#include <string>

#include "any_law.h"
#include "plastigran/impact/validate.h"
#include "plastigran/shared/rate_factor.h"
#include "values.h"

namespace plastigran {

template <class Law>
struct StateOf : AnyState {
  static_assert(Law::state_names.size() <= capacity);
  StateOf() : AnyState{Law::name, Law::state_names.data(), Law::state_names.size()} {}
};

template <class Law>
class LawOf : public AnyLaw {
 public:
  LawOf(const MaterialPair& bodies, const typename Law::Parameters& given)
      : law(bodies, given), pair(bodies), constants(given) {}

  const Law law;
  const MaterialPair pair;
  const typename Law::Parameters constants;

  const char* name() const override { return Law::name; }
  Response respond(double radius_eff, double overlap, double* values,
                   double overlap_rate) const override {
    constexpr std::size_t bytes = Law::state_names.size() * sizeof(double);
    typename Law::State state;
    std::memcpy(&state, values, bytes);
    const Response response = plastigran::respond(law, radius_eff, overlap, state, overlap_rate);
    std::memcpy(values, &state, bytes);
    return response;
  }
  ImpactOutcome central_impact(double radius_eff, double mass_eff, double speed) const override {
    const double factor = rate_factor(pair, radius_eff, speed);
    return plastigran::central_impact(factor == 1 ? law : strengthened(factor).law, radius_eff,
                                      mass_eff, speed);
  }
  double overlap_range() const override { return plastigran::overlap_range(law); }
  double recommended_timestep(double radius_eff, double mass_eff, double speed) const override {
    const double factor = rate_factor(pair, radius_eff, speed);
    return plastigran::recommended_timestep(factor == 1 ? law : strengthened(factor).law,
                                            radius_eff, mass_eff, speed);
  }
  LawOf strengthened(double factor) const {
    return LawOf(plastigran::strengthened(pair, factor),
                 strengthened_constants<Law>(constants, factor));
  }
};

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
      std::string text = std::string(Law::name) + " has no constant '" + name + "'; it takes";
      for (const auto& p : parameters_of<Law>) text += std::string(" ") + p.name;
      for (const auto& o : options_of<Law>) text += std::string(" ") + o.name;
      throw std::invalid_argument(
          text + (parameters_of<Law>.empty() && options_of<Law>.empty() ? " none" : ""));
    }
    if (!nb::try_cast<double>(value, constants.*(known->value)))
      throw std::invalid_argument(name + " is " + nb::cast<std::string>(nb::repr(value)) +
                                  "; it must be a number [" + known->unit + "]");
  }
  raise_if(validate<Law>(pair, constants), std::string(Law::name) + ": ");
  return constants;
}

// A table of a law for Python: a dict a row, from its name to its meaning; `fill` says the rest.
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

// The law's own constants with their defaults, None for one that must be given.
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

// The constructor as Python writes it.
template <class Law>
std::string constructor_signature() {
  std::string said, star = ", *";
  const typename Law::Parameters defaults;
  for (const auto& p : parameters_of<Law>) {
    const double value = defaults.*p.value;
    said += star + ", " + p.name + ": float";
    if (!std::isnan(value)) said += " = " + nb::cast<std::string>(nb::repr(nb::float_(value)));
    star.clear();
  }
  for (const auto& o : options_of<Law>) {
    said += star + ", " + o.name + ": Literal[";
    for (const char* choice : o.choices)
      if (choice) said += (choice == o.choices[0] ? "'" : ", '") + std::string(choice) + "'";
    said += std::string("] = '") + o.choices[defaults.*o.value] + "'";
    star.clear();
  }
  return "def __init__(self, pair: MaterialPair" + said + ") -> None";
}

template <class Law>
std::string constructor_doc() {
  std::string said = "The law between two bodies.\n\nArgs:\n    pair: The two bodies.\n";
  for (const auto& p : parameters_of<Law>)
    said += std::string("    ") + p.name + ": " + p.meaning + " [" + p.unit + "].\n";
  for (const auto& o : options_of<Law>)
    said += std::string("    ") + o.name + ": " + o.meaning + ".\n";
  return said +
         "\nRaises:\n    ValueError: A constant is missing or out of range, or there is no "
         "such constant; the message\n        names it, its value and the range.";
}

// Laws with more to say (a force-driven form, an iteration count) say it in a specialisation.
template <class Law>
void bind_extras(nb::class_<LawOf<Law>, AnyLaw>&) {}

template <class Law>
void bind_state(nb::class_<LawOf<Law>, AnyLaw>& law) {
  typedef StateOf<Law> State;
  nb::class_<State, AnyState> state(law, "State",
                                    "History of one contact of this law: zeros for a virgin one.");
  state.def(nb::init<>(), "A virgin contact.");
  state.def(
      "copy", [](const State& self) { return State(self); }, "The same history once more.");
  for (std::size_t k = 0; k < Law::state_names.size(); ++k)
    state.def_prop_ro(
        Law::state_names[k], [k](const State& self) { return self.values[k]; },
        "What the contact has reached; 0 for a virgin one.");
  bind_values(
      state,
      [](const State& self) {
        nb::dict values;
        for (std::size_t k = 0; k < self.count; ++k) values[self.names[k]] = self.values[k];
        return values;
      },
      [](State* memory, const nb::dict& values) {
        State* const self = new (memory) State();
        for (std::size_t k = 0; k < self->count; ++k)
          self->values[k] = nb::cast<double>(values[self->names[k]]);
      },
      false);
}

template <class Law>
void bind_law(nb::module_& module, const char* class_name) {
  typedef LawOf<Law> Self;
  const std::string meaning = std::string(Law::source) + ".\n\nRange: " + Law::range + ".";
  const std::string signature = constructor_signature<Law>(), doc = constructor_doc<Law>();
  nb::class_<Self, AnyLaw> law(module, class_name, meaning.c_str());
  bind_state<Law>(law);
  law.def(
      "__init__",
      [](Self* self, const MaterialPair& pair, const nb::kwargs& constants) {
        new (self) Self(pair, parse_constants<Law>(pair, constants));
      },
      "pair"_a, "constants"_a, nb::sig(signature.c_str()), doc.c_str());
  bind_values(
      law,
      [](const Self& self) {
        nb::dict values;
        values["pair"] = self.pair;
        for (const auto& p : parameters_of<Law>) values[p.name] = self.constants.*p.value;
        for (const auto& o : options_of<Law>) values[o.name] = o.choices[self.constants.*o.value];
        return values;
      },
      [](Self* memory, const nb::dict& values) {
        const MaterialPair pair = nb::cast<MaterialPair>(values["pair"]);
        nb::dict constants;
        for (auto [name, value] : values)
          if (nb::cast<std::string>(name) != "pair") constants[name] = value;
        new (memory) Self(pair, parse_constants<Law>(pair, constants));
      },
      true);
  law.def_ro("pair", &Self::pair, "The two bodies.");
  law.def(
      "at_impact",
      [](const Self& self, const nb::object& radius_eff, const nb::object& speed) {
        const Broadcast given(
            {{"radius_eff", radius_eff, positive, "m"}, {"speed", speed, positive, "m/s"}});
        if (!given.shape().empty())
          throw std::invalid_argument(
              "at_impact is for one impact: radius_eff and speed are numbers");
        return self.strengthened(rate_factor(self.pair, given(0, 0), given(1, 0)));
      },
      "radius_eff"_a, "speed"_a,
      nb::sig("def at_impact(self, radius_eff: float, speed: float) -> Self"),
      R"(The law during one impact: its yield strength times `rate_factor`, whatever the rate then.

Args:
    radius_eff: R* [m], positive.
    speed: At which the bodies close in at first touch [m/s], positive.

Returns:
    A law whose pair has no rate coefficient; the same law where it had none.

Raises:
    ValueError: A value is out of range.)");
  law.def_static("parameters", &parameter_table<Law>,
                 nb::sig("def parameters() -> list[dict[str, Any]]"),
                 "The law's own constants: name, unit, default (None: it must be given), per_body "
                 "(of each body, a pair has the larger), lower, upper, meaning.");
  law.def_static("options", &option_table<Law>, nb::sig("def options() -> list[dict[str, Any]]"),
                 "The choices the law leaves open: name, choices, default, meaning.");
  law.attr("name") = Law::name;
  law.attr("source") = Law::source;
  law.attr("range") = Law::range;
  law.attr("rate_dependent") = rate_dependent<Law>;
  law.attr("yields") = yields<Law>;
  law.attr("hardens") = hardens<Law>;
  law.attr("shape") = shape<Law>;
  nb::list names;
  for (const char* name : Law::state_names) names.append(name);
  law.attr("state_names") = nb::tuple(names);
  bind_extras<Law>(law);
}

}  // namespace plastigran
