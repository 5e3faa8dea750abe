// SPDX-License-Identifier: GPL-2.0-or-later
//
// Text form of the deck lines that define contacts (pair_style and fix wall/gran). HistoryKeeper
// compares these lines between runs and stores them in restart files.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

namespace LAMMPS_NS {
class LAMMPS;
}

namespace plastigran {

struct ContactLine {
  std::string models;                  // names of the law, its options and the other contact models
  std::string settings;                // all settings of the line: NAME WORD NAME WORD ...
  std::vector<std::string> histories;  // IDs of LIGGGHTS' fixes that store the contact histories
  // Constants of the law, one text line per pair of atom types; empty if contacts have no history.
  std::string constants;
  std::string report;          // constants to print in the log; empty if they were printed before
  std::uint64_t position = 0;  // hash of a primitive wall's geometry; 0 for other lines
};

// Contact lines by owner: "pair_style" or "fix ID".
typedef std::map<std::string, ContactLine> ContactLines;

constexpr char pair_owner[] = "pair_style";

// Converts contact lines to the text in a restart file, and back. The text omits walls without
// contact histories. For a pair style without histories, the text contains the settings, but no
// models.
std::string restart_text(const ContactLines& lines);
ContactLines read_restart_text(const std::string& text);

// Stops the run, because the restart file has contacts of the models `restarted`, but the deck line
// of `owner` (the pair style or a wall) has `models`.
[[noreturn]] void refuse_other_models(LAMMPS_NS::LAMMPS* engine, const std::string& owner,
                                      const std::string& restarted, const std::string& models);

// Returns the constants to print in the log, with the pair style and walls to which they apply.
std::string constants_report(const ContactLines& lines);

// Describes the first pair of atom types whose constants differ: "`...` is now `...`". Returns an
// empty string if none differs. Ignores pairs of types that only one text contains.
std::string first_change(const std::string& before, const std::string& now);

}  // namespace plastigran
