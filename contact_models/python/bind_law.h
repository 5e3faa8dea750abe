// SPDX-License-Identifier: GPL-2.0-or-later
//
// Binds one law to Python: a class with the name of the C++ class, its State, constants and
// options.
#pragma once

#include <nanobind/stl/string.h>
#include <nanobind/stl/vector.h>

#include <stdexcept>
#include <string>

#include "any_law.h"
#include "law_constants.h"
#include "plastigran/shared/rate_factor.h"
#include "plastigran/tables/adhesive.h"
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
  const char* const* state_names() const override { return Law::state_names.data(); }
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
  double pull_off_distance(double radius_eff) const override {
    return plastigran::pull_off_distance(law, radius_eff);
  }
  double pull_off_force(double radius_eff, double overlap, const double* values) const override {
    typename Law::State state;
    std::memcpy(&state, values, Law::state_names.size() * sizeof(double));
    return plastigran::pull_off_force(law, radius_eff, overlap, state);
  }
  double recommended_timestep(double radius_eff, double mass_eff, double speed,
                              const ImpactOutcome& impact) const override {
    const double factor = rate_factor(pair, radius_eff, speed);
    return plastigran::recommended_timestep(factor == 1 ? law : strengthened(factor).law,
                                            radius_eff, mass_eff, speed, impact);
  }
  LawOf strengthened(double factor) const {
    return LawOf(plastigran::strengthened(pair, factor),
                 strengthened_constants<Law>(constants, factor));
  }
};

// Does nothing by default. Specializations bind functions that only one law has, such as the
// overlap at a given force.
template <class Law>
void bind_extras(nb::class_<LawOf<Law>, AnyLaw>&) {}

template <class Law>
void bind_state(nb::class_<LawOf<Law>, AnyLaw>& law) {
  typedef StateOf<Law> State;
  nb::class_<State, AnyState> state(
      law, "State", "History of one contact of this law: zeros before first touch.");
  state.def(nb::init<>(), "Create the history of a contact before first touch.");
  state.def(
      "copy", [](const State& self) { return State(self); }, "Return a copy of this history.");
  for (std::size_t k = 0; k < Law::state_names.size(); ++k)
    state.def_prop_ro(
        Law::state_names[k], [k](const State& self) { return self.values[k]; },
        "State variable of the contact; 0 before first touch.");
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
  law.def_ro("pair", &Self::pair, "Combined constants of the two bodies.");
  law.def(
      "at_impact",
      [](const Self& self, const nb::object& radius_eff, const nb::object& speed) {
        const Broadcast given(
            {{"radius_eff", radius_eff, positive, "m"}, {"speed", speed, positive, "m/s"}});
        if (!given.shape().empty())
          throw std::invalid_argument(
              "at_impact describes one impact: radius_eff and speed must be numbers, not arrays");
        return self.strengthened(rate_factor(self.pair, given(0, 0), given(1, 0)));
      },
      "radius_eff"_a, "speed"_a,
      nb::sig("def at_impact(self, radius_eff: float, speed: float) -> Self"),
      R"(Return the law for one impact, with the yield strength multiplied by `rate_factor`.

Args:
    radius_eff: R* [m], positive.
    speed: Closing speed at first touch [m/s], positive.

Returns:
    A law whose rate coefficient is 0. It equals this law if the rate coefficient of this law is 0.

Raises:
    ValueError: A value is out of range, or an argument is an array.)");
  law.def_static(
      "parameters", &parameter_table<Law>, nb::sig("def parameters() -> list[dict[str, Any]]"),
      "Return one dict per constant of the law: name, unit, default (None: required), per_body "
      "(whether each body has a value; the pair uses the larger), lower, upper (bounds), meaning.");
  law.def_static("options", &option_table<Law>, nb::sig("def options() -> list[dict[str, Any]]"),
                 "Return one dict per option of the law: name, choices, default, meaning.");
  law.attr("name") = Law::name;
  law.attr("source") = Law::source;
  law.attr("range") = Law::range;
  law.attr("rate_dependent") = rate_dependent<Law>;
  law.attr("yields") = yields<Law>;
  law.attr("elastic_first") = elastic_first<Law>;
  law.attr("adhesive") = adhesive<Law>;
  law.attr("hardens") = hardens<Law>;
  law.attr("indentation") = indentation<Law>;
  law.attr("shape") = shape<Law>;
  nb::list names;
  for (const char* name : Law::state_names) names.append(name);
  law.attr("state_names") = nb::tuple(names);
  bind_extras<Law>(law);
}

// Binds the variant of a law with adhesion, if the law supports adhesion. Adds the class to `all`.
template <class Law>
void bind_adhesive_law(nb::module_& module, nb::dict& all, const char* class_name) {
  if constexpr (takes_adhesion<Law>) {
    bind_law<Adhesive<Law>>(module, class_name);
    all[Law::name] = module.attr(class_name);
  }
}

}  // namespace plastigran
