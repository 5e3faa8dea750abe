// SPDX-License-Identifier: GPL-2.0-or-later
//
// Material properties of a deck (`fix ID all property/global`), accessed by the field names of
// laws.
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

// Returns the LIGGGHTS property name of a field in camel case: yieldStrength for yield_strength.
std::string property_name(const std::string& field);

class DeckProperties : protected LAMMPS_NS::Pointers {
 public:
  // Creates the access to the properties for a contact model or fix. Messages begin with `model`.
  DeckProperties(LAMMPS_NS::LAMMPS* engine, const std::string& model, int type_count)
      : Pointers(engine), model_(model), type_count_(type_count) {}

  // Returns whether the deck defines a property, of any shape.
  bool given(const char* field) const;

  // Returns whether the deck defines a property that is positive for at least one atom type.
  bool positive(const char* field) const;

  // Returns the value for an atom type. Stops if the property is missing and there is no fallback.
  double per_type(const char* field, int type, const char* unit, double fallback = NAN) const;

  // Returns the value for a pair of atom types, or `fallback` if the property is missing.
  double per_pair(const char* field, int type, int other_type, double fallback) const;

  // Returns the constants of every atom type without checking them. Stops if a strength is missing
  // and `yields` is true.
  std::vector<Body> bodies(bool yields) const;

  // Returns all material constants that a law needs.
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

  [[noreturn]] void fail(const std::string& reason) const;  // stops the run; collective
  void check(const Complaint& complaint) const;             // stops unless the complaint is empty

  // Convert complaints, SI units and field names to the property names and units of the deck.
  std::string worded(const Complaint& complaint) const;
  std::string unit(const std::string& si) const;
  Words words() const {
    return {property_name, [this](const std::string& si) { return unit(si); }};
  }

  // Returns warnings of unused properties whose name differs from a used one by one or two letters.
  std::vector<std::string> misspellings() const;

  // Returns the warnings of misspellings(), and of values that are allowed but probably wrong.
  // `cohesive` is true if the contacts have a cohesion model.
  std::vector<std::string> doubts(const std::vector<Body>& bodies, bool cohesive) const;

 private:
  LAMMPS_NS::FixPropertyGlobal* find(const char* field, const char* shape, int rows, int columns,
                                     bool required) const;
  LAMMPS_NS::FixPropertyGlobal* values(const char* field, const char* shape, int rows,
                                       int columns) const;
  std::vector<std::string> unused_similar_to(const std::string& name) const;

  std::string model_;
  int type_count_;
  mutable std::set<std::string> used_;  // names of the properties that were read
};

}  // namespace plastigran
