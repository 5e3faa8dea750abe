// SPDX-License-Identifier: GPL-2.0-or-later
//
// A law of this project: Hertz to yield, then closed forms from yield through the fully plastic
// regime, with linear hardening, fitted once to finite elements of spheres on a rigid plane and to
// nothing else (docs/laws/universal.md). In t = (overlap/overlap_Y)^(1/2), s = t - 1, with
// F_Y = 4/3 E* a_Y^3/R*, overlap_Y = a_Y^2/R*, a_Y = pi p_y R*/(2 E*):
//
//   q = (q_1 + s)/(q_1 + w s) + q_2 h s/(1 + q_3 s)       strength, over that at yield
//   S = <t/q - 1>
//   F = F_Y t^3/(1 + f_1 S^2 (S + f_2)/((S + f_3)(S + f_4)) (1 + f_5 Z)),  Z = (r S)^2/(1 + r S)
//   a = a_Y t (1 + c_1 S^2/((1 + c_4 h) S^2 + c_2 S + c_3))^(1/2) (1 + c_5 Z)
//   overlap_max - overlap_res = (1 - D) 3 F/(4 E* a),   D = d_1 S^2/(S^2 + d_2 S + d_3)
//
//   F = F_max y^(3/2) (1 + g)/(1 + g y^(1/2)),  g = g_1 D,       unloading and reloading
//   y = (overlap - overlap_res)/(overlap_max - overlap_res)
//
// w is p_y/sigma_Y over that at nu = 0.3: far from yield only sigma_Y matters.
// h = (p_y/sigma_Y) H/E', H the plastic modulus; r = a_Y/R. E' and R are those of the fitted
// sphere, see fitted_sphere.h. Where a hard sphere dents a flat, the body that yields has no
// radius: option yielding flat, r = 0. The contact radius falls as dF/d(overlap) does.
//
//   F |            /           virgin curve: force and slope go on from Hertz'
//     |          //            unloading and reloading on one curve back to F_max,
//     |       _/ /             then along the virgin curve again
//     |    _/   |
//     |__/_____/_____ overlap
//          overlap_res
//
// Why e <= 1: beyond yield F/t^3 falls, and so does the energy given back over F^2/a, and a/t
// grows. With all three constant, as Hertz has them, the energy given back grows as the work done.
#pragma once

#include <algorithm>

#include "plastigran/shared/contact.h"
#include "plastigran/shared/fitted_sphere.h"
#include "plastigran/shared/hertz_contact.h"
#include "plastigran/shared/largest_overlap.h"
#include "plastigran/shared/tabulated.h"

namespace plastigran {

class Universal : public LargestOverlap {
 public:
  static constexpr const char* name = "universal";
  static constexpr const char* source = "finite elements of Plastigran, docs/laws/universal.md";
  static constexpr const char* range = "a/R <= 0.1, hardening to E/20";
  static constexpr bool hardens = true;
  enum Yielding { sphere, flat };
  struct Parameters {
    int yielding = sphere;
  };
  static constexpr std::array<Option<Parameters>, 1> options{{
      {"yielding",
       &Parameters::yielding,
       {"sphere", "flat", nullptr},
       "the body that yields: a sphere that flattens, or a flat; for a flat, the fit for small a/R "
       "holds at any a/R"},
  }};

  // Beyond, strong hardening would make a yielding contact elastic again.
  static bool admissible(const MaterialPair& pair, const Parameters&) {
    return pair.yield_pressure <= 3 * pair.yield_strength;
  }
  static constexpr const char* admissibility =
      "{yield_pressure_factor} of the weaker body must be at most 3: the finite elements have 1.5 "
      "to 2.1";

  Universal(const MaterialPair& pair, const Parameters& constants)
      : fitted_(pair, of_yielding_body),
        modulus_(4.0 / 3.0 * pair.youngs_modulus_eff),
        yield_radius_ratio_(yield_radius_ratio(pair)) {
    const double pressure_factor = pair.yield_pressure / pair.yield_strength;
    yield_radius_ = pi * pair.yield_pressure / (2 * fitted_.modulus);
    widening_radius_ = constants.yielding == flat ? 0 : yield_radius_;
    onset_ = pressure_factor / hertz_yield_pressure_factor(0.3);
    const double plastic_modulus =
        pair.tangent_modulus * pair.youngs_modulus / (pair.youngs_modulus - pair.tangent_modulus);
    hardening_ = pressure_factor * plastic_modulus / fitted_.modulus;
    given_back_ =
        Tabulated<1>(0.5, [](double x) { return std::array{summed_unloading_work(x - 1)}; });
    loaded_ = Tabulated<4>(1, [this](double x) { return compute(x); });
    virgin_work_ = Tabulated<1>(1, [this](double x) {
                     const double t = std::sqrt(x);
                     return std::array{force(t, depth(t))};
                   }).integral(0.4);
    works_ = Tabulated<2>(1, [this](double x) { return computed_works(x); });
  }

  Response respond(double radius_eff, double overlap, State& state) const {
    const double overlap_y = radius_eff * yield_radius_ratio_ * yield_radius_ratio_;
    if (state.overlap_max == 0 && overlap <= overlap_y) {
      if (!(overlap > 0)) return {};
      return hertz_response(modulus_, radius_eff, overlap);
    }
    if (!(overlap > 0)) {
      if (!(state.overlap_max > 0)) return {};  // an overlap that is no number
      return {0, 0, 0, plastic_work(radius_eff, overlap_y, state.overlap_max)};
    }
    // Loading and unloading go two ways, as in power_unloading.h.
    if (overlap > state.overlap_max) {
      state.overlap_max = overlap;
      const Peak reached = peak(radius_eff, overlap_y, overlap);
      Response response = energies(reached, 1);
      response.force = reached.force;
      response.contact_radius = reached.contact_radius;
      return response;
    }
    const Peak reached = peak(radius_eff, overlap_y, state.overlap_max);
    const double left = 1 - (state.overlap_max - overlap) * reached.inverse_recovery;
    const double y = left > 0 ? left : 0;
    // `steeper` and `wider` are exactly 1 at the largest overlap, where loading goes on.
    const double root = std::sqrt(y), g = reached.steepness - 1;
    const double steeper = reached.steepness / (1 + g * root);
    const double wider = steeper * steeper * ((3 + 2 * g * root) / (3 + 2 * g));
    Response response = energies(reached, root);
    response.force = reached.force * y * root * steeper;
    response.contact_radius = reached.contact_radius * root * wider;
    return response;
  }

  // Where a/R is 0.1, to which the finite elements go, over R*.
  double overlap_range() const {
    double left = 0, right = 0.1 / yield_radius_;  // of t; a is Hertz' or wider
    halve(left, right, [this](double t) {
      return yield_radius_ * (t > 1 ? contact_radius(t, depth(t)) : t) >= 0.1;
    });
    return fitted_.overlap_range(left * left * yield_radius_ * yield_radius_);
  }

 private:
  // As `python -m plastigran.validation.spheres.fit` prints them.
  static constexpr double q_1 = 6.791;
  static constexpr double q_2 = 0.3561;
  static constexpr double q_3 = 0.01798;
  static constexpr double f_1 = 0.1253;
  static constexpr double f_2 = 11.91;
  static constexpr double f_3 = 8.355;
  static constexpr double f_4 = 1.114;
  static constexpr double f_5 = 3.802;
  static constexpr double c_1 = 1.248;
  static constexpr double c_2 = 5.11;
  static constexpr double c_3 = 4.411;
  static constexpr double c_4 = 3.473;
  static constexpr double c_5 = 7.842;
  static constexpr double d_1 = 0.1902;
  static constexpr double d_2 = 0.6156;
  static constexpr double d_3 = 0.359;
  static constexpr double g_1 = 3.642;

  // What loading to x = overlap/overlap_Y leaves: F/F_Y, a/a_Y, overlap_Y over the recovery, and
  // 1 + g. Who loads on asks for the first two.
  enum Quantity { FORCE, RADIUS, INVERSE_RECOVERY, STEEPNESS };
  typedef std::array<double, 4> Values;

  Values compute(double x) const {
    const double t = std::sqrt(x), S = depth(t), f = force(t, S), a = contact_radius(t, S);
    return {f, a, a / ((1 - lacking(S)) * f), 1 + g_1 * lacking(S)};
  }
  // Apart, where no table reaches.
  [[gnu::noinline, gnu::cold]] Values computed(double x) const { return compute(x); }

  // The same with sizes and moduli, and what the energies need.
  struct Peak {
    double force, contact_radius, inverse_recovery, steepness, plastic_work;
  };
  Peak peak(double radius_eff, double overlap_y, double overlap_max) const {
    const double per_overlap_y = 1 / overlap_y, x = overlap_max * per_overlap_y;
    const Values at = loaded_.covers(x) ? loaded_(x) : computed(x);
    const double radius_y = radius_eff * yield_radius_ratio_;
    const double force_y = modulus_ * radius_y * overlap_y;
    return {force_y * at[FORCE], radius_y * at[RADIUS], at[INVERSE_RECOVERY] * per_overlap_y,
            at[STEEPNESS], plastic_work(radius_eff, overlap_y, overlap_max)};
  }

  double plastic_work(double radius_eff, double overlap_y, double overlap_max) const {
    const double x = overlap_max * (1 / overlap_y);
    const auto [taken, returned] = works_.covers(x) ? works_(x) : computed_works(x);
    return modulus_ * radius_eff * yield_radius_ratio_ * overlap_y * overlap_y * (taken - returned);
  }
  // What loading to x takes and unloading returns, over F_Y overlap_Y.
  [[gnu::noinline, gnu::cold]] std::array<double, 2> computed_works(double x) const {
    const Values at = compute(x);
    return {virgin_work(x),
            at[FORCE] * at[STEEPNESS] / at[INVERSE_RECOVERY] * unloading_work(at[STEEPNESS] - 1)};
  }

  // At y = root^2 of the way from the residual to the largest overlap: the energies alone.
  Response energies(const Peak& peak, double root) const {
    const double g = peak.steepness - 1, square = root * root;
    const double scale = peak.force * peak.steepness / peak.inverse_recovery;
    Response response;
    response.elastic_energy = scale * (square * square * root * unloading_work(g * root));
    response.plastic_work = peak.plastic_work;
    return response;
  }

  // S at t >= 1.
  double depth(double t) const {
    const double s = t - 1;
    const double strength = (q_1 + s) / (q_1 + onset_ * s) + q_2 * hardening_ * s / (1 + q_3 * s);
    return std::max(0.0, t / strength - 1);
  }
  // Z, of a contact that is wide for its sphere.
  double wide(double S) const {
    const double a = widening_radius_ * S;
    return a * a / (1 + a);
  }
  // F/F_Y.
  double force(double t, double S) const {
    const double softening = f_1 * S * S * (S + f_2) / ((S + f_3) * (S + f_4));
    return t * t * t / (1 + softening * (1 + f_5 * wide(S)));
  }
  // a/a_Y.
  double contact_radius(double t, double S) const {
    const double widening = c_1 * S * S / ((1 + c_4 * hardening_) * S * S + c_2 * S + c_3);
    return t * std::sqrt(1 + widening) * (1 + c_5 * wide(S));
  }
  // D.
  static double lacking(double S) { return d_1 * S * S / (S * S + d_2 * S + d_3); }

  // Work from y = 0 to 1, over F_max (1 + g) (overlap_max - overlap_res). That to another y is
  // y^(5/2) times the same with g y^(1/2) for g.
  double unloading_work(double g) const {
    return given_back_.covers(1 + g) ? given_back_(1 + g)[0] : summed_unloading_work(g);
  }
  static double summed_unloading_work(double g) {
    return gauss_legendre([g](double z) { return 2 * z * z * z * z / (1 + g * z); }, 0, 1);
  }

  // Work of the virgin curve up to x, over F_Y overlap_Y.
  double virgin_work(double x) const {
    return virgin_work_.covers(x) ? virgin_work_(x)[0] : summed_work(x);
  }
  // The same where no table reaches, from its end on panels that double in length, for the
  // integrand's poles are some panel lengths away.
  [[gnu::noinline, gnu::cold, gnu::pure]] double summed_work(double x) const {
    if (!(x > 1)) return 0.4 * x * x * std::sqrt(x);
    double sum = virgin_work_(virgin_work_.end() * (1 - 1e-15))[0];
    for (double left = std::sqrt(virgin_work_.end()), t = std::sqrt(x); left < t; left *= 2)
      sum += gauss_legendre([this](double at) { return 2 * at * force(at, depth(at)); }, left,
                            std::min(2 * left, t));
    return sum;
  }

  FittedSphere fitted_;
  double modulus_;             // 4/3 E*
  double yield_radius_ratio_;  // a_Y/R*
  double yield_radius_;        // a_Y/R of the fitted sphere
  double widening_radius_;     // r
  double onset_;               // w
  double hardening_;           // h
  Tabulated<4> loaded_;
  Tabulated<1, 9> virgin_work_;  // of the virgin curve, over F_Y overlap_Y
  Tabulated<2> works_;           // it, and what unloading returns
  Tabulated<1> given_back_;      // of 1 + g
};

}  // namespace plastigran
