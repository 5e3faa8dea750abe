// SPDX-License-Identifier: GPL-2.0-or-later
//
// Base class of fixes that a deck can add, and that receive every contact of the laws in every
// step. Their styles are registered by the first pair_style line with a law.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "contact_interface.h"
#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/model/accounted_load.h"

namespace plastigran {

// Addresses of the pair style and the walls that report their contacts in the coming run.
class ReportingOwners {
 public:
  void add(const void* owner) { owners_.insert(owner); }
  bool has(const void* owner) const { return owners_.count(owner); }

  // Returns the IDs of granular walls that do not report contacts to this observer, separated by
  // commas; empty if they are the same as in the last call. Clears the list of reporting owners,
  // because all register again before each run.
  std::string new_missing_walls(const LAMMPS_NS::Modify* modify);

 private:
  std::set<const void*> owners_;
  std::string missing_;
};

class ContactObserver : public PluginFix {
 public:
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;
  typedef LIGGGHTS::ContactModels::ForceData Load;

  // Reads the group of the fix. Stops unless the group is `all`.
  ContactObserver(LAMMPS_NS::LAMMPS* engine, int count, char** words);

  // Registers the pair style or wall `owner` with all observers, and returns the observers. Each
  // setup calls this function.
  static std::vector<ContactObserver*> attach(LAMMPS_NS::LAMMPS* engine, const void* owner);

  // Receives the loads of all models of a contact. A contact with a ghost is reported twice, once
  // for each particle. In reports from the setup of a run, contact.shearupdate is 0.
  virtual void add(const Contact& contact, const AccountedLoad& on_i, const Load& on_j,
                   const void* owner) = 0;

  // Forces a setup of the next run, even with `pre no`.
  void post_create() override { update->first_update = 0; }
  void init() override;
  void setup_pre_exchange() override;

 protected:
  // Returns "fix ID STYLE".
  std::string name() const { return std::string("fix ") + id + ' ' + style; }
  [[noreturn]] void fail(const std::string& reason) const;  // stops the run; collective

 private:
  ReportingOwners owners_;
};

// Returns why contacts of this deck cannot be counted; empty if they can.
std::string uncountable(LAMMPS_NS::LAMMPS* engine);

}  // namespace plastigran
