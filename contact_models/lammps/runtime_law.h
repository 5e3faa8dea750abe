// SPDX-License-Identifier: GPL-2.0-or-later
//
// A law between two materials, selected by its name at run time. The functions receive the state of
// a contact as a pointer to its values in the contact history. The argument `factor` is the rate
// factor of the contact, which multiplies the yield strength.
#pragma once

#include <algorithm>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

#include "lammps/contact_line.h"
#include "plastigran/impact/central_impact.h"
#include "plastigran/impact/validate.h"
#include "plastigran/pairs/range_account.h"
#include "plastigran/pairs/type_pair.h"
#include "plastigran/pairs/type_pairs.h"
#include "plastigran/shared/adhesion.h"
#include "plastigran/shared/contact.h"
#include "plastigran/shared/rate_factor.h"
#include "plastigran/tables/adhesive.h"

namespace plastigran {

// Result of the check of an expected impact.
struct ImpactCheck {
  double timestep;  // recommended time step [s]
  bool in_range;    // whether the impact stays in the validity range of the law
};

class RuntimeLaw {
 public:
  static constexpr std::size_t capacity = 8;  // largest number of values of a state

  virtual ~RuntimeLaw() = default;
  // Returns the response of the law, including the pull-off force, and updates the state.
  virtual Response respond(double radius_eff, double overlap, double overlap_rate, double factor,
                           double* state) const = 0;
  // Returns the same response as respond(), but without energies, which takes less time.
  virtual Response forces(double radius_eff, double overlap, double overlap_rate, double factor,
                          double* state) const = 0;
  virtual double plastic_work(double radius_eff, double factor, const double* state) const = 0;
  virtual double pull_off_distance(double radius_eff) const = 0;
  // Returns the energy that is lost if the contact formed or broke in a step [J]. `before` and
  // `now` are the states before and after the step.
  virtual double lost_at_ends(double radius_eff, const double* before, const double* now) const = 0;
  // Returns whether the bodies are in contact; always true for laws whose contacts cannot last
  // without overlap.
  virtual bool in_contact(const double* state) const = 0;
  // Returns the tangential stiffness without slip [N/m].
  virtual double tangential_stiffness(double contact_radius) const = 0;
  virtual ImpactCheck check_impact(double radius_eff, double mass_eff, double speed) const = 0;
  virtual double range_at(double factor) const = 0;  // largest valid overlap/R* at a rate factor
  // Counts a contact beyond the validity range in `account`.
  virtual void count(RangeAccount& account, double factor,
                     const DeepContact<const double*>& contact) const = 0;

  // Returns whether the yield strength depends on the strain rate.
  bool has_rate() const { return bodies.rate_coefficient > 0; }
  double rate_factor(double radius_eff, double closing_speed) const {
    return plastigran::rate_factor(bodies, radius_eff, closing_speed);
  }

  std::size_t state_size = 0;  // number of values of a state
  bool attracts = false;       // whether the force may be attractive
  bool stretches = false;      // whether contacts can last without overlap
  double range = 0;            // largest overlap/R* for which the law is valid, at rate factor 1
  const char *name = "", *range_words = "";  // name of the law, and its validity range in words
  MaterialPair bodies;
};

template <class Law>
class RuntimeLawOf : public RuntimeLaw {
  typedef typename Law::State LawState;
  static constexpr std::size_t bytes = Law::state_names.size() * sizeof(double);
  static_assert(Law::state_names.size() <= capacity);

 public:
  RuntimeLawOf(const MaterialPair& pair, const typename Law::Parameters& constants)
      : pair_(pair, constants) {
    state_size = Law::state_names.size();
    attracts = adhesive<Law>;
    stretches = can_stretch<Law>;
    range = pair_.range;
    name = Law::name;
    range_words = Law::range;
    bodies = pair;
    if (!yields<Law>) bodies.rate_coefficient = 0;
  }

  Response respond(double radius_eff, double overlap, double overlap_rate, double factor,
                   double* state) const override {
    LawState now = read(state);
    Response response = factor == 1
                            ? plastigran::respond(pair_.law, radius_eff, overlap, now, overlap_rate)
                            : at_factor(radius_eff, overlap, overlap_rate, factor, now);
    response.pull_off_force =
        plastigran::pull_off_force(pair_.law, radius_eff, overlap, now, response);
    std::memcpy(state, static_cast<const void*>(&now), bytes);
    return response;
  }
  // The attribute `flatten` inlines the law, so that the compiler can omit its energies.
  [[gnu::flatten]] Response forces(double radius_eff, double overlap, double overlap_rate,
                                   double factor, double* state) const override {
    const Response all = RuntimeLawOf::respond(radius_eff, overlap, overlap_rate, factor, state);
    Response needed;
    needed.force = all.force;
    needed.viscous_force = all.viscous_force;
    needed.contact_radius = all.contact_radius;
    needed.pull_off_force = all.pull_off_force;
    return needed;
  }
  double plastic_work(double radius_eff, double factor, const double* state) const override {
    return pair_.at_factor(factor, [&](const auto& law, double) {
      return plastigran::plastic_work_of(law, radius_eff, read(state));
    });
  }
  double pull_off_distance(double radius_eff) const override {
    return plastigran::pull_off_distance(pair_.law, radius_eff);
  }
  double lost_at_ends(double radius_eff, const double* before, const double* now) const override {
    return plastigran::lost_at_ends(pair_.law, radius_eff, read(before), read(now));
  }
  bool in_contact(const double* state) const override {
    if constexpr (can_stretch<Law>)
      return read(state).in_contact != 0;
    else
      return true;
  }
  double tangential_stiffness(double contact_radius) const override {
    return elastic_stiffness(pair_.law, bodies.youngs_modulus_eff, bodies.shear_modulus_eff,
                             contact_radius)
        .tangential;
  }
  ImpactCheck check_impact(double radius_eff, double mass_eff, double speed) const override {
    return pair_.at_factor(rate_factor(radius_eff, speed), [&](const auto& law, double) {
      const ImpactOutcome impact = central_impact(law, radius_eff, mass_eff, speed);
      return ImpactCheck{recommended_timestep(law, radius_eff, mass_eff, speed, impact),
                         impact.in_range};
    });
  }
  double range_at(double factor) const override {
    return pair_.at_factor(factor, [](const auto&, double range_) { return range_; });
  }
  void count(RangeAccount& account, double factor,
             const DeepContact<const double*>& contact) const override {
    const LawState before = read(contact.before), now = read(contact.now);
    pair_.at_factor(factor, [&](const auto& law, double range_) {
      account.add(law, range_,
                  {contact.radius_eff, contact.overlap, contact.closing, before, now,
                   contact.has_moved_freely, contact.share});
    });
  }

 private:
  [[gnu::noinline]] Response at_factor(double radius_eff, double overlap, double overlap_rate,
                                       double factor, LawState& state) const {
    return pair_.at_factor(factor, [&](const auto& law, double) {
      return plastigran::respond(law, radius_eff, overlap, state, overlap_rate);
    });
  }
  static LawState read(const double* state) {
    LawState own;
    std::memcpy(static_cast<void*>(&own), state, bytes);
    return own;
  }

  TypePair<Law> pair_;
};

// A law with its name in decks. `make` creates the law from a line. If a word or value of the line
// is invalid, `make` returns null and sets the complaint.
struct NamedLaw {
  const char* name;
  std::shared_ptr<const RuntimeLaw> (*make)(const ContactLine& line, const Body& one,
                                            const Body& other, Complaint& complaint);
};

const std::vector<const NamedLaw*>& named_laws();

// Sets the constants and options of a law from its line. Skips the option `adhesion`, because
// make_law() reads it to select the class of the law.
template <class Law>
Complaint read_constants(const ContactLine& line, typename Law::Parameters& constants) {
  std::string names = " adhesion";
  std::size_t used = line.law_words.count("adhesion");
  for (const auto& parameter : parameters_of<Law>) {
    names += std::string(" ") + parameter.name;
    const auto word = line.law_words.find(parameter.name);
    if (word == line.law_words.end()) continue;
    ++used;
    if (!to_number(word->second, constants.*parameter.value))
      return not_a_number(word->first, word->second);
  }
  for (const auto& option : options_of<Law>) {
    names += std::string(" ") + option.name;
    const auto word = line.law_words.find(option.name);
    if (word == line.law_words.end()) continue;
    ++used;
    std::string choices;
    int choice = -1;
    for (std::size_t k = 0; k < option.choices.size() && option.choices[k]; ++k) {
      choices += (k ? " or " : "") + std::string(option.choices[k]);
      if (word->second == option.choices[k]) choice = static_cast<int>(k);
    }
    if (choice < 0)
      return Complaint('{' + word->first + "} is " + word->second + "; it must be " + choices);
    constants.*option.value = choice;
  }
  if (used == line.law_words.size()) return {};
  for (const auto& [name, value] : line.law_words)
    if ((names + ' ').find(' ' + name + ' ') == std::string::npos)
      return Complaint("there is no constant or option `" + name + "`; the law has" + names +
                       ", and a body has " + body_words());
  return {};
}

template <class Law>
std::shared_ptr<const RuntimeLaw> make_runtime_law(const ContactLine& line, const Body& one,
                                                   const Body& other, Complaint& complaint) {
  typename Law::Parameters constants;
  complaint = is_cylinder<Law> ? Complaint("the law is for cylinders; use a law for spheres")
                               : read_constants<Law>(line, constants);
  for (const Body* const body : {&one, &other})
    if (complaint.empty()) complaint = validate(*body);
  const MaterialPair bodies = combine(one, other);
  if (complaint.empty()) complaint = validate<Law>(bodies, constants);
  if (!complaint.empty()) return nullptr;
  return std::make_shared<RuntimeLawOf<Law>>(bodies, constants);
}

template <class Law>
std::shared_ptr<const RuntimeLaw> make_law(const ContactLine& line, const Body& one,
                                           const Body& other, Complaint& complaint) {
  const auto adhesion = line.law_words.find("adhesion");
  if (adhesion == line.law_words.end() || adhesion->second == "off")
    return make_runtime_law<Law>(line, one, other, complaint);
  if (adhesion->second != "jkr") {
    complaint = Complaint("{adhesion} is " + adhesion->second + "; it must be off or jkr");
    return nullptr;
  }
  if constexpr (takes_adhesion<Law>) {
    return make_runtime_law<Adhesive<Law>>(line, one, other, complaint);
  } else {
    complaint = Complaint(std::string("adhesion jkr is not supported, because ") +
                          refusal_of_adhesion<Law>());
    return nullptr;
  }
}

}  // namespace plastigran
