// SPDX-License-Identifier: GPL-2.0-or-later
//
// A fix of the deck that is told of every contact of the plugin's models, step by step. Its style
// is known once the deck has a pair_style line of one of them.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "contact_interface.h"
#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/model/accounted_load.h"

namespace plastigran {

class ContactObserver : public PluginFix {
 public:
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;
  typedef LIGGGHTS::ContactModels::ForceData Load;

  // Stops unless the group is `all`.
  ContactObserver(LAMMPS_NS::LAMMPS* engine, int count, char** words);

  // The observers there are; the pair style or wall `owner` will report to them. Before each run.
  static std::vector<ContactObserver*> attach(LAMMPS_NS::LAMMPS* engine, const void* owner);

  // What all models of a contact did together. `owner`: the pair style or wall. A contact with a
  // ghost is reported from both sides, on the ranks of the two particles or twice on one.
  // Set-up reports contacts too, with contact.shearupdate 0.
  virtual void add(const Contact& contact, const AccountedLoad& on_i, const Load& on_j,
                   const void* owner) = 0;

  void post_create() override { update->first_update = 0; }  // no `run ... pre no` without it
  void init() override;
  void setup_pre_exchange() override;

 protected:
  // Stops with "fix ID STYLE: reason". All ranks together.
  void fail(const std::string& reason);

  std::set<const void*> attached_;  // who reports, for the coming run

 private:
  std::string strangers_;
};

// IDs of granular walls that are not among `attached`, with commas.
std::string strange_walls(const LAMMPS_NS::Modify* modify, const std::set<const void*>& attached);

// Why contacts of this deck cannot be counted one by one; empty when they can.
std::string uncountable(LAMMPS_NS::LAMMPS* engine);

}  // namespace plastigran
