// SPDX-License-Identifier: GPL-2.0-or-later
//
// A fix that a deck can add, and that receives every contact of the laws in every step. LIGGGHTS
// knows its style after the first pair_style line with a law.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "contact_interface.h"
#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/model/accounted_load.h"

namespace plastigran {

// The pair style and the walls that report their contacts in the coming run, by address.
class ReportingOwners {
 public:
  void add(const void* owner) { owners_.insert(owner); }
  bool has(const void* owner) const { return owners_.count(owner); }

  // IDs of the other granular walls, with commas; empty if they are the same as in the last call.
  // Clears the list, because all owners report again before each run.
  std::string new_missing_walls(const LAMMPS_NS::Modify* modify);

 private:
  std::set<const void*> owners_;
  std::string missing_;
};

class ContactObserver : public PluginFix {
 public:
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;
  typedef LIGGGHTS::ContactModels::ForceData Load;

  // Stops unless the group is `all`.
  ContactObserver(LAMMPS_NS::LAMMPS* engine, int count, char** words);

  // Returns all observers, to which the pair style or wall `owner` reports. Each setup calls it.
  static std::vector<ContactObserver*> attach(LAMMPS_NS::LAMMPS* engine, const void* owner);

  // Receives the loads of all models of a contact. The ranks of both particles report a contact
  // with a ghost, or one rank twice. The setup reports contacts with contact.shearupdate 0.
  virtual void add(const Contact& contact, const AccountedLoad& on_i, const Load& on_j,
                   const void* owner) = 0;

  void post_create() override {
    update->first_update = 0;
  }  // the next run needs a setup, even with `pre no`
  void init() override;
  void setup_pre_exchange() override;

 protected:
  // "fix ID STYLE"
  std::string name() const { return std::string("fix ") + id + ' ' + style; }
  [[noreturn]] void fail(const std::string& reason) const;  // collective

 private:
  ReportingOwners owners_;
};

// Why contacts of this deck cannot be counted; empty if they can.
std::string uncountable(LAMMPS_NS::LAMMPS* engine);

}  // namespace plastigran
