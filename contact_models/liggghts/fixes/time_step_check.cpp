// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/time_step_check.h"

#include <mpi.h>

#include <algorithm>
#include <sstream>

#include "comm.h"
#include "update.h"

namespace plastigran {

TimeStepCheck::TimeStepCheck(LAMMPS_NS::LAMMPS* engine, int count, char** words)
    : PluginFix(engine, count, words) {
  nevery = 1000;  // number of steps between two reductions over ranks
}

void TimeStepCheck::expect(const std::string& model, const Recommended& impact, double rayleigh,
                           double hertz) {
  rayleigh_ = std::min(rayleigh_, rayleigh);
  hertz_ = std::min(hertz_, hertz);
  if (impact.step < impact_.step) impact_ = impact, model_ = model;
}

int TimeStepCheck::setmask() { return LAMMPS_NS::FixConst::END_OF_STEP; }

void TimeStepCheck::setup(int) {
  find_stiffest();
  if (comm->me == 0) print_ratios();
  if (update->dt > impact_.step && impact_.step < 0.99 * warned_impact_) {
    warned_impact_ = impact_.step;
    std::ostringstream text;
    text << model_ << ": the time step " << update->dt << " is too long for "
         << (impact_.with_wall ? "wall " : "") << "impacts at the current speeds (up to "
         << impact_.speed << "). The error in restitution may exceed 0.1 %. Use `timestep "
         << impact_.step << '`';
    warn_if_first(text.str());
  }
  impact_ = Recommended(), rayleigh_ = hertz_ = unknown;
}

void TimeStepCheck::end_of_step() {
  find_stiffest();
  // Warn again only if the recommended step is 10 % shorter than in the last warning.
  if (update->dt <= stiffest_.step || stiffest_.step > 0.9 * warned_contact_) return;
  warned_contact_ = stiffest_.step;
  std::ostringstream text;
  text << "the time step " << update->dt << " is too long for the contact of particle "
       << stiffest_.id << " with ";
  stiffest_.partner_id ? text << "particle " << stiffest_.partner_id : text << "a wall";
  text << " at (" << stiffest_.x[0] << ' ' << stiffest_.x[1] << ' ' << stiffest_.x[2]
       << "). An impact at the speed " << stiffest_.speed
       << " would reach the same overlap. The time step is " << update->dt / stiffest_.step
       << " times the recommended one, for which the error in restitution is 0.1 %. Use `timestep "
       << stiffest_.step << '`';
  warn_if_first(text.str());
}

// Replaces stiffest_ by the contact with the shortest recommended step of all ranks. Collective.
void TimeStepCheck::find_stiffest() {
  struct {
    double step;
    int rank;
  } mine{stiffest_.step, comm->me}, least;
  MPI_Allreduce(&mine, &least, 1, MPI_DOUBLE_INT, MPI_MINLOC, world);
  if (least.step < unknown) MPI_Bcast(&stiffest_, sizeof stiffest_, MPI_BYTE, least.rank, world);
}

void TimeStepCheck::print_ratios() {
  std::ostringstream text;
  text.precision(2);
  text << "time step " << update->dt << ":";
  const auto ratio = [&](double time, const char* of) {
    if (time < unknown) text << ' ' << update->dt / time << " of " << of << ',';
  };
  ratio(rayleigh_, "the Rayleigh time");
  ratio(hertz_, "the shortest Hertz contact time at the current speeds");
  ratio(impact_.step, "the recommended time step");
  ratio(stiffest_.step, "the recommended time step for the stiffest contact");
  std::string line = text.str();
  if (line.back() == ':') return;  // print nothing if there are no particles yet
  line.back() = '\n';
  print(lmp, line);
}

void TimeStepCheck::warn_if_first(const std::string& text) {
  if (comm->me == 0) plastigran::warn(lmp, text);
}

}  // namespace plastigran
