// SPDX-License-Identifier: GPL-2.0-or-later
//
// Interfaces that hide the C++ types of a law and of a contact history, so that one Python binding
// works for all laws.
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
  const char* law;           // name of the law
  const char* const* names;  // names of the values
  std::size_t count;         // number of values
  std::array<double, capacity> values{};
};

class AnyLaw {
 public:
  virtual ~AnyLaw() = default;
  virtual const char* name() const = 0;
  virtual const char* const* state_names() const = 0;
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

// Returns whether a history belongs to a law. Compares the name of the law and the names of the
// state variables, because adhesion changes only the state variables of a law, not its name.
inline bool is_state_of(const AnyState& state, const AnyLaw& law) {
  return state.law == law.name() && state.names == law.state_names();
}

// Histories of an array of contacts: the State objects that the caller passes, or zeros for first
// loading.
class States {
 public:
  // Creates one history per contact; `shape` is the shape of the array of contacts. Raises
  // TypeError for the State of another law, and ValueError for a wrong number of states.
  States(const AnyLaw& law, const nb::object& given, std::vector<std::size_t> shape);
  double* operator[](std::size_t contact) {
    return given_.empty() ? untouched_[contact].data() : given_[contact]->values.data();
  }

 private:
  nb::object kept_;  // keeps the State objects alive
  std::vector<AnyState*> given_;
  std::vector<std::array<double, AnyState::capacity>> untouched_;
};

}  // namespace plastigran
