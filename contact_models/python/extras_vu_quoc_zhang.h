// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "bind_law.h"
#include "plastigran/laws/vu_quoc_zhang.h"

namespace plastigran {

template <>
inline void bind_extras(nb::class_<LawOf<VuQuocZhang>, AnyLaw>& law) {
  law.def(
      "overlap",
      [](const LawOf<VuQuocZhang>& self, const nb::object& radius_eff, const nb::object& force,
         const nb::object& state) {
        const Broadcast given(
            {{"radius_eff", radius_eff, positive, "m"}, {"force", force, not_negative, "N"}});
        States states(self, state, given.shape());
        return column<double>(given, [&](std::size_t i) {
          VuQuocZhang::State history{*states[i]};
          const double overlap = self.law.overlap(given(0, i), given(1, i), history);
          *states[i] = history.elastic_radius_max;
          return overlap;
        });
      },
      "radius_eff"_a, "force"_a, "state"_a = nb::none(),
      nb::sig("def overlap(self, radius_eff: ArrayLike, force: ArrayLike, state: "
              "ContactState | Sequence[ContactState] | NDArray[Any] | None = None) -> Numbers"),
      R"(Return the overlap at a given force [m]: the force-driven form of the law.

Args:
    radius_eff: R* [m], positive. `radius_eff` and `force` are numbers or arrays; arrays broadcast
        together.
    force: Normal force [N], not negative.
    state: History of the contact, as in `respond`.

Returns:
    A number, or an array of the broadcast shape.

Raises:
    ValueError: A value is out of range, or the shapes cannot be broadcast.
    TypeError: `state` belongs to another law.

Source: Vu-Quoc, Zhang & Lesburg 2000, J. Appl. Mech. 67:363.)");
  law.def(
      "yield_force",
      [](const LawOf<VuQuocZhang>& self, const nb::object& radius_eff) {
        const Broadcast given({{"radius_eff", radius_eff, positive, "m"}});
        return column<double>(given,
                              [&](std::size_t i) { return self.law.yield_force(given(0, i)); });
      },
      "radius_eff"_a, nb::sig("def yield_force(self, radius_eff: ArrayLike) -> Numbers"),
      R"(Return the force P_Y at first yield [N].

Args:
    radius_eff: R* [m], positive: a number or an array of any shape.

Raises:
    ValueError: A value is out of range.)");
}

}  // namespace plastigran
