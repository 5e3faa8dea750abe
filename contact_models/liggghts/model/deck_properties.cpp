// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/deck_properties.h"

#include <algorithm>
#include <cctype>
#include <numeric>
#include <sstream>

#include "fix_property_global.h"
#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/model/deck_units.h"
#include "plastigran/impact/plausibility.h"
#include "update.h"

namespace plastigran {

namespace {

// Returns the number of letters to change, add or remove to turn one word into the other
// (Levenshtein 1966).
int letters_apart(const std::string& one, const std::string& other) {
  std::vector<int> before(other.size() + 1);
  std::iota(before.begin(), before.end(), 0);
  for (std::size_t i = 0; i < one.size(); ++i) {
    std::vector<int> now{before[0] + 1};
    for (std::size_t j = 0; j < other.size(); ++j)
      now.push_back(
          std::min({now[j] + 1, before[j + 1] + 1, before[j] + (one[i] == other[j] ? 0 : 1)}));
    before = now;
  }
  return before.back();
}

}  // namespace

std::string property_name(const std::string& field) {
  std::string name;
  bool capital = false;
  for (const char letter : field) {
    if (letter != '_') name += capital ? static_cast<char>(std::toupper(letter)) : letter;
    capital = letter == '_';
  }
  return name;
}

LAMMPS_NS::FixPropertyGlobal* DeckProperties::find(const char* field, const char* shape, int rows,
                                                   int columns, bool required) const {
  used_.insert(property_name(field));
  return static_cast<LAMMPS_NS::FixPropertyGlobal*>(
      modify->find_fix_property(property_name(field).c_str(), "property/global", shape, rows,
                                columns, model_.c_str(), required));
}

bool DeckProperties::given(const char* field) const {
  return find(field, "scalar", 0, 0, false) || find(field, "vector", 0, 0, false) ||
         find(field, "matrix", 0, 0, false);
}

// Returns a property of the deck; null if the deck does not define it. LIGGGHTS stops if its shape
// is wrong.
LAMMPS_NS::FixPropertyGlobal* DeckProperties::values(const char* field, const char* shape, int rows,
                                                     int columns) const {
  return given(field) ? find(field, shape, rows, columns, true) : nullptr;
}

bool DeckProperties::positive(const char* field) const {
  for (int type = 1; type <= type_count_; ++type)
    if (per_type(field, type, "", 0) > 0) return true;
  return false;
}

double DeckProperties::per_type(const char* field, int type, const char* unit,
                                double fallback) const {
  if (const auto property = values(field, "peratomtype", type_count_, 0))
    return property->compute_vector(type - 1);
  if (!std::isnan(fallback)) return fallback;
  const std::string name = property_name(field);
  std::string similar;
  for (const std::string& other : unused_similar_to(name))
    similar += ". The deck defines " + other + ", possibly a misspelling";
  fail("property " + name + " is missing. Add one value [" + this->unit(unit) +
       "] per atom type: `fix ID all property/global " + name + " peratomtype VALUE ...`" +
       similar);
}

double DeckProperties::per_pair(const char* field, int type, int other_type,
                                double fallback) const {
  const auto property = values(field, "peratomtypepair", type_count_, type_count_);
  return property ? property->compute_array(type - 1, other_type - 1) : fallback;
}

std::vector<Body> DeckProperties::bodies(bool yields) const {
  std::vector<Body> bodies(type_count_);
  for (int type = 1; type <= type_count_; ++type)
    for (const BodyConstant& constant : body_constants) {
      const bool needed = yields && constant.value == &Body::yield_strength;
      bodies[type - 1].*constant.value =
          per_type(constant.name, type, constant.unit, needed ? required : constant.standard);
    }
  return bodies;
}

void DeckProperties::check_friction() const {
  for (const char* const field : {"coefficient_friction", "coefficient_rolling_friction"})
    for (int type = 1; type <= type_count_; ++type)
      for (int other = type; other <= type_count_; ++other) {
        const double value = per_pair(field, type, other, 0);
        if (value >= 0) continue;
        std::ostringstream text;
        text << property_name(field) << " is " << value << "; it must be 0 or more";
        fail(about_types(text.str(), type, other));
      }
}

void DeckProperties::fail(const std::string& reason) const { stop(lmp, model_ + ": " + reason); }

void DeckProperties::check(const Complaint& complaint) const {
  if (!complaint.empty()) fail(worded(complaint));
}

std::string DeckProperties::worded(const Complaint& complaint) const {
  return sentence_in_deck(update->unit_style, complaint.worded(property_name));
}

std::string DeckProperties::unit(const std::string& si) const {
  return unit_in_deck(update->unit_style, si);
}

std::vector<std::string> DeckProperties::unused_similar_to(const std::string& name) const {
  std::vector<std::string> names;
  for (LAMMPS_NS::FixPropertyGlobal* const property :
       fixes_of<LAMMPS_NS::FixPropertyGlobal>(modify)) {
    const std::string given = variable_name(property);
    if (!used_.count(given) && letters_apart(given, name) <= 2) names.push_back(given);
  }
  return names;
}

std::vector<std::string> DeckProperties::doubts(const std::vector<Body>& bodies,
                                                bool cohesive) const {
  std::vector<std::string> sentences = misspellings();
  const double pascal = pascal_in_deck(update->unit_style);
  for (int type = 1; pascal > 0 && type <= type_count_; ++type) {
    const Complaint complaint = implausible(bodies[type - 1], pascal);
    if (!complaint.empty()) sentences.push_back(about_types(worded(complaint), type));
  }
  for (int type = 1; cohesive && given("cohesion_energy_density") && type <= type_count_; ++type)
    for (int other = type; other <= type_count_; ++other) {
      const double pull = per_pair("cohesion_energy_density", type, other, 0);
      const double push = combine(bodies[type - 1], bodies[other - 1]).yield_pressure;
      if (!(pull > push)) continue;
      std::ostringstream text;
      text << "cohesionEnergyDensity is " << pull << " [" << unit("Pa")
           << "], above the yield pressure " << push
           << ", so cohesion sjkr or sjkr2 pulls these bodies into each other. Lower "
              "cohesionEnergyDensity";
      sentences.push_back(about_types(text.str(), type, other));
    }
  return sentences;
}

std::vector<std::string> DeckProperties::misspellings() const {
  std::vector<std::string> sentences;
  for (const std::string& name : used_)
    for (const std::string& other : unused_similar_to(name))
      sentences.push_back("property " + other + " is not used. Possible misspelling of " + name);
  return sentences;
}

}  // namespace plastigran
