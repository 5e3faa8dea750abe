// SPDX-License-Identifier: GPL-2.0-or-later
//
// Ends the contacts of primitive walls. The engine offers a wall's model only the particles within
// one neighbor skin of the wall. A particle that crosses the skin in one step, or any particle with
// `neighbor 0.0`, would keep the contact history of its last touch.
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

  // Where the law's state stands in the history of the contacts of "fix ID".
  void set_state(const std::string& owner, int offset, int count) {
    states_[owner] = {offset, count};
  }

  int setmask() override;
  void pre_neighbor() override;

 private:
  std::map<std::string, std::pair<int, int>> states_;
};

}  // namespace plastigran
