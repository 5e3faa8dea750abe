// SPDX-License-Identifier: GPL-2.0-or-later
#include <doctest/doctest.h>

#include <algorithm>
#include <cmath>
#include <string_view>
#include <type_traits>
#include <vector>

#include "all_laws.h"
#include "plastigran/impact/validate.h"

using namespace plastigran;

namespace {
template <class Law>
bool guarded() {
  for (const auto& option : options_of<Law>)
    if (std::string_view(option.name) == "energy_guard") return true;
  return false;
}

// Returns the sets of constants with which a law is tested: its defaults, each choice of each
// option, and a range of values for the indentation pressure or the thickness of a body.
template <class Law>
std::vector<typename Law::Parameters> cases([[maybe_unused]] const MaterialPair& pair) {
  typedef typename Law::Parameters Parameters;
  std::vector<Parameters> found(1);
  if constexpr (std::is_base_of_v<Brake2012Curve, Law> || std::is_base_of_v<Brake2015Curve, Law>)
    // Values that exceed the lower limit 2/3 p_y by a relative 1e-6 or more.
    for (double above = 1e-6; above < 10; above *= 8) {
      found.emplace_back();
      found.back().indentation_pressure = 2.0 / 3.0 * (1 + above) * pair.yield_pressure;
    }
  if constexpr (std::is_same_v<Law, LimStronge> || std::is_same_v<Law, KattaPolycarpou>) {
    found.clear();
    for (double thickness = 1e-8; thickness < 1e6; thickness *= 100)
      found.push_back({1, thickness, 1});
  }
  for (const auto& option : options_of<Law>)
    for (int choice = 1; choice < 3 && option.choices[choice]; ++choice) {
      Parameters constants = found[0];
      constants.*option.value = choice;
      if (std::string_view(option.name) != "energy_guard") found.push_back(constants);
    }
  return found;
}

// Returns the overlap at which a contact of R* = 1 m yields [m].
template <class Law>
double yield_overlap(const Law& law) {
  double low = 1e-30, high = 1e3;
  const auto yielded = [&](double overlap) {
    typename Law::State state;
    law.respond(1, overlap, state);
    return state.overlap_max > 0;
  };
  for (int i = 0; i < 100; ++i) {
    const double middle = std::sqrt(low * high);
    (yielded(middle) ? high : low) = middle;
  }
  return high;
}

// Returns overlaps / overlap at yield: many close to yield, and some for every formula of a law.
std::vector<double> overlaps() {
  std::vector<double> all;
  for (double beyond = 1e-14; beyond < 1e-3; beyond *= 2) all.push_back(1 + beyond);
  for (double x = 1.001; x < 1.1; x *= 1.0005) all.push_back(x);
  for (double x = 1.1; x < 1e4; x *= 1.01) all.push_back(x);
  return all;
}
}  // namespace

TEST_CASE("the laws whose fits can lose plastic work are guarded") {
  REQUIRE(guarded<Mdr>());
  REQUIRE(guarded<JacksonGreen>());
  REQUIRE(guarded<Brake2012>());
}

// The yield strengths reach a third of the modulus, the upper limit of solids. Above 1e-3 of the
// modulus, they are close together: for some fits, the strengths at which plastic work would
// decrease without the guard end there. The tolerance is 1e-12 of the loading work, because plastic
// work is the difference of two energies, which tables store to 3e-14.
TEST_CASE_TEMPLATE("the energy guard lets no plastic work fall", Law, ALL_LAWS) {
  if constexpr (std::is_same_v<typename Law::State, LargestOverlap::State>) {
    int tested = 0;
    const std::vector<double> path = overlaps();
    for (double decade = -6; guarded<Law>() && decade < -0.5; decade += decade < -3 ? 1 : 0.05)
      for (const double poissons_ratio : {0.0, 0.3, 0.5}) {
        const double strength = std::pow(10, decade);  // yield strength/modulus
        const Body body{7e10, poissons_ratio, 7e10 * strength};
        const MaterialPair pair = combine(body, {1e30, 0.3, 1e30});
        for (const typename Law::Parameters& constants : cases<Law>(pair)) {
          if (!validate<Law>(pair, constants).empty()) continue;
          ++tested;
          const Law law(pair, constants);
          const double overlap_y = yield_overlap(law);
          double largest = 0, fall = 0;
          for (const double x : path) {
            typename Law::State state;
            const Response response = law.respond(1, x * overlap_y, state);
            const double taken = response.elastic_energy + response.plastic_work;
            fall = std::max(fall, (largest - response.plastic_work) / taken);
            largest = std::max(largest, response.plastic_work);
          }
          CAPTURE(strength);
          CAPTURE(poissons_ratio);
          REQUIRE(fall <= 1e-12);
        }
      }
    REQUIRE((tested >= 50 || !guarded<Law>()));
  }
}
