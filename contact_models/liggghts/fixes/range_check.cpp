// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/range_check.h"

#include <mpi.h>

#include "comm.h"
#include "plastigran/pairs/range_report.h"

namespace plastigran {

RangeCheck::Excess* RangeCheck::of(LAMMPS_NS::LAMMPS* engine, const std::string& model,
                                   const char* range) {
  Excess& excess = ensure_fix<RangeCheck>(engine)->models_[model];
  excess.range = range;
  return &excess;
}

int RangeCheck::setmask() { return LAMMPS_NS::FixConst::END_OF_STEP; }

// Prints the largest overlaps during the run, so that the log of a killed run contains them.
void RangeCheck::end_of_step() {
  for (auto& [model, excess] : models_) print_furthest(model, excess, 1.1);
}

void RangeCheck::post_run() {
  for (auto& [model, excess] : models_) {
    print_furthest(model, excess, 1);
    const double furthest = excess.printed_furthest;
    if (comm->me != 0 || furthest == 0) continue;
    if (excess.warned && excess.all_contacts == excess.warned_contacts) continue;
    excess.warned = true;
    excess.warned_contacts = excess.all_contacts;
    warn(lmp, model + ": " + range_warning(excess.range, excess.all_contacts, furthest));
  }
}

// Prints the largest overlap if it exceeds `factor` times the last printed one. Collective.
void RangeCheck::print_furthest(const std::string& model, Excess& excess, double factor) {
  double furthest;
  MPI_Reduce(&excess.contacts, &excess.all_contacts, 1, MPI_DOUBLE, MPI_SUM, 0, world);
  MPI_Reduce(&excess.furthest, &furthest, 1, MPI_DOUBLE, MPI_MAX, 0, world);
  if (comm->me != 0 || furthest <= factor * excess.printed_furthest) return;
  excess.printed_furthest = furthest;
  print(lmp, range_line(model.substr(model.find(' ') + 1), excess.all_contacts, furthest));
}

}  // namespace plastigran
