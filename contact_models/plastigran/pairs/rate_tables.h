// SPDX-License-Identifier: GPL-2.0-or-later
//
// Evaluation of a law at any rate factor k without a table for each k. The rate factor multiplies
// the yield strength (shared/rate_factor.h).
//
// A law is `self_similar` if F/F_y and a/a_y are functions of overlap/overlap_y for any yield
// strength. Because a_y/R* is proportional to k, the law at k equals the law at k = 1 for another
// radius:
//
//   F_k(R*, overlap) = F(k^2 R*, overlap)/k, and likewise for contact radius and energies
//
// Other laws are of two kinds. If only a few constants depend on the strength, the law defines
// respond_stronger(k, radius_eff, overlap, state). If the curves depend on a/R or sigma_Y/E, two
// more tables at larger factors k_j are built before a run. The equation above, with k/k_j for k,
// gives the responses of the two tables whose k_j enclose k. The result is interpolated linearly in
// k^2, because the leading term in a/R is quadratic. Each contact has a constant factor, so the
// weights (0 to 1) are constant along its path. Therefore the force remains the derivative of the
// energies, and plastic work never decreases. docs/rate_factor.md gives the error.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "plastigran/impact/central_impact.h"
#include "plastigran/shared/adhesion.h"
#include "plastigran/shared/contact.h"
#include "plastigran/shared/device.h"
#include "plastigran/shared/largest_overlap.h"
#include "plastigran/shared/rate_factor.h"

namespace plastigran {

template <class Law, class = void>
constexpr bool self_similar = false;
template <class Law>
constexpr bool self_similar<Law, std::void_t<decltype(Law::self_similar)>> = Law::self_similar;

template <class Law, class = void>
constexpr bool responds_stronger = false;
template <class Law>
constexpr bool responds_stronger<Law, std::void_t<decltype(&Law::respond_stronger)>> = true;

// Tables of a law for one pair of materials at rate factors above 1, if the law needs them.
template <class Law>
class RateTables {
 public:
  static constexpr bool interpolates =
      takes_rate_factor<Law> && !self_similar<Law> && !responds_stronger<Law>;
  static constexpr double largest_ratio = 1e9;  // largest rate/reference rate [-]
  // Largest rate factor of a table. Contacts with larger factors rescale the last table.
  static constexpr double largest_factor = 2.5;

  RateTables(const MaterialPair& bodies, const typename Law::Parameters& constants) {
    if (!interpolates || !(bodies.rate_coefficient > 0)) return;
    const double end =
        std::min(1 + bodies.rate_coefficient * std::log(largest_ratio), largest_factor);
    factors_ = {1, std::sqrt(end), end};
    laws_.reserve(2);
    for (const double factor : {factors_[1], factors_[2]}) {
      laws_.emplace_back(strengthened(bodies, factor),
                         strengthened_constants<Law>(constants, factor));
      ranges_.push_back(overlap_range(laws_.back()));
    }
  }

  bool built() const { return !laws_.empty(); }

  // Returns table k. Table 0 is `at_rest`, the law at rate factor 1.
  const Law& law(const Law& at_rest, std::size_t k) const { return k ? laws_[k - 1] : at_rest; }
  double range(double at_rest, std::size_t k) const { return k ? ranges_[k - 1] : at_rest; }
  double factor(std::size_t k) const { return factors_[k]; }

  // begin() returns the index of the first of the two tables that enclose a factor;
  // weight_of_next() returns the weight of the second.
  std::size_t begin(double factor) const { return factor < factors_[1] ? 0 : 1; }
  double weight_of_next(double factor) const {
    const double low = factors_[begin(factor)], high = factors_[begin(factor) + 1];
    return std::min(1.0, (factor * factor - low * low) / (high * high - low * low));
  }

 private:
  std::vector<Law> laws_;
  std::vector<double> ranges_;  // validity ranges of the tables: largest overlap/R*
  std::array<double, 3> factors_{};
};

// The law at one rate factor, with the interface of a law. Stores references to the law at factor 1
// and to its tables, which must outlive this object.
template <class Law>
class LawAtFactor {
 public:
  typedef typename Law::State State;
  static constexpr auto state_names = Law::state_names;

  // Creates the law at `factor`; `range` is the validity range at factor 1.
  LawAtFactor(const Law& at_rest, double range, const RateTables<Law>& tables, double factor)
      : factor_(factor) {
    parts_.fill({&at_rest, range, factor, 0});
    parts_[0].weight = 1;
    if (RateTables<Law>::interpolates && tables.built()) {
      const double next = tables.weight_of_next(factor);
      for (std::size_t k = 0; k < parts; ++k) {
        const std::size_t table = tables.begin(factor) + k;
        parts_[k] = {&tables.law(at_rest, table), tables.range(range, table),
                     factor / tables.factor(table), k ? next : 1 - next};
      }
    }
  }

  PLASTIGRAN_DEVICE Response respond(double radius_eff, double overlap, State& state) const {
    if constexpr (responds_stronger<Law>) {
      return parts_[0].law->respond_stronger(factor_, radius_eff, overlap, state);
    } else if constexpr (parts == 1) {
      Response sum;
      add(sum, parts_[0], radius_eff, overlap, state);
      return sum;
    } else {
      static_assert(
          std::is_base_of_v<LargestOverlap, Law>,
          "rate_coefficient: interpolation between strengths requires the state LargestOverlap; "
          "other laws must declare self_similar or define respond_stronger()");
      const State before = state;
      Response sum;
      for (const Part& part : parts_) {
        State reached = before;
        add(sum, part, radius_eff, overlap, reached);
        state.overlap_max = std::max(state.overlap_max, reached.overlap_max);
      }
      return sum;
    }
  }

  double overlap_range() const {
    if constexpr (self_similar<Law>)
      return std::min(factor_ * factor_ * parts_[0].range, widest_overlap_range);
    double range = 0;
    for (const Part& part : parts_) range += part.weight * part.range;
    return range;
  }

  // Returns the values of overlap/R* at which the force of any table may jump, without duplicates.
  std::vector<double> overlap_breaks() const {
    std::vector<double> all;
    if constexpr (has_breaks<Law> && !responds_stronger<Law>)
      for (const Part& part : parts_)
        for (const double at : part.law->overlap_breaks())
          all.push_back(at * part.factor * part.factor);
    std::sort(all.begin(), all.end());
    const auto same = [](double one, double next) { return next < one * (1 + 1e-8); };
    all.erase(std::unique(all.begin(), all.end(), same), all.end());
    return all;
  }

 private:
  static constexpr std::size_t parts = RateTables<Law>::interpolates ? 2 : 1;
  struct Part {
    const Law* law;
    double range;   // validity range: largest overlap/R*
    double factor;  // rate factor of the contact/factor of the table
    double weight;
  };

  PLASTIGRAN_DEVICE static void add(Response& sum, const Part& part, double radius_eff,
                                    double overlap, State& state) {
    const Response response =
        part.law->respond(part.factor * part.factor * radius_eff, overlap, state);
    const double share = part.weight / part.factor;
    sum.force += share * response.force;
    sum.contact_radius += share * response.contact_radius;
    sum.elastic_energy += share * response.elastic_energy;
    sum.plastic_work += share * response.plastic_work;
  }

  double factor_;
  std::array<Part, parts> parts_;
};

}  // namespace plastigran
