// SPDX-License-Identifier: GPL-2.0-or-later
//
// Owner of the contacts that a model computes: the pair style, or a wall with all its meshes.
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

  // Returns "pair_style", or "fix ID" for a wall.
  std::string name() const;

  bool has_model(const std::string& keyword, const std::string& name) const;

  // Returns the law in the pair_style or wall line, with the option `adhesion jkr` if the line has
  // it. Returns "hertz" for LIGGGHTS' `hertz` combined with a tangential law, and an empty string
  // for all other models of LIGGGHTS.
  std::string law() const;

  // Returns the other contact models in the pair_style or wall line (" KIND NAME ..."), without
  // those that are off, and the number of rings if it is not the default.
  std::string other_models() const;

  // Returns why one of the other models cannot be combined with a law; empty if all can.
  std::string unsuitable_model(const std::string& law, bool is_cylinder, bool is_adhesive) const;

  // Returns the IDs of the LIGGGHTS fixes that store the contact histories; empty without
  // histories.
  std::vector<std::string> histories() const;

  // Returns the bit of the group whose particles can touch: all, or the group of a primitive wall.
  int group() const;

  // Returns the atom types that particles can touch: all, or only those of the wall.
  std::vector<int> partner_types(int type_count) const;

 private:
  LAMMPS_NS::PairGran* pair_ = nullptr;
  LAMMPS_NS::FixWallGran* wall_ = nullptr;
};

// Returns the atom types of all granular walls.
std::set<int> wall_types(LAMMPS_NS::Modify* modify);

// The normal models in the lines of a deck, if they differ.
struct MixedModels {
  // Text such as "pair_style has thornton; fix floor has one of LIGGGHTS' own models"; empty if all
  // lines have the same model.
  std::string text;
  std::string first;         // first line with a law, as in ContactOwner::name()
  bool has_foreign = false;  // whether a line has one of LIGGGHTS' own models
};
MixedModels mixed_models(LAMMPS_NS::LAMMPS* engine);

}  // namespace plastigran
