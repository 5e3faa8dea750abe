// SPDX-License-Identifier: GPL-2.0-or-later
//
// The pair style, or the wall with all its meshes, whose contacts a model computes.
#pragma once

#include <set>
#include <string>
#include <vector>

#include "contact_interface.h"

namespace LAMMPS_NS {
class FixWallGran;
class LAMMPS;
class Modify;
class PairGran;
}  // namespace LAMMPS_NS

namespace plastigran {

class ContactOwner {
 public:
  explicit ContactOwner(LAMMPS_NS::PairGran* pair) : pair_(pair) {}
  explicit ContactOwner(LAMMPS_NS::FixWallGran* wall) : wall_(wall) {}
  ContactOwner(LIGGGHTS::IContactHistorySetup* owner, bool is_wall);

  bool is_wall() const { return wall_; }
  bool is_mesh_wall() const;

  // "pair_style", or "fix ID" of a wall.
  std::string name() const;

  bool has_model(const std::string& kind, const std::string& name) const;

  // The law of this package in the line; empty for a model of LIGGGHTS.
  std::string law() const;

  // The other models in the line (" KIND NAME ..."), without those that are off.
  std::string other_models() const;

  // Why one of the other models cannot be combined with a law; empty if all can.
  std::string unsuitable_model(const std::string& law, bool is_cylinder, bool is_adhesive) const;

  // IDs of LIGGGHTS' fixes that store the contact histories; none without histories.
  std::vector<std::string> histories() const;

  // The atom types that particles can touch: all, or those of the wall.
  std::vector<int> partner_types(int type_count) const;

 private:
  LAMMPS_NS::PairGran* pair_ = nullptr;
  LAMMPS_NS::FixWallGran* wall_ = nullptr;
};

// The atom types of all granular walls.
std::set<int> wall_types(LAMMPS_NS::Modify* modify);

// The normal models in the lines of a deck, if they differ.
struct MixedModels {
  std::string
      text;  // "pair_style has thornton; fix floor has a model of LIGGGHTS"; empty: one model
  std::string first;         // the first line with a law, as ContactOwner::name()
  bool has_foreign = false;  // a line has a model of LIGGGHTS
};
MixedModels mixed_models(LAMMPS_NS::LAMMPS* engine);

}  // namespace plastigran
