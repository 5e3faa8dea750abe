// SPDX-License-Identifier: GPL-2.0-or-later
//
// What the deck says of materials: `fix property/global`, read by the names of the laws' fields.
#pragma once

#include <cmath>
#include <set>
#include <string>
#include <vector>

#include "plastigran/pairs/materials.h"
#include "plastigran/shared/complaint.h"
#include "plastigran/shared/contact.h"
#include "pointers.h"

namespace LAMMPS_NS {
class FixPropertyGlobal;
}

namespace plastigran {

// What decks call a field of the laws: yieldStrength for yield_strength. LIGGGHTS names properties
// in camel case.
std::string property_name(const std::string& field);

class DeckProperties : protected LAMMPS_NS::Pointers {
 public:
  // `model` words who asks, in messages.
  DeckProperties(LAMMPS_NS::LAMMPS* engine, const std::string& model, int type_count)
      : Pointers(engine), model_(model), type_count_(type_count) {}

  // Whether the deck gives the property at all.
  bool given(const char* field) const;

  // Whether the deck gives the property and it is positive for any atom type.
  bool positive(const char* field) const;

  // The value for an atom type. Without a fallback it must be given.
  double per_type(const char* field, int type, const char* unit, double fallback = NAN) const;

  // The value for a pair of atom types, the fallback when the deck gives none.
  double per_pair(const char* field, int type, int other_type, double fallback) const;

  // The bulk constants of every atom type, unchecked. Their strength may be left out where nothing
  // yields.
  std::vector<Body> bodies(bool yields) const;

  // All that a law asks for.
  template <class Law>
  Materials materials() const {
    Materials materials;
    materials.bodies = bodies(yields<Law>);
    if (hardens<Law> && given("tangent_modulus")) materials.given.insert("tangent_modulus");
    for (const auto& parameter : parameters_of<Law>) {
      const bool is_given = given(parameter.name);
      if (is_given) materials.given.insert(parameter.name);
      if (!is_given && !parameter.per_body) continue;
      auto& values = materials.constants[parameter.name];
      for (int type = 1; type <= type_count_; ++type)
        if (parameter.per_body)
          values.push_back(per_type(parameter.name, type, parameter.unit));
        else
          for (int other = 1; other <= type_count_; ++other)
            values.push_back(per_pair(parameter.name, type, other, 0));
    }
    return materials;
  }

  // Stops where a coefficient of friction is negative, which the engine takes.
  void check_friction() const;

  // Stops on all ranks together.
  void fail(const std::string& reason) const;

  // Stops with a complaint, unless it is empty.
  void check(const Complaint& complaint) const;

  // A complaint with the properties' names and the deck's units.
  std::string worded(const Complaint& complaint) const;

  // The deck's unit for an SI unit.
  std::string unit(const std::string& si) const;

  // The deck's names of fields and units.
  Words words() const {
    return {property_name, [this](const std::string& si) { return unit(si); }};
  }

  // Sentences on properties that nothing has asked for and whose name is a letter or two off one
  // that has been.
  std::vector<std::string> misspellings() const;

  // The same on all that is allowed and yet looks like a slip, values of bodies, too. `cohesive`:
  // bodies draw each other.
  std::vector<std::string> doubts(const std::vector<Body>& bodies, bool cohesive) const;

 private:
  LAMMPS_NS::FixPropertyGlobal* find(const char* field, const char* shape, int rows, int columns,
                                     bool required) const;
  LAMMPS_NS::FixPropertyGlobal* values(const char* field, const char* shape, int rows,
                                       int columns) const;

  // Properties of the deck that may stand for a misspelt `name`.
  std::vector<std::string> misspelt(const std::string& name) const;

  std::string model_;
  int type_count_;
  mutable std::set<std::string> asked_;  // names asked for so far
};

}  // namespace plastigran
