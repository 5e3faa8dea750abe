// SPDX-License-Identifier: GPL-2.0-or-later
#include "lammps/run_time_checks.h"

#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <cstring>

#include "comm.h"
#include "error.h"
#include "lammps.h"
#include "modify.h"
#include "plastigran/pairs/range_report.h"
#include "update.h"
#include "utils.h"

namespace plastigran {

namespace {

constexpr const char* fix_id = "plastigran_checks";

// Record of one law in a restart file: number of contacts beyond the validity range, and largest
// ratio of overlap to limit, over all ranks.
struct Stored {
  char law[64];
  double contacts, furthest;
};

}  // namespace

RunTimeChecks::RunTimeChecks(LAMMPS_NS::LAMMPS* lammps, int count, char** words)
    : Fix(lammps, count, words) {
  restart_global = 1;
  nevery = 1000;  // number of steps between two reductions over ranks
}

RunTimeChecks& RunTimeChecks::of(LAMMPS_NS::LAMMPS* lammps) {
  LAMMPS_NS::Modify* const modify = lammps->modify;
  LAMMPS_NS::Fix* fix = modify->get_fix_by_id(fix_id);
  if (!fix) fix = modify->add_fix(std::string(fix_id) + " all plastigran/checks");
  return *static_cast<RunTimeChecks*>(fix);
}

RangeAccount* RunTimeChecks::account(const RuntimeLaw& law) {
  Excess& excess = laws_[law.name];
  excess.range = law.range_words;
  return &excess;
}

void RunTimeChecks::warn(const std::string& text) {
  error->warning(FLERR, "granular/plastigran: {}", text);
}

void RunTimeChecks::expect(const std::vector<ExpectedImpact>& impacts) {
  if (comm->me != 0) return;
  double step = 0, step_speed = 0;
  std::map<std::string, double> outside;  // largest speed beyond the range of each law [m/s]
  for (const auto& [meeting, law] : impacts) {
    if (!(meeting.speed > 0)) continue;
    const ImpactCheck check =
        law->check_impact(meeting.radius_eff, meeting.mass_eff, meeting.speed);
    if (step == 0 || check.timestep < step) step = check.timestep, step_speed = meeting.speed;
    if (!check.in_range) outside[law->name] = std::max(outside[law->name], meeting.speed);
  }
  // Repeat a warning only if the recommended time step is shorter, or the impact speed higher, than
  // in the last warning.
  if (step > 0 && update->dt > step && (warned_step_ == 0 || step < 0.99 * warned_step_)) {
    warned_step_ = step;
    error->warning(FLERR,
                   "granular/plastigran: the time step is {:.3g} s; at most {:.3g} s is "
                   "recommended for impacts at {:.3g} m/s",
                   update->dt, step, step_speed);
  }
  for (const auto& [law, speed] : outside) {
    Excess& excess = laws_[law];
    if (speed <= 1.01 * excess.warned_speed) continue;
    excess.warned_speed = speed;
    warn("model " + law + ": " + range_forecast(excess.range, speed, "m/s"));
  }
}

int RunTimeChecks::setmask() {
  return LAMMPS_NS::FixConst::END_OF_STEP | LAMMPS_NS::FixConst::POST_RUN;
}

void RunTimeChecks::init() { warned_step_ = 0; }

// Prints the largest overlaps during the run, so that the log of a killed run contains them.
void RunTimeChecks::end_of_step() {
  for (auto& [law, excess] : laws_) print_furthest(law, excess, 1.1);
}

void RunTimeChecks::post_run() {
  for (auto& [law, excess] : laws_) {
    print_furthest(law, excess, 1);
    if (comm->me != 0 || excess.printed_furthest == 0) continue;
    if (excess.all_contacts == excess.warned_contacts) continue;
    excess.warned_contacts = excess.all_contacts;
    warn("model " + law + ": " +
         range_warning(excess.range, excess.all_contacts, excess.printed_furthest));
  }
}

// Prints the largest ratio of overlap to limit if it exceeds `factor` times the last printed ratio.
// All ranks must call this function.
void RunTimeChecks::print_furthest(const std::string& law, Excess& excess, double factor) {
  if (excess.range.empty()) return;  // a law from the restart file that this run does not use
  double furthest;
  MPI_Reduce(&excess.contacts, &excess.all_contacts, 1, MPI_DOUBLE, MPI_SUM, 0, world);
  MPI_Reduce(&excess.furthest, &furthest, 1, MPI_DOUBLE, MPI_MAX, 0, world);
  if (comm->me != 0 || furthest <= factor * excess.printed_furthest) return;
  excess.printed_furthest = furthest;
  LAMMPS_NS::utils::logmesg(lmp, range_line(law, excess.all_contacts, furthest));
}

void RunTimeChecks::write_restart(FILE* file) {
  std::vector<Stored> all;
  for (const auto& [law, excess] : laws_) {
    Stored stored{};
    std::snprintf(stored.law, sizeof stored.law, "%s", law.c_str());
    MPI_Reduce(&excess.contacts, &stored.contacts, 1, MPI_DOUBLE, MPI_SUM, 0, world);
    MPI_Reduce(&excess.furthest, &stored.furthest, 1, MPI_DOUBLE, MPI_MAX, 0, world);
    all.push_back(stored);
  }
  if (comm->me != 0) return;
  const int count = static_cast<int>(all.size());
  const int size = static_cast<int>(sizeof count + all.size() * sizeof(Stored));
  std::fwrite(&size, sizeof size, 1, file);
  std::fwrite(&count, sizeof count, 1, file);
  std::fwrite(all.data(), sizeof(Stored), all.size(), file);
}

void RunTimeChecks::restart(char* data) {
  int count = 0;
  std::memcpy(&count, data, sizeof count);
  data += sizeof count;
  for (int k = 0; k < count; ++k, data += sizeof(Stored)) {
    Stored stored;
    std::memcpy(&stored, data, sizeof stored);
    Excess& excess = laws_[stored.law];
    // After a restart, rank 0 holds the counts of all ranks, and the other ranks start at zero.
    if (comm->me != 0) continue;
    excess.contacts = stored.contacts;
    excess.furthest = stored.furthest;
  }
}

}  // namespace plastigran
