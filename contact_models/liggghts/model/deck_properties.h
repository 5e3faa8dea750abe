// SPDX-License-Identifier: GPL-2.0-or-later
//
// What the deck says of materials: `fix property/global`, read by the names of the laws' fields.
#pragma once

#include <cmath>
#include <set>
#include <string>
#include <vector>

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

  // The bulk constants of every atom type. Their strength may be left out where nothing yields.
  std::vector<Body> bodies(bool yields) const;

  // Stops where a coefficient of friction is negative, which the engine takes.
  void check_friction() const;

  // Stops on all ranks together.
  void fail(const std::string& reason) const;

  // Stops with a complaint about these atom types (other_type 0: about one), unless it is empty.
  void check(const Complaint& complaint, int type, int other_type = 0) const;

  // A complaint with the properties' names and the deck's units.
  std::string worded(const Complaint& complaint) const;

  // A sentence and the atom types it is about (other_type 0: one).
  static std::string about_types(const std::string& sentence, int type, int other_type);

  // The deck's unit for an SI unit.
  std::string unit(const std::string& si) const;

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
