// SPDX-License-Identifier: GPL-2.0-or-later
//
// The lines of a deck that define contacts, the pair style and the granular walls, as HistoryKeeper
// compares them from run to run and stores them in restart files.
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
  std::string models;                  // the law, its options and the other models
  std::string settings;                // all settings: NAME WORD NAME WORD ...
  std::vector<std::string> histories;  // IDs of LIGGGHTS' fixes that store the contact histories
  std::string constants;               // a text line per pair of atom types; empty: no history
  bool is_new = false;                 // given since the last run
  std::string report;                  // constants for the log; empty if the log has them
  std::uint64_t position = 0;          // primitive_wall_position()
};

// By owner: "pair_style" or "fix ID".
typedef std::map<std::string, ContactLine> ContactLines;

constexpr char pair_owner[] = "pair_style";

// The lines in a restart file. Without histories, only the settings of the pair style are stored.
std::string restart_text(const ContactLines& lines);
ContactLines read_restart_text(const std::string& text);

// Stops: the restart file has contacts of other models than the line.
[[noreturn]] void refuse_other_models(LAMMPS_NS::LAMMPS* engine, const std::string& owner,
                                      const std::string& restarted, const std::string& models);

// The constants for the log, with the owners that they apply to.
std::string constants_report(const ContactLines& lines);

// The first pair of atom types with other constants than before: "`...` is now `...`"; empty if
// none. Pairs of types that only one text contains are ignored.
std::string first_change(const std::string& before, const std::string& now);

}  // namespace plastigran
