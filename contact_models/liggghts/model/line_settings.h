// SPDX-License-Identifier: GPL-2.0-or-later
//
// The settings of a pair style's or wall's line as one text: NAME WORD NAME WORD ...
#pragma once

#include <string>

#include "lammps.h"
#include "settings.h"

namespace plastigran {

// Of settings that were registered, and parsed since.
std::string settings_text(Settings& settings);

// Sets what the text names; names that are not registered are left.
void set_from_text(Settings& settings, const std::string& text);

// The same for a model that the engine made without a line, from a restart file: `read` is called
// when the model has its settings.
template <class Model, class Read>
void restore_settings(LAMMPS_NS::LAMMPS* engine, Model& model, const std::string& text, Read read) {
  Settings settings(engine);
  model.registerSettings(settings);
  set_from_text(settings, text);
  read();
}

}  // namespace plastigran
