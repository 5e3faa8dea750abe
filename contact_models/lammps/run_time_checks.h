// SPDX-License-Identifier: GPL-2.0-or-later
//
// Run-time checks. The fix counts contacts beyond the validity range of their law, and warns at the
// end of a run. Before a run, it warns of a time step that is too long, and of impacts that will
// exceed the range. The pair style creates this fix with the ID `plastigran_checks`.
#pragma once

#include <map>
#include <memory>
#include <string>
#include <vector>

#include "fix.h"
#include "lammps/runtime_law.h"
#include "plastigran/pairs/impact_forecast.h"
#include "plastigran/pairs/range_account.h"

namespace plastigran {

// An expected impact with its law.
struct ExpectedImpact {
  Meeting meeting;
  std::shared_ptr<const RuntimeLaw> law;
};

class RunTimeChecks : public LAMMPS_NS::Fix {
 public:
  RunTimeChecks(LAMMPS_NS::LAMMPS* lammps, int count, char** words);

  // Returns the fix of a simulation; creates it if there is none. All ranks must call this.
  static RunTimeChecks& of(LAMMPS_NS::LAMMPS* lammps);

  // Returns the record of contacts beyond the validity range of a law on this rank, for all pairs
  // and walls. All ranks must call this.
  RangeAccount* account(const RuntimeLaw& law);

  // Warns if the time step is too long for an impact, or if an impact will exceed the range of its
  // law.
  void expect(const std::vector<ExpectedImpact>& impacts);

  int setmask() override;
  void init() override;
  void end_of_step() override;
  void post_run() override;
  void write_restart(FILE* file) override;
  void restart(char* data) override;

 private:
  // Contacts beyond the validity range of one law on this rank. The members declared here, except
  // `range`, are used only on rank 0.
  struct Excess : RangeAccount {
    std::string range;            // validity range in words
    double all_contacts = 0;      // number of contacts beyond the range on all ranks
    double warned_contacts = -1;  // number of contacts in the last warning; -1 before the first
    double printed_furthest = 0;  // last printed ratio of overlap to limit
    double warned_speed = 0;      // impact speed in the last warning [m/s]
  };

  void print_furthest(const std::string& law, Excess& excess, double factor);
  void warn(const std::string& text);

  std::map<std::string, Excess> laws_;
  double warned_step_ = 0;  // shortest time step recommended in this run [s]; 0 without one
};

}  // namespace plastigran
