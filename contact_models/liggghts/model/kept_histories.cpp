// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/kept_histories.h"

#include "liggghts/fixes/motion_check.h"
#include "liggghts/fixes/parted_walls.h"

namespace plastigran {

HistoryKeeper& keep_histories(LAMMPS_NS::LAMMPS* engine, const ContactOwner& owner,
                              const std::string& caller, const std::string& restarted_lines,
                              HistoryState state) {
  // LIGGGHTS initializes walls when it has already listed the fixes to call in this run. The list
  // then lacks a fix that a wall adds.
  const bool is_late = owner.is_wall() && !find_fix<MotionCheck>(engine);
  const auto check = ensure_fix<MotionCheck>(engine);
  if (is_late) check->list_fixes_again();
  if (!owner.is_wall() && !owner.histories().empty()) check->check_periodic_sides(caller);
  const auto parted = ensure_fix<PartedWalls>(engine);
  HistoryKeeper& keeper = *HistoryKeeper::of(engine, restarted_lines);
  parted->set_state(owner.name(), state.offset, state.count);
  return keeper;
}

}  // namespace plastigran
