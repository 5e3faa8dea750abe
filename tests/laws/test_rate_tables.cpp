// SPDX-License-Identifier: GPL-2.0-or-later
//
// Tests of laws at a rate factor. The factor multiplies the yield strength and differs between
// contacts. No table is built for a factor during a run.
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <new>

#include "all_laws.h"
#include "plastigran/pairs/type_pair.h"

using namespace plastigran;

namespace {
std::size_t allocated = 0;  // bytes that this program has allocated so far
}

[[gnu::noinline]] void* operator new(std::size_t size) {
  allocated += size;
  if (void* const memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }

namespace {
MaterialPair metal(double coefficient) {
  Body body{7e10, 0.3, 1e8, 1.61};
  body.rate_coefficient = coefficient;
  return combine(body, {1e30, 0.3});
}
template <class Law>
typename Law::Parameters defaults() {
  typename Law::Parameters constants;
  for (const auto& parameter : parameters_of<Law>)
    if (std::isnan(constants.*parameter.value)) constants.*parameter.value = 1;
  return constants;
}
}  // namespace

// Impacts over nine decades of speed, with 1700 different factors.
TEST_CASE_TEMPLATE("a pair needs less than 200 kB for all rate factors", Law, ALL_LAWS) {
  const std::size_t before = allocated;
  const TypePair<Law> pair(metal(0.02), defaults<Law>());
  const std::size_t built = allocated;
  for (double speed = 1e-4; speed < 1e5; speed *= 1.01)
    pair.at_factor(rate_factor(pair.bodies, 0.01, speed), [](const auto& law, double) {
      typename Law::State state;
      respond(law, 0.01, 1e-5, state, 0);
    });
  CHECK(built - before < 200000);
  CHECK(allocated == built);
}

// A restart file may contain factors although the deck has no rate coefficient.
TEST_CASE_TEMPLATE("a pair without a rate coefficient has no tables, and answers at any factor",
                   Law, ALL_LAWS) {
  const TypePair<Law> pair(metal(0), defaults<Law>());
  pair.at_factor(1.2, [&](const auto& law, double range) {
    typename Law::State state;
    CHECK(respond(law, 0.01, 1e-5, state, 0).force > 0);
    CHECK(range > 0);
  });
}

// The path is loading, unloading to zero overlap and further loading, up to the end of the range.
// Errors are relative to the largest force or energy. Without interpolation, they are below 1e-12,
// because the same formulas are evaluated in another order. Interpolation between tables causes
// errors of up to 1e-3, and of up to 5e-3 for overlaps above 0.01 R*. The rate coefficient is the
// largest of a metal in docs/rate_factor.md.
TEST_CASE_TEMPLATE("a law at a rate factor is the law of the stronger bodies", Law, ALL_LAWS) {
  if constexpr (takes_rate_factor<Law>) {
    constexpr double coefficient = 0.025;
    constexpr bool interpolates = RateTables<Law>::interpolates;
    constexpr double allowed = interpolates ? 1e-3 : 1e-12;
    const TypePair<Law> pair(metal(coefficient), defaults<Law>());
    for (const double factor : {1.003, 1.1, 1.25, 1.5}) {
      const Law expected(strengthened(pair.bodies, factor),
                         strengthened_constants<Law>(pair.constants, factor));
      const LawAtFactor<Law> law(pair.law, pair.range, pair.rates, factor);
      CHECK(law.overlap_range() == doctest::Approx(overlap_range(expected)).epsilon(allowed));
      CHECK(law.overlap_range() >= (1 - 1e-12) * pair.range);
      for (const double deepest : {1e-5, 1e-4, 1e-3, 1e-2, 9e-2}) {
        if (deepest > pair.range) continue;
        typename Law::State state, state_expected;
        const Response most = expected.respond(0.01, 0.01 * deepest, state_expected);
        const double energy = most.elastic_energy + most.plastic_work;
        state_expected = {};
        double off = 0;
        for (const double part : {0.3, 0.6, 0.5, 0.3, 0.1, 0.0, 0.4, 0.8, 1.0, 0.98, 0.95, 1.0}) {
          const double overlap = 0.01 * deepest * part;
          const Response found = law.respond(0.01, overlap, state);
          const Response right = expected.respond(0.01, overlap, state_expected);
          off = std::max({off, std::abs(found.force - right.force) / most.force,
                          std::abs(found.elastic_energy - right.elastic_energy) / energy,
                          std::abs(found.plastic_work - right.plastic_work) / energy});
        }
        INFO(factor, " ", deepest);
        CHECK(off < (interpolates && deepest > 0.01 ? 5e-3 : allowed));
      }
    }
  }
}

// With interpolation, too, the energies change by the work of the force along a path. The tolerance
// is 1e-6 of the loading work, the error of the trapezoidal rule for smooth forces.
TEST_CASE_TEMPLATE("a law at a rate factor keeps the energy balance", Law, Universal, Mdr,
                   JacksonGreen, Thornton) {
  const TypePair<Law> pair(metal(0.025), defaults<Law>());
  const LawAtFactor<Law> law(pair.law, pair.range, pair.rates, 1.2);
  typename Law::State state;
  Response last;
  double work = 0, taken = 0;
  const auto move = [&](double from, double to) {
    const int steps = 4000;
    for (int step = 1; step <= steps; ++step) {
      const Response now = law.respond(0.01, from + (to - from) * step / steps, state);
      const double step_work = 0.5 * (last.force + now.force) * (to - from) / steps;
      work += step_work;
      taken += std::max(0.0, step_work);
      CHECK(now.plastic_work >= last.plastic_work * (1 - 1e-12));
      last = now;
    }
  };
  move(0, 2e-5);
  move(2e-5, 1.2e-5);
  move(1.2e-5, 1e-4);
  move(1e-4, 0);
  CHECK(std::abs(work - last.elastic_energy - last.plastic_work) < 1e-6 * taken);
}
