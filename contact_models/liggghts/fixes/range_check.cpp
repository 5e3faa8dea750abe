// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/range_check.h"

#include <mpi.h>

#include <sstream>

#include "comm.h"
#include "error.h"
#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/fixes/print.h"

namespace plastigran {

RangeCheck::Excess* RangeCheck::of(LAMMPS_NS::LAMMPS* engine, const std::string& model,
                                   const char* range) {
  Excess& excess = ensure_fix<RangeCheck>(engine)->models_[model];
  excess.range = range;
  return &excess;
}

int RangeCheck::setmask() { return LAMMPS_NS::FixConst::END_OF_STEP; }

// A run that is killed has its largest overlaps in the log, too.
void RangeCheck::end_of_step() {
  for (auto& [model, excess] : models_) print_furthest(model, excess, 1.1);
}

void RangeCheck::post_run() {
  for (auto& [model, excess] : models_) {
    print_furthest(model, excess, 1);
    const double furthest = excess.announced_furthest;
    if (comm->me != 0 || furthest == 0) continue;
    if (excess.warned && excess.all_contacts == excess.announced) continue;
    excess.warned = true;
    excess.announced = excess.all_contacts;
    std::ostringstream text;
    text << model << ": contacts beyond the law's range (" << excess.range << ')';
    // Elastic contacts are not counted: nothing in their state shows that they were beyond before.
    if (excess.announced > 0) text << " so far: " << excess.announced << ", the furthest at ";
    if (excess.announced == 0) text << ", still elastic, the furthest at ";
    text << furthest << " times the largest overlap that the law is good for";
    warn(lmp, text.str());
  }
}

// One line where the largest overlap has grown by more than a factor. All ranks together.
void RangeCheck::print_furthest(const std::string& model, Excess& excess, double factor) {
  double furthest;
  MPI_Reduce(&excess.contacts, &excess.all_contacts, 1, MPI_DOUBLE, MPI_SUM, 0, world);
  MPI_Reduce(&excess.furthest, &furthest, 1, MPI_DOUBLE, MPI_MAX, 0, world);
  if (comm->me != 0 || furthest <= factor * excess.announced_furthest) return;
  excess.announced_furthest = furthest;
  std::ostringstream line;  // read by the Python package
  line << "plastigran range " << model.substr(model.find(' ') + 1)
       << " contacts=" << excess.all_contacts << " furthest=" << furthest << '\n';
  print(lmp, line.str());
}

}  // namespace plastigran
