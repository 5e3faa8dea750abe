// SPDX-License-Identifier: GPL-2.0-or-later
//
// Zunker & Kamrin 2024 (J. Mech. Phys. Solids 183:105492), method of dimensionality reduction for
// one contact without adhesion: a sphere on a rigid flat is mapped to an elliptical indenter that
// sinks into a bed of springs. Equations as in LAMMPS' `normal mdr`; those of several contacts on
// one body (bulk response, growth of the radius) are no part of it.
//
// For a sphere of modulus E' and radius R, in xi = overlap/R and y, the indenter's depth over half
// its height:
//
//   h(y) = 2/pi (acos(1-y) - (1-y) sqrt(2y - y^2)),   p(xi) = sigma_Y (1.75 exp(-4.4 xi) + 1)
//   F = pi E' R^2 h(y),  a = R sqrt(2y - y^2),  y = xi/2      while 4 E' sqrt(xi)/(3 pi) <= p(xi)
//   beyond that xi_Y, for the largest xi:
//   a_max^2 = R^2 (2 xi - xi^2 + xi_Y^2 - xi_Y),   F_max = pi a_max^2 p(xi)
//   F = F_max h(y),  a = a_max sqrt(2y - y^2),  y = 1 - (overlap_max - overlap)/recovery
//   recovery = A/2 (1 - a_max/s (1 - (1-2 nu) z/(2 (1-nu) (s+z)))),
//   A/2 = 2 p a_max/E',  z = R - overlap_max + A/2,  s^2 = a_max^2 + z^2
//
// Below y = 1 the elliptical indenter, beyond (overlaps of 2 R that never yielded) a flat punch.
// Two bodies are read as one sphere on a rigid flat (shared/fitted_sphere.h), which is what LAMMPS
// does with equal ones.
//
// Just beyond yield what unloading gives back grows faster than what loading puts in: there the
// energy guard (default on) keeps the work lost. Beyond an overlap of 0.7 R, where the source's
// rebound shrinks to nothing, the contact no longer grows. Range: a contact that no other one on
// the same body disturbs.
#pragma once

#include "plastigran/shared/contact.h"
#include "plastigran/shared/energy_guard.h"
#include "plastigran/shared/fitted_sphere.h"
#include "plastigran/shared/largest_overlap.h"
#include "plastigran/shared/numerics.h"
#include "plastigran/shared/tabulated.h"

namespace plastigran {

class Mdr : public LargestOverlap {
 public:
  static constexpr const char* name = "mdr";
  static constexpr const char* source = "Zunker & Kamrin 2024, J. Mech. Phys. Solids 183:105492";
  static constexpr const char* range = "overlap <= 0.1 R, contacts apart from each other";
  struct Parameters {
    int energy_guard = 1;
  };
  static constexpr std::array<Option<Parameters>, 1> options{
      {energy_guard_option<Parameters>(&Parameters::energy_guard)}};

  Mdr(const MaterialPair& pair, const Parameters& constants)
      : sphere_(pair, of_yielding_body),
        strength_(pair.yield_strength / sphere_.modulus),
        correction_((1 - 2 * pair.poissons_ratio) / (2 * (1 - pair.poissons_ratio))) {
    // The Hertzian mean pressure rises with the overlap, the pressure of yield falls.
    const auto yielded = [this](double depth) {
      return 4 * std::sqrt(depth) > 3 * pi * pressure(depth);
    };
    if (!yielded(largest)) return;
    double low = 0, high = largest;
    halve(low, high, yielded);
    yield_ = high;
    virgin_work_ = Tabulated<1>(yield_, [this](double depth) {
                     return std::array{force(depth)};
                   }).integral(2 * stored(0.5 * yield_));
    if (constants.energy_guard == 1)
      guard_ = EnergyGuard<1>(
          {yield_}, largest, [this](double depth) { return virgin_work(depth); },
          [this](double depth) { return published_plastic_work(depth); });
    works_ = Tabulated<2>(yield_, [this](double depth) { return computed_works(depth); });
    loaded_ = Tabulated<3>(yield_, [this](double depth) { return compute(depth); });
  }

  Response respond(double radius_eff, double overlap, State& state) const {
    const double radius = radius_eff * sphere_.radius_ratio;
    const double per_overlap = 1 / (radius * sphere_.radius_ratio);  // depth over overlap
    const double force_unit = pi * sphere_.modulus * radius * radius;
    Response response;
    if (state.overlap_max == 0 && overlap * per_overlap <= yield_) {
      if (!(overlap > 0)) return response;
      const double y = 0.5 * overlap * per_overlap, root = std::sqrt(y);
      const Shares shares = tabulated_shares(y);
      response.force = force_unit * y * root * shares[0];
      response.contact_radius = radius * chord(y);
      response.elastic_energy = force_unit / per_overlap * 2 * y * y * root * shares[1];
      return response;
    }
    if (overlap > state.overlap_max) state.overlap_max = overlap;
    if (!(state.overlap_max > 0)) return response;  // an overlap that is no number
    const double depth_max = state.overlap_max * per_overlap;
    response.plastic_work = force_unit / per_overlap * plastic_work(depth_max);
    if (!(overlap > 0)) return response;
    const Values at = loaded_.covers(depth_max) ? loaded_(depth_max) : computed(depth_max);
    const double force_max = force_unit * at[FORCE];
    const double y = 1 - (state.overlap_max - overlap) * per_overlap / at[RECOVERY];
    if (y > 0) {
      const double root = std::sqrt(y);
      const Shares shares = tabulated_shares(y);
      response.force = force_max * y * root * shares[0];
      response.contact_radius = radius * at[RADIUS] * chord(y);
      response.elastic_energy = force_max * at[RECOVERY] / per_overlap * y * y * root * shares[1];
    }
    return response;
  }

  double overlap_range() const { return sphere_.overlap_range(0.1); }

 private:
  static constexpr double largest = 0.7;  // overlap over R up to which the contact grows

  // What loading beyond yield to an overlap over R leaves: F/(pi E' R^2), (overlap_max -
  // overlap_res)/R and a_max/R.
  enum Quantity { FORCE, RECOVERY, RADIUS };
  typedef std::array<double, 3> Values;

  Values compute(double depth) const {
    return {force(depth), guarded_recovery(depth), std::sqrt(area(depth))};
  }
  // Apart, where no table reaches.
  [[gnu::noinline, gnu::cold]] Values computed(double depth) const { return compute(depth); }

  // Share of the force over y^(3/2), and its integral over y^(5/2); at 1 + y, for y goes to 0.
  typedef std::array<double, 2> Shares;
  static Shares shares(double y) {
    if (y < series_end) return {series(y, 0), series(y, 1)};
    const double root = std::sqrt(y);
    return {share(y) / (y * root), stored(y) / (y * y * root)};
  }
  inline static const Tabulated<2> shares_table_{1, [](double z) { return shares(z - 1); }};
  static Shares tabulated_shares(double y) {
    return shares_table_.covers(1 + y) ? shares_table_(1 + y) : shares(y);
  }

  // Share h(y) of the force at half the height. Where the closed form cancels, the series of the
  // integral of 4/pi sqrt(2y) sqrt(1 - y/2); beyond y = 1 a flat punch.
  static double share(double y) {
    if (y < series_end) return y * std::sqrt(y) * series(y, 0);
    if (y > 1) return 1 + 4 / pi * (y - 1);
    return 2 / pi * (std::acos(1 - y) - (1 - y) * chord(y));
  }

  // Integral of the share from 0.
  static double stored(double y) {
    if (y < series_end) return y * y * std::sqrt(y) * series(y, 1);
    if (y > 1) return stored(1) + (y - 1) + 2 / pi * (y - 1) * (y - 1);
    const double root = chord(y);
    return 2 / pi * (root - (1 - y) * std::acos(1 - y) - root * root * root / 3);
  }

  // Contact radius over the largest.
  static double chord(double y) { return y < 1 ? std::sqrt(y * (2 - y)) : 1; }

  // 4 sqrt(2)/pi times the sum of (1/2 over k) (-y/2)^k/(k + 3/2), each over (k + 5/2) once more
  // when integrated. 16 terms leave 1e-17 below y = 1/4.
  static constexpr double series_end = 0.25;
  static constexpr std::array<std::array<double, 16>, 2> coefficients = [] {
    std::array<std::array<double, 16>, 2> all{};
    double term = 4 * 1.4142135623730951 / pi;
    for (int k = 0; k < 16; ++k) {
      all[0][k] = term / (k + 1.5);
      all[1][k] = all[0][k] / (k + 2.5);
      term *= 0.5 * (k - 0.5) / (k + 1);
    }
    return all;
  }();
  static double series(double y, int integrals) {
    double sum = 0;
    for (int k = 15; k >= 0; --k) sum = sum * y + coefficients[integrals][k];
    return sum;
  }

  // p/E' at an overlap over R.
  double pressure(double depth) const {
    return strength_ * (1.75 * std::exp(-4.4 * std::min(depth, largest)) + 1);
  }

  // (a_max/R)^2.
  double area(double depth) const {
    const double held = std::min(depth, largest);
    return held * (2 - held) - yield_ * (1 - yield_);
  }

  // F/(pi E' R^2) on the virgin curve beyond yield.
  double force(double depth) const { return area(depth) * pressure(depth); }

  // (overlap_max - overlap_res)/R after loading beyond yield.
  double recovery(double depth) const {
    const double radius = std::sqrt(area(depth)), half_height = 2 * pressure(depth) * radius;
    const double z = 1 - std::min(depth, largest) + half_height, slant = std::hypot(radius, z);
    return half_height * (1 - radius / slant * (1 - correction_ * z / (slant + z)));
  }

  // Work of the virgin curve over pi E' R^3.
  double virgin_work(double depth) const {
    return virgin_work_.covers(depth) ? virgin_work_(depth)[0] : summed_work(depth);
  }
  // The same where no table reaches. Beyond yield the integrand is a polynomial times an
  // exponential, which one panel takes to rounding.
  [[gnu::noinline, gnu::cold, gnu::pure]] double summed_work(double depth) const {
    if (depth <= yield_) return 2 * stored(0.5 * depth);
    const double grown = std::min(depth, largest);
    return 2 * stored(0.5 * yield_) +
           gauss_legendre([this](double at) { return force(at); }, yield_, grown) +
           (depth - grown) * force(largest);
  }

  // What is lost by loading, over pi E' R^3.
  double plastic_work(double depth) const {
    const auto [taken, returned] = works_.covers(depth) ? works_(depth) : computed_works(depth);
    return taken - returned;
  }
  // What loading takes and unloading returns, over pi E' R^3.
  [[gnu::noinline, gnu::cold]] std::array<double, 2> computed_works(double depth) const {
    return {virgin_work(depth), force(depth) * guarded_recovery(depth) * stored(1)};
  }

  double published_plastic_work(double depth) const {
    return virgin_work(depth) - force(depth) * recovery(depth) * stored(1);
  }

  double guarded_recovery(double depth) const {
    const double returned = virgin_work(depth) - guard_.least_loss(depth);
    return std::min(recovery(depth), returned / (force(depth) * stored(1)));
  }

  FittedSphere sphere_;
  double strength_;           // sigma_Y/E'
  double correction_;         // (1 - 2 nu)/(2 (1 - nu))
  double yield_ = unlimited;  // overlap over R at yield
  EnergyGuard<1> guard_;      // of the overlap over R, over pi E' R^3
  Tabulated<3> loaded_;
  Tabulated<1, 9> virgin_work_;  // of the virgin curve, over pi E' R^3
  Tabulated<2> works_;           // it, and what unloading returns
};

}  // namespace plastigran
