// SPDX-License-Identifier: GPL-2.0-or-later
//
// The law of every pair of atom types, with what belongs to that pair alone.
#pragma once

#include <algorithm>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "liggghts/model/deck_properties.h"
#include "plastigran/impact/central_impact.h"
#include "plastigran/impact/validate.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

// Whether bodies bring constants of the law's own (cylinders their length).
template <class Law>
constexpr bool takes_bodies = [] {
  for (const auto& parameter : parameters_of<Law>)
    if (parameter.per_body) return true;
  return false;
}();

template <class Law>
constexpr bool is_cylinder = std::string_view(shape<Law>) == std::string_view("cylinder");

// The law's options with their choices, each after a separator.
template <class Law>
std::string options_text(const typename Law::Parameters& choices, const char* separator) {
  std::string text;
  for (const auto& option : options_of<Law>)
    text += std::string(separator) + option.name + ' ' + option.choices[choices.*option.value];
  return text;
}

template <class Law>
struct TypePair {
  typedef typename Law::Parameters Constants;

  Law law;
  MaterialPair bodies;
  double watched = 0;   // overlap over R* from which on the contact watch looks at contacts
  double noted = 0;     // overlap over R* up to which it has
  double range;         // largest overlap over R* the law is good for
  std::string lacking;  // what neither body brings: an error once the two can meet
  Constants constants;

  TypePair(const MaterialPair& bodies_, const Constants& constants_, const std::string& lacking_)
      : law(bodies_, constants_),
        bodies(bodies_),
        range(overlap_range(law)),
        lacking(lacking_),
        constants(constants_) {}
};

template <class Law>
class TypePairs {
  typedef typename Law::Parameters Constants;

 public:
  // Of the deck's atom types; what it does not give of the law's constants stays as in `defaults`.
  void build(const DeckProperties& deck, int type_count, const Constants& defaults) {
    type_count_ = type_count;
    bodies_ = deck.bodies(yields<Law>);
    pairs_.clear();
    for (int i = 1; i <= type_count; ++i)
      for (int j = 1; j <= type_count; ++j)
        pairs_.push_back(j < i ? TypePair<Law>((*this)(j, i))  // the engine takes symmetric values
                               : between(deck, i, j, defaults));
  }

  TypePair<Law>& operator()(int type, int other_type) {
    return pairs_[(type - 1) * type_count_ + other_type - 1];
  }

  // A line for each two types that may meet: their effective constants, the law's own and its
  // options. `caller` begins each line.
  std::string describe(const std::string& caller, const DeckProperties& deck,
                       const Constants& options) {
    std::ostringstream text;
    for (int i = 1; i <= type_count_; ++i)
      for (int j = i; j <= type_count_; ++j) {
        const TypePair<Law>& pair = (*this)(i, j);
        if (!pair.lacking.empty()) continue;
        text << caller << ", atom types " << i << " and " << j << ": effective modulus "
             << pair.bodies.youngs_modulus_eff << " Pa";
        if (yields<Law>)
          text << ", yield strength " << pair.bodies.yield_strength << " Pa, yield pressure "
               << pair.bodies.yield_pressure << " Pa";
        for (const auto& parameter : parameters_of<Law>)
          text << ", " << property_name(parameter.name) << ' ' << pair.constants.*parameter.value
               << (deck.given(parameter.name) ? "" : " (default)");
        text << options_text<Law>(options, ", ") << '\n';
      }
    return text.str();
  }

  int type_count() const { return type_count_; }
  const std::vector<Body>& bodies() const { return bodies_; }  // by type - 1

 private:
  TypePair<Law> between(const DeckProperties& deck, int i, int j, Constants constants) const {
    std::string lacking;
    for (const auto& parameter : parameters_of<Law>) {
      double& value = constants.*parameter.value;
      if (!parameter.per_body) {
        value = deck.per_pair(parameter.name, i, j, value);
        continue;
      }
      value = larger_of_bodies(deck, parameter, i, j);
      if (lacking.empty() && value == 0)
        lacking = DeckProperties::about_types(
            DeckProperties::worded(complaint(parameter, 0)) + "; one of the two must have it", i,
            j);
    }
    const MaterialPair pair = combine(bodies_[i - 1], bodies_[j - 1]);
    if (lacking.empty()) deck.check(validate<Law>(pair, constants), i, j);
    return TypePair<Law>(pair, constants, lacking);
  }

  // A pair's value of a constant that bodies bring: the larger one; 0 says "not this body".
  static double larger_of_bodies(const DeckProperties& deck, const Parameter<Constants>& parameter,
                                 int type, int other_type) {
    double larger = 0;
    for (int each : {type, other_type}) {
      const double value = deck.per_type(parameter.name, each, parameter.unit);
      if (value != 0) deck.check(complaint(parameter, value), each);
      larger = std::max(larger, value);
    }
    return larger;
  }

  int type_count_ = 0;
  std::vector<Body> bodies_;
  std::vector<TypePair<Law>> pairs_;
};

}  // namespace plastigran
