// SPDX-License-Identifier: GPL-2.0-or-later
//
// Adds the fixes that keep contact histories and check the motion of the particles. A normal model
// calls keep_histories() before each run.
#pragma once

#include <cstddef>
#include <string>

#include "liggghts/fixes/history_keeper.h"
#include "liggghts/model/contact_owner.h"

namespace plastigran {

// State of a normal law in the contact history: offset of its first value, and number of values.
struct HistoryState {
  int offset = 0;
  std::size_t count = 0;
};

// Returns the HistoryKeeper. `caller` names the model in messages. `restarted_lines` is the value
// of HistoryKeeper::restarted_lines() at the construction of the model. Collective.
HistoryKeeper& keep_histories(LAMMPS_NS::LAMMPS* engine, const ContactOwner& owner,
                              const std::string& caller, const std::string& restarted_lines,
                              HistoryState state);

}  // namespace plastigran
