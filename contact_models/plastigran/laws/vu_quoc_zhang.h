// SPDX-License-Identifier: GPL-2.0-or-later
//
// Vu-Quoc & Zhang 1999 (Proc. R. Soc. A 455:4013), total-overlap form of Zhang & Vu-Quoc 2002
// (Int. J. Impact Eng. 27:317), eqs 4.1-4.9: the contact radius is an elastic part plus a plastic
// part, and plastic flow enlarges the radius of curvature, both linearly in the force beyond yield.
//
//   a = a_e + a_p,  a_e^3 = 3 F R*/(4 E*),  a_p = C_a <F - P_Y>,  C_R = 1 + K_c <F - P_Y>
//   overlap = a^2 / (C_R R*)                        virgin curve
//   unloading, reloading: a_p and C_R keep their values at the largest force
//   P_Y = pi^3 R*^2 p_y^3/(6 E*^2),  a_Y = pi p_y R*/(2 E*),  overlap_Y = a_Y^2/R*   (yield)
//
// In s = a_e/a_Y, with F = P_Y s^3, u = <s^3 - 1>, c_a = C_a P_Y/a_Y, k_c = K_c P_Y, the law has
// no size or material left in it:
//
//   overlap/overlap_Y = A^2/C,   A = s + c_a u,   C = 1 + k_c u
//
// The defaults of c_a and k_c are the paper's calibration (C_a = 2.33e-7 m/N, K_c = 2.69e-4 1/N on
// its 0.1 m aluminium sphere). Range: calibrated up to F = 41 P_Y for nu = 0.3, perfectly plastic;
// far beyond, F tends to (k_c/c_a^2) P_Y overlap/overlap_Y, which no real hardness reaches.
#pragma once

#include <algorithm>

#include "plastigran/shared/contact.h"
#include "plastigran/shared/tabulated.h"

namespace plastigran {

class VuQuocZhang {
 public:
  static constexpr const char* name = "vu_quoc_zhang";
  static constexpr const char* source = "Vu-Quoc & Zhang 1999, Proc. R. Soc. A 455:4013";
  static constexpr const char* range = "F <= 41 P_Y, nu near 0.3, perfectly plastic";
  struct Parameters {
    double contact_radius_coefficient = 0.0258303;  // c_a
    double curvature_coefficient = 0.00980426;      // k_c
  };
  static constexpr std::array<Parameter<Parameters>, 2> parameters{{
      {"contact_radius_coefficient", "-", &Parameters::contact_radius_coefficient, 0, 10,
       "growth of the plastic contact radius with force, C_a P_Y / a_Y"},
      {"curvature_coefficient", "-", &Parameters::curvature_coefficient, 0, 0.99,
       "growth of the contact's radius of curvature with force, K_c P_Y"},
  }};
  struct State {
    double elastic_radius_max = 0;  // largest a_e beyond yield, over a_Y [-]; 0 while elastic
  };
  static constexpr std::array<const char*, 1> state_names{"elastic_radius_max"};

  explicit VuQuocZhang(const MaterialPair& pair, const Parameters& constants)
      : ca_(constants.contact_radius_coefficient),
        kc_(constants.curvature_coefficient),
        yield_radius_ratio_(plastigran::yield_radius_ratio(pair)),
        yield_force_ratio_(4.0 / 3.0 * pair.youngs_modulus_eff * yield_radius_ratio_ *
                           yield_radius_ratio_ * yield_radius_ratio_) {
    root_ = Tabulated<1>(1, [this](double x) { return std::array{elastic_radius(x, 1)}; });
    const auto complementary =
        Tabulated<1>(1, [this](double s) { return std::array{complement(s)}; }).integral(0);
    works_ = Tabulated<2>(1, [&](double s) {
      const double sum = complementary.covers(s) ? complementary(s)[0] : summed_complement(s);
      return works(shape(s), sum);
    });
  }

  // Sufficient, and at most a quarter stricter in c_a than necessary, for the virgin curve to rise
  // and for every increment of plastic work to be positive: c_a^(3/2) (2 - k_c) >= 2/5 sqrt(1/5)
  // k_c. Curvature that grows without the contact radius would return more energy than it took.
  static bool admissible(const MaterialPair&, const Parameters& constants) {
    const double ca = constants.contact_radius_coefficient, kc = constants.curvature_coefficient;
    return ca * std::sqrt(ca) * (2 - kc) >= 0.4 * std::sqrt(0.2) * kc;
  }
  static constexpr const char* admissibility =
      "{contact_radius_coefficient}^1.5 * (2 - {curvature_coefficient}) must be at least "
      "0.1789 * {curvature_coefficient}, or the contact might create energy";

  Response respond(double radius_eff, double overlap, State& state) const {
    const double overlap_y = radius_eff * yield_radius_ratio_ * yield_radius_ratio_;
    const double force_y = radius_eff * radius_eff * yield_force_ratio_;
    const double x = overlap / overlap_y;
    Shape max = shape(std::max(state.elastic_radius_max, 1.0));
    if (!(overlap > 0)) return {0, 0, 0, force_y * overlap_y * plastic_work(max)};
    double s = max.s;
    // As near the maximum as the table's roots are to the root, it is the maximum: the second of
    // two equal calls must not find itself beyond the first.
    const double reached = max.radius * max.radius;
    const double ahead = max.curvature * x - reached;
    if (ahead > rounding * reached) {  // on the virgin curve, beyond yield
      s = state.elastic_radius_max = root_.covers(x) ? root_(x)[0] : solved(x, max.s);
      max = shape(s);
    } else if (!(ahead >= -rounding * reached)) {
      // elastic, or unloading: a_e^2 = C R* (overlap - overlap_res)
      const double plastic = ca_ * max.u * (2 * max.s + ca_ * max.u);
      const double s_squared = max.curvature * x - plastic;
      s = s_squared > 0 ? std::sqrt(s_squared) : 0;
    }
    Response response;
    response.force = force_y * s * s * s;
    if (s > 0) response.contact_radius = radius_eff * yield_radius_ratio_ * (s + ca_ * max.u);
    response.elastic_energy = 0.4 * response.force * overlap_y * s * s / max.curvature;
    response.plastic_work = force_y * overlap_y * plastic_work(max);
    return response;
  }

  // The force-driven form of the same law (Vu-Quoc, Zhang & Lesburg 2000, J. Appl. Mech. 67:363):
  // the overlap at a given force >= 0.
  double overlap(double radius_eff, double force, State& state) const {
    const double overlap_y = radius_eff * yield_radius_ratio_ * yield_radius_ratio_;
    const double s = std::cbrt(force / (radius_eff * radius_eff * yield_force_ratio_));
    if (s > 1 && s > state.elastic_radius_max) state.elastic_radius_max = s;
    const Shape max = shape(std::max(state.elastic_radius_max, 1.0));
    const double plastic = ca_ * max.u * (2 * max.s + ca_ * max.u);
    return overlap_y * (s * s + plastic) / max.curvature;
  }

  // The calibration reaches F = 41 P_Y; 2 % for rounded figures.
  double overlap_range() const {
    const Shape at = shape(std::cbrt(42));
    return std::min(
        at.radius * at.radius / at.curvature * yield_radius_ratio_ * yield_radius_ratio_,
        widest_overlap_range);
  }

  // P_Y [N].
  double yield_force(double radius_eff) const {
    return radius_eff * radius_eff * yield_force_ratio_;
  }

  // Root s >= 1 of g(s) = A(s)^2 - x C(s) for x >= 1, from a start at or left of it. For admissible
  // constants g is negative before the root, and rising and convex from it on: once an iterate has
  // passed the root, Newton descends on it monotonically, and before it no step shorter than
  // doubling is refused, so the iteration always arrives. About four iterations for the overlap
  // steps of a simulation, the last one to see that it has; more only for the first steps of a
  // violent impact.
  double elastic_radius(double x, double start, int& iterations) const {
    double s = start;
    for (iterations = 1; iterations <= 200; ++iterations) {
      const Shape at = shape(s);
      const double value = at.radius * at.radius - x * at.curvature;
      const double slope = 2 * at.radius * (1 + 3 * ca_ * s * s) - 3 * kc_ * x * s * s;
      const double step = slope > 0 ? std::min(-value / slope, s) : s;
      s += step;
      if (std::abs(step) <= 1e-8 * s) break;  // quadratic: the next step would be below rounding
    }
    return s;
  }
  double elastic_radius(double x, double start) const {
    int iterations;
    return elastic_radius(x, start, iterations);
  }

 private:
  struct Shape {
    double s;          // a_e / a_Y
    double u;          // (F - P_Y) / P_Y
    double radius;     // A = a / a_Y
    double curvature;  // C = C_R
  };
  Shape shape(double s) const {
    const double u = s * s * s - 1;
    return {s, u, s + ca_ * u, 1 + kc_ * u};
  }

  // Apart, where no table reaches.
  [[gnu::noinline, gnu::cold]] double solved(double x, double start) const {
    return elastic_radius(x, start);
  }

  // Of A^2/C: s to 3e-14, and A rises up to three times as fast as s.
  static constexpr double rounding = 2e-13;

  // overlap/overlap_Y d(F/P_Y)/ds
  double complement(double s) const {
    const Shape at = shape(s);
    return 3 * s * s * at.radius * at.radius / at.curvature;
  }

  // Plastic work over P_Y overlap_Y.
  double plastic_work(const Shape& max) const {
    if (!(max.u > 0)) return 0;
    const auto [taken, returned] =
        works_.covers(max.s) ? works_(max.s) : works(max, summed_complement(max.s));
    return taken - returned;
  }
  // Virgin work 2/5 + integral of s^3 d(overlap), and the recoverable 2/5 s^5/C. The integral is
  // taken by parts, F overlap - integral of overlap dF, which is `complementary`.
  std::array<double, 2> works(const Shape& max, double complementary) const {
    const double force = max.u + 1;
    return {0.4 + force * max.radius * max.radius / max.curvature - 1 - complementary,
            0.4 * force * max.s * max.s / max.curvature};
  }
  // That integral where no table reaches, by Gauss-Legendre on s-panels that double in length: the
  // integrand's poles are complex and lie a fixed number of panel lengths away, so 12 points per
  // panel leave less than 1e-12.
  [[gnu::noinline, gnu::cold, gnu::pure]] double summed_complement(double s) const {
    double sum = 0;
    for (double left = 1; left < s; left *= 2)
      sum +=
          gauss_legendre([this](double at) { return complement(at); }, left, std::min(2 * left, s));
    return sum;
  }

  double ca_, kc_;
  double yield_radius_ratio_;  // a_Y / R*
  double yield_force_ratio_;   // P_Y / R*^2
  Tabulated<1> root_;          // s of the virgin curve at overlap/overlap_Y
  Tabulated<2> works_;         // taken and returned after loading to s, over P_Y overlap_Y
};

}  // namespace plastigran
