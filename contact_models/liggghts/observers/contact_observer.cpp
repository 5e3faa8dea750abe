// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/observers/contact_observer.h"

#include <cstring>
#include <utility>

#include "force.h"
#include "pair.h"

namespace plastigran {

std::string ReportingOwners::new_missing_walls(const LAMMPS_NS::Modify* modify) {
  std::string missing;
  for (int k = 0; k < modify->nfix; ++k) {
    const LAMMPS_NS::Fix* const wall = modify->fix[k];
    if (std::strncmp(wall->style, "wall/gran", 9) == 0 && !has(wall))
      missing += (missing.empty() ? "" : ", ") + std::string(wall->id);
  }
  owners_.clear();
  return std::exchange(missing_, missing) == missing ? "" : missing;
}

ContactObserver::ContactObserver(LAMMPS_NS::LAMMPS* engine, int count, char** words)
    : PluginFix(engine, count, words) {
  if (igroup != 0) fail(std::string("its group is ") + words[1] + "; it must be all");
}

std::vector<ContactObserver*> ContactObserver::attach(LAMMPS_NS::LAMMPS* engine,
                                                      const void* owner) {
  const auto observers = fixes_of<ContactObserver>(engine->modify);
  for (ContactObserver* const observer : observers) observer->owners_.add(owner);
  return observers;
}

void ContactObserver::init() {
  const std::string reason = uncountable(lmp);
  if (!reason.empty()) fail(reason);
}

void ContactObserver::setup_pre_exchange() {
  if (!owners_.has(force->pair_match("gran", 1)))
    fail("the pair_style line has one of LIGGGHTS' own models. Use a law of this plugin");
  const std::string walls = owners_.new_missing_walls(modify);
  if (comm->me == 0 && !walls.empty())
    warn(lmp, name() + ": contacts of walls with LIGGGHTS' own models are not counted: " + walls);
}

void ContactObserver::fail(const std::string& reason) const { stop(lmp, name() + ": " + reason); }

std::string uncountable(LAMMPS_NS::LAMMPS* engine) {
  if (engine->force->newton_pair)
    return "`newton on` is not supported, because contacts between particles of two MPI "
           "ranks are then computed on one rank only. Use `newton off`";
  for (const std::string style : {"multisphere", "rigid"})
    if (engine->modify->n_fixes_style(style.c_str()) > 0)
      return "fix " + style + " is not supported, because contacts are counted for particles and " +
             "not for rigid bodies. Remove one of these fixes";
  return "";
}

}  // namespace plastigran
