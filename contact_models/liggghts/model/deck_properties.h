// SPDX-License-Identifier: GPL-2.0-or-later
//
// The material properties of a deck, `fix ID all property/global`, by the field names of the laws.
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

// The property of a field, in camel case like LIGGGHTS' properties: yieldStrength for
// yield_strength.
std::string property_name(const std::string& field);

class DeckProperties : protected LAMMPS_NS::Pointers {
 public:
  // `model` is the name of the caller in messages.
  DeckProperties(LAMMPS_NS::LAMMPS* engine, const std::string& model, int type_count)
      : Pointers(engine), model_(model), type_count_(type_count) {}

  bool given(const char* field) const;

  // Whether a property is given and positive for any atom type.
  bool positive(const char* field) const;

  // The value for an atom type. Stops if it is missing and there is no fallback.
  double per_type(const char* field, int type, const char* unit, double fallback = NAN) const;

  // The value for a pair of atom types.
  double per_pair(const char* field, int type, int other_type, double fallback) const;

  // The constants of every atom type, unchecked. Stops if a strength is missing and `yields`.
  std::vector<Body> bodies(bool yields) const;

  // All constants that a law needs.
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

  // Stops if a coefficient of friction is negative, which LIGGGHTS accepts.
  void check_friction() const;

  [[noreturn]] void fail(const std::string& reason) const;  // collective
  void check(const Complaint& complaint) const;             // fails unless it is empty

  // A complaint, a unit, and all names with the property names and the units of the deck.
  std::string worded(const Complaint& complaint) const;
  std::string unit(const std::string& si) const;
  Words words() const {
    return {property_name, [this](const std::string& si) { return unit(si); }};
  }

  // Sentences on unused properties with a name that differs from a used one by one or two letters.
  std::vector<std::string> misspellings() const;

  // The same, and sentences on values that are allowed but probably wrong. `cohesive`: the contacts
  // have a cohesion model.
  std::vector<std::string> doubts(const std::vector<Body>& bodies, bool cohesive) const;

 private:
  LAMMPS_NS::FixPropertyGlobal* find(const char* field, const char* shape, int rows, int columns,
                                     bool required) const;
  LAMMPS_NS::FixPropertyGlobal* values(const char* field, const char* shape, int rows,
                                       int columns) const;
  std::vector<std::string> unused_similar_to(const std::string& name) const;

  std::string model_;
  int type_count_;
  mutable std::set<std::string> used_;  // names of properties
};

}  // namespace plastigran
