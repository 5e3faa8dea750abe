// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/observers/contact_observer.h"

#include <cstring>

#include "comm.h"
#include "force.h"
#include "pair.h"
#include "liggghts/fixes/print.h"

namespace plastigran {

ContactObserver::ContactObserver(LAMMPS_NS::LAMMPS* engine, int count, char** words)
    : PluginFix(engine, count, words) {
  if (igroup != 0) fail(std::string("its group is ") + words[1] + "; it must be all");
}

std::vector<ContactObserver*> ContactObserver::attach(LAMMPS_NS::LAMMPS* engine,
                                                      const void* owner) {
  std::vector<ContactObserver*> observers;
  for (int k = 0; k < engine->modify->nfix; ++k)
    if (const auto observer = dynamic_cast<ContactObserver*>(engine->modify->fix[k])) {
      observer->attached_.insert(owner);
      observers.push_back(observer);
    }
  return observers;
}

void ContactObserver::init() {
  const std::string reason = uncountable(lmp);
  if (!reason.empty()) fail(reason);
}

void ContactObserver::setup_pre_exchange() {
  if (!attached_.count(force->pair_match("gran", 1)))
    fail("the pair_style line has another model; it needs one of this plugin's laws");
  const std::string strangers = strange_walls(modify, attached_);
  attached_.clear();
  if (strangers == strangers_) return;
  strangers_ = strangers;
  if (comm->me == 0 && !strangers.empty())
    warn(lmp, std::string("fix ") + id + ' ' + style +
                  ": contacts with these walls of other models are not counted: " + strangers);
}

void ContactObserver::fail(const std::string& reason) {
  error->all(FLERR, (std::string("fix ") + id + ' ' + style + ": " + reason).c_str());
}

std::string strange_walls(const LAMMPS_NS::Modify* modify, const std::set<const void*>& attached) {
  std::string strangers;
  for (int k = 0; k < modify->nfix; ++k) {
    const LAMMPS_NS::Fix* const wall = modify->fix[k];
    if (std::strncmp(wall->style, "wall/gran", 9) == 0 && !attached.count(wall))
      strangers += std::string(strangers.empty() ? "" : ", ") + wall->id;
  }
  return strangers;
}

std::string uncountable(LAMMPS_NS::LAMMPS* engine) {
  if (engine->force->newton_pair)
    return "it needs `newton off`, for contacts across the borders between ranks";
  for (const char* style : {"multisphere", "rigid"})
    if (engine->modify->n_fixes_style(style) > 0)
      return std::string("it counts particles, and not the bodies that fix ") + style +
             " makes of them; leave it off";
  return "";
}

}  // namespace plastigran
