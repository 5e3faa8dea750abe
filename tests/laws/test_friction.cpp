// SPDX-License-Identifier: GPL-2.0-or-later
//
// Tests of the tangential laws: exact solution of elastic contacts, energy, Coulomb's limit,
// rotation.
#include <doctest/doctest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <random>
#include <type_traits>
#include <utility>
#include <vector>

#include "plastigran/friction/incremental.h"
#include "plastigran/friction/partial_slip.h"
#include "plastigran/laws/hertz.h"
#include "plastigran/laws/kogut_etsion.h"
#include "plastigran/laws/mdr.h"
#include "plastigran/laws/thornton.h"
#include "plastigran/laws/universal.h"

using namespace plastigran;

namespace {

constexpr double friction = 0.3;
const MaterialPair steel = combine({2.1e11, 0.3, 3e8, 1.61}, {2.1e11, 0.3, 3e8, 1.61});

// A sum of harmonics with random amplitudes, between -1 and 1.
class RandomMotion {
 public:
  explicit RandomMotion(std::mt19937& random) {
    std::uniform_real_distribution<double> unit(0, 1);
    double sum = 0;
    for (int k = 0; k < 5; ++k) {
      amplitude_[k] = unit(random) / (1 + k);
      frequency_[k] = (1 + k) * (0.5 + unit(random));
      phase_[k] = 2 * pi * unit(random);
      sum += amplitude_[k];
    }
    for (double& amplitude : amplitude_) amplitude /= sum;
  }
  double operator()(double time) const {
    double sum = 0;
    for (int k = 0; k < 5; ++k) sum += amplitude_[k] * std::sin(frequency_[k] * time + phase_[k]);
    return sum;
  }

 private:
  std::array<double, 5> amplitude_, frequency_, phase_;
};

// Independent solution: memory diagram of a Hertzian contact in two tangential dimensions. The
// normal force is F = z^(3/2), with an overlap z that is 1 at the reference load. The range of z is
// divided into cells, and each cell stores the tangential traction that was applied at its z. Each
// step searches the cells from the edge of the contact.
class DenseDiagram {
 public:
  static constexpr int cells = 8000;
  explicit DenseDiagram(double compliance)
      : compliance_(compliance / cells), x_(cells), y_(cells) {}

  void move(int depth, double x, double y) {
    if (depth > depth_) {
      const double width = compliance_ * (depth - depth_), size = std::hypot(x, y);
      const double taken = std::min(1.0, friction * width / std::max(size, 1e-300));
      for (int k = depth_; k < depth; ++k) x_[k] = taken * x / width, y_[k] = taken * y / width;
      x -= taken * x, y -= taken * y;
    }
    for (int k = depth; k < depth_; ++k) x += compliance_ * x_[k], y += compliance_ * y_[k];
    depth_ = depth;
    if (std::hypot(x, y) > 1e-18) slip(x, y);
  }

  std::array<double, 2> force() const {
    std::array<double, 2> force{};
    for (int k = 0; k < depth_; ++k) {
      const double part = std::pow((k + 1.0) / cells, 1.5) - std::pow(double(k) / cells, 1.5);
      force[0] += x_[k] * part, force[1] += y_[k] * part;
    }
    return force;
  }

 private:
  void slip(double x, double y) {
    // Returns the excess over Coulomb's limit if a part of cell k slips.
    const auto excess = [&](int k, double part, double above) {
      return std::hypot(x + part * compliance_ * x_[k], y + part * compliance_ * y_[k]) -
             friction * compliance_ * (above + part);
    };
    int k = depth_ - 1;
    double above = 0, low = 1;
    for (; k >= 0; --k, ++above) {
      if (excess(k, 1, above) <= 0) {
        low = 0;
        double high = 1;
        halve(low, high, [&](double part) { return excess(k, part, above) <= 0; });
        break;
      }
      x += compliance_ * x_[k], y += compliance_ * y_[k];
    }
    if (k >= 0) x += low * compliance_ * x_[k], y += low * compliance_ * y_[k];
    const double size = std::hypot(x, y), nx = friction * x / size, ny = friction * y / size;
    for (int j = k + 1; j < depth_; ++j) x_[j] = nx, y_[j] = ny;
    if (k >= 0) x_[k] += low * (nx - x_[k]), y_[k] += low * (ny - y_[k]);
  }

  double compliance_;
  int depth_ = 0;
  std::vector<double> x_, y_;
};

// Result of a random path of a contact with a normal and a tangential law.
struct PathResult {
  double least_work = 0, work = 0, largest_energy = 0, largest_ratio = 0;
};

template <class Normal, class Tangential>
PathResult follow_random_path(const Tangential& tangential, unsigned seed, double amplitude,
                              int steps) {
  std::mt19937 random(seed);
  const RandomMotion depth(random), x(random), y(random), tilt(random), spin(random);
  const Normal normal_law(steel, {});
  typename Normal::State normal_state;
  typename Tangential::State state;
  constexpr double radius = 2.5e-3, mean_overlap = 4e-6, duration = 30;
  const double stretch = amplitude * friction * mean_overlap * steel.youngs_modulus_eff /
                         (4 * steel.shear_modulus_eff);
  PathResult result;
  double sx = 0, sy = 0, turned = 0;
  for (int step = 0; step < steps; ++step) {
    const double time = duration * step / steps;
    const double growth = 1 + 0.3 * time / duration;  // the contact yields again and again
    const double overlap = mean_overlap * growth * (1 + 0.05 * depth(time));
    const Response response = normal_law.respond(radius, overlap, normal_state);
    const NormalLoad load{std::max(0.0, response.force),
                          8 * steel.shear_modulus_eff * response.contact_radius};
    const double angle = tilt(time), new_x = stretch * x(time), new_y = stretch * y(time);
    const Vector3 normal{std::sin(angle), 0, std::cos(angle)};
    const Vector3 along{std::cos(angle), 0, -std::sin(angle)};
    TangentialMotion motion;
    motion.displacement = (new_x - sx) * along + (new_y - sy) * Vector3{0, 1, 0};
    motion.normal = normal;
    motion.spin = spin(time) - turned;
    if (step == 0) motion = {{}, normal, 0};
    sx = new_x, sy = new_y, turned = spin(time);
    const TangentialResponse answer = tangential.respond(load, motion, state);
    result.least_work = std::min(result.least_work, answer.friction_work);
    result.work += answer.friction_work;
    result.largest_energy = std::max(result.largest_energy, answer.stored_energy);
    if (load.force > 0)
      result.largest_ratio = std::max(result.largest_ratio, length(answer.force) / load.force);
  }
  return result;
}

}  // namespace

TEST_CASE("partial slip with many rings is the dense memory diagram of an elastic contact") {
  constexpr double compliance = 1.2;
  for (unsigned seed = 0; seed < 6; ++seed) {
    std::mt19937 random(seed);
    const RandomMotion depth(random), x(random), y(random);
    const double stretch = (seed % 2 ? 0.3 : 1.2) * friction * compliance;
    const PartialSlip<400> law(friction, 400);
    PartialSlip<400>::State state;
    DenseDiagram reference(compliance);
    double old_x = 0, old_y = 0;
    for (int step = 0; step < 300; ++step) {
      const double time = 0.03 * step;
      const int cells = int(DenseDiagram::cells * (0.55 + 0.4 * depth(time)));
      const double z = double(cells) / DenseDiagram::cells;
      const double now_x = stretch * x(time), now_y = stretch * y(time);
      const double dx = step ? now_x - old_x : 0, dy = step ? now_y - old_y : 0;
      old_x = now_x, old_y = now_y;
      reference.move(cells, dx, dy);
      const auto answer = law.respond({std::pow(z, 1.5), 1.5 * std::sqrt(z) / compliance},
                                      {{dx, dy, 0}, {0, 0, 1}, 0}, state);
      const auto expected = reference.force();
      // The difference is divided by Coulomb's limit at the reference load, z = 1. The grid of the
      // reference has an error of 5e-7 where the edges of several rings lie in one cell.
      REQUIRE(std::abs(answer.force.x - expected[0]) < 1e-6 * friction);
      REQUIRE(std::abs(answer.force.y - expected[1]) < 1e-6 * friction);
    }
  }
}

TEST_CASE_TEMPLATE("friction never creates energy, and Coulomb's limit holds", Normal, Hertz,
                   Thornton, Universal, Mdr, KogutEtsion) {
  // The tolerance of the friction work of a step is relative to the largest stored energy. The
  // trapezoidal rule has an error of third order in the step, and merging rings slightly changes
  // the force within a step.
  const auto check = [](const auto& law, double tolerance) {
    for (unsigned seed = 0; seed < 10; ++seed)
      for (const double amplitude : {0.3, 2.0}) {
        const PathResult path = follow_random_path<Normal>(law, seed, amplitude, 50000);
        CAPTURE(path.work);
        CHECK(path.least_work > -tolerance * path.largest_energy);
        CHECK(path.largest_ratio <= friction * (1 + 1e-12));
        CHECK(path.work > 0);
      }
  };
  check(Incremental(friction), 1e-12);
  check(PartialSlip<8>(friction, 2), 1e-5);
  check(PartialSlip<8>(friction, 4), 1e-6);
}

TEST_CASE_TEMPLATE("few rings have the friction of many", Normal, Hertz, Thornton) {
  // Sums of the friction work over paths of different amplitudes. `test_laws -s` prints the table
  // of docs/friction.md.
  struct Sum {
    double work = 0, least_work = 0;
  };
  const auto sum = [](const auto& law) {
    Sum all;
    for (unsigned seed = 0; seed < 10; ++seed)
      for (const double amplitude : {0.3, 1.0}) {
        const PathResult path = follow_random_path<Normal>(law, seed, amplitude, 20000);
        all.work += path.work;
        all.least_work = std::min(all.least_work, path.least_work / path.largest_energy);
      }
    return all;
  };
  const double exact = sum(PartialSlip<300>(friction, 300)).work;
  for (const auto& [rings, tolerance] : {std::pair{2, 0.2}, {3, 0.1}, {4, 0.06}, {8, 0.02}}) {
    const Sum few = sum(PartialSlip<8>(friction, rings));
    const double ratio = few.work / exact;
    CAPTURE(rings);
    CAPTURE(few.least_work);
    CHECK(ratio == doctest::Approx(1).epsilon(tolerance));
  }
  // The tolerance was set after the first run, which gave the ratios 1.20 and 1.15.
  const Sum incremental = sum(Incremental(friction));
  CAPTURE(incremental.least_work);
  CHECK(incremental.work / exact == doctest::Approx(1).epsilon(0.3));
}

TEST_CASE_TEMPLATE("a pair that tumbles at constant overlap keeps its force", Law, Incremental,
                   PartialSlip<8>) {
  const Law law(friction, 4);
  typename Law::State state;
  const NormalLoad load{2, 5};
  law.respond({1, 4}, {{0.05, 0.02, 0}, {0, 0, 1}, 0}, state);
  const auto start = law.respond(load, {{-0.01, 0.03, 0}, {0, 0, 1}, 0}, state);
  TangentialResponse answer;
  constexpr int steps = 100000;
  for (int step = 1; step <= steps; ++step) {
    const double angle = 2 * pi * step / steps;
    answer = law.respond(load, {{}, {std::sin(angle), 0, std::cos(angle)}, 0}, state);
  }
  CHECK(length(answer.force) == doctest::Approx(length(start.force)).epsilon(1e-9));
  CHECK(answer.force.x == doctest::Approx(start.force.x).epsilon(1e-9));
  CHECK(answer.force.y == doctest::Approx(start.force.y).epsilon(1e-9));
}

TEST_CASE_TEMPLATE("after oblique oscillations of a body about another, the force is zero", Law,
                   Incremental, PartialSlip<8>) {
  // The host passes the normal at the end of the step. When the body is back at the start, the
  // force is zero, because the path encloses no area and nothing slides. After 10 oscillations, the
  // force is below 1e-6 of the largest force; without the tangential part of the separation, it
  // would be 0.09. With PartialSlip, the limit is 1e-3, because merging rings acts as a small slip.
  // This limit was set after the first run, which gave 4e-4.
  const Law law(100, 4);
  typename Law::State state;
  const NormalLoad load{1, 5};
  double x = 0, z = 1, largest = 0;
  law.respond(load, {{}, {0, 0, 1}, 0}, state);
  TangentialResponse answer;
  constexpr int steps = 100;
  for (int step = 1; step <= 10 * steps; ++step) {
    const double wave = std::sin(2 * pi * step / steps);
    const double new_x = 0.1 * wave, new_z = 1 + 0.1 * wave;
    const Vector3 moved{new_x - x, 0, new_z - z};
    x = new_x, z = new_z;
    const Vector3 normal = 1 / std::hypot(x, z) * Vector3{x, 0, z};
    const double separation = dot(moved, normal);
    answer = law.respond(load, {moved - separation * normal, normal, 0, separation}, state);
    largest = std::max(largest, length(answer.force));
  }
  CAPTURE(largest);
  CHECK(length(answer.force) < (std::is_same_v<Law, Incremental> ? 1e-6 : 1e-3) * largest);
}

TEST_CASE_TEMPLATE("spin about the normal turns the force", Law, Incremental, PartialSlip<8>) {
  const Law law(friction, 4);
  typename Law::State state;
  const NormalLoad load{1, 5};
  law.respond(load, {{}, {0, 0, 1}, 0}, state);
  const auto start = law.respond(load, {{0.01, 0, 0}, {0, 0, 1}, 0}, state);
  TangentialResponse answer;
  for (int step = 0; step < 1000; ++step) answer = law.respond(load, {{}, {0, 0, 1}, 1e-3}, state);
  CHECK(answer.force.x == doctest::Approx(start.force.x * std::cos(1.0)).epsilon(1e-12));
  CHECK(answer.force.y == doctest::Approx(start.force.x * std::sin(1.0)).epsilon(1e-12));
}

TEST_CASE_TEMPLATE("an exchange of the two bodies reverses the force", Law, Incremental,
                   PartialSlip<8>) {
  const Law law(friction, 4);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> unit(-1, 1);
  typename Law::State state, exchanged;
  Vector3 normal{0, 0, 1};
  const auto opposite = [](const Vector3& a) { return -1.0 * a; };
  for (int step = 0; step < 1000; ++step) {
    const Vector3 turned = normal + 0.02 * Vector3{unit(random), unit(random), unit(random)};
    normal = 1 / length(turned) * turned;
    const double force = 1 + 0.5 * unit(random), spin = 0.02 * unit(random);
    const NormalLoad load{force, 5 * std::cbrt(force)};
    const Vector3 shift = 0.02 * Vector3{unit(random), unit(random), unit(random)};
    const auto one = law.respond(load, {shift, normal, spin, 0}, state);
    const auto other = law.respond(load, {opposite(shift), opposite(normal), -spin, 0}, exchanged);
    CHECK(length(one.force + other.force) < 1e-12);
    CHECK(other.stored_energy == doctest::Approx(one.stored_energy).epsilon(1e-12));
    // In the next step, the exchanged contact starts from the state of the first one, with the
    // signs that a host reverses for exchanged bodies.
    double values[sizeof state / sizeof(double)];
    std::memcpy(values, &state, sizeof state);
    for (std::size_t k = 0; k < Law::state_size(4); ++k)
      if (Law::changes_sign(k)) values[k] = -values[k];
    std::memcpy(static_cast<void*>(&exchanged), values, sizeof state);
  }
}

TEST_CASE_TEMPLATE("the stiffness of a fresh contact is Mindlin's", Law, Incremental,
                   PartialSlip<8>) {
  const Law law(friction, 4);
  typename Law::State state;
  law.respond({1, 5}, {{}, {0, 0, 1}, 0}, state);
  const auto answer = law.respond({1, 5}, {{1e-9, 0, 0}, {0, 0, 1}, 0}, state);
  CHECK(answer.force.x == doctest::Approx(5e-9).epsilon(1e-6));
}

TEST_CASE_TEMPLATE("a contact obeys a lower coefficient of friction at once", Law, Incremental,
                   PartialSlip<8>) {
  typename Law::State state;
  const Law rough(0.5, 4), smooth(0.1, 4);
  for (int step = 1; step <= 20; ++step)
    rough.respond({1 + 0.1 * step, 5}, {{0.05, 0, 0}, {0, 0, 1}, 0}, state);
  for (int step = 1; step <= 20; ++step) {
    const double force = 3 + 0.1 * step;
    const auto answer = smooth.respond({force, 5}, {{1e-4, 0, 0}, {0, 0, 1}, 0}, state);
    CHECK(length(answer.force) <= 0.1 * force * (1 + 1e-9));
    CHECK(answer.friction_work >= -1e-12);
  }
}

TEST_CASE_TEMPLATE("a contact that ends forgets its history", Law, Incremental, PartialSlip<8>) {
  const Law law(friction, 4);
  typename Law::State state;
  law.respond({1, 5}, {{0.01, 0, 0}, {0, 0, 1}, 0}, state);
  const auto answer = law.respond({0, 0}, {{0.01, 0, 0}, {0, 0, 1}, 0}, state);
  CHECK(length(answer.force) == 0);
  const typename Law::State fresh;
  CHECK(std::memcmp(&state, &fresh, sizeof state) == 0);
}
