// SPDX-License-Identifier: GPL-2.0-or-later
//
// Compares the time step with the recommended one. Before a run, the recommended time step follows
// from the fastest impact at the current velocities. During the run, it follows from the stiffest
// contact so far. A line in the log compares the time step with the Rayleigh and Hertz times. A
// warning reports a time step that is too long.
#pragma once

#include <string>

#include "liggghts/fixes/plugin_fix.h"
#include "plastigran/pairs/impact_times.h"

namespace plastigran {

class TimeStepCheck : public PluginFix {
 public:
  static constexpr double unknown = ImpactTimes::unknown;  // time step if no impact is possible [s]

  // A recommended time step [s] and the speed [m/s] of the impact from which it follows.
  struct Recommended {
    double step = unknown, speed = 0;
    bool with_wall = false;
  };

  // A contact and its recommended time step [s]. MPI ranks send this struct as bytes.
  struct LoadedContact {
    double step, speed;  // time step [s], and speed of an impact that reaches this overlap [m/s]
    double x[3];
    int id, partner_id;  // IDs of the particles; partner_id is 0 for a wall
  };

  TimeStepCheck(LAMMPS_NS::LAMMPS* engine, int count, char** words);
  static const char* id() { return "plastigran_step"; }
  static const char* style() { return "plastigran/step"; }

  // Sets the recommended step of the fastest expected impact, and the Rayleigh and Hertz times [s].
  // A contact model calls this function before a run; the warning contains `model`.
  void expect(const std::string& model, const Recommended& impact, double rayleigh, double hertz);

  // Clears the stiffest contact before a run, because contacts and materials may have changed.
  void reset() { stiffest_.step = unknown; }

  // Records a contact if it is the stiffest so far. Called during a run on the rank that has the
  // contact.
  void add(const LoadedContact& contact) {
    if (contact.step < stiffest_.step) stiffest_ = contact;
  }

  int setmask() override;
  void setup(int) override;
  void end_of_step() override;

 private:
  void find_stiffest();
  void print_ratios();
  void warn_if_first(const std::string& text);

  Recommended impact_;
  std::string model_;
  double rayleigh_ = unknown, hertz_ = unknown;
  LoadedContact stiffest_{
      unknown, 0, {0, 0, 0}, 0, 0};  // contact with the shortest recommended step in this run
  double warned_impact_ = unknown, warned_contact_ = unknown;
};

}  // namespace plastigran
