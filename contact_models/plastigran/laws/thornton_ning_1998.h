// SPDX-License-Identifier: GPL-2.0-or-later
//
// Thornton & Ning 1998 (Powder Technol. 99:154): JKR (laws/jkr.h) until the pressure at the center
// of the contact reaches p_y; beyond, the pressure is limited. Unloading is JKR with the radius
// R_p* of the flattened contact. With s = a^(1/2), P_c = 3/2 pi Gamma R* and
// c = (2 pi Gamma/E*)^(1/2):
//
//   p_y = 2 E* a_y/(pi R*) - (2 Gamma E*/(pi a_y))^(1/2)                           yield
//   F = F_y + pi p_y (a^2 - a_y^2) - 2 E* c a_y (s - s_y),  overlap = s^4/R* - c s  beyond
//   R_p* = R* P_1/(F_max + 2 (P_c P_1)^(1/2)),  P_1 = 4 E* a_max^3/(3 R*)          unloading
//   overlap - overlap_p = s^4/R_p* - c s,  overlap_p = a_max^2 (1/R* - 1/R_p*)
//
// The paper gives dF/d(overlap) beyond yield; F is its integral, as a function of the contact
// radius. Without adhesion the law equals `thornton`; without yield it equals `jkr`. After
// pull-off, the contact forms again at overlap_p, where the flattened surfaces touch.
//
// If a contact yields at s_y^3 < 5/4 c R*, it is under tension. The published unloading then
// releases more energy than loading took. With the option energy_guard, such a contact yields at
// s_y^3 = 5/4 c R*, which corresponds to a larger p_y.
//
// Range: a << R*; as `thornton`, the force is too low well beyond yield.
#pragma once

#include "plastigran/shared/adhesion.h"
#include "plastigran/tables/tabulated.h"

namespace plastigran {

class ThorntonNing1998 {
 public:
  static constexpr const char* name = "thornton_ning_1998";
  static constexpr const char* source = "Thornton & Ning 1998, Powder Technol. 99:154";
  static constexpr const char* range = "a << R*; force too low well beyond yield";
  static constexpr bool adhesive = true;

  struct Parameters {
    double surface_energy = required;
    int energy_guard = 1;
  };
  static constexpr std::array<Parameter<Parameters>, 1> parameters{
      {{"surface_energy", "J/m^2", &Parameters::surface_energy, 0, 1e3,
        "work of adhesion Gamma of the two surfaces"}}};
  static constexpr std::array<Option<Parameters>, 1> options{
      {energy_guard_option<Parameters>(&Parameters::energy_guard)}};

  struct State {
    double in_contact = 0;          // 1 from first touch to pull-off
    double contact_radius_max = 0;  // largest contact radius beyond yield [m]; 0 while elastic
  };
  static constexpr std::array<const char*, 2> state_names{"in_contact", "contact_radius_max"};

  ThorntonNing1998(const MaterialPair& pair, const Parameters& constants)
      : contact_(pair.youngs_modulus_eff, constants.surface_energy),
        pressure_(pi * pair.yield_pressure),
        guarded_(constants.energy_guard == 1),
        root_unit_(contact_.pull() * contact_.modulus() / pressure_),
        per_length_(contact_.pull() / (root_unit_ * root_unit_ * root_unit_)) {
    const auto in_units = [this](double x) {
      const Yield yield = computed_yield(x / per_length_);
      return std::array{yield.root / root_unit_, yield.pressure / pressure_};
    };
    constexpr double guard_ends = 2.7;
    yields_ = Yields(1, in_units, std::array{guard_ends});
  }

  double pull_off_distance(double radius_eff) const {
    return -contact_.pull_off_overlap(radius_eff);
  }

  PLASTIGRAN_DEVICE double pull_off_force(double radius_eff, double, const State& state) const {
    return contact_.pull_off_force(unloading_radius(radius_eff, state));
  }
  double energy_at_end(double radius_eff, const State& before, bool forms) const {
    return contact_.energy_at_end(unloading_radius(radius_eff, before), forms);
  }
  PLASTIGRAN_DEVICE double unloading_radius(double radius_eff, const State& state) const {  // R_p*
    if (state.contact_radius_max == 0) return radius_eff;
    return flatten(radius_eff, yield_of(radius_eff), std::sqrt(state.contact_radius_max)).radius;
  }

  PLASTIGRAN_DEVICE Response respond(double radius_eff, double overlap, State& state) const {
    const Yield yield = yield_of(radius_eff);
    const double reached = std::sqrt(state.contact_radius_max);
    Flattened flattened{radius_eff, 0};
    if (reached > 0) flattened = flatten(radius_eff, yield, reached);
    const double beyond_touch = overlap - flattened.overlap;
    if (state.in_contact == 0 && !(beyond_touch > 0)) return apart(radius_eff, yield, reached);
    if (!(beyond_touch > 0) && !(beyond_touch >= contact_.pull_off_overlap(flattened.radius))) {
      state.in_contact = 0;
      return apart(radius_eff, yield, reached);
    }
    state.in_contact = 1;
    double root;
    if (overlap > contact_.overlap(radius_eff, std::max(reached, yield.root))) {
      root = contact_.root(radius_eff, overlap);
      state.contact_radius_max = root * root;
      flattened = flatten(radius_eff, yield, root);
    } else {
      root = contact_.root(flattened.radius, beyond_touch);
    }
    Response response = contact_.at(flattened.radius, root);
    response.plastic_work = plastic_work(radius_eff, yield, std::sqrt(state.contact_radius_max));
    return response;
  }

 private:
  struct Yield {
    double root;      // s_y
    double pressure;  // pi p_y
  };
  struct Flattened {
    double radius, overlap;  // R_p*, overlap_p
  };

  // Returns pi p_y and s_y, the square root of the contact radius at yield.
  PLASTIGRAN_DEVICE Yield yield_of(double radius_eff) const {
    const double x = radius_eff * per_length_;
    if (!yields_.covers(x)) return computed_yield(radius_eff);
    const auto [root, pressure] = yields_(x);
    return {root_unit_ * root, pressure_ * pressure};
  }
  // Computes s_y = a_y^(1/2), the root of 2 s^3/R* - pi p_y/E* s - c = 0 with
  // c = (2 pi Gamma/E*)^(1/2). If the energy guard is on and s_y is too small, increases s_y and
  // the pressure.
  [[gnu::noinline, gnu::cold]] PLASTIGRAN_DEVICE Yield computed_yield(double radius_eff) const {
    const double half = 0.25 * contact_.pull() * radius_eff;
    const double area = pressure_ * radius_eff / (2 * contact_.modulus()), scale = std::sqrt(area);
    double root = scale * root_at_yield(2 * half / (scale * area));
    if (!guarded_ || root * root * root >= 5 * half) return {root, pressure_};
    root = std::cbrt(5 * half);
    return {root, contact_.modulus() * 1.5 * contact_.pull() / root};
  }

  // Returns F + 2 E* c s^3 beyond yield, with s = a^(1/2). This is the force of a contact of the
  // same radius without adhesion. F_y is eliminated by the yield condition.
  PLASTIGRAN_DEVICE double force_without_pull(Yield yield, double s) const {
    const double square = s * s, area = yield.root * yield.root;
    const double pull = 2 * contact_.modulus() * contact_.pull();
    constexpr double third = 1.0 / 3;
    return yield.pressure * (square * square - third * (area * area)) +
           pull * (square * s - area * (s - third * yield.root));
  }

  PLASTIGRAN_DEVICE Flattened flatten(double radius_eff, Yield yield, double s) const {
    const double cube = s * s * s, hertz = 4.0 / 3.0 * contact_.modulus() * cube * cube;
    const double without_pull = force_without_pull(yield, s);
    return {hertz / without_pull, cube * s * (1 / radius_eff - without_pull * (1 / hertz))};
  }

  // Returns the plastic work [J]: energy at yield plus the work beyond yield, minus the energy on
  // the unloading curve at the same contact radius s^2.
  PLASTIGRAN_DEVICE double plastic_work(double radius_eff, Yield yield, double s) const {
    if (!(s > yield.root)) return 0;
    // Integrate F d(overlap) with F = first + p s^4 - linear s and d(overlap) = (4 s^3/R* - c) ds.
    const double pull = contact_.pull(), p = yield.pressure, area = yield.root * yield.root;
    const double linear = 2 * contact_.modulus() * pull * area;
    const Response at_yield = contact_.at(radius_eff, yield.root);
    const double first = at_yield.force - p * area * area + linear * yield.root;
    const auto integral = [=](double r) {
      const double square = r * r, fourth = square * square;
      return fourth * (first + 0.5 * p * fourth - 0.8 * linear * r) / radius_eff -
             pull * r * (first + 0.2 * p * fourth - 0.5 * linear * r);
    };
    const Response unloading = contact_.at(flatten(radius_eff, yield, s).radius, s);
    return at_yield.elastic_energy + at_yield.surface_energy + integral(s) - integral(yield.root) -
           unloading.elastic_energy - unloading.surface_energy;
  }

  PLASTIGRAN_DEVICE Response apart(double radius_eff, Yield yield, double reached) const {
    Response response;
    response.plastic_work = plastic_work(radius_eff, yield, reached);
    return response;
  }

  JkrContact contact_;
  double pressure_;  // pi p_y
  bool guarded_;
  // Table of two functions of the product of R* and per_length_. One is s_y/root_unit_. The other
  // is Yield::pressure/(pi p_y), which exceeds 1 where the energy guard increases the yield
  // pressure.
  typedef Tabulated<2, 10, 20, 96> Yields;
  double root_unit_;   // c E*/(pi p_y)
  double per_length_;  // (pi p_y/E*)^3/c^2
  Yields yields_;
};

}  // namespace plastigran
