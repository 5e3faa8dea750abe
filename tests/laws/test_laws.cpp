// SPDX-License-Identifier: GPL-2.0-or-later
#define DOCTEST_CONFIG_IMPLEMENT_WITH_MAIN
#include <doctest/doctest.h>

#include <cmath>
#include <cstring>
#include <random>
#include <type_traits>

#include "all_laws.h"
#include "plastigran/impact/central_impact.h"
#include "plastigran/impact/validate.h"
#include "plastigran/tables/power_tables.h"
#include "plastigran/tables/tabulated.h"

using namespace plastigran;

namespace {
const MaterialPair aluminium = combine({7e10, 0.3, 1e8, 1.61}, {1e30, 0.3, 1e30, 1.61});

// Returns the defaults of a law, and small values for constants without a default.
template <class Law>
typename Law::Parameters defaults() {
  typename Law::Parameters constants;
  for (const auto& parameter : parameters_of<Law>)
    if (std::isnan(constants.*parameter.value))
      constants.*parameter.value = parameter.lower + 1e-6 * (parameter.upper - parameter.lower);
  return constants;
}

// Returns valid random constants of Vu-Quoc-Zhang's law. The contact radius coefficient is spread
// over `decades` above 10^lowest; the curvature coefficient is more often small than large.
VuQuocZhang::Parameters random_admissible(std::mt19937& random, double lowest, double decades) {
  std::uniform_real_distribution<double> unit(0, 1);
  VuQuocZhang::Parameters constants;
  do {
    constants.contact_radius_coefficient = std::pow(10, lowest + decades * unit(random));
    constants.curvature_coefficient = 0.99 * std::pow(unit(random), 3);
  } while (!validate<VuQuocZhang>(aluminium, constants).empty());
  return constants;
}
}  // namespace

TEST_CASE_TEMPLATE("every constant and every choice of a law is in its tables", Law, ALL_LAWS) {
  typedef typename Law::Parameters Parameters;
  const std::size_t said =
      parameters_of<Law>.size() * sizeof(double) + options_of<Law>.size() * sizeof(int);
  if (said == 0) {
    CHECK(std::is_empty_v<Parameters>);
  } else {
    const std::size_t unit = alignof(Parameters);
    CHECK(sizeof(Parameters) == (said + unit - 1) / unit * unit);
  }
}

TEST_CASE_TEMPLATE("a law's state can be stored as plain doubles", Law, ALL_LAWS) {
  CHECK(std::is_trivially_copyable_v<typename Law::State>);
  if constexpr (Law::state_names.size() > 0)
    CHECK(sizeof(typename Law::State) == Law::state_names.size() * sizeof(double));
}

TEST_CASE_TEMPLATE("the state of a new contact is zero", Law, ALL_LAWS) {
  // LIGGGHTS sets the history to zero when a contact begins and when it ends.
  if constexpr (Law::state_names.size() > 0) {
    const typename Law::State state;
    const unsigned char zeros[sizeof state] = {};
    CHECK(std::memcmp(&state, zeros, sizeof state) == 0);
  }
}

// A host copies tables byte by byte, for example to a GPU.
TEST_CASE_TEMPLATE("a law's table is trivially copyable", Law, ALL_LAWS) {
  static_assert(std::is_trivially_copyable_v<Law>);
  const Law law(aluminium, defaults<Law>());
  alignas(Law) unsigned char bytes[sizeof(Law)];
  std::memcpy(bytes, &law, sizeof law);
  typename Law::State state, state_of_copy;
  const Response response = respond(law, 0.1, 1e-5, state, 0);
  const Response copied = respond(*reinterpret_cast<Law*>(bytes), 0.1, 1e-5, state_of_copy, 0);
  CHECK(copied.force == response.force);
  CHECK(sizeof(Law) < 90000);
}

TEST_CASE_TEMPLATE("a second call at one overlap changes nothing, bit for bit", Law, ALL_LAWS) {
  const Law law(aluminium, defaults<Law>());
  std::mt19937 random(1);
  std::uniform_real_distribution<double> exponent(-9, -3);
  for (int path = 0; path < 2000; ++path) {
    typename Law::State state;
    for (int step = 0; step < 10; ++step) {
      const double overlap = std::pow(10, exponent(random));
      law.respond(0.1, overlap, state);
      typename Law::State before = state;
      const Response first = law.respond(0.1, overlap, state);
      const Response second = law.respond(0.1, overlap, state);
      CHECK(first.force == second.force);
      if constexpr (Law::state_names.size() > 0)
        CHECK(std::memcmp(&before, &state, sizeof state) == 0);
    }
  }
}

// The energy balance reads the plastic work at zero overlap.
TEST_CASE_TEMPLATE("plastic work follows from the state at any overlap", Law, ALL_LAWS) {
  const Law law(aluminium, defaults<Law>());
  std::mt19937 random(2);
  std::uniform_real_distribution<double> exponent(-9, -3), share(0, 1);
  for (int path = 0; path < 2000; ++path) {
    typename Law::State state;
    const double overlap_max = std::pow(10, exponent(random));
    const double plastic_work = law.respond(0.1, overlap_max, state).plastic_work;
    CHECK(plastic_work_of(law, 0.1, state) == plastic_work);
    if constexpr (!keeps_plastic_work<Law>)
      CHECK(law.respond(0.1, share(random) * overlap_max, state).plastic_work == plastic_work);
  }
}

TEST_CASE_TEMPLATE("defaults are admissible", Law, ALL_LAWS) {
  CHECK(validate<Law>(aluminium, defaults<Law>()).empty());
}

TEST_CASE_TEMPLATE("a constant without a default must be given", Law, ALL_LAWS) {
  for (const auto& parameter : parameters_of<Law>) {
    if (!std::isnan(typename Law::Parameters().*parameter.value)) continue;
    auto constants = defaults<Law>();
    constants.*parameter.value = required;
    const std::string said = validate<Law>(aluminium, constants).text();
    CHECK(said.find(std::string(parameter.name) + " is missing") == 0);
    CHECK(said.find(parameter.unit) != std::string::npos);
  }
}

TEST_CASE_TEMPLATE("only rate-dependent laws have a viscous force", Law, ALL_LAWS) {
  const Law law(aluminium, defaults<Law>());
  typename Law::State state;
  const Response still = respond(law, 0.1, 1e-5, state, 0);
  const Response closing = respond(law, 0.1, 1e-5, state, 0.1);
  const Response parting = respond(law, 0.1, 1e-5, state, -0.1);
  CHECK(still.viscous_force == 0);
  CHECK((closing.viscous_force > 0) == rate_dependent<Law>);
  CHECK((parting.viscous_force < 0) == rate_dependent<Law>);
  CHECK((closing.force > still.force) == rate_dependent<Law>);
}

TEST_CASE_TEMPLATE("a constant per body has no default", Law, ALL_LAWS) {
  for (const auto& parameter : parameters_of<Law>)
    if (parameter.per_body) {
      CHECK(std::isnan(typename Law::Parameters{}.*parameter.value));
      CHECK(parameter.lower > 0);
    }
}

TEST_CASE("Vu-Quoc-Zhang's Newton iteration converges for every admissible constant") {
  std::mt19937 random(2);
  std::uniform_real_distribution<double> unit(0, 1);
  for (int tried = 0; tried < 20000; ++tried) {
    const VuQuocZhang::Parameters constants = random_admissible(random, -4, 5);
    const VuQuocZhang law(aluminium, constants);
    const double ca = constants.contact_radius_coefficient, kc = constants.curvature_coefficient;
    // Choose a root of the equation. Then let the iteration find it from a random start between the
    // root at yield, 1, and this root.
    const double root = 1 + std::pow(10, -6 + 9 * unit(random));
    const double u = root * root * root - 1, radius = root + ca * u;
    const double x = radius * radius / (1 + kc * u);
    const double start = 1 + (root - 1) * unit(random);
    const double found = law.elastic_radius(x, start);
    REQUIRE(found == doctest::Approx(root).epsilon(1e-12));
  }
}

TEST_CASE(
    "Vu-Quoc-Zhang's admissible constants never create energy, inadmissible ones are refused") {
  std::mt19937 random(3);
  const double overlap_y = 0.1 * std::pow(yield_radius_ratio(aluminium), 2);
  for (int tried = 0; tried < 3000; ++tried) {
    const VuQuocZhang::Parameters constants = random_admissible(random, -3, 3);
    const VuQuocZhang law(aluminium, constants);
    VuQuocZhang::State state;
    double work = 0, force = 0;
    for (double x = 1; x < 1e4; x *= 1.3) {
      const Response response = law.respond(0.1, x * overlap_y, state);
      REQUIRE(response.force > force);
      REQUIRE(response.plastic_work >= work * (1 - 1e-12));
      work = response.plastic_work, force = response.force;
    }
  }
  CHECK_FALSE(VuQuocZhang::admissible(aluminium, {0.001, 0.1}));
  CHECK(VuQuocZhang::admissible(aluminium, {0, 0}));  // Hertz
}

TEST_CASE("the Lambert function of the cylinder laws is accurate in the range they need") {
  // t ranges from 2 - ln 2, below which the law continues along a tangent, to the logarithm of the
  // largest ratio of doubles. The root w solves w - ln w = t to round-off. In this range, the slope
  // of w - ln w is at least 1/2, so w is accurate, too.
  for (double t = 2 - std::log(2.0); t < 1500; t *= 1.001) {
    const double w = lambert_root(t);
    REQUIRE(w > 1);
    REQUIRE(std::abs(w - std::log(w) - t) <= 4e-16 * w);
  }
}

TEST_CASE("a table equals its functions, also at kinks and jumps that it has to find") {
  // A power, a function with a kink that is not passed to the table, and one that jumps at 6.
  const auto functions = [](double x) {
    return std::array{std::pow(x, 1.425), std::min(std::sqrt(x), 1.7), x <= 6 ? std::log(x) : 2.0};
  };
  const Tabulated<3> table(1, functions, std::array{6.0});
  REQUIRE(table.covers(1));
  REQUIRE(table.covers(1e4));
  for (const double x : {0.999, -1.0, 0.0, 1e300, unlimited, required})
    CHECK_FALSE(table.covers(x));
  std::mt19937 random(4);
  std::uniform_real_distribution<double> decade(0, 4);
  for (int k = 0; k < 200000; ++k) {
    const double x = std::pow(10, decade(random));
    const auto found = table(x), expected = functions(x);
    // The polynomials are accepted to 3e-14 of the largest value on their panel.
    for (std::size_t i = 0; i < 3; ++i)
      REQUIRE(std::abs(found[i] - expected[i]) <= 1e-13 * std::max(expected[i], 0.05));
  }
}

TEST_CASE("a table's integral is its function's") {
  const auto table = Tabulated<1>(2, [](double x) { return std::array{1 / x}; }).integral(3);
  for (double x = 2; x < 1e4; x *= 1.01)
    REQUIRE(table(x)[0] == doctest::Approx(3 + std::log(x / 2)).epsilon(1e-14));
}

TEST_CASE("powers for the force loop equal std::pow") {
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(0, 1);
  const PowerTables tables;
  for (int k = 0; k < 200000; ++k) {
    const double base = std::pow(10, -16 * unit(random)), exponent = unit(random) - 0.5;
    REQUIRE(tables.power(base, exponent) ==
            doctest::Approx(std::pow(base, exponent)).epsilon(1e-14));
  }
}
