// SPDX-License-Identifier: GPL-2.0-or-later
//
// Whose contacts a model computes: those of the pair style, or of one wall with all its meshes.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "contact_interface.h"

namespace LAMMPS_NS {
class Modify;
}

namespace plastigran {

class ContactOwner {
 public:
  ContactOwner(LIGGGHTS::IContactHistorySetup* owner, bool is_wall)
      : owner_(owner), is_wall_(is_wall) {}

  bool is_wall() const { return is_wall_; }

  // Whether the tangential model beside the normal one has that name.
  bool tangential_model_is(const std::string& name) const;

  // The atom types particles meet here: all of them, or those of the wall.
  std::vector<int> partner_types(int type_count) const;

  // The atom types of all granular walls of the engine.
  static std::set<int> wall_types(LAMMPS_NS::Modify* modify);

 private:
  LIGGGHTS::IContactHistorySetup* owner_;  // a PairGran or FixWallGran
  bool is_wall_;
};

}  // namespace plastigran
