// SPDX-License-Identifier: GPL-2.0-or-later
//
// Is the time step short enough? A fix that gathers what the models know: before a run the Rayleigh
// and Hertz times and the rebound of the fastest impact the present velocities allow, and from then
// on the stiffest unloading branch that contacts have come to. It says so in one line as a run
// starts, and warns when the time step is too long, also in the middle of a run.
#ifndef PLASTIGRAN_STEP_WATCH_H
#define PLASTIGRAN_STEP_WATCH_H

#include <mpi.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <sstream>
#include <string>

#include "comm.h"
#include "error.h"
#include "fix.h"
#include "own_fix.h"
#include "update.h"

namespace plastigran {

class StepWatch : public LAMMPS_NS::Fix {
 public:
  static constexpr double unknown = 1e300;

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

  StepWatch(LAMMPS_NS::LAMMPS* engine, int count, char** words) : Fix(engine, count, words) {
    nevery = 1000;  // steps; one small reduction each
  }
  static const char* id() { return "plastigran_step"; }
  static const char* style() { return "plastigran/step"; }

  // From a model, before a run; `model` words who says so.
  void expect(const std::string& model, const Recommended& impact, double rayleigh, double hertz) {
    rayleigh_ = std::min(rayleigh_, rayleigh);
    hertz_ = std::min(hertz_, hertz);
    if (impact.step < impact_.step) impact_ = impact, model_ = model;
  }

  // Before a run: contacts of the one before may be gone, their bodies other ones.
  void forget() { stiffest_.step = unknown; }

  // From a model, during a run, on the rank that has the contact.
  void met(const Place& place) {
    if (place.step < stiffest_.step) stiffest_ = place;
  }

  int setmask() override { return LAMMPS_NS::FixConst::END_OF_STEP; }

  void setup(int) override {
    gather();
    if (comm->me == 0) announce();
    if (update->dt > impact_.step && impact_.step < 0.99 * warned_impact_) {
      warned_impact_ = impact_.step;
      std::ostringstream text;
      text << model_ << ": the time step " << update->dt << " is too long for rebound from "
           << (impact_.wall ? "wall " : "") << "impacts at the present speeds (up to "
           << impact_.speed
           << "); restitution may be off by more than 0.1 %. Recommended: timestep "
           << impact_.step;
      warn(text.str());
    }
    impact_ = Recommended(), rayleigh_ = hertz_ = unknown;
  }

  void end_of_step() override {
    gather();
    if (update->dt <= stiffest_.step || stiffest_.step > 0.9 * warned_contact_) return;
    warned_contact_ = stiffest_.step;
    std::ostringstream text;
    text << "the time step " << update->dt << " is too long for the contact of particle "
         << stiffest_.i << " with ";
    stiffest_.j ? text << "particle " << stiffest_.j : text << "a wall";
    text << " at (" << stiffest_.x[0] << ' ' << stiffest_.x[1] << ' ' << stiffest_.x[2]
         << "), loaded as by an impact at " << stiffest_.speed
         << "; restitution may be off by more than 0.1 %. Recommended: timestep " << stiffest_.step;
    warn(text.str());
  }

 private:
  // The stiffest contact of all ranks, on all of them.
  void gather() {
    struct {
      double step;
      int rank;
    } mine{stiffest_.step, comm->me}, least;
    MPI_Allreduce(&mine, &least, 1, MPI_DOUBLE_INT, MPI_MINLOC, world);
    if (least.step < unknown) MPI_Bcast(&stiffest_, sizeof stiffest_, MPI_BYTE, least.rank, world);
  }

  void announce() {
    std::ostringstream text;
    text.precision(2);
    text << "time step " << update->dt << ":";
    const auto ratio = [&](double time, const char* of) {
      if (time < unknown) text << ' ' << update->dt / time << " of " << of << ',';
    };
    ratio(rayleigh_, "the Rayleigh time");
    ratio(hertz_, "the shortest Hertz impact at the present speeds");
    ratio(impact_.step, "the recommended step for those");
    ratio(stiffest_.step, "that for the stiffest contact");
    std::string line = text.str();
    line.back() = '\n';
    if (screen) fputs(line.c_str(), screen);
    if (logfile) fputs(line.c_str(), logfile);
  }

  void warn(const std::string& text) {
    if (comm->me == 0) error->warning(FLERR, text.c_str());
  }

  Recommended impact_;
  std::string model_;
  double rayleigh_ = unknown, hertz_ = unknown;
  Place stiffest_{unknown, 0, {0, 0, 0}, 0, 0};  // of this run
  double warned_impact_ = unknown, warned_contact_ = unknown;
};

}  // namespace plastigran

#endif
