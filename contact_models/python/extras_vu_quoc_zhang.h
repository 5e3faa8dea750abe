// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "bind_law.h"
#include "plastigran/laws/vu_quoc_zhang.h"

namespace plastigran {

template <>
inline void bind_extras(nb::class_<VuQuocZhang>& law) {
  law.def(
      "overlap",
      [](const VuQuocZhang& self, double radius_eff, double force, VuQuocZhang::State& state) {
        require_positive("radius_eff", radius_eff, "m");
        if (!(force >= 0)) raise_if(Complaint::about("force", force, "zero or positive [N]"));
        return self.overlap(radius_eff, force, state);
      },
      "radius_eff"_a, "force"_a, "state"_a,
      "The force-driven form of the law (Vu-Quoc, Zhang & Lesburg 2000): overlap [m] at a force "
      "[N].");
  law.def("yield_force", &VuQuocZhang::yield_force, "radius_eff"_a, "P_Y [N].");
  law.def(
      "elastic_radius",
      [](const VuQuocZhang& self, double overlap_ratio, double start) {
        int iterations = 0;
        const double root = self.elastic_radius(overlap_ratio, start, iterations);
        return nb::make_tuple(root, iterations);
      },
      "overlap_ratio"_a, "start"_a,
      "Root of the virgin curve and the Newton iterations it took: (a_e/a_Y, int), from "
      "overlap/overlap_Y >= 1 and a start in [1, root].");
}

}  // namespace plastigran
