// SPDX-License-Identifier: GPL-2.0-or-later
//
// Clears the histories of ended contacts with primitive walls. LIGGGHTS calls the contact model of
// a wall only for particles within one neighbor skin of the wall. A particle that crosses the skin
// in one step, or any particle with `neighbor 0.0`, would keep the history of its last contact.
#pragma once

#include <map>
#include <string>
#include <utility>

#include "liggghts/fixes/plugin_fix.h"

namespace plastigran {

class PartedWalls : public PluginFix {
 public:
  using PluginFix::PluginFix;
  static const char* id() { return "plastigran_parted_walls"; }
  static const char* style() { return "plastigran/parted_walls"; }

  // Sets the offset and the number of values of the law's state in the contact history of "fix ID".
  void set_state(const std::string& owner, int offset, int count) {
    states_[owner] = {offset, count};
  }

  int setmask() override;
  void setup_pre_neighbor() override { pre_neighbor(); }
  void pre_neighbor() override;

 private:
  std::map<std::string, std::pair<int, int>> states_;
};

}  // namespace plastigran
