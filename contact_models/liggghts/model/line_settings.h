// SPDX-License-Identifier: GPL-2.0-or-later
//
// Conversion of the settings of a pair style or wall to text (NAME WORD NAME WORD ...), and back.
#pragma once

#include <string>

#include "lammps.h"
#include "settings.h"

namespace plastigran {

// Returns the text of settings that LIGGGHTS has read.
std::string settings_text(Settings& settings);

// Sets the registered settings that the text names.
void set_from_text(Settings& settings, const std::string& text);

// Sets the settings of a model that LIGGGHTS made from a restart file, and then calls `read`.
template <class Model, class Read>
void restore_settings(LAMMPS_NS::LAMMPS* engine, Model& model, const std::string& text, Read read) {
  Settings settings(engine);
  model.registerSettings(settings);
  set_from_text(settings, text);
  read();
}

}  // namespace plastigran
