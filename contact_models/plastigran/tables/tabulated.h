// SPDX-License-Identifier: GPL-2.0-or-later
//
// Tables of functions of a law, as piecewise polynomials on panels. The host computes powers,
// logarithms and integrals once per pair of materials; the force loop evaluates only polynomials. A
// table is trivially copyable.
//
// The exponent and the five leading mantissa bits of x select a bucket (32 per octave), and thus a
// panel, without a search. A panel is as wide as its accuracy allows: polynomials interpolate the
// functions at Chebyshev points, and their error is at most 3e-14 of the largest value on the
// panel. A panel ends at a kink or jump of a function, which bisection finds.
//
//   const auto both = [](double x) { return std::array{std::log(x), std::exp(-x)}; };
//   const Tabulated<2> table(1, both);
//   if (table.covers(x)) const auto [log_x, decay] = table(x);
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>

#include "plastigran/shared/device.h"
#include "plastigran/tables/panel.h"

namespace plastigran {

template <std::size_t count, std::size_t terms = 8, std::size_t octaves = 14,
          std::size_t capacity = 160>  // largest number of panels
class Tabulated {
  typedef plastigran::Panel<count, terms> Panel;
  static constexpr std::size_t per_octave = 32;  // number of buckets per octave
  static constexpr std::size_t buckets = octaves * per_octave;
  static constexpr std::size_t widest = 32;  // largest number of buckets in a panel

 public:
  typedef typename Panel::Values Values;

  // Creates an empty table.
  Tabulated() = default;

  // Builds the table from `begin` > 0. The table ends after `octaves` octaves, or when all panels
  // are used. `functions(x)` returns Values. `kinks`: optional positions of known kinks, which
  // shorten the search for panel ends.
  template <class Functions, class Kinks = std::array<double, 0>>
  Tabulated(double begin, const Functions& functions, const Kinks& kinks = {})
      : begin_(begin), end_(begin) {
    if (!(begin > 0 && begin < 1e300)) return;
    const Interpolation<terms> through;
    std::size_t width = 1, bucket = 0;
    for (std::size_t panel = 0; panel < capacity && end_ < edge(buckets) && width > 0; ++panel) {
      width = add(panels_[panel], width, functions, kinks, through);
      for (; bucket < buckets && edge(bucket) < end_; ++bucket)
        panel_of_[bucket] = static_cast<std::uint8_t>(panel);
    }
  }

  PLASTIGRAN_DEVICE bool covers(double x) const { return x >= begin_ && x < end_; }
  PLASTIGRAN_DEVICE double end() const { return end_; }

  // Returns the values at x; covers(x) must be true.
  PLASTIGRAN_DEVICE Values operator()(double x) const {
    const Panel* panel = &panels_[panel_of_[bucket_of(x)]];
    while (x >= panel->end) ++panel;
    return panel->at(x);
  }

  // Returns the table of the integral, which equals `constant` at `begin`. Requires count == 1.
  Tabulated<1, terms + 1, octaves, capacity> integral(double constant) const {
    static_assert(count == 1);
    Tabulated<1, terms + 1, octaves, capacity> sum;
    sum.begin_ = begin_, sum.end_ = end_, sum.panel_of_ = panel_of_;
    double left = begin_;
    for (std::size_t panel = 0; panel < capacity && left < end_; ++panel) {
      const Panel& from = panels_[panel];
      auto& to = sum.panels_[panel];
      to.centre = from.centre, to.end = from.end;
      for (std::size_t k = 0; k < terms; ++k)
        to.coefficient[k + 1][0] = from.coefficient[k][0] / static_cast<double>(k + 1);
      to.coefficient[0][0] = constant - to.at(left)[0];
      left = to.end;
      constant = to.at(left)[0];
    }
    return sum;
  }

 private:
  template <std::size_t, std::size_t, std::size_t, std::size_t>
  friend class Tabulated;

  PLASTIGRAN_DEVICE static std::uint64_t leading_bits(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits >> 47;  // exponent and five leading mantissa bits
  }
  PLASTIGRAN_DEVICE std::size_t bucket_of(double x) const {
    return leading_bits(x) - leading_bits(begin_);
  }
  double edge(std::size_t bucket) const {
    const std::uint64_t bits = (leading_bits(begin_) + bucket) << 47;
    double x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
  }

  // Fits a panel from end_ over at most `width` buckets. The panel ends earlier at a kink of the
  // functions. Moves end_ to the end of the panel. Returns the number of buckets to try for the
  // next panel, or 0 if the functions are not finite.
  template <class Functions, class Kinks>
  std::size_t add(Panel& panel, std::size_t width, const Functions& functions, const Kinks& kinks,
                  const Interpolation<terms>& through) {
    const double begin = end_;
    const std::size_t bucket = bucket_of(begin);
    for (; width > 0; --width) {
      end_ = edge(std::min(bucket + width, buckets));
      const double off = panel.fit(begin, end_, functions, through);
      if (off <= 1) return off < 0.2 ? std::min(width + 1, widest) : width;
    }
    double fits = begin;
    const auto narrow = [&](double x) {
      if (x > fits && x < end_) (panel.fit(begin, x, functions, through) <= 1 ? fits : end_) = x;
    };
    for (double kink : kinks) narrow(kink * (1 - 1e-12)), narrow(kink * (1 + 1e-12));
    while (end_ - fits > Panel::ulp * fits) narrow(0.5 * (fits + end_));
    if (fits > begin && panel.fit(begin, fits, functions, through) <= 1)
      panel.end = end_;
    else
      panel.hold(begin, end_, functions(begin));
    return std::isfinite(panel.at(begin)[0]);  // 0 (false) if the functions are not finite
  }

  double begin_ = 0, end_ = 0;
  std::array<std::uint8_t, buckets> panel_of_{};
  std::array<Panel, capacity> panels_{};
};

}  // namespace plastigran
