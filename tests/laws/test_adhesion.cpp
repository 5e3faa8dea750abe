// SPDX-License-Identifier: GPL-2.0-or-later
//
// Tests of the adhesive laws on random paths, on which the bodies separate and touch again.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <type_traits>
#include <vector>

#include "all_laws.h"
#include "plastigran/impact/central_impact.h"
#include "plastigran/shared/numerics.h"
#include "plastigran/tables/adhesive.h"

using namespace plastigran;

namespace {
constexpr double radius = 2.5e-6;  // [m]

// Fine powder, in which adhesion alone nearly causes yield.
const MaterialPair powder = combine({1.2e9, 0.3, 2.2e7, 1.6}, {1.8e11, 0.3, 1e30});

template <class Law>
constexpr bool is_wrapped = false;
template <class Law>
constexpr bool is_wrapped<Adhesive<Law>> = true;

// Whether the force of first loading can jump.
template <class Law>
constexpr bool jumps = false;
template <class Law>
constexpr bool jumps<Adhesive<Law>> = has_breaks<Law>;

#define WRAPPED                                                                         \
  Adhesive<VuQuocZhang>, Adhesive<Thornton>, Adhesive<Stronge>, Adhesive<JacksonGreen>, \
      Adhesive<Ghaednia>, Adhesive<Ghaednia2019>, Adhesive<KogutEtsion>,                \
      Adhesive<KogutKomvopoulos>, Adhesive<YeKomvopoulos>, Adhesive<Brake2012>,         \
      Adhesive<Brake2015>, Adhesive<Universal>

// Returns constants of a law, with different strengths of adhesion.
template <class Law>
std::vector<typename Law::Parameters> cases() {
  if constexpr (is_wrapped<Law>) {
    typename Law::Parameters none, little, much;
    none.surface_energy = 0, little.surface_energy = 0.004, much.surface_energy = 0.1;
    return {none, little, much};
  } else if constexpr (std::is_same_v<Law, Jkr>)
    return {{0}, {0.02}, {2}};
  else if constexpr (std::is_same_v<Law, ThorntonNing1998>)
    return {{0}, {0.002}, {0.02}, {0.2}, {2}};
  else if constexpr (std::is_same_v<Law, Edinburgh2014>)
    return {{5, 0, 0, 0}, {5, 0.2, -1e-7, 0}, {1.1, 5, 0, 1}};
  else
    return {{1e3, 5e3, 0, 0.05}, {1e3, 5e3, 2e3, 0.05}, {1e3, 1.1e3, 1e4, 0.01}};
}
}  // namespace

// Random overlaps [m] over five decades, up to 0.05 R*.
struct RandomOverlaps {
  std::mt19937 random;
  std::uniform_real_distribution<double> unit{0, 1};

  explicit RandomOverlaps(int seed) : random(seed) {}
  double operator()() { return std::pow(10, -5 * unit(random)) * 0.05 * radius; }
};

// Steps have random length and direction; a tenth of them separate the bodies.
TEST_CASE_TEMPLATE("plastic work never falls on a million random steps", Law, Jkr, ThorntonNing1998,
                   Luding2008, Edinburgh2014, WRAPPED) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const auto& constants : cases<Law>()) {
    const Law law(powder, constants);
    const double apart = 1.2 * pull_off_distance(law, radius) + 1e-3 * radius;
    typename Law::State state;
    double work = 0, largest = 0;
    int formed = 0;
    bool touching = false;
    for (int step = 0; step < 1000000 / int(cases<Law>().size()); ++step) {
      const double reach = std::pow(10, -4 * unit(random)) * 0.05 * radius;
      const double overlap = unit(random) < 0.1 ? -unit(random) * apart : reach;
      const Response response = law.respond(radius, overlap, state);
      largest = std::max(largest, response.elastic_energy + response.plastic_work);
      formed += response.contact_radius > 0 && !touching;
      touching = response.contact_radius > 0;
      // The tolerance is 1e-13 of the largest energy, because plastic work is a difference of
      // energies.
      REQUIRE(response.plastic_work >= work - 1e-13 * largest);
      REQUIRE(response.surface_energy <= 0);
      REQUIRE(response.elastic_energy >= -1e-13 * largest);
      work = response.plastic_work;
    }
    CHECK(formed > 1000);
  }
}

// Separated bodies have no contact energy. At first touch, the energy of the contact is negative,
// and the difference is lost. When the contact breaks, its energy is positive, and is lost, too.
TEST_CASE_TEMPLATE("a contact that forms or breaks loses energy", Law, Jkr, ThorntonNing1998,
                   Luding2008, Edinburgh2014, WRAPPED) {
  for (const auto& constants : cases<Law>()) {
    const Law law(powder, constants);
    CHECK(contact_energy(first_touch(law, radius)) <= 0);
    for (double depth = 1e-6; depth < 0.1; depth *= 1.1) {
      const Response end = end_of_contact(law, radius, depth * radius);
      typename Law::State state;
      const Response top = law.respond(radius, depth * radius, state);
      REQUIRE(end.elastic_energy + end.surface_energy >= -1e-12 * top.elastic_energy);
      REQUIRE(end.force <= 1e-9 * std::abs(top.force));
    }
  }
}

// While the bodies are in contact, the energies grow by the work of the force. The tolerance is
// 1e-5 of the largest energy: the trapezoidal rule with 4000 steps has its largest error near
// pull-off, where the slope is infinite. If the force of first loading jumps, the tolerance is
// 3e-3, because the rule misses half a step of the jump.
TEST_CASE_TEMPLATE("energies grow by the work of the force", Law, Jkr, ThorntonNing1998, Luding2008,
                   Edinburgh2014, WRAPPED) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> unit(0, 1);
  for (const auto& constants : cases<Law>()) {
    const Law law(powder, constants);
    const double apart = 1.2 * pull_off_distance(law, radius) + 1e-4 * radius;
    typename Law::State state;
    double overlap = 1e-9 * radius, largest = 0;
    Response last = law.respond(radius, overlap, state);
    for (int leg = 0; leg < 100; ++leg) {
      const double begin = overlap;
      const double end = unit(random) < 0.2 ? -apart : 0.03 * radius * std::pow(unit(random), 3);
      double work = 0, growth = 0;
      for (int step = 1; step <= 4000; ++step) {
        const double next = begin + (end - begin) * step / 4000;
        const Response response = law.respond(radius, next, state);
        if (last.contact_radius > 0 && response.contact_radius > 0) {
          work += 0.5 * (last.force + response.force) * (next - overlap);
          growth += contact_energy(response) - contact_energy(last);
        }
        largest = std::max(largest, response.elastic_energy);
        last = response;
        overlap = next;
      }
      REQUIRE(std::abs(growth - work) <= (jumps<Law> ? 3e-3 : 1e-5) * largest);
    }
  }
}

// The work of the force is a sum of Gauss-Legendre quadratures over short intervals, whose ends
// include the jumps of the force. The tolerance is 1e-8 of the energies, because an interval of
// relative length 1e-3 with a kink of the force has an error of 2e-9. The tolerance is 1e-5 for
// ye_komvopoulos, set after an error of 3e-6 was measured: its adhesive force has another jump,
// where the slope of unloading jumps.
TEST_CASE_TEMPLATE("energies of first loading grow by the work of the force between its jumps", Law,
                   WRAPPED) {
  for (const auto& constants : cases<Law>()) {
    const Law law(powder, constants);
    const auto at = [&](double overlap) {
      typename Law::State state;
      return law.respond(radius, overlap, state);
    };
    const std::vector<double> breaks = law.overlap_breaks(radius);
    const double tolerance = std::is_same_v<Law, Adhesive<YeKomvopoulos>> ? 1e-5 : 1e-8;
    double work = 0, growth = 0, left = 1e-5 * radius;
    while (left < 0.5 * radius) {
      double right = 1.001 * left, next = right;
      for (const double depth : breaks) {
        const double jump = depth * radius;
        if (left < jump && jump < 1.0000001 * right)
          right = (1 - 1e-9) * jump, next = (1 + 1e-9) * jump;
      }
      const auto force = [&](double overlap) { return at(overlap).force; };
      if (right > left) {
        work += gauss_legendre(force, left, right);
        growth += contact_energy(at(right)) - contact_energy(at(left));
      }
      left = next;
      const Response end = at(right);
      const double scale = end.elastic_energy + end.plastic_work - end.surface_energy;
      REQUIRE(std::abs(growth - work) <= tolerance * scale);
    }
  }
}

// The root of the contact radius, w = a^(1/2), solves w^4 - b w = x, where x is the overlap times
// R*, and b grows with the surface energy. The function uses a polynomial for weak adhesion, b <=
// x^(3/4), and a closed form otherwise. The tolerance of 4e-15 is the round-off of w^4 and of the
// polynomial.
TEST_CASE("the root of the JKR equation solves it for any adhesion") {
  for (double x = 1e-12; x < 1; x *= 3)
    for (double e = 0; e < 4; e += 0.01) {
      const double b = e * std::pow(x, 0.75), w = adhesive_root(x, b), fourth = w * w * w * w;
      REQUIRE(std::abs(fourth - b * w - x) <= 4e-15 * fourth);
    }
}

TEST_CASE("the cube root of the force loop is a cube root") {
  CHECK(cube_root(0) < 1e-90);
  for (double x = 1e-9; x < 10; x *= 1.01)
    REQUIRE(cube_root(x) == doctest::Approx(std::cbrt(x)).epsilon(1e-14));  // round-off
}

TEST_CASE("without adhesion Thornton & Ning's law is Thornton's, without yield it is JKR") {
  const MaterialPair strong = combine({1.2e9, 0.3, 1e20}, {1.8e11, 0.3, 1e30});
  const ThorntonNing1998 no_adhesion(powder, {0}), no_yield(strong, {0.2});
  const Thornton thornton(powder, {});
  const Jkr jkr(strong, {0.2});
  ThorntonNing1998::State first, second;
  Thornton::State third;
  Jkr::State fourth;
  Thornton::State fresh;
  const double force_max = thornton.respond(radius, 0.05 * radius, fresh).force;
  RandomOverlaps random(8);
  for (int step = 0; step < 20000; ++step) {
    const double overlap = random();
    const Response one = no_adhesion.respond(radius, overlap, first),
                   other = thornton.respond(radius, overlap, third);
    REQUIRE(std::abs(one.force - other.force) <= 1e-14 * force_max);
    REQUIRE(one.plastic_work == doctest::Approx(other.plastic_work).epsilon(1e-12));
    const double stretched = overlap - 0.9 * jkr.pull_off_distance(radius);
    REQUIRE(no_yield.respond(radius, stretched, second).force ==
            jkr.respond(radius, stretched, fourth).force);
  }
}

// With zero surface energy, Adhesive<Law> differs from Law only by the error of its table, 3e-14 of
// each quantity, and by round-off during unloading.
TEST_CASE_TEMPLATE("a law with a surface energy of zero is the law", Law, VuQuocZhang, Thornton,
                   Stronge, JacksonGreen, Ghaednia, Ghaednia2019, KogutEtsion, KogutKomvopoulos,
                   YeKomvopoulos, Brake2012, Brake2015, Universal) {
  typename Adhesive<Law>::Parameters none;
  none.surface_energy = 0;
  const Adhesive<Law> law(powder, none);
  const Law plain(powder, {});
  typename Adhesive<Law>::State state;
  typename Law::State plain_state, fresh;
  const Response largest = plain.respond(radius, 0.05 * radius, fresh);
  RandomOverlaps random(3);
  for (int step = 0; step < 20000; ++step) {
    const double overlap = random();
    const Response one = law.respond(radius, overlap, state),
                   other = plain.respond(radius, overlap, plain_state);
    REQUIRE(std::abs(one.force - other.force) <= 1e-11 * largest.force);
    REQUIRE(std::abs(one.contact_radius - other.contact_radius) <= 1e-7 * largest.contact_radius);
    REQUIRE(std::abs(one.elastic_energy - other.elastic_energy) <= 1e-11 * largest.elastic_energy);
    REQUIRE(std::abs(one.plastic_work - other.plastic_work) <= 1e-11 * largest.plastic_work);
  }
}

TEST_CASE_TEMPLATE("without yield a law with adhesion is JKR", Law, WRAPPED) {
  const MaterialPair strong = combine({1.2e9, 0.3, 1e20, 1.6}, {1.8e11, 0.3, 1e30});
  typename Law::Parameters constants;
  constants.surface_energy = 0.2;
  const Law law(strong, constants);
  const Jkr jkr(strong, {0.2});
  typename Law::State state;
  Jkr::State jkr_state;
  RandomOverlaps random(8);
  for (int step = 0; step < 20000; ++step) {
    const double overlap =
        random() - 1.1 * random.unit(random.random) * jkr.pull_off_distance(radius);
    const Response one = law.respond(radius, overlap, state),
                   other = jkr.respond(radius, overlap, jkr_state);
    REQUIRE(one.force == other.force);
    REQUIRE(contact_energy(one) == contact_energy(other));
  }
}

// Just below the sticking energy the bodies stick, and just above it they rebound. The relative
// distance from this energy, 1e-6, is far above round-off.
TEST_CASE_TEMPLATE("the sticking energy separates sticking from rebound", Law, Jkr, Edinburgh2014) {
  typename Law::Parameters constants;
  if constexpr (std::is_same_v<Law, Jkr>) {
    constants.surface_energy = 0.02;
  } else {
    constants.stiffness_ratio = 5;
    constants.constant_force = -1e-7;
  }
  const Law law(powder, constants);
  const double energy = sticking_energy(law, radius), mass = 1e-13;
  REQUIRE(energy > 0);
  const auto restitution = [&](double part) {
    const double speed = std::sqrt(2 * part * energy / mass);
    return central_impact(law, radius, mass, speed).coefficient_of_restitution;
  };
  CHECK(restitution(1 - 1e-6) == 0);
  CHECK(restitution(1 + 1e-6) > 0);
  CHECK(recommended_timestep(law, radius, mass, 1e-6) > 0);
}
