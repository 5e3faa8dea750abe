// SPDX-License-Identifier: GPL-2.0-or-later
//
// Functions that bind those parts of the Python module that all laws have in common.
#pragma once

#include "any_law.h"

namespace plastigran {

void bind_bodies(nb::module_& module);    // binds Body, MaterialPair and functions of them
void bind_answers(nb::module_& module);   // binds Response and ImpactOutcome
void bind_laws(nb::module_& module);      // binds the base classes Law and ContactState
void bind_friction(nb::module_& module);  // binds the tangential laws

}  // namespace plastigran
