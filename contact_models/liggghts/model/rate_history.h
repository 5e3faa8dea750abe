// SPDX-License-Identifier: GPL-2.0-or-later
//
// A history value more for contacts between particles, where a yield strength depends on the rate
// of impact: the rate factor of the contact's first touch. The engine asks fixes for such values
// when it sets up a pair style's first run, after the deck's properties, which may come after the
// pair style or after a restart file. (Walls count their values when they are made.)
#pragma once

#include "fix.h"

namespace plastigran {

class RateHistory : public LAMMPS_NS::Fix {
 public:
  RateHistory(LAMMPS_NS::LAMMPS* engine, int count, char** words) : Fix(engine, count, words) {}
  static const char* id() { return "plastigran_rate"; }
  static const char* style() { return "plastigran/rate"; }

  // A pair style of a law that yields begins, or ends.
  void begin() { needed_ = Needed::unknown; }
  void end() { needed_ = Needed::no; }

  // Where the value stands in a contact's history, -1 when there is none.
  int offset() const;

  int setmask() override { return 0; }
  int n_history_extra() override;
  bool history_args(char** words) override;

 private:
  enum class Needed { unknown, no, yes } needed_ = Needed::no;
};

}  // namespace plastigran
