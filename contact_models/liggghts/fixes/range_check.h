// SPDX-License-Identifier: GPL-2.0-or-later
//
// Counts contacts that exceed the validity range of their law, and warns at the end of a run. Every
// 1000 steps, if the largest overlap has grown, a line in the log gives it to programs.
#pragma once

#include <map>
#include <set>
#include <string>

#include "liggghts/fixes/plugin_fix.h"
#include "plastigran/pairs/range_account.h"

namespace plastigran {

class RangeCheck : public PluginFix {
 public:
  // Counts of one model on this rank. The members are for the first rank.
  struct Excess : RangeAccount {
    const char* range = "";
    double all_contacts = 0;                // over all ranks
    double warned_contacts = 0;             // in the last warning
    double printed_furthest = 0;            // largest overlap divided by its limit, in the log
    double warned_speed = 0;                // speed in the last warning before a run [m/s]
    bool warned = false;                    // whether contacts beyond the range were reported
    std::set<std::string> unique_warnings;  // given once, before a run
  };

  RangeCheck(LAMMPS_NS::LAMMPS* engine, int count, char** words) : PluginFix(engine, count, words) {
    nevery = 1000;  // steps between reductions
  }
  static const char* id() { return "plastigran_range"; }
  static const char* style() { return "plastigran/range"; }

  // The counts of a model. Collective.
  static Excess* of(LAMMPS_NS::LAMMPS* engine, const std::string& model, const char* range);

  int setmask() override;
  void end_of_step() override;
  void post_run() override;

 private:
  void print_furthest(const std::string& model, Excess& excess, double factor);

  std::map<std::string, Excess> models_;
};

}  // namespace plastigran
