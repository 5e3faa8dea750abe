// SPDX-License-Identifier: GPL-2.0-or-later
//
// A law, its history and its answers as Python sees them, whichever law it is: what one function
// can do for all laws, it does through these.
#pragma once

#include <array>
#include <cstring>
#include <string>
#include <vector>

#include "arguments.h"
#include "plastigran/impact/central_impact.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

// History of one contact of a law.
struct AnyState {
  static constexpr std::size_t capacity = 8;
  const char* law;  // its name
  const char* const* names;
  std::size_t count;
  std::array<double, capacity> values{};
};

class AnyLaw {
 public:
  virtual ~AnyLaw() = default;
  virtual const char* name() const = 0;
  virtual Response respond(double radius_eff, double overlap, double* state,
                           double overlap_rate) const = 0;
  virtual ImpactOutcome central_impact(double radius_eff, double mass_eff, double speed) const = 0;
  virtual double overlap_range() const = 0;
  virtual double pull_off_distance(double radius_eff) const = 0;
  virtual double pull_off_force(double radius_eff, double overlap, const double* state) const = 0;
  // `impact` is the outcome of central_impact() for the same arguments.
  virtual double recommended_timestep(double radius_eff, double mass_eff, double speed,
                                      const ImpactOutcome& impact) const = 0;
};

// Histories of an array of contacts: those given, or those of first loading.
class States {
 public:
  // One for each element, or for each path along the last axis of `shape`. Raises TypeError for
  // another law's state, ValueError when there are more or fewer than asked for.
  States(const AnyLaw& law, const nb::object& given, std::vector<std::size_t> shape);
  double* operator[](std::size_t contact) {
    return given_.empty() ? untouched_[contact].data() : given_[contact]->values.data();
  }

 private:
  nb::object kept_;
  std::vector<AnyState*> given_;
  std::vector<std::array<double, AnyState::capacity>> untouched_;
};

}  // namespace plastigran
