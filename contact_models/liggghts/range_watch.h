// SPDX-License-Identifier: GPL-2.0-or-later
//
// Counts the contacts that leave the range of their law while the engine runs, and says so once at
// the end of a run. plastigran's adapter adds this fix to the engine by itself; no deck names it.
#ifndef PLASTIGRAN_RANGE_WATCH_H
#define PLASTIGRAN_RANGE_WATCH_H

#include <mpi.h>

#include <map>
#include <sstream>
#include <string>

#include "comm.h"
#include "error.h"
#include "fix.h"
#include "own_fix.h"

namespace plastigran {

class RangeWatch : public LAMMPS_NS::Fix {
 public:
  struct Excess {
    const char* range = "";
    double contacts = 0;   // one seen from both sides of a border counts half on each
    double furthest = 0;   // largest overlap over the range's
    double announced = 0;  // contacts, over all ranks, when it was last said
  };

  RangeWatch(LAMMPS_NS::LAMMPS* engine, int count, char** words) : Fix(engine, count, words) {}
  static const char* id() { return "plastigran_range"; }
  static const char* style() { return "plastigran/range"; }

  // What is counted for a model; the watch is made when the first one asks. All ranks together.
  static Excess* of(LAMMPS_NS::LAMMPS* engine, const std::string& model, const char* range) {
    RangeWatch* const watch = own_fix<RangeWatch>(engine);
    Excess& excess = watch->models_[model];
    excess.range = range;
    return &excess;
  }

  int setmask() override { return 0; }

  void post_run() override {
    for (auto& [model, excess] : models_) {
      double contacts, furthest;
      MPI_Reduce(&excess.contacts, &contacts, 1, MPI_DOUBLE, MPI_SUM, 0, world);
      MPI_Reduce(&excess.furthest, &furthest, 1, MPI_DOUBLE, MPI_MAX, 0, world);
      if (comm->me != 0 || contacts == excess.announced) continue;
      excess.announced = contacts;
      std::ostringstream text;
      text << model << ": contacts beyond the law's range (" << excess.range
           << ") so far: " << contacts << ", the furthest at " << furthest
           << " times its largest overlap";
      error->warning(FLERR, text.str().c_str());
    }
  }

 private:
  std::map<std::string, Excess> models_;
};

}  // namespace plastigran

#endif
