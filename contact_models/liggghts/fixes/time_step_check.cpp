// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/time_step_check.h"

#include <mpi.h>

#include <algorithm>
#include <sstream>

#include "comm.h"
#include "error.h"
#include "liggghts/fixes/print.h"
#include "update.h"

namespace plastigran {

TimeStepCheck::TimeStepCheck(LAMMPS_NS::LAMMPS* engine, int count, char** words)
    : PluginFix(engine, count, words) {
  nevery = 1000;  // steps; one small reduction each
}

void TimeStepCheck::expect(const std::string& model, const Recommended& impact, double rayleigh,
                           double hertz) {
  rayleigh_ = std::min(rayleigh_, rayleigh);
  hertz_ = std::min(hertz_, hertz);
  if (impact.step < impact_.step) impact_ = impact, model_ = model;
}

int TimeStepCheck::setmask() { return LAMMPS_NS::FixConst::END_OF_STEP; }

void TimeStepCheck::setup(int) {
  gather();
  if (comm->me == 0) announce();
  if (update->dt > impact_.step && impact_.step < 0.99 * warned_impact_) {
    warned_impact_ = impact_.step;
    std::ostringstream text;
    text << model_ << ": the time step " << update->dt << " is too long for rebound from "
         << (impact_.wall ? "wall " : "") << "impacts at the present speeds (at most "
         << impact_.speed << "); restitution may be off by more than 0.1 %. Recommended: timestep "
         << impact_.step;
    warn(text.str());
  }
  impact_ = Recommended(), rayleigh_ = hertz_ = unknown;
}

void TimeStepCheck::end_of_step() {
  gather();
  if (update->dt <= stiffest_.step || stiffest_.step > 0.9 * warned_contact_) return;
  warned_contact_ = stiffest_.step;
  std::ostringstream text;
  text << "the time step " << update->dt << " is too long for the contact of particle "
       << stiffest_.i << " with ";
  stiffest_.j ? text << "particle " << stiffest_.j : text << "a wall";
  text << " at (" << stiffest_.x[0] << ' ' << stiffest_.x[1] << ' ' << stiffest_.x[2]
       << "), loaded as by an impact at " << stiffest_.speed << ": " << update->dt / stiffest_.step
       << " times the recommended one, which keeps restitution to 0.1 %. Recommended: timestep "
       << stiffest_.step;
  warn(text.str());
}

// The stiffest contact of all ranks, on all of them.
void TimeStepCheck::gather() {
  struct {
    double step;
    int rank;
  } mine{stiffest_.step, comm->me}, least;
  MPI_Allreduce(&mine, &least, 1, MPI_DOUBLE_INT, MPI_MINLOC, world);
  if (least.step < unknown) MPI_Bcast(&stiffest_, sizeof stiffest_, MPI_BYTE, least.rank, world);
}

void TimeStepCheck::announce() {
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
  if (line.back() == ':') return;  // no particles yet
  line.back() = '\n';
  print(lmp, line);
}

void TimeStepCheck::warn(const std::string& text) {
  if (comm->me == 0) plastigran::warn(lmp, text);
}

}  // namespace plastigran
