// SPDX-License-Identifier: GPL-2.0-or-later
//
// Is the time step short enough? A fix that gathers what the models know: before a run the Rayleigh
// and Hertz times and the rebound of the fastest impact the present velocities allow, and from then
// on the stiffest unloading branch that contacts have come to. It says so in one line as a run
// starts, and warns when the time step is too long, also in the middle of a run.
#pragma once

#include <string>

#include "liggghts/fixes/plugin_fix.h"
#include "plastigran/pairs/impact_times.h"

namespace plastigran {

class TimeStepCheck : public PluginFix {
 public:
  static constexpr double unknown = ImpactTimes::unknown;  // a time nobody has told yet [s]

  // A time step, and the impact it is short enough for.
  struct Recommended {
    double step = unknown, speed = 0;
    bool wall = false;
  };

  // A contact of particles i and j (j = 0: a wall) and where it is. A plain struct: ranks send it.
  struct Place {
    double step, speed;  // as Recommended; the speed at which an impact would load as deeply
    double x[3];
    int i, j;
  };

  TimeStepCheck(LAMMPS_NS::LAMMPS* engine, int count, char** words);
  static const char* id() { return "plastigran_step"; }
  static const char* style() { return "plastigran/step"; }

  // From a model, before a run; `model` words who says so.
  void expect(const std::string& model, const Recommended& impact, double rayleigh, double hertz);

  // Before a run: contacts of the one before may be gone, their bodies other ones.
  void forget() { stiffest_.step = unknown; }

  // From a model, during a run, on the rank that has the contact.
  void met(const Place& place) {
    if (place.step < stiffest_.step) stiffest_ = place;
  }

  int setmask() override;
  void setup(int) override;
  void end_of_step() override;

 private:
  void gather();
  void announce();
  void warn(const std::string& text);

  Recommended impact_;
  std::string model_;
  double rayleigh_ = unknown, hertz_ = unknown;
  Place stiffest_{unknown, 0, {0, 0, 0}, 0, 0};  // of this run
  double warned_impact_ = unknown, warned_contact_ = unknown;
};

}  // namespace plastigran
