// SPDX-License-Identifier: GPL-2.0-or-later
//
// Measure the cost of a law alone, without a host. Every law computes the same contacts, and the
// program prints the time of each phase as CSV. Under callgrind, each phase writes its instruction
// counts to a separate file with the label law/phase/answer. law_cost.py combines times and counts.
//
//   law_cost [--repeats N] [LAW ...]
//
// The largest overlaps are 1.5 to 100 times the overlap at yield. The phases are
//
//   elastic    up to half the overlap at yield
//   loading    every step is deeper than the previous one
//   unloading  from the largest overlap down to nine tenths of it
//   mixed      random steps below and above the largest overlap; two thirds of them load
//
// Each phase runs with two sets of results: force and contact radius (`force`), or force, contact
// radius and energies (`energies`). The column `answer` names the set.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <random>
#include <string>
#include <vector>

#include "all_laws.h"
#include "plastigran/shared/contact.h"
#if __has_include(<valgrind/callgrind.h>)
#include <valgrind/callgrind.h>
#else
#define CALLGRIND_ZERO_STATS
#define CALLGRIND_DUMP_STATS_AT(name)
#endif

namespace plastigran {
namespace {

constexpr std::size_t contact_count = 4096;
constexpr std::size_t path_length = 8;  // number of steps of a path
constexpr double radius_eff = 1.25e-3;  // mean R* of the contacts [m]

// Path of all contacts: their largest overlaps before the path, and their overlaps at each step.
struct Path {
  std::string name;
  std::vector<double> reached;
  std::vector<std::vector<double>> overlap;
};

struct Bed {
  std::vector<double> radius_eff;
  std::vector<Path> paths;
};

// Returns the contacts and their paths; `overlap_y` is overlap/R* at yield.
Bed make_bed(double overlap_y) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  std::vector<double> radius, deepest;
  for (std::size_t k = 0; k < contact_count; ++k) {
    radius.push_back(radius_eff * (0.8 + 0.4 * unit(random)));
    deepest.push_back(radius.back() * overlap_y * 1.5 * std::pow(100 / 1.5, unit(random)));
  }
  const auto path = [&](const char* name, double before, auto&& share) {
    Path made{name, {}, std::vector<std::vector<double>>(path_length)};
    for (std::size_t k = 0; k < contact_count; ++k) {
      made.reached.push_back(before * deepest[k]);
      for (std::size_t step = 0; step < path_length; ++step)
        made.overlap[step].push_back(share(k, static_cast<double>(step + 1) / path_length));
    }
    return made;
  };
  return {
      radius,
      {path("elastic", 0, [&](std::size_t k, double s) { return 0.5 * s * overlap_y * radius[k]; }),
       path("loading", 0.9, [&](std::size_t k, double s) { return (0.9 + 0.1 * s) * deepest[k]; }),
       path("unloading", 1, [&](std::size_t k, double s) { return (1 - 0.1 * s) * deepest[k]; }),
       path("mixed", 0.9, [&](std::size_t k, double s) {
         return (0.9 + 0.1 * s + 0.05 * (unit(random) - 0.5)) * deepest[k];
       })}};
}

// Computes one step of all contacts as a host does: read the state, call the law, write the state.
template <class Law, bool energies>
[[gnu::noinline, gnu::flatten]] double step(const Law& law, const std::vector<double>& radius,
                                            const std::vector<double>& overlap,
                                            std::vector<double>& history) {
  constexpr std::size_t width = Law::state_names.size();
  double sum = 0;
  for (std::size_t k = 0; k < contact_count; ++k) {
    typename Law::State state;
    if constexpr (width > 0)
      std::memcpy(static_cast<void*>(&state), &history[k * width], width * sizeof(double));
    const Response response = respond(law, radius[k], overlap[k], state, 0.1);
    if constexpr (width > 0) std::memcpy(&history[k * width], &state, width * sizeof(double));
    sum += response.force + response.contact_radius;
    if constexpr (energies) sum += response.elastic_energy + response.plastic_work;
  }
  return sum;
}

double seconds() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

// Prints the shortest time of several repetitions of a path [ns per contact and step]. Also prints
// the sum of all results, so that the compiler cannot omit the computation.
template <class Law, bool energies>
void walk(const Law& law, const Bed& bed, const Path& path, int repeats) {
  std::vector<double> begin(contact_count * Law::state_names.size() + 1), history;
  step<Law, false>(law, bed.radius_eff, path.reached, begin);
  double best = 1e9, sum = 0;
  for (int repeat = 0; repeat < repeats; ++repeat) {
    history = begin;
    CALLGRIND_ZERO_STATS;
    const double before = seconds();
    for (const auto& overlap : path.overlap)
      sum += step<Law, energies>(law, bed.radius_eff, overlap, history);
    best = std::min(best, seconds() - before);
  }
  const std::string answer = energies ? "energies" : "force";
  const std::string dump = std::string(Law::name) + '/' + path.name + '/' + answer;
  CALLGRIND_DUMP_STATS_AT(dump.c_str());
  std::printf("%s,%s,%s,%.3f,%.17g\n", Law::name, path.name.c_str(), answer.c_str(),
              1e9 * best / static_cast<double>(contact_count * path_length), sum / repeats);
  std::fflush(stdout);
}

template <class Law>
void measure(const std::vector<std::string>& chosen, int repeats) {
  if (!chosen.empty() && std::find(chosen.begin(), chosen.end(), Law::name) == chosen.end()) return;
  typename Law::Parameters constants;
  for (const auto& parameter : parameters_of<Law>)
    if (parameter.per_body)
      constants.*parameter.value = 0.1;
    else if (std::isnan(constants.*parameter.value))
      constants.*parameter.value = 1e-6;
  const Body body{7e10, 0.3, 3e8, 1.61};
  const MaterialPair pair = combine(body, body);
  double overlap_y = yield_radius_ratio(pair) * yield_radius_ratio(pair);
  // The formula above is for spheres. Cylinders yield at larger overlaps.
  if constexpr (std::string_view(shape<Law>) == std::string_view("cylinder")) overlap_y *= 9;
  const Bed bed = make_bed(overlap_y);
  const double before = seconds();
  const Law law(pair, constants);
  std::printf("%s,setup,law,%.0f,%zu\n", Law::name, 1e9 * (seconds() - before), sizeof law);
  for (const Path& path : bed.paths) {
    walk<Law, false>(law, bed, path, repeats);
    walk<Law, true>(law, bed, path, repeats);
  }
}

// Measures the chosen laws. Returns 0 if all words are names of laws.
template <class... Laws>
int measure_all(const std::vector<std::string>& chosen, int repeats) {
  for (const std::string& name : chosen)
    if (!((name == Laws::name) || ...)) {
      std::fprintf(stderr, "ERROR: %s is not a law; `plastigran laws` lists the names\n",
                   name.c_str());
      return 2;
    }
  std::printf("law,phase,answer,ns,sum\n");
  (measure<Laws>(chosen, repeats), ...);
  return 0;
}

}  // namespace
}  // namespace plastigran

int main(int count, char** words) {
  std::vector<std::string> chosen(words + 1, words + count);
  int repeats = 100;
  if (chosen.size() > 1 && chosen[0] == "--repeats") {
    repeats = std::atoi(chosen[1].c_str());
    if (repeats < 1) {
      std::fprintf(stderr, "ERROR: --repeats is %s; it must be at least 1\n", chosen[1].c_str());
      return 2;
    }
    chosen.erase(chosen.begin(), chosen.begin() + 2);
  }
  return plastigran::measure_all<ALL_LAWS>(chosen, repeats);
}
