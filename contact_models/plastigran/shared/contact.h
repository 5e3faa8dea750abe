// SPDX-License-Identifier: GPL-2.0-or-later
//
// The vocabulary every contact law shares: what two bodies bring to a contact, and what a law
// answers. Nothing here or in a law allocates, throws, reads a global that changes or knows a host
// program.
//
// A law is a class over a MaterialPair. It answers one question: two bodies overlap by this much
// and have this history; what force, what energy? It provides
//
//   name         the word a user types; source, range: where it is from, how far it is good
//   Parameters   a struct of the law's own constants, each with its default
//   State        a struct of doubles, zero before first touch: the extremes the contact has
//                reached, symmetric in the two bodies
//   respond(radius_eff, overlap, state)
//                the Response on the total law; moves `state` when a new extreme is reached, so
//                that a second call at the same overlap changes nothing; at no overlap, the
//                plastic work of the state alone
//
// and may say more of itself:
//
//   parameters   a table of its constants: name, unit, allowed range
//   options      a table of the choices its sources leave open
//   shape = "cylinder"      the bodies are no spheres
//   rate_dependent = true   the force depends on the rate of overlap, too [m/s, closing positive]:
//                respond(radius_eff, overlap, state, overlap_rate = 0), a total law at rate zero
//   yields = false          no yield: the yield strength is not asked for
//   hardens = true          the tangent modulus matters
//   indentation = true      of a flat that a hard sphere dents; else a sphere flattens
//   self_similar = true     its curves in yield units do not depend on the yield strength
//   respond_stronger(factor, radius_eff, overlap, state)    with the yield strength times a factor
//   overlap_range()         the largest overlap over R* it is good for
//   overlap_breaks()        overlaps over R* at which the virgin force may jump
//   elastic_stiffness(contact_radius)      of the elastic contact
//   elastic_first = false   plastic from first touch; else elastic to yield
//   adhesive = true         the force may be attractive; the law has pull_off_force()
//   pull_off_distance(radius_eff)    largest separation of bodies in contact; the state then has
//                the member in_contact (adhesion.h)
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

// What two bodies bring to any contact between them; the same in either order. The weaker body is
// the one that yields.
struct MaterialPair {
  double youngs_modulus_eff = 0;  // E*: 1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2 [Pa]
  double shear_modulus_eff = 0;   // G*: 1/G* = (2-nu1)/G1 + (2-nu2)/G2 [Pa]
  double yield_pressure = 0;      // p_y, contact pressure at which the weaker body yields [Pa]
  double yield_strength = 0;      // sigma_Y of the weaker body [Pa]
  double poissons_ratio = 0;      // nu of the weaker body [-]
  double youngs_modulus = 0;      // E of the weaker body [Pa]
  double tangent_modulus = 0;     // E_t of the weaker body [Pa]
  double rate_coefficient = 0;    // C of the weaker body [-]
  double reference_rate = 1;      // of the weaker body [1/s]
};

// A law's answer. Energies are totals since first touch. While the contact lasts and the overlap
// grows at `overlap_rate`, force * overlap_rate is the growth rate of elastic_energy,
// surface_energy and plastic_work together, plus the loss viscous_force * overlap_rate >= 0.
struct Response {
  double force = 0;           // normal force, negative where the bodies attract each other [N]
  double contact_radius = 0;  // of a line contact the half-width [m]
  double elastic_energy = 0;  // what unloading from here would give back [J]
  double plastic_work = 0;    // what it will not [J]
  double viscous_force = 0;   // the rate's share of `force`, negative while parting [N]
  double surface_energy =
      0;  // of the contact area, relative to separated bodies; never positive [J]
};

PLASTIGRAN_DEVICE inline double contact_energy(const Response& response) {
  return response.elastic_energy + response.plastic_work + response.surface_energy;
}

// A choice a law leaves to the user, where its sources leave it open: an index into `choices`.
template <class Parameters>
struct Option {
  const char* name;
  int Parameters::*value;
  std::array<const char*, 3> choices;  // null where there are fewer
  const char* meaning;
};

// The option of laws that, as published, may return more energy than was put in.
template <class Parameters>
constexpr Option<Parameters> energy_guard_option(int Parameters::*value) {
  return {"energy_guard", value, {"off", "on", nullptr}, "the work lost never falls"};
}

// One constant of a law: how users name it and what it may be.
template <class Parameters>
struct Parameter {
  const char* name;
  const char* unit;
  double Parameters::*value;
  double lower, upper;  // allowed range, ends included
  const char* meaning;
  // A constant of each body instead of the pair, without a default: 0 for a body it does not
  // describe; the pair has the larger of two.
  bool per_body = false;
};

// Laws without constants or choices of their own say so with this base.
struct NoConstants {
  struct Parameters {};
};

// What a law says of itself, and what holds where it says nothing: its constants, its choices, the
// shape of its bodies, whether the rate of overlap matters, whether the bodies yield and harden,
// which one yields.
template <class Law, class = void>
constexpr std::array<Parameter<typename Law::Parameters>, 0> parameters_of{};
template <class Law>
constexpr auto parameters_of<Law, std::void_t<decltype(Law::parameters)>> = Law::parameters;

template <class Law, class = void>
constexpr std::array<Option<typename Law::Parameters>, 0> options_of{};
template <class Law>
constexpr auto options_of<Law, std::void_t<decltype(Law::options)>> = Law::options;

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

template <class Law, class = void>
constexpr bool hardens = false;
template <class Law>
constexpr bool hardens<Law, std::void_t<decltype(Law::hardens)>> = Law::hardens;

template <class Law, class = void>
constexpr bool indentation = false;
template <class Law>
constexpr bool indentation<Law, std::void_t<decltype(Law::indentation)>> = Law::indentation;

// Ask any law; one that does not depend on the rate never sees it.
template <class Law>
PLASTIGRAN_DEVICE Response respond(const Law& law, double radius_eff, double overlap,
                                   typename Law::State& state, double overlap_rate) {
  if constexpr (rate_dependent<Law>)
    return law.respond(radius_eff, overlap, state, overlap_rate);
  else
    return law.respond(radius_eff, overlap, state);
}

// Plastic work of a contact with this history [J]. A law whose history contains it has a function.
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

// Largest overlap over R* a law is good for. No contact law is good for overlaps of the order of
// the radius: 0.1, unless the law says otherwise.
constexpr double widest_overlap_range = 0.1;

template <class Law, class = void>
constexpr bool says_range = false;
template <class Law>
constexpr bool says_range<Law, std::void_t<decltype(&Law::overlap_range)>> = true;

template <class Law>
double overlap_range(const Law& law) {
  if constexpr (says_range<Law>)
    return law.overlap_range();
  else
    return widest_overlap_range;
}

// p_y / sigma_Y at which a Hertzian contact first yields (von Mises) below its centre: the inverse
// of the largest shear over peak pressure on the axis, max over z (depth / contact radius) of
// 1.5/(1+z^2) - (1+nu)(1 - z atan(1/z)). Johnson, Contact Mechanics (1985), sec. 3.4 and 4.1.
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

// (1-nu^2)/E [1/Pa], of a Body or of a MaterialPair's weaker body.
template <class Constants>
double plane_strain_compliance(const Constants& body) {
  return (1 - body.poissons_ratio * body.poissons_ratio) / body.youngs_modulus;
}

inline MaterialPair combine(const Body& a, const Body& b) {
  const auto shear_compliance = [](const Body& body) {
    return 2 * (2 - body.poissons_ratio) * (1 + body.poissons_ratio) / body.youngs_modulus;
  };
  // The one that yields at the lower pressure; ties are broken so that the order never matters.
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

// a_Y / R*: contact radius over effective radius when the peak Hertz pressure reaches p_y.
inline double yield_radius_ratio(const MaterialPair& pair) {
  return pi * pair.yield_pressure / (2 * pair.youngs_modulus_eff);
}

// Stiffness of the elastic contact with a given contact radius [N/m], for springs and dashpots
// along and across the normal. A law of other bodies than spheres says its own. Spheres: Mindlin
// 1949; Johnson, Contact Mechanics (1985), sec. 4.2 and 7.2.
struct Stiffness {
  double normal, tangential;
};
template <class Law, class = void>
constexpr bool says_stiffness = false;
template <class Law>
constexpr bool says_stiffness<Law, std::void_t<decltype(&Law::elastic_stiffness)>> = true;

template <class Law>
PLASTIGRAN_DEVICE Stiffness elastic_stiffness(const Law& law, double youngs_modulus_eff,
                                              double shear_modulus_eff, double contact_radius) {
  if constexpr (says_stiffness<Law>)
    return law.elastic_stiffness(contact_radius);
  else
    return {2 * youngs_modulus_eff * contact_radius, 8 * shear_modulus_eff * contact_radius};
}

}  // namespace plastigran
