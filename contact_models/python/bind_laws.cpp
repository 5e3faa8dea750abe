// SPDX-License-Identifier: GPL-2.0-or-later
//
// Python bindings of the methods that all laws have, and of contact histories.
#include <nanobind/stl/vector.h>

#include <cmath>
#include <numeric>
#include <sstream>
#include <stdexcept>

#include "answers.h"
#include "bind.h"
#include "values.h"

namespace plastigran {

States::States(const AnyLaw& law, const nb::object& given, std::vector<std::size_t> shape) {
  const std::size_t count =
      std::accumulate(shape.begin(), shape.end(), std::size_t(1), std::multiplies<std::size_t>());
  if (given.is_none()) {
    untouched_.resize(count);
    return;
  }
  AnyState* one;
  if (count == 1 && nb::try_cast(given, one) && is_state_of(*one, law)) {
    given_.push_back(one);
    return;
  }
  const nb::module_ numpy = nb::module_::import_("numpy");
  const nb::object states = numpy.attr("asarray")(given, "dtype"_a = "object");
  for (nb::handle state : states.attr("flat")) {
    if (!nb::isinstance<AnyState>(state) || !is_state_of(nb::cast<AnyState&>(state), law))
      throw nb::type_error((std::string("state is ") + nb::cast<std::string>(nb::repr(state)) +
                            "; it must be a " + law.name() + " State, or an array of them")
                               .c_str());
    given_.push_back(&nb::cast<AnyState&>(state));
  }
  const std::vector<std::size_t> its_shape =
      nb::cast<std::vector<std::size_t>>(states.attr("shape"));
  if (given_.size() != count || (!its_shape.empty() && its_shape != shape))
    throw std::invalid_argument("state has shape " +
                                nb::cast<std::string>(nb::repr(states.attr("shape"))) +
                                "; it must contain one State per contact, with the shape " +
                                nb::cast<std::string>(nb::repr(nb::tuple(nb::cast(shape)))));
  kept_ = states;
}

namespace {

Broadcast impact_arguments(const nb::object& radius_eff, const nb::object& mass_eff,
                           const nb::object& speed) {
  return Broadcast({{"radius_eff", radius_eff, positive, "m"},
                    {"mass_eff", mass_eff, positive, "kg"},
                    {"speed", speed, positive, "m/s"}});
}

// Returns the outcome of an impact. Throws an exception if the largest overlap is too small or too
// large for the computation.
ImpactOutcome impact_of(const AnyLaw& law, double radius_eff, double mass_eff, double speed) {
  constexpr double least = 1e-30, largest = 1e6;  // overlap/R* [-]
  const ImpactOutcome impact = law.central_impact(radius_eff, mass_eff, speed);
  const double ratio = impact.overlap_max / radius_eff;
  if (ratio >= least && ratio < largest && std::isfinite(impact.coefficient_of_restitution))
    return impact;
  std::ostringstream text;
  text << "speed is " << speed << " m/s, mass_eff " << mass_eff << " kg and radius_eff "
       << radius_eff << " m; an impact is computed only if its largest overlap is between " << least
       << " and " << largest << " times radius_eff. Check the units";
  throw std::invalid_argument(text.str());
}

Answer<ImpactOutcome> central_impact_of(const AnyLaw& law, const nb::object& radius_eff,
                                        const nb::object& mass_eff, const nb::object& speed) {
  const Broadcast given = impact_arguments(radius_eff, mass_eff, speed);
  return answer<ImpactOutcome>(
      given, [&](std::size_t i) { return impact_of(law, given(0, i), given(1, i), given(2, i)); });
}

nb::object pull_off_force_of(const AnyLaw& law, const nb::object& radius_eff,
                             const nb::object& overlap, const nb::object& state) {
  const Broadcast given(
      {{"radius_eff", radius_eff, positive, "m"}, {"overlap", overlap, finite, "m"}});
  States states(law, state, given.shape());
  return column<double>(given, [&](std::size_t i) {
    return law.pull_off_force(given(0, i), given(1, i), states[i]);
  });
}

nb::object pull_off_distance_of(const AnyLaw& law, const nb::object& radius_eff) {
  const Broadcast given({{"radius_eff", radius_eff, positive, "m"}});
  return column<double>(given, [&](std::size_t i) { return law.pull_off_distance(given(0, i)); });
}

nb::object recommended_timestep_of(const AnyLaw& law, const nb::object& radius_eff,
                                   const nb::object& mass_eff, const nb::object& speed) {
  const Broadcast given = impact_arguments(radius_eff, mass_eff, speed);
  return column<double>(given, [&](std::size_t i) {
    return law.recommended_timestep(given(0, i), given(1, i), given(2, i),
                                    impact_of(law, given(0, i), given(1, i), given(2, i)));
  });
}

Answer<Response> respond_to(const AnyLaw& law, const nb::object& radius_eff,
                            const nb::object& overlap, const nb::object& state,
                            const nb::object& overlap_rate) {
  const Broadcast given({{"radius_eff", radius_eff, positive, "m"},
                         {"overlap", overlap, finite, "m"},
                         {"overlap_rate", overlap_rate, finite, "m/s"}});
  States states(law, state, given.shape());
  return answer<Response>(given, [&](std::size_t i) {
    return law.respond(given(0, i), given(1, i), states[i], given(2, i));
  });
}

nb::dict follow(const AnyLaw& law, const nb::object& radius_eff, const nb::object& overlap,
                const nb::object& state, const nb::object& overlap_rate) {
  const Broadcast given(
      {{"radius_eff", radius_eff, positive, "m", true},
       {"overlap", overlap, finite, "m"},
       {"overlap_rate", overlap_rate.is_none() ? nb::object(nb::float_(0.0)) : overlap_rate, finite,
        "m/s"}});
  std::vector<std::size_t> paths = given.shape();
  std::size_t points = 1;
  if (!paths.empty()) points = paths.back(), paths.pop_back();
  States states(law, state, paths);
  const Answer<Response> responses = answer<Response>(given, [&](std::size_t i) {
    return law.respond(given(0, i), given(1, i), states[i / points], given(2, i));
  });
  nb::dict table;
  for (std::size_t k = 0; k < responses.values.size(); ++k)
    table[AnswerFields<Response>::all[k].name] = responses.values[k];
  return table;
}

}  // namespace

void bind_laws(nb::module_& module) {
  nb::class_<AnyState>(module, "ContactState",
                       "History of one contact, created by `State()` of a law: zeros before first "
                       "touch. `respond` and `follow` update it.")
      .def(
          "values",
          [](const AnyState& self) {
            return std::vector<double>(self.values.begin(), self.values.begin() + self.count);
          },
          "Values of the state variables as a list, in the order of `state_names` of the law.");

  nb::class_<AnyLaw> law(
      module, "Law",
      "Contact law between two bodies: base class of the laws in `LAWS`. Immutable.");
  law.def_prop_ro(
      "overlap_range", &AnyLaw::overlap_range,
      "Largest overlap/R* for which the law is valid [-]. `range` states the validity in words.");
  law.def("respond", &respond_to, "radius_eff"_a, "overlap"_a, "state"_a = nb::none(),
          "overlap_rate"_a = 0.0,
          nb::sig("def respond(self, radius_eff: ArrayLike, overlap: ArrayLike, state: "
                  "ContactState | Sequence[ContactState] | NDArray[Any] | None = None, "
                  "overlap_rate: ArrayLike = 0.0) -> "
                  "Response"),
          R"(Return the response of one contact or of an array of contacts.

The law uses the yield strength of the `pair` at the reference rate. For the yield strength at the
strain rate of an impact, use the law that `at_impact` returns.

Args:
    radius_eff: R* [m], positive. All arguments except `state` are numbers or arrays; arrays
        broadcast together.
    overlap: Overlap [m].
    state: History of the contact; an array of histories with the broadcast shape for an array of
        contacts. The call updates it if the overlap reaches a new extreme. None for first loading.
    overlap_rate: Overlap rate [m/s], positive while closing; used only by `rate_dependent` laws.

Returns:
    Force, contact radius and energies: numbers, or arrays of the broadcast shape.

Raises:
    ValueError: A value is out of range (the message names the argument, index and range), or
        the shapes cannot be broadcast.
    TypeError: `state` belongs to another law.)");
  law.def("follow", &follow, "radius_eff"_a, "overlap"_a, "state"_a = nb::none(),
          "overlap_rate"_a = nb::none(),
          nb::sig("def follow(self, radius_eff: ArrayLike, overlap: ArrayLike, state: "
                  "ContactState | Sequence[ContactState] | NDArray[Any] | None = None, "
                  "overlap_rate: ArrayLike | None = "
                  "None) -> dict[str, Numbers]"),
          R"(Return the responses along a path of overlaps, or along an array of paths.

The law uses the yield strength of the `pair` at the reference rate. For the yield strength at the
strain rate of an impact, use the law that `at_impact` returns.

Args:
    radius_eff: R* [m], positive: a number, or an array of shape (...) with one value per path.
    overlap: Overlaps [m], shape (..., N). The last axis is the path of one contact.
    state: History of the contact at the start of the path; the call updates it. An array of shape
        (...) for several paths. None for first loading.
    overlap_rate: Overlap rate [m/s], positive while closing, broadcast with `overlap`; None for
        zero. Used only by `rate_dependent` laws.

Returns:
    Dict of arrays of shape (..., N): force [N], contact_radius [m], elastic_energy [J],
    plastic_work [J], viscous_force [N], surface_energy [J]. pandas.DataFrame accepts the dict of a
    single path.

Raises:
    ValueError: A value is out of range (the message names the argument, index and range), or
        the shapes cannot be broadcast.
    TypeError: `state` belongs to another law.)");
  law.def("central_impact", &central_impact_of, "radius_eff"_a, "mass_eff"_a, "speed"_a,
          nb::sig("def central_impact(self, radius_eff: ArrayLike, mass_eff: ArrayLike, speed: "
                  "ArrayLike) -> ImpactOutcome"),
          R"(Compute the central impact of two bodies.

The outcome follows from the energies of the law. For a `rate_dependent` law, it follows from the
equation of motion. The yield strength is multiplied by `rate_factor`.

Args:
    radius_eff: R* [m], positive. All arguments are numbers or arrays; arrays broadcast together.
    mass_eff: m* [kg], positive.
    speed: Relative speed [m/s], positive.

Returns:
    Outcome of the impact: numbers, or arrays of the broadcast shape.

Raises:
    ValueError: A value is out of range (the message names the argument, index and range), or
        the shapes cannot be broadcast.)");
  law.def(
      "pull_off_distance", &pull_off_distance_of, "radius_eff"_a,
      nb::sig("def pull_off_distance(self, radius_eff: ArrayLike) -> Numbers"),
      R"(Return the largest separation at which bodies may be in contact [m]; 0 without adhesion.

Args:
    radius_eff: R* [m], positive: a number or an array.

Returns:
    A number, or an array of the shape of `radius_eff`.

Raises:
    ValueError: A radius is out of range; the message gives its value, index and range.)");
  law.def("pull_off_force", &pull_off_force_of, "radius_eff"_a, "overlap"_a = 0.0,
          "state"_a = nb::none(),
          nb::sig("def pull_off_force(self, radius_eff: ArrayLike, overlap: ArrayLike = 0.0, "
                  "state: ContactState | Sequence[ContactState] | NDArray[Any] | None = None) -> "
                  "Numbers"),
          R"(Return the largest attractive force of a contact with this history [N].

This pull-off force is 0 for laws without adhesion.

Args:
    radius_eff: R* [m], positive. `radius_eff` and `overlap` are numbers or arrays; arrays broadcast
        together.
    overlap: Overlap [m], used by laws whose adhesive limit is a function of the overlap.
    state: History of the contact; for an array of contacts an array of histories with the broadcast
        shape. None for a contact before yield.

Returns:
    A number, or an array of the broadcast shape.

Raises:
    ValueError: A value is out of range (the message names the argument, index and range), or
        the shapes cannot be broadcast.
    TypeError: `state` belongs to another law.)");
  law.def(
      "recommended_timestep", &recommended_timestep_of, "radius_eff"_a, "mass_eff"_a, "speed"_a,
      nb::sig("def recommended_timestep(self, radius_eff: ArrayLike, mass_eff: ArrayLike, speed: "
              "ArrayLike) -> Numbers"),
      R"(Return the time step [s] that limits the restitution error of an impact to about 1e-3.

The step is a tenth of sqrt(m*/k), with the largest stiffness k during the impact. It is shorter
if the force depends on the overlap rate, or if the force jumps.

Args:
    radius_eff: R* [m], positive. All arguments are numbers or arrays; arrays broadcast together.
    mass_eff: m* [kg], positive.
    speed: Relative speed [m/s], positive.

Returns:
    A number, or an array of the broadcast shape.

Raises:
    ValueError: A value is out of range (the message names the argument, index and range), or
        the shapes cannot be broadcast.)");
}

}  // namespace plastigran
