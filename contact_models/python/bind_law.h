// SPDX-License-Identifier: GPL-2.0-or-later
//
// Binds any law to Python: a class named as in C++, its State, and what the tools say about it.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>
#include <nanobind/stl/map.h>
#include <nanobind/stl/optional.h>
#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <algorithm>
#include <map>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

#include "plastigran/shared/contact.h"
#include "plastigran/impact/central_impact.h"
#include "plastigran/impact/validate.h"

namespace plastigran {

namespace nb = nanobind;
using namespace nb::literals;

typedef nb::ndarray<const double, nb::ndim<1>, nb::c_contig, nb::device::cpu> Input;
typedef nb::ndarray<nb::numpy, double, nb::ndim<1>> Output;

inline void raise_if(const Complaint& complaint, const std::string& about = "") {
  if (!complaint.empty()) throw std::invalid_argument(about + complaint.text());
}

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
typename Law::Parameters parse_constants(const MaterialPair& pair, const nb::kwargs& given) {
  typename Law::Parameters constants;
  for (auto item : given) {
    const std::string name = nb::cast<std::string>(item.first);
    const auto option = std::find_if(Law::options.begin(), Law::options.end(),
                                     [&](const auto& candidate) { return name == candidate.name; });
    if (option != Law::options.end()) {
      const std::string word = nb::cast<std::string>(nb::str(item.second));
      constants.*(option->value) = parse_choice(*option, word);
      continue;
    }
    const auto known = std::find_if(Law::parameters.begin(), Law::parameters.end(),
                                    [&](const auto& p) { return name == p.name; });
    if (known == Law::parameters.end()) {
      std::string text = std::string(Law::name) + " has no constant '" + name + "'; it takes";
      for (const auto& p : Law::parameters) text += std::string(" ") + p.name;
      for (const auto& o : Law::options) text += std::string(" ") + o.name;
      throw std::invalid_argument(text +
                                  (Law::parameters.empty() && Law::options.empty() ? " none" : ""));
    }
    constants.*(known->value) = nb::cast<double>(item.second);
  }
  raise_if(validate<Law>(pair, constants), std::string(Law::name) + ": ");
  return constants;
}

inline void require_positive(const char* name, double value, const char* unit) {
  if (!(value > 0 && std::isfinite(value)))
    raise_if(Complaint::about(name, value, std::string("positive and finite [") + unit + "]"));
}

// Responses along a path of overlaps and their rates, as arrays of the path's length.
template <class Law>
std::map<std::string, Output> follow(const Law& law, double radius_eff, Input overlap,
                                     typename Law::State& state,
                                     std::optional<Input> overlap_rate) {
  require_positive("radius_eff", radius_eff, "m");
  const std::size_t n = overlap.shape(0);
  if (overlap_rate && overlap_rate->shape(0) != n)
    raise_if(Complaint::about("length of overlap_rate", double(overlap_rate->shape(0)),
                              std::to_string(n) + ", that of overlap"));
  constexpr int count = 5;
  static constexpr const char* names[count] = {"force", "contact_radius", "elastic_energy",
                                               "plastic_work", "viscous_force"};
  static constexpr double Response::*members[count] = {
      &Response::force, &Response::contact_radius, &Response::elastic_energy,
      &Response::plastic_work, &Response::viscous_force};
  double* columns[count];
  std::map<std::string, Output> table;
  for (int c = 0; c < count; ++c) {
    columns[c] = new double[n];
    nb::capsule owner(columns[c], [](void* data) noexcept { delete[] static_cast<double*>(data); });
    table.emplace(names[c], Output(columns[c], {n}, owner));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const double rate = overlap_rate ? (*overlap_rate)(i) : 0;
    const Response response = respond(law, radius_eff, overlap(i), state, rate);
    for (int c = 0; c < count; ++c) columns[c][i] = response.*members[c];
  }
  return table;
}

// Laws with more to say (a force-driven form, an iteration count) say it in a specialisation.
template <class Law>
void bind_extras(nb::class_<Law>&) {}

template <class Law>
void bind_law(nb::module_& module, const char* class_name) {
  typedef typename Law::State State;
  nb::class_<Law> law(module, class_name);

  nb::class_<State> state(law, "State", "History of one contact: zeros for a virgin one.");
  state.def(nb::init<>());
  state.def("copy", [](const State& self) { return State(self); });
  state.def(
      "values",
      [](const State& self) {
        std::vector<double> values(Law::state_names.size());
        std::copy_n(reinterpret_cast<const double*>(&self), values.size(), values.begin());
        return values;
      },
      "The state as a list of floats, in the order of `state_names`.");

  law.def(
      "__init__",
      [](Law* self, const MaterialPair& pair, const nb::kwargs& constants) {
        new (self) Law(pair, parse_constants<Law>(pair, constants));
      },
      "pair"_a, "constants"_a,
      "A law between two bodies. Keyword arguments are the law's own constants (see "
      "`parameters()`).\n\nRaises ValueError naming the constant, its value and allowed range.");
  law.def(
      "respond",
      [](const Law& self, double radius_eff, double overlap, State& history, double overlap_rate) {
        require_positive("radius_eff", radius_eff, "m");
        return respond(self, radius_eff, overlap, history, overlap_rate);
      },
      "radius_eff"_a, "overlap"_a, "state"_a, "overlap_rate"_a = 0.0,
      "Response at one overlap [m]; `state` moves on when a new extreme is reached. The rate of "
      "overlap [m/s, closing positive] matters to a `rate_dependent` law only.");
  law.def("follow", &follow<Law>, "radius_eff"_a, "overlap"_a, "state"_a,
          "overlap_rate"_a = nb::none(),
          "Responses along a path of overlaps, (N,) float64 [m]: a dict of (N,) arrays force [N], "
          "contact_radius [m], elastic_energy [J], plastic_work [J], viscous_force [N]. `state` "
          "moves along. `overlap_rate`, (N,) float64 [m/s, closing positive], none for zero, "
          "matters to a `rate_dependent` law only.\n\nRaises ValueError when the lengths differ.");
  law.def(
      "central_impact",
      [](const Law& self, double radius_eff, double mass_eff, double speed) {
        require_positive("radius_eff", radius_eff, "m");
        require_positive("mass_eff", mass_eff, "kg");
        require_positive("speed", speed, "m/s");
        return central_impact(self, radius_eff, mass_eff, speed);
      },
      "radius_eff"_a, "mass_eff"_a, "speed"_a,
      "Central impact at a relative speed [m/s], from the law's energies, or from the equation of "
      "motion when it is `rate_dependent`.");
  law.def(
      "recommended_time_step",
      [](const Law& self, double radius_eff, double mass_eff, double speed) {
        require_positive("radius_eff", radius_eff, "m");
        require_positive("mass_eff", mass_eff, "kg");
        require_positive("speed", speed, "m/s");
        return recommended_time_step(self, radius_eff, mass_eff, speed);
      },
      "radius_eff"_a, "mass_eff"_a, "speed"_a,
      "Time step [s] that resolves the rebound of such an impact to 1e-3 in restitution.");
  law.def_static(
      "parameters",
      [] {
        nb::list table;
        const typename Law::Parameters defaults;
        for (const auto& p : Law::parameters) {
          nb::dict row;
          row["name"] = p.name;
          row["unit"] = p.unit;
          const double value = defaults.*p.value;
          row["default"] =
              std::isnan(value) ? nb::object(nb::none()) : nb::object(nb::float_(value));
          row["per_body"] = p.per_body;
          row["lower"] = p.lower;
          row["upper"] = p.upper;
          row["meaning"] = p.meaning;
          table.append(row);
        }
        return table;
      },
      "The law's own constants: name, unit, default (None: it must be given), "
      "per_body (of each body, a pair has the larger), range, meaning.");
  law.def_static(
      "options",
      [] {
        nb::list table;
        const typename Law::Parameters defaults;
        for (const auto& o : Law::options) {
          nb::list choices;
          for (const char* choice : o.choices)
            if (choice) choices.append(choice);
          nb::dict row;
          row["name"] = o.name;
          row["choices"] = choices;
          row["default"] = o.choices[defaults.*o.value];
          row["meaning"] = o.meaning;
          table.append(row);
        }
        return table;
      },
      "The choices the law leaves open: name, choices, default, meaning.");
  law.attr("name") = Law::name;
  law.attr("source") = Law::source;
  law.attr("range") = Law::range;
  law.attr("rate_dependent") = IsRateDependent<Law>::value;
  law.attr("yields") = Yields<Law>::value;
  law.attr("shape") = shape<Law>;
  nb::list names;
  for (const char* name : Law::state_names) names.append(name);
  law.attr("state_names") = nb::tuple(names);
  bind_extras(law);
}

}  // namespace plastigran
