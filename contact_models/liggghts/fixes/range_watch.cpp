// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/range_watch.h"

#include <mpi.h>

#include <cstdio>
#include <sstream>

#include "comm.h"
#include "error.h"
#include "liggghts/fixes/own_fix.h"

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
    if (comm->me != 0 || contacts == excess.announced) continue;
    excess.announced = contacts;
    std::ostringstream line;  // for programs
    line << "plastigran range " << model.substr(model.find(' ') + 1) << " contacts=" << contacts
         << " furthest=" << furthest << '\n';
    if (screen) fputs(line.str().c_str(), screen);
    if (logfile) fputs(line.str().c_str(), logfile);
    std::ostringstream text;
    text << model << ": contacts beyond the law's range (" << excess.range
         << ") so far: " << contacts << ", the furthest at " << furthest
         << " times the largest overlap that the law is good for";
    error->warning(FLERR, text.str().c_str());
  }
}

}  // namespace plastigran
