// SPDX-License-Identifier: GPL-2.0-or-later
//
// Counts the contacts that leave the range of their law while the engine runs, and says so once at
// the end of a run. The largest overlap is written every 1000 steps where it has grown, for
// programs.
#pragma once

#include <map>
#include <set>
#include <string>

#include "liggghts/fixes/plugin_fix.h"
#include "plastigran/pairs/range_account.h"

namespace plastigran {

class RangeCheck : public PluginFix {
 public:
  // Of one model, on this rank.
  struct Excess : RangeAccount {
    const char* range = "";
    double all_contacts = 0;        // over all ranks, on the first one, as the next two are
    double announced = 0;           // contacts, when the log last had a warning
    double announced_furthest = 0;  // largest overlap over the range's that the log has
    double warned_speed = 0;        // of impacts before a run that leave the range [m/s]
    bool warned = false;            // of anything beyond the range
    std::set<std::string> said;     // warnings before a run that are given once
  };

  RangeCheck(LAMMPS_NS::LAMMPS* engine, int count, char** words) : PluginFix(engine, count, words) {
    nevery = 1000;  // steps; small reductions each
  }
  static const char* id() { return "plastigran_range"; }
  static const char* style() { return "plastigran/range"; }

  // What is counted for a model; the watch is made when the first one asks. All ranks together.
  static Excess* of(LAMMPS_NS::LAMMPS* engine, const std::string& model, const char* range);

  int setmask() override;
  void end_of_step() override;
  void post_run() override;

 private:
  void print_furthest(const std::string& model, Excess& excess, double factor);

  std::map<std::string, Excess> models_;
};

}  // namespace plastigran
