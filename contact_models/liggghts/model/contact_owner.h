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
namespace LIGGGHTS::ContactModels {
class ContactModelBase;
}

namespace plastigran {

class ContactOwner {
 public:
  ContactOwner(LIGGGHTS::IContactHistorySetup* owner, bool is_wall)
      : owner_(owner), is_wall_(is_wall) {}

  bool is_wall() const { return is_wall_; }

  // The owner's line in the deck: "pair_style", or "fix ID" of a wall.
  std::string name() const;

  // The models beside the normal one, as that line has them (" KIND NAME ..."), without those off.
  std::string other_models() const;

  // What is wrong with one of them beside ours, empty when nothing is.
  std::string unsuitable_model(bool is_cylinder, bool is_adhesive) const;

  bool is_mesh_wall() const;

  // IDs of the engine's fixes that store what these contacts remember; none when they do not.
  std::vector<std::string> histories() const;

  // Whether the tangential model beside the normal one has that name.
  bool tangential_model_is(const std::string& name) const;

  // The atom types particles meet here: all of them, or those of the wall.
  std::vector<int> partner_types(int type_count) const;

  // The atom types of all granular walls of the engine.
  static std::set<int> wall_types(LAMMPS_NS::Modify* modify);

 private:
  bool has_model(const std::string& kind, const std::string& name) const;

  LIGGGHTS::IContactHistorySetup* owner_;  // a PairGran or FixWallGran
  bool is_wall_;
};

}  // namespace plastigran
