// SPDX-License-Identifier: GPL-2.0-or-later
//
// Functions that read or change private members of LIGGGHTS.
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

// Registers a setting whose value is one of several words. `chosen` is the index of the word: first
// the default, and the word of the deck after LIGGGHTS has read the line. Null words are omitted.
// LIGGGHTS itself offers only on/off and numbers.
void add_choice(Settings& settings, const std::string& name, const char* const* words,
                std::size_t count, int& chosen);

// All settings of a model line.
const std::map<std::string, Setting*>& settings_by_name(const Settings& settings);

// Whether the value of a setting is a number, which is then returned.
bool is_number(const Setting& setting, double& number);

// Registers a style of fixes.
typedef LAMMPS_NS::Fix* (*FixCreator)(LAMMPS_NS::LAMMPS*, int, char**);
void add_fix_style(LAMMPS_NS::Modify* modify, const std::string& style, FixCreator creator);

// The creator of a style of fixes, null if the style is unknown.
FixCreator fix_creator(LAMMPS_NS::Modify* modify, const std::string& style);

// The global state of a fix in the restart file, null if there is none. Available until the first
// run after the restart.
const char* restarted_state(LAMMPS_NS::Modify* modify, const std::string& id,
                            const std::string& style);

// Discards the state of a fix in the restart file, unless a new fix has read it. Returns whether
// there was a state.
bool discard_restarted(LAMMPS_NS::Modify* modify, const std::string& id, const std::string& style);

// Whether lost particles are an error (thermo_modify lost error).
bool lost_is_error(const LAMMPS_NS::Output* output);

// The step of the next file of the `restart` command.
LAMMPS_NS::bigint next_restart(const LAMMPS_NS::Output* output);

// The name of a property in `fix ID all property/global NAME`.
std::string variable_name(LAMMPS_NS::FixPropertyGlobal* property);

// The number of particles that a fix insert/... has left to insert; the largest int if unlimited.
int particles_to_insert(const LAMMPS_NS::FixInsert* fix);

// The type of a primitive wall and its numbers in the deck.
std::vector<double> geometry(const LAMMPS_NS::PrimitiveWall* wall);

}  // namespace plastigran
