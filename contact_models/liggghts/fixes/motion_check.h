// SPDX-License-Identifier: GPL-2.0-or-later
//
// Stops a run that has gone wrong, and says which particle, where, and what to try: one whose
// velocity is no number, one that outruns its contacts, one that leaves the box where particles
// must not be lost (thermo_modify lost error). Each is found by the rank that has the particle,
// before LIGGGHTS' next output, so that no restart file is written of it. Also stops a run whose
// time step is not the one with which the integrators were set up.
#pragma once

#include <string>

#include "liggghts/fixes/plugin_fix.h"

namespace plastigran {

class MotionCheck : public PluginFix {
 public:
  MotionCheck(LAMMPS_NS::LAMMPS* engine, int count, char** words);
  static const char* id() { return "plastigran_motion"; }
  static const char* style() { return "plastigran/motion"; }

  // To be called where a wall makes the fixes of this package. LIGGGHTS has then listed the fixes
  // of the run already; it lists them again once all are initialised.
  void list_fixes_again() { list_again_ = true; }

  // From a pair style's model before each run: periodic sides must not be too short, now and while
  // a fix changes the box. All ranks together.
  void check_periodic_sides(const std::string& model);

  int setmask() override;
  void init() override;
  void reset_dt() override;  // by a fix that changes the time step in a run
  void setup(int) override { first_ = true; }
  void pre_initial_integrate() override;
  void end_of_step() override;
  void setup_pre_exchange() override { pre_exchange(); }
  void pre_exchange() override;

 private:
  void lost_control(int i, double travel);
  void stop(int i, const std::string& what, const std::string& try_this);

  bool first_ = true;
  bool list_again_ = false;
  std::string model_of_pairs_;  // whose contacts have histories; or empty
  double timestep_ = 0;         // with which the integrators were set up
};

}  // namespace plastigran
