// SPDX-License-Identifier: GPL-2.0-or-later
//
// The law of every pair of atom types, with what belongs to that pair alone.
#pragma once

#include <algorithm>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "liggghts/model/deck_properties.h"
#include "plastigran/impact/central_impact.h"
#include "plastigran/impact/validate.h"
#include "plastigran/shared/contact.h"
#include "plastigran/shared/rate_factor.h"

namespace plastigran {

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

  double watched = 0;    // overlap over R* from which on the contact watch looks at contacts
  std::string refusal;   // why the law is none for these two; empty when it is
  bool lacking = false;  // neither body brings what one must: refused once two particles can meet
  Law law;
  MaterialPair bodies;
  double noted = 0;  // overlap over R* up to which the contact watch has looked
  double range;      // largest overlap over R* the law is good for
  Constants constants;

  TypePair(const MaterialPair& bodies_, const Constants& constants_)
      : law(bodies_, constants_),
        bodies(bodies_),
        range(overlap_range(law)),
        constants(constants_) {}

  // The two with their strength at a rate factor; made when first asked for. A new one counts as
  // watched as deeply as the others.
  TypePair& strengthened(double factor) {
    const std::size_t steps = rate_factor_steps(factor);
    if (steps == 0) return *this;
    if (steps >= stronger_.size()) stronger_.resize(steps + 1);
    if (!stronger_[steps]) stronger_[steps] = make(factor);
    return *stronger_[steps];
  }

 private:
  std::shared_ptr<TypePair> make(double factor) const {
    auto made = std::make_shared<TypePair>(*this);
    made->stronger_.clear();
    made->bodies = plastigran::strengthened(bodies, factor);
    made->constants = strengthened_constants<Law>(constants, factor);
    made->law = Law(made->bodies, made->constants);
    made->range = overlap_range(made->law);
    for (const auto& other : stronger_)
      if (other && other->noted > made->noted)
        made->noted = other->noted, made->watched = other->watched;
    return made;
  }

  std::vector<std::shared_ptr<TypePair>> stronger_;  // by steps of the rate factor
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
    of_types_.assign(type_count * type_count, nullptr);
    for (int i = 1; i <= type_count; ++i)
      for (int j = i; j <= type_count; ++j) {  // the engine takes symmetric values
        pairs_.push_back(std::make_unique<TypePair<Law>>(between(deck, i, j, defaults)));
        at(i, j) = at(j, i) = pairs_.back().get();
      }
  }

  TypePair<Law>& operator()(int type, int other_type) { return *at(type, other_type); }

  // A line for each two types that may meet: their effective constants, the law's own and its
  // options. `caller` begins each line; `assumed` follows constants that the deck does not give.
  std::string describe(const std::string& caller, const DeckProperties& deck,
                       const Constants& options, const char* assumed) {
    std::ostringstream text;
    for (int i = 1; i <= type_count_; ++i)
      for (int j = i; j <= type_count_; ++j) {
        const TypePair<Law>& pair = (*this)(i, j);
        if (!pair.refusal.empty()) continue;
        const std::string pascal = ' ' + deck.unit("Pa");
        text << caller << ", atom types " << i << " and " << j << ": effective modulus "
             << pair.bodies.youngs_modulus_eff << pascal;
        if (yields<Law>)
          text << ", yield strength " << pair.bodies.yield_strength << pascal << ", yield pressure "
               << pair.bodies.yield_pressure << pascal;
        if (pair.bodies.rate_coefficient > 0)
          text << ", rate coefficient " << pair.bodies.rate_coefficient << ", reference rate "
               << pair.bodies.reference_rate << ' ' << deck.unit("1/s");
        if (hardens<Law>)
          text << ", tangent modulus " << pair.bodies.tangent_modulus << pascal
               << (deck.given("tangent_modulus") ? "" : assumed);
        for (const auto& parameter : parameters_of<Law>)
          text << ", " << property_name(parameter.name) << ' ' << pair.constants.*parameter.value
               << (deck.given(parameter.name) ? "" : assumed);
        text << options_text<Law>(options, ", ") << '\n';
      }
    return text.str();
  }

  // Whether the strength of any two depends on the rate of their impact.
  bool rate_matters() const {
    return std::any_of(pairs_.begin(), pairs_.end(), [](const auto& pair) {
      return yields<Law> && pair->bodies.rate_coefficient > 0;
    });
  }

  int type_count() const { return type_count_; }
  const std::vector<Body>& bodies() const { return bodies_; }  // by type - 1

 private:
  TypePair<Law>*& at(int type, int other_type) {
    return of_types_[(type - 1) * type_count_ + other_type - 1];
  }

  TypePair<Law> between(const DeckProperties& deck, int i, int j, Constants constants) const {
    Complaint lacking;
    for (const auto& parameter : parameters_of<Law>) {
      double& value = constants.*parameter.value;
      if (!parameter.per_body) {
        value = deck.per_pair(parameter.name, i, j, value);
        continue;
      }
      value = larger_of_bodies(deck, parameter, i, j);
      if (lacking.empty() && value == 0) lacking = complaint(parameter, 0);
    }
    const MaterialPair bodies = combine(bodies_[i - 1], bodies_[j - 1]);
    TypePair<Law> pair(bodies, constants);
    pair.lacking = !lacking.empty();
    std::string reason = deck.worded(pair.lacking ? lacking : validate<Law>(bodies, constants));
    if (pair.lacking) reason += "; one of the two must have it";
    if (!reason.empty()) pair.refusal = DeckProperties::about_types(reason, i, j);
    return pair;
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
  std::vector<std::unique_ptr<TypePair<Law>>> pairs_;
  std::vector<TypePair<Law>*> of_types_;  // in either order
};

}  // namespace plastigran
