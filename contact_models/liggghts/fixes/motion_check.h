// SPDX-License-Identifier: GPL-2.0-or-later
//
// Stops a run when a particle has an infinite or NaN velocity or force, moves by more than its
// radius in one step, or leaves the box with `thermo_modify lost error`. Each rank checks its own
// particles before LIGGGHTS' next output, so that no restart file contains such a particle. Also
// stops a run with `pre no` whose time step differs from that of the last setup.
#pragma once

#include <string>

#include "liggghts/fixes/plugin_fix.h"

namespace plastigran {

class MotionCheck : public PluginFix {
 public:
  MotionCheck(LAMMPS_NS::LAMMPS* engine, int count, char** words);
  static const char* id() { return "plastigran_motion"; }
  static const char* style() { return "plastigran/motion"; }

  // Makes init() rebuild LIGGGHTS' lists of the fixes to call in each step. A wall that adds this
  // fix calls this function, because LIGGGHTS has already built the lists for the run.
  void list_fixes_again() { list_again_ = true; }

  // Stops if a periodic side of the box is too short, now or when a fix changes the box. The model
  // of a pair style calls this function before each run. Collective.
  void check_periodic_sides(const std::string& model);

  int setmask() override;
  void init() override;
  void reset_dt() override;  // called when a fix changes the time step during a run
  void setup(int) override { first_ = true; }
  void pre_initial_integrate() override;
  void end_of_step() override;
  void setup_pre_exchange() override { pre_exchange(); }
  void pre_exchange() override;

 private:
  void stop_for(int i, const std::string& problem, const std::string& remedy);

  bool first_ = true;  // whether the next step is the first after the setup
  bool list_again_ = false;
  std::string model_of_pairs_;  // model of the pair style; empty if contacts have no histories
  double timestep_ = 0;         // time step of the last setup
};

}  // namespace plastigran
