// SPDX-License-Identifier: GPL-2.0-or-later
//
// The parts of the Python module that are the same for every law.
#pragma once

#include "any_law.h"

namespace plastigran {

void bind_bodies(nb::module_& module);    // Body, MaterialPair and what is made of them
void bind_answers(nb::module_& module);   // Response, ImpactOutcome
void bind_laws(nb::module_& module);      // Law and ContactState, the bases of every law's own
void bind_friction(nb::module_& module);  // the tangential laws

}  // namespace plastigran
