// SPDX-License-Identifier: GPL-2.0-or-later
//
// Counts contacts that exceed the validity range of their law, and warns at the end of a run. Every
// 1000 steps, prints the largest overlap as a machine-readable log line if it has grown by 10 %.
#pragma once

#include <map>
#include <set>
#include <string>

#include "liggghts/fixes/plugin_fix.h"
#include "plastigran/pairs/range_account.h"

namespace plastigran {

class RangeCheck : public PluginFix {
 public:
  // Contacts of one model beyond the validity range of its law, counted on this rank. The members
  // declared here are used only on rank 0.
  struct Excess : RangeAccount {
    const char* range = "";
    double all_contacts = 0;                // number of contacts beyond the range on all ranks
    double warned_contacts = 0;             // number of contacts reported in the last warning
    double printed_furthest = 0;            // last printed ratio of overlap to limit
    double warned_speed = 0;                // impact speed in the last warning [m/s]
    bool warned = false;                    // whether a warning was printed
    std::set<std::string> unique_warnings;  // warnings already printed, each only once
  };

  RangeCheck(LAMMPS_NS::LAMMPS* engine, int count, char** words) : PluginFix(engine, count, words) {
    nevery = 1000;  // number of steps between two reductions over ranks
  }
  static const char* id() { return "plastigran_range"; }
  static const char* style() { return "plastigran/range"; }

  // Returns the counts of a model's contacts beyond the validity range `range`; adds the fix if
  // needed. Collective.
  static Excess* of(LAMMPS_NS::LAMMPS* engine, const std::string& model, const char* range);

  int setmask() override;
  void end_of_step() override;
  void post_run() override;

 private:
  void print_furthest(const std::string& model, Excess& excess, double factor);

  std::map<std::string, Excess> models_;
};

}  // namespace plastigran
