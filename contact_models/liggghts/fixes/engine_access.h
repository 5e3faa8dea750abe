// SPDX-License-Identifier: GPL-2.0-or-later
//
// Functions that read or change private data of LIGGGHTS' classes.
#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <vector>

#include "lmptype.h"

class Setting;
class Settings;

namespace LAMMPS_NS {
class Fix;
class FixInsert;
class FixPropertyGlobal;
class LAMMPS;
class Modify;
class Output;
class PrimitiveWall;
}  // namespace LAMMPS_NS

namespace plastigran {

// Registers a setting whose value is one of several words, because LIGGGHTS itself offers only
// on/off and numbers. `chosen` contains the index of the default word. When LIGGGHTS has read the
// deck line, `chosen` contains the index of the word in the deck. Null words are omitted.
void add_choice(Settings& settings, const std::string& name, const char* const* words,
                std::size_t count, int& chosen);

// Returns all settings of a pair_style or wall line by name.
const std::map<std::string, Setting*>& settings_by_name(const Settings& settings);

// Returns whether the value of a setting is a number, and if so stores it in `number`.
bool is_number(const Setting& setting, double& number);

// Registers a fix style, so that decks and the plugin can create fixes of this style.
typedef LAMMPS_NS::Fix* (*FixCreator)(LAMMPS_NS::LAMMPS*, int, char**);
void add_fix_style(LAMMPS_NS::Modify* modify, const std::string& style, FixCreator creator);

// Returns the global state of a fix from the restart file, or null if the file has none. The state
// is available until the first run after the restart.
const char* restarted_state(LAMMPS_NS::Modify* modify, const std::string& id,
                            const std::string& style);

// Discards the state of a fix that was read from the restart file, unless a new fix has used it.
// Returns whether a state was discarded.
bool discard_restarted(LAMMPS_NS::Modify* modify, const std::string& id, const std::string& style);

// Returns whether lost particles are an error (thermo_modify lost error).
bool lost_is_error(const LAMMPS_NS::Output* output);

// Returns the time step at which the `restart` command writes its next file.
LAMMPS_NS::bigint next_restart(const LAMMPS_NS::Output* output);

// Returns NAME of a property defined by `fix ID all property/global NAME`.
std::string variable_name(LAMMPS_NS::FixPropertyGlobal* property);

// Returns the number of particles that a fix insert/... will still insert; the largest int if
// unlimited.
int particles_to_insert(const LAMMPS_NS::FixInsert* fix);

// Returns the type of a primitive wall, followed by its parameters in the deck.
std::vector<double> geometry(const LAMMPS_NS::PrimitiveWall* wall);

}  // namespace plastigran
