// SPDX-License-Identifier: GPL-2.0-or-later
//
// What the adapter must reach in the engine and the engine keeps private.
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

// Adds a setting of the model line whose value is one of several words. `chosen` is the index of
// the word: the default now, the deck's word once the line is read. The engine's Settings offers
// models only on/off and numbers. Words that are null are left out.
void add_choice(Settings& settings, const std::string& name, const char* const* words,
                std::size_t count, int& chosen);

// All settings of a model line.
const std::map<std::string, Setting*>& settings_by_name(const Settings& settings);

// Whether the value of a setting is a number, and which.
bool is_number(const Setting& setting, double& number);

// Adds a style of fixes. A plugin has no other way to do that.
typedef LAMMPS_NS::Fix* (*FixCreator)(LAMMPS_NS::LAMMPS*, int, char**);
void add_fix_style(LAMMPS_NS::Modify* modify, const std::string& style, FixCreator creator);

// The creator of a style of fixes; null where there is none.
FixCreator fix_creator(LAMMPS_NS::Modify* modify, const std::string& style);

// What a restart file holds of a fix for all particles together, until the first run after it; null
// where it holds nothing.
const char* restarted_state(LAMMPS_NS::Modify* modify, const std::string& id,
                            const std::string& style);

// Discards what a restart file holds of a fix, as long as no new fix has taken it. Returns whether
// there was anything.
bool discard_restarted(LAMMPS_NS::Modify* modify, const std::string& id, const std::string& style);

// Whether lost particles are an error (thermo_modify lost error).
bool lost_is_error(const LAMMPS_NS::Output* output);

// The step of the next file of the `restart` command.
LAMMPS_NS::bigint next_restart(const LAMMPS_NS::Output* output);

// The name by which models ask for a property/global.
std::string variable_name(LAMMPS_NS::FixPropertyGlobal* property);

// How many particles a fix insert/... is still to insert; the largest int where it sets no number.
int particles_to_insert(const LAMMPS_NS::FixInsert* fix);

// What a primitive wall is and where: its kind's number, and its numbers in the deck.
std::vector<double> geometry(const LAMMPS_NS::PrimitiveWall* wall);

}  // namespace plastigran
