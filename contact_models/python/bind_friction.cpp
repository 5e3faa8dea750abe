// SPDX-License-Identifier: GPL-2.0-or-later
//
// Python bindings of the tangential laws. Vectors have components x and y in the contact plane.
#include <nanobind/stl/vector.h>

#include <cstring>
#include <functional>
#include <numeric>
#include <stdexcept>
#include <string>

#include "answers.h"
#include "bind.h"
#include "plastigran/friction/incremental.h"
#include "plastigran/friction/partial_slip.h"
#include "values.h"

namespace plastigran {

namespace {

constexpr bool has_rings(const Incremental*) { return false; }
constexpr bool has_rings(const PartialSlip<>*) { return true; }

template <class Law>
struct BoundLaw {
  double coefficient_of_friction;
  int rings;
  Law law() const { return Law(coefficient_of_friction, rings); }
};

// Histories of an array of contacts.
template <class Law>
struct Histories {
  std::vector<std::size_t> shape;
  std::vector<typename Law::State> states;
  explicit Histories(const std::vector<std::size_t>& given)
      : shape(given),
        states(std::accumulate(given.begin(), given.end(), std::size_t(1),
                               std::multiplies<std::size_t>())) {}
};

template <class Law>
Answer<PlaneResponse> respond_to(const BoundLaw<Law>& bound, const nb::object& force,
                                 const nb::object& stiffness, const nb::object& displacement_x,
                                 const nb::object& displacement_y, const nb::object& spin,
                                 Histories<Law>* state) {
  const Broadcast given({{"force", force, not_negative, "N"},
                         {"stiffness", stiffness, not_negative, "N/m"},
                         {"displacement_x", displacement_x, finite, "m"},
                         {"displacement_y", displacement_y, finite, "m"},
                         {"spin", spin, finite, "rad"}});
  if (state && state->shape != given.shape())
    throw std::invalid_argument("state has the shape " +
                                nb::cast<std::string>(nb::repr(nb::cast(state->shape))) +
                                "; it must be the shape of the contacts, " +
                                nb::cast<std::string>(nb::repr(nb::cast(given.shape()))));
  const Law law = bound.law();
  return answer<PlaneResponse>(given, [&](std::size_t i) {
    typename Law::State fresh;
    const TangentialResponse response = law.respond(
        {given(0, i), given(1, i)}, {{given(2, i), given(3, i), 0}, {0, 0, 1}, given(4, i)},
        state ? state->states[i] : fresh);
    return PlaneResponse{response.force.x, response.force.y, response.stored_energy,
                         response.friction_work};
  });
}

template <class Law>
void bind_tangential(nb::module_& module, nb::dict& all, const char* class_name,
                     const char* meaning) {
  typedef BoundLaw<Law> Self;
  typedef Histories<Law> State;
  constexpr bool rings = has_rings(static_cast<const Law*>(nullptr));
  nb::class_<Self> law(module, class_name, meaning);

  nb::class_<State> state(law, "State", "Histories of an array of contacts of this law.");
  state.def(nb::init<const std::vector<std::size_t>&>(), "shape"_a = std::vector<std::size_t>(),
            nb::sig("def __init__(self, shape: Sequence[int] = ()) -> None"),
            "Create an array of histories of this shape, for contacts before first touch.");
  state.def(
      "copy", [](const State& self) { return State(self); }, nb::sig("def copy(self) -> Self"),
      "Return a copy.");
  state.def("__getstate__", [](const State& self) {
    const std::size_t size = self.states.size() * sizeof(typename Law::State);
    return nb::make_tuple(self.shape, nb::bytes(self.states.data(), size));
  });
  state.def("__setstate__", [](State& self, const nb::tuple& values) {
    State restored(nb::cast<std::vector<std::size_t>>(values[0]));
    const nb::bytes history(values[1]);
    if (history.size() != restored.states.size() * sizeof(typename Law::State))
      throw std::invalid_argument(
          "the pickled histories belong to another law; load them with the law that saved them");
    std::memcpy(static_cast<void*>(restored.states.data()), history.c_str(), history.size());
    new (&self) State(std::move(restored));
  });

  const auto construct = [](Self* self, double friction, int number) {
    if (!(friction >= 0 && friction <= 10))
      raise_if(Complaint::about("coefficient_of_friction", friction, "between 0 and 10 [-]"));
    if (!(number >= PartialSlip<>::least_rings && number <= PartialSlip<>::most_rings))
      raise_if(Complaint::about("rings", number, "between 2 and 8"));
    new (self) Self{friction, number};
  };
  if constexpr (rings) {
    law.def("__init__", construct, "coefficient_of_friction"_a,
            "rings"_a = PartialSlip<>::default_rings,
            "Create the law with a coefficient of friction [-] and a number of rings, 2 to 8.");
    law.def_ro("rings", &Self::rings, "Number of rings.");
  } else {
    law.def(
        "__init__",
        [construct](Self* self, double friction) {
          construct(self, friction, PartialSlip<>::default_rings);
        },
        "coefficient_of_friction"_a, "Create the law with a coefficient of friction [-].");
  }
  law.def_ro("coefficient_of_friction", &Self::coefficient_of_friction,
             "Coefficient of friction mu [-].");
  bind_values(
      law,
      [](const Self& self) {
        nb::dict values;
        values["coefficient_of_friction"] = self.coefficient_of_friction;
        if (rings) values["rings"] = self.rings;
        return values;
      },
      [](Self* memory, const nb::dict& values) {
        new (memory) Self{nb::cast<double>(values["coefficient_of_friction"]),
                          rings ? nb::cast<int>(values["rings"]) : 1};
      },
      true);
  law.def("respond", &respond_to<Law>, "force"_a, "stiffness"_a, "displacement_x"_a,
          "displacement_y"_a = 0.0, "spin"_a = 0.0, "state"_a = nb::none(),
          nb::sig("def respond(self, force: ArrayLike, stiffness: ArrayLike, displacement_x: "
                  "ArrayLike, displacement_y: ArrayLike = 0.0, spin: ArrayLike = 0.0, state: State "
                  "| None = None) -> TangentialResponse"),
          R"(Advance one contact, or an array of contacts, by one step.

Args:
    force: Normal force at the end of the step [N], not negative. All arguments except `state` are
        numbers or arrays; arrays broadcast together.
    stiffness: Tangential stiffness of a sticking contact, 8 G* a, with a at the end of the step
        [N/m].
    displacement_x: Component x of the tangential displacement in this step [m]: the displacement of
        the first body's surface relative to the surface of the second body.
    displacement_y: Component y of this displacement [m].
    spin: Rotation of the contact about its normal in this step [rad].
    state: Histories of the contacts, which this call advances. None for contacts before first
        touch.

Returns:
    Tangential force along the displacement and energies: numbers, or arrays of the broadcast shape.

Raises:
    ValueError: A value is out of range, the shapes cannot be broadcast, or `state` does not have
        the broadcast shape.)");
  law.attr("name") = Law::name;
  law.attr("source") = Law::source;
  law.attr("range") = Law::range;
  all[Law::name] = law;
}

}  // namespace

void bind_friction(nb::module_& module) {
  nb::dict all;
  bind_tangential<PartialSlip<>>(
      module, all, "PartialSlip",
      "Tangential contact with partial slip: the edge slips while the middle sticks. Immutable.");
  bind_tangential<Incremental>(
      module, all, "Incremental",
      "Incremental tangential force without slip at the edge of the contact. Immutable.");
  module.attr("TANGENTIAL_LAWS") = all;
}

}  // namespace plastigran
