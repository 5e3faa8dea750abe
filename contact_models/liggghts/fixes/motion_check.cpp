// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/motion_check.h"

#include <cmath>
#include <sstream>
#include <utility>

#include "atom.h"
#include "domain.h"
#include "liggghts/fixes/engine_access.h"
#include "liggghts/model/periodic_sides.h"
#include "update.h"

namespace plastigran {

MotionCheck::MotionCheck(LAMMPS_NS::LAMMPS* engine, int count, char** words)
    : PluginFix(engine, count, words) {
  nevery = 1;
}

int MotionCheck::setmask() {
  using namespace LAMMPS_NS::FixConst;
  return PRE_INITIAL_INTEGRATE | PRE_EXCHANGE | END_OF_STEP;
}

void MotionCheck::init() {
  timestep_ = update->dt;
  if (std::exchange(list_again_, false)) modify->init();
}

void MotionCheck::reset_dt() { timestep_ = update->dt; }

// Checks the forces after the setup, because the first step would spread a NaN force to positions.
void MotionCheck::pre_initial_integrate() {
  if (update->dt != timestep_) {
    std::ostringstream text;
    text << "run ... pre no: timestep is " << update->dt << ", but particles would move with "
         << timestep_ << ", the timestep of the last setup. Remove `pre no`, or give `timestep "
         << timestep_ << "` again";
    stop(lmp, text.str());
  }
  if (!first_) return;
  first_ = false;
  for (int i = 0; i < atom->nlocal; ++i) {
    const double* const f = atom->f[i];
    if (!std::isfinite(f[0] + f[1] + f[2]))
      stop_for(
          i, "has a force that is NaN or infinite",
          "Check for particles whose center is on a wall or on the center of another particle");
  }
}

void MotionCheck::end_of_step() {
  const double step_squared = update->dt * update->dt;
  for (int i = 0; i < atom->nlocal; ++i) {
    const double* const v = atom->v[i];
    const double travel = step_squared * (v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    const double radius = atom->radius[i];
    if (travel <= radius * radius) continue;
    if (!std::isfinite(travel))
      stop_for(i, "has a velocity that is NaN or infinite",
               "Check the last contacts of the particle, and whether its center is on a wall");
    std::ostringstream problem;
    problem << "moved " << std::sqrt(travel) / radius
            << " times its radius in one step; the limit is 1";
    stop_for(
        i, problem.str(),
        "Reduce the time step to the value recommended in the log or by `plastigran timestep`. "
        "Check for overlapping particles near its start position");
  }
}

void MotionCheck::check_periodic_sides(const std::string& model) {
  model_of_pairs_ = model;
  const std::string problem = short_periodic_side(lmp);
  if (!problem.empty()) stop(lmp, model + ": " + problem);
}

void MotionCheck::pre_exchange() {
  if (domain->box_change && !model_of_pairs_.empty()) check_periodic_sides(model_of_pairs_);
  if (!lost_is_error(output)) return;
  for (int i = 0; i < atom->nlocal; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      if (domain->periodicity[axis]) continue;
      // A particle is lost only at a fixed side (`boundary f`, value 1).
      const bool below = domain->boundary[axis][0] == 1 && atom->x[i][axis] < domain->boxlo[axis];
      const bool above = domain->boundary[axis][1] == 1 && atom->x[i][axis] > domain->boxhi[axis];
      if (below || above)
        stop_for(i,
                 std::string("leaves the box at its ") + (below ? "lower " : "upper ") +
                     "xyz"[axis] + " side",
                 "Close gaps in the walls and meshes, reduce the time step, enlarge the box, or "
                 "allow lost particles: thermo_modify lost ignore");
    }
}

void MotionCheck::stop_for(int i, const std::string& problem, const std::string& remedy) {
  stop_from_rank(lmp, describe_particle(atom, i) + ' ' + problem + ". " + remedy);
}

}  // namespace plastigran
