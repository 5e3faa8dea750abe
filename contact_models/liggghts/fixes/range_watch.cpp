// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/range_watch.h"

#include <mpi.h>

#include <sstream>

#include "comm.h"
#include "error.h"
#include "liggghts/fixes/own_fix.h"
#include "liggghts/fixes/print.h"

namespace plastigran {

RangeWatch::Excess* RangeWatch::of(LAMMPS_NS::LAMMPS* engine, const std::string& model,
                                   const char* range) {
  Excess& excess = own_fix<RangeWatch>(engine)->models_[model];
  excess.range = range;
  return &excess;
}

void RangeWatch::post_run() {
  for (auto& [model, excess] : models_) {
    double contacts, furthest;
    MPI_Reduce(&excess.contacts, &contacts, 1, MPI_DOUBLE, MPI_SUM, 0, world);
    MPI_Reduce(&excess.furthest, &furthest, 1, MPI_DOUBLE, MPI_MAX, 0, world);
    if (comm->me != 0) continue;
    const bool more = contacts > excess.announced, further = furthest > excess.announced_furthest;
    if (!more && !further) continue;
    excess.announced = contacts;
    excess.announced_furthest = furthest;
    std::ostringstream line;  // read by the Python package
    line << "plastigran range " << model.substr(model.find(' ') + 1) << " contacts=" << contacts
         << " furthest=" << furthest << '\n';
    print(lmp, line.str());
    if (!more) continue;
    std::ostringstream text;
    text << model << ": contacts beyond the law's range (" << excess.range
         << ") so far: " << contacts << ", the furthest at " << furthest
         << " times the largest overlap that the law is good for";
    warn(lmp, text.str());
  }
}

}  // namespace plastigran
