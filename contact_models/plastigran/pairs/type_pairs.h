// SPDX-License-Identifier: GPL-2.0-or-later
//
// Laws of all pairs of atom types, for any host. For each pair of types, there is a law with the
// combined constants of two materials, or the reason why the two types must not touch.
//
//   TypePairs<Thornton> pairs;
//   const Complaint complaint = pairs.build(materials, Thornton::Parameters());
//   if (!complaint.empty()) stop(complaint);
//   TypePair<Thornton>& pair = pairs(type, other_type);  // pair.law, pair.refusal
#pragma once

#include <algorithm>
#include <cstddef>
#include <memory>
#include <sstream>
#include <string>
#include <string_view>
#include <vector>

#include "plastigran/impact/validate.h"
#include "plastigran/pairs/materials.h"
#include "plastigran/pairs/type_pair.h"
#include "plastigran/shared/complaint.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

template <class Law>
constexpr bool is_cylinder = std::string_view(shape<Law>) == std::string_view("cylinder");

// Returns the reason why a law cannot have the option `adhesion jkr` (tables/adhesive.h).
template <class Law>
const char* refusal_of_adhesion() {
  if (adhesive<Law>) return "the law has its own adhesion";
  if (is_cylinder<Law>) return "the law is for cylinders, and adhesion is for spheres";
  if (rate_dependent<Law>) return "the force of the law depends on the overlap rate";
  if (!elastic_first<Law>) return "the law is plastic from first touch";
  return "the law does not begin with Hertz' contact";
}

// Returns the options of a law and their choices as text, each option preceded by `separator`.
template <class Law>
std::string options_text(const typename Law::Parameters& choices, const char* separator) {
  std::string text;
  for (const auto& option : options_of<Law>) {
    const auto choice = static_cast<std::size_t>(choices.*option.value);
    text += std::string(separator) + option.name + ' ' + option.choices[choice];
  }
  return text;
}

template <class Law>
class TypePairs {
  typedef typename Law::Parameters Constants;

 public:
  // Builds the laws of all pairs. `defaults` contains the options, and the constants that the
  // materials do not define. Returns a complaint about an invalid value; empty if all are valid.
  Complaint build(const Materials& materials, const Constants& defaults) {
    Complaint complaint = validate(materials.bodies);
    if (complaint.empty()) complaint = wrong_body_constant(materials);
    if (!complaint.empty()) return complaint;
    materials_ = materials;
    type_count_ = static_cast<int>(materials.bodies.size());
    pairs_.clear();
    of_types_.assign(materials.bodies.size() * materials.bodies.size(), nullptr);
    for (int i = 1; i <= type_count(); ++i)
      for (int j = i; j <= type_count(); ++j) {
        pairs_.push_back(between(i, j, defaults));
        at(i, j) = at(j, i) = pairs_.back().get();
      }
    return {};
  }

  TypePair<Law>& operator()(int type, int other_type) { return *at(type, other_type); }

  // Returns one line of text for each pair of types that may touch: effective constants, constants
  // of the law, and options. Each line begins with `caller`. `assumed` is appended to each constant
  // that the deck does not define.
  std::string describe(const std::string& caller, const Words& words, const Constants& options,
                       const char* assumed) {
    std::ostringstream text;
    for (int i = 1; i <= type_count(); ++i)
      for (int j = i; j <= type_count(); ++j) {
        const TypePair<Law>& pair = (*this)(i, j);
        if (!pair.refusal.empty()) continue;
        const std::string pascal = ' ' + words.unit("Pa");
        text << caller << ", atom types " << i << " and " << j << ": effective modulus "
             << pair.bodies.youngs_modulus_eff << pascal;
        if (yields<Law>)
          text << ", yield strength " << pair.bodies.yield_strength << pascal << ", yield pressure "
               << pair.bodies.yield_pressure << pascal;
        if (pair.bodies.rate_coefficient > 0)
          text << ", rate coefficient " << pair.bodies.rate_coefficient << ", reference rate "
               << pair.bodies.reference_rate << ' ' << words.unit("1/s");
        const auto note = [&](const char* field) {
          return materials_.given.count(field) ? "" : assumed;
        };
        if (hardens<Law>)
          text << ", tangent modulus " << pair.bodies.tangent_modulus << pascal
               << note("tangent_modulus");
        for (const auto& parameter : parameters_of<Law>)
          text << ", " << words.name(parameter.name) << ' ' << pair.constants.*parameter.value
               << note(parameter.name);
        text << options_text<Law>(options, ", ") << '\n';
      }
    return text.str();
  }

  // Returns whether the yield strength of any pair depends on the strain rate.
  bool rate_matters() const {
    return std::any_of(pairs_.begin(), pairs_.end(), [](const auto& pair) {
      return takes_rate_factor<Law> && pair->bodies.rate_coefficient > 0;
    });
  }

  int type_count() const { return type_count_; }
  const std::vector<Body>& bodies() const { return materials_.bodies; }  // index k: type k + 1

 private:
  TypePair<Law>*& at(int type, int other_type) {
    return of_types_[static_cast<std::size_t>((type - 1) * type_count_ + other_type - 1)];
  }

  // Returns a complaint about an invalid constant of a body. The value 0 is valid, because the
  // other body of a pair may define the constant.
  static Complaint wrong_body_constant(const Materials& materials) {
    for (const auto& parameter : parameters_of<Law>) {
      const auto values = materials.constants.find(parameter.name);
      if (!parameter.per_body || values == materials.constants.end()) continue;
      for (std::size_t k = 0; k < values->second.size(); ++k) {
        const double value = values->second[k];
        const Complaint wrong = value == 0 ? Complaint() : complaint(parameter, value);
        if (!wrong.empty()) return about_types(wrong, static_cast<int>(k) + 1);
      }
    }
    return {};
  }

  std::unique_ptr<TypePair<Law>> between(int i, int j, Constants constants) const {
    Complaint lacking;
    const auto first = static_cast<std::size_t>(i) - 1, second = static_cast<std::size_t>(j) - 1;
    for (const auto& parameter : parameters_of<Law>) {
      const auto given = materials_.constants.find(parameter.name);
      const bool is_given = given != materials_.constants.end();
      double& value = constants.*parameter.value;
      if (!parameter.per_body) {
        if (is_given) value = given->second[first * materials_.bodies.size() + second];
        continue;
      }
      value = is_given ? std::max(given->second[first], given->second[second]) : 0;
      if (lacking.empty() && value == 0) lacking = complaint(parameter, 0);
    }
    const MaterialPair bodies = combine(materials_.bodies[first], materials_.bodies[second]);
    auto pair = std::make_unique<TypePair<Law>>(bodies, constants);
    pair->lacking = !lacking.empty();
    pair->refusal = pair->lacking ? Complaint(lacking.sentence() + "; one of the bodies needs it")
                                  : validate<Law>(bodies, constants);
    pair->refusal = about_types(pair->refusal, i, j);
    return pair;
  }

  int type_count_ = 0;
  Materials materials_;
  std::vector<std::unique_ptr<TypePair<Law>>> pairs_;
  std::vector<TypePair<Law>*> of_types_;  // the pair of types i, j at (i, j) and at (j, i)
};

}  // namespace plastigran
