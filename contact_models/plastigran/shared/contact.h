// SPDX-License-Identifier: GPL-2.0-or-later
//
// Interface of contact laws: the constants of two bodies in contact, and the response of a law.
// This header and the laws neither allocate nor throw, do not read mutable globals, and do not
// depend on a host program.
//
// A law is a class that is constructed from a MaterialPair and its own constants. It computes force
// and energies from the overlap and the history of a contact. It has these members:
//
//   name         name in decks; source: the publication; range: where the law is valid
//   Parameters   struct of the law's own constants, each with its default
//   State        struct of doubles, zero before first touch: extremes of the contact history,
//                which do not depend on the order of the two bodies
//   state_names  array of the names of these doubles, in their order
//   respond(radius_eff, overlap, state)
//                returns the Response, which depends on overlap and state only. It changes `state`
//                at a new extreme, so that a second call at the same overlap changes nothing. At
//                zero overlap, the response contains only the plastic work of the state
//
// A law may have more members:
//
//   parameters   table of its constants: name, unit, allowed range
//   options      table of the choices that its sources leave open
//   shape = "cylinder"      the bodies are cylinders, not spheres
//   rate_dependent = true   the force also depends on the overlap rate, positive while closing:
//                respond(radius_eff, overlap, state, overlap_rate = 0)   overlap_rate in m/s
//   yields = false          the law needs no yield strength
//   hardens = true          the law uses the tangent modulus
//   indentation = true      a hard sphere indents a flat; otherwise a sphere flattens
//   self_similar = true     F/F_y and a/a_y, as functions of overlap/overlap_y, do not depend on
//                the yield strength
//   respond_stronger(factor, radius_eff, overlap, state)
//                returns the response for the yield strength multiplied by `factor`
//   overlap_range()         largest overlap/R* for which the law is valid
//   overlap_breaks()        values of overlap/R* at which the force of first loading may jump
//   elastic_stiffness(contact_radius)      stiffness of the elastic contact
//   elastic_first = false   the contact is plastic from first touch; otherwise elastic to yield
//   adhesive = true         the force may be attractive; the law has pull_off_force()
//   pull_off_distance(radius_eff)          largest separation of bodies in contact. Such a law also
//                has the state member in_contact and the function energy_at_end() (adhesion.h)
//   plastic_work_in(state)  plastic work, for a law whose state contains it
//
// SI units throughout.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <tuple>
#include <type_traits>

#include "plastigran/shared/body.h"
#include "plastigran/shared/device.h"
#include "plastigran/shared/numerics.h"

namespace plastigran {

constexpr double pi = 3.14159265358979323846;

// Combined constants of two bodies in contact, independent of their order. The weaker body is the
// one with the lower yield pressure; only this body yields.
struct MaterialPair {
  double youngs_modulus_eff = 0;  // E*: 1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2 [Pa]
  double shear_modulus_eff = 0;   // G*: 1/G* = (2-nu1)/G1 + (2-nu2)/G2 [Pa]
  double yield_pressure = 0;      // p_y, contact pressure at which the weaker body yields [Pa]
  double yield_strength = 0;      // sigma_Y of the weaker body [Pa]
  double poissons_ratio = 0;      // nu of the weaker body [-]
  double youngs_modulus = 0;      // E of the weaker body [Pa]
  double tangent_modulus = 0;     // E_t of the weaker body [Pa]
  double rate_coefficient = 0;    // C of the weaker body [-]
  double reference_rate = 1;      // reference rate of the weaker body [1/s]
};

// Response of a law. Energies are totals since first touch. While the contact lasts,
// force * overlap_rate = d(elastic_energy + surface_energy + plastic_work)/dt
// + viscous_force * overlap_rate. The last term is dissipated and never negative.
struct Response {
  double force = 0;           // normal force, negative where the bodies attract each other [N]
  double contact_radius = 0;  // contact radius; half-width of a line contact [m]
  double elastic_energy = 0;  // energy that unloading would release [J]
  double plastic_work = 0;    // energy dissipated by plastic deformation [J]
  double viscous_force = 0;   // part of `force` due to the rate, negative while separating [N]
  double surface_energy = 0;  // surface energy relative to separated bodies, never positive [J]
  double pull_off_force = 0;  // largest attraction during unloading, if contacts can stretch [N]
};

PLASTIGRAN_DEVICE inline double contact_energy(const Response& response) {
  return response.elastic_energy + response.plastic_work + response.surface_energy;
}

// A choice that the sources of a law leave open. The value is an index into `choices`.
template <class Parameters>
struct Option {
  const char* name;
  int Parameters::*value;
  std::array<const char*, 3> choices;  // names of the choices; null after the last
  const char* meaning;
};

// Returns the option energy_guard, for laws whose published curves may release more energy than
// loading took.
template <class Parameters>
constexpr Option<Parameters> energy_guard_option(int Parameters::*value) {
  return {"energy_guard",
          value,
          {"off", "on", nullptr},
          "shorten the unloading curve so that plastic work never decreases"};
}

// One constant of a law: its name for users, and its range.
template <class Parameters>
struct Parameter {
  const char* name;
  const char* unit;
  double Parameters::*value;
  double lower, upper;  // allowed range, including both ends
  const char* meaning;
  // Whether the constant belongs to each body instead of the pair. It then has no default; 0 means
  // that it does not apply to a body. The pair uses the larger value.
  bool per_body = false;
};

// Base of laws without constants and options.
struct NoConstants {
  struct Parameters {};
};

// Optional members of a law, and their defaults.
template <class Law, class = void>
constexpr std::array<Parameter<typename Law::Parameters>, 0> parameters_of{};
template <class Law>
constexpr auto parameters_of<Law, std::void_t<decltype(Law::parameters)>> = Law::parameters;

template <class Law, class = void>
constexpr std::array<Option<typename Law::Parameters>, 0> options_of{};
template <class Law>
constexpr auto options_of<Law, std::void_t<decltype(Law::options)>> = Law::options;

// The next two functions return the constants and the options of a law, followed by `more`.
// `Parameters` derives from the parameters of the law.
template <class Law, class Parameters, class... More>
constexpr auto inherited_parameters(const More&... more) {
  std::array<Parameter<Parameters>, parameters_of<Law>.size() + sizeof...(More)> all{};
  std::size_t k = 0;
  for (const auto& p : parameters_of<Law>)
    all[k++] = {p.name, p.unit, p.value, p.lower, p.upper, p.meaning, p.per_body};
  ((all[k++] = more), ...);
  return all;
}
template <class Law, class Parameters, class... More>
constexpr auto inherited_options(const More&... more) {
  std::array<Option<Parameters>, options_of<Law>.size() + sizeof...(More)> all{};
  std::size_t k = 0;
  for (const auto& o : options_of<Law>) all[k++] = {o.name, o.value, o.choices, o.meaning};
  ((all[k++] = more), ...);
  return all;
}

template <class Law, class = void>
constexpr const char* shape = "sphere";
template <class Law>
constexpr const char* shape<Law, std::void_t<decltype(Law::shape)>> = Law::shape;

template <class Law, class = void>
constexpr bool rate_dependent = false;
template <class Law>
constexpr bool rate_dependent<Law, std::void_t<decltype(Law::rate_dependent)>> =
    Law::rate_dependent;

template <class Law, class = void>
constexpr bool yields = true;
template <class Law>
constexpr bool yields<Law, std::void_t<decltype(Law::yields)>> = Law::yields;

template <class Law, class = void>
constexpr bool elastic_first = true;
template <class Law>
constexpr bool elastic_first<Law, std::void_t<decltype(Law::elastic_first)>> = Law::elastic_first;

template <class Law, class = void>
constexpr bool adhesive = false;
template <class Law>
constexpr bool adhesive<Law, std::void_t<decltype(Law::adhesive)>> = Law::adhesive;

// Keywords that a deck appends to the line of another law to select this law, with a leading space,
// for example " adhesion jkr". Most laws need none.
template <class Law, class = void>
constexpr const char* line_option = "";
template <class Law>
constexpr const char* line_option<Law, std::void_t<decltype(Law::line_option)>> = Law::line_option;

template <class Law, class = void>
constexpr bool hardens = false;
template <class Law>
constexpr bool hardens<Law, std::void_t<decltype(Law::hardens)>> = Law::hardens;

template <class Law, class = void>
constexpr bool indentation = false;
template <class Law>
constexpr bool indentation<Law, std::void_t<decltype(Law::indentation)>> = Law::indentation;

// Returns the response of any law. Passes overlap_rate only to rate-dependent laws.
template <class Law>
PLASTIGRAN_DEVICE Response respond(const Law& law, double radius_eff, double overlap,
                                   typename Law::State& state, double overlap_rate) {
  if constexpr (rate_dependent<Law>)
    return law.respond(radius_eff, overlap, state, overlap_rate);
  else
    return law.respond(radius_eff, overlap, state);
}

// Whether a law defines plastic_work_in(), because its state contains the plastic work.
template <class Law, class = void>
constexpr bool keeps_plastic_work = false;
template <class Law>
constexpr bool keeps_plastic_work<Law, std::void_t<decltype(&Law::plastic_work_in)>> = true;

template <class Law>
PLASTIGRAN_DEVICE double plastic_work_of(const Law& law, [[maybe_unused]] double radius_eff,
                                         typename Law::State state) {
  if constexpr (keeps_plastic_work<Law>)
    return law.plastic_work_in(state);
  else
    return law.respond(radius_eff, 0, state).plastic_work;
}

// Largest valid overlap/R* of laws without overlap_range(). No contact law is valid for overlaps of
// the order of the radius.
constexpr double widest_overlap_range = 0.1;

template <class Law, class = void>
constexpr bool has_range = false;
template <class Law>
constexpr bool has_range<Law, std::void_t<decltype(&Law::overlap_range)>> = true;

template <class Law>
double overlap_range(const Law& law) {
  if constexpr (has_range<Law>)
    return law.overlap_range();
  else
    return widest_overlap_range;
}

// Returns p_y/sigma_Y at which a Hertz contact first yields below its center (von Mises). This is
// the inverse of the largest (von Mises stress)/(peak pressure) on the axis, the maximum of
// 1.5/(1+z^2) - (1+nu)(1 - z atan(1/z)) over z = depth/(contact radius). Johnson, Contact Mechanics
// (1985), sec. 3.4 and 4.1.
inline double hertz_yield_pressure_factor(double poissons_ratio) {
  const auto shear = [=](double z) {
    return 1.5 / (1 + z * z) - (1 + poissons_ratio) * (1 - z * std::atan2(1.0, z));
  };
  return 1 / shear(golden_section(shear, 0, 2, 80));
}

inline double yield_pressure(const Body& body) {
  const double factor = body.yield_pressure_factor > 0
                            ? body.yield_pressure_factor
                            : hertz_yield_pressure_factor(body.poissons_ratio);
  return factor * body.yield_strength;
}

// Returns (1-nu^2)/E [1/Pa] of a Body, or of the weaker body of a MaterialPair.
template <class Constants>
double plane_strain_compliance(const Constants& body) {
  return (1 - body.poissons_ratio * body.poissons_ratio) / body.youngs_modulus;
}

inline MaterialPair combine(const Body& a, const Body& b) {
  const auto shear_compliance = [](const Body& body) {
    return 2 * (2 - body.poissons_ratio) * (1 + body.poissons_ratio) / body.youngs_modulus;
  };
  // Compare further constants if the yield pressures are equal, so that the order of the bodies
  // never matters.
  const auto rank = [](const Body& body) {
    return std::make_tuple(yield_pressure(body), body.yield_strength, body.poissons_ratio,
                           body.youngs_modulus, body.tangent_modulus, body.rate_coefficient,
                           body.reference_rate);
  };
  const Body& weaker = rank(a) <= rank(b) ? a : b;
  MaterialPair pair;
  pair.youngs_modulus_eff = 1 / (plane_strain_compliance(a) + plane_strain_compliance(b));
  pair.shear_modulus_eff = 1 / (shear_compliance(a) + shear_compliance(b));
  pair.yield_pressure = yield_pressure(weaker);
  pair.yield_strength = weaker.yield_strength;
  pair.poissons_ratio = weaker.poissons_ratio;
  pair.youngs_modulus = weaker.youngs_modulus;
  pair.tangent_modulus = weaker.tangent_modulus;
  pair.rate_coefficient = weaker.rate_coefficient;
  pair.reference_rate = weaker.reference_rate;
  return pair;
}

// Returns a_Y/R* [-]: contact radius/effective radius when the peak Hertz pressure reaches p_y.
inline double yield_radius_ratio(const MaterialPair& pair) {
  return pi * pair.yield_pressure / (2 * pair.youngs_modulus_eff);
}

// Normal and tangential stiffness of an elastic contact [N/m], for springs and dashpots. A law may
// define its own elastic_stiffness(). Otherwise, the stiffness is that of elastic spheres (Mindlin
// 1949; Johnson, Contact Mechanics, 1985, sec. 4.2 and 7.2).
struct Stiffness {
  double normal, tangential;
};
template <class Law, class = void>
constexpr bool has_stiffness = false;
template <class Law>
constexpr bool has_stiffness<Law, std::void_t<decltype(&Law::elastic_stiffness)>> = true;

template <class Law>
PLASTIGRAN_DEVICE Stiffness elastic_stiffness(const Law& law, double youngs_modulus_eff,
                                              double shear_modulus_eff, double contact_radius) {
  if constexpr (has_stiffness<Law>)
    return law.elastic_stiffness(contact_radius);
  else
    return {2 * youngs_modulus_eff * contact_radius, 8 * shear_modulus_eff * contact_radius};
}

}  // namespace plastigran
