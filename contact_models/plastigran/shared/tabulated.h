// SPDX-License-Identifier: GPL-2.0-or-later
//
// Functions that a law asks for again and again, as polynomials on panels: what a power, a
// logarithm or an integral costs is paid once per pair of materials.
//
// The leading bits of x, its exponent and the 32nd of the octave, give the panel without a search.
// A panel is as wide as its polynomials allow: those through the functions' values at the Chebyshev
// points, accepted where they meet them between the points to 3e-14 of the largest value there. A
// kink or a jump ends a panel, wherever it is: it is found, and nobody has to name it.
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
#include <type_traits>

namespace plastigran {

// Two numbers that are computed with at once.
typedef double Two __attribute__((vector_size(2 * sizeof(double))));

// Polynomials of `count` functions up to an x.
template <std::size_t count, std::size_t terms>
struct Panel {
  typedef std::array<double, count> Values;
  // The functions two by two, one alone by itself.
  typedef std::conditional_t<count == 1, double, Two> Pack;
  static constexpr std::size_t packs = (count + 1) / 2;
  typedef std::array<Pack, packs> Row;

  double end = 0;
  double centre = 0;
  std::array<Row, terms> coefficient{};  // of powers of x - centre

  Values at(double x) const {
    double power[levels];  // x - centre to the powers 1, 2, 4, 8
    power[0] = x - centre;
    for (std::size_t k = 1; k < levels; ++k) power[k] = power[k - 1] * power[k - 1];
    return unpacked(sum<0, terms>(power));
  }

  // The polynomials through the functions' values at the Chebyshev points from `begin` to `right`.
  // Returns how far they are from the functions elsewhere, over what is allowed.
  template <class Functions>
  double fit(double begin, double right, const Functions& functions) {
    static const Interpolation through;
    const double half = 0.5 * (right - begin);
    Values value[terms], largest{};
    centre = begin + half;
    end = right;
    for (std::size_t j = 0; j < terms; ++j) {
      value[j] = functions(centre + half * through.point[j]);
      for (std::size_t i = 0; i < count; ++i)
        largest[i] = std::max(largest[i], std::abs(value[j][i]));
    }
    double scale = 1;
    // Off the value near the middle, so that the weights' rounding does not count.
    const Values middle = value[terms / 2];
    for (std::size_t k = 0; k < terms; ++k) {
      Values sums{};
      for (std::size_t i = 0; i < count; ++i) {
        for (std::size_t j = 0; j < terms; ++j)
          sums[i] += through.weight[k][j] * (value[j][i] - middle[i]);
        sums[i] = sums[i] * scale + (k == 0 ? middle[i] : 0);
      }
      coefficient[k] = packed(sums);
      scale /= half;
    }
    double off = 0;
    for (double x : {right * (1 - ulp), begin * (1 + ulp), centre, centre + 0.6 * half}) {
      const Values found = at(x), expected = functions(x);
      for (std::size_t i = 0; i < count; ++i) {
        const double error = std::abs(found[i] - expected[i]);
        if (!(error <= tolerance * largest[i])) return infinite;
        if (error > 0) off = std::max(off, error / (tolerance * largest[i]));
      }
    }
    return off;
  }

  // One value throughout.
  void hold(double begin, double right, const Values& value) {
    *this = {};
    centre = begin;
    end = right;
    coefficient[0] = packed(value);
  }

  static constexpr double infinite = std::numeric_limits<double>::infinity();
  static constexpr double tolerance = 3e-14;
  static constexpr double ulp = 4e-16;  // moves any number by one or two of its last digits

 private:
  static constexpr std::size_t levels = 4;
  static_assert(terms <= 16);

  // Of `length` terms, by halves (Estrin): a short chain of operations.
  template <std::size_t first, std::size_t length, std::size_t level = levels - 1>
  Row sum(const double (&power)[levels]) const {
    constexpr std::size_t half = std::size_t{1} << level, below = level ? level - 1 : 0;
    if constexpr (length > half) {
      Row low = sum<first, half, below>(power);
      const Row high = sum<first + half, length - half, below>(power);
      for (std::size_t i = 0; i < packs; ++i) low[i] += power[level] * high[i];
      return low;
    } else if constexpr (level > 0) {
      return sum<first, length, below>(power);
    } else {
      return coefficient[first];
    }
  }

  static Row packed(const Values& values) {
    Row row{};
    if constexpr (count == 1)
      row[0] = values[0];
    else
      for (std::size_t i = 0; i < count; ++i) row[i / 2][i % 2] = values[i];
    return row;
  }
  static Values unpacked(const Row& row) {
    if constexpr (count == 1) return {row[0]};
    Values values;
    if constexpr (count > 1)
      for (std::size_t i = 0; i < count; ++i) values[i] = row[i / 2][i % 2];
    return values;
  }

  // Chebyshev points on (-1, 1), and the weights of the values there in each power's coefficient.
  struct Interpolation {
    double point[terms];
    double weight[terms][terms] = {};

    Interpolation() {
      double chebyshev[terms][terms] = {{1}, {0, 1}};  // [degree][power]
      for (std::size_t k = 2; k < terms; ++k)
        for (std::size_t power = 0; power < terms; ++power)
          chebyshev[k][power] =
              (power ? 2 * chebyshev[k - 1][power - 1] : 0) - chebyshev[k - 2][power];
      const double step = std::acos(-1.0) / terms;
      for (std::size_t j = 0; j < terms; ++j) {
        const double angle = (static_cast<double>(j) + 0.5) * step;
        point[j] = std::cos(angle);
        for (std::size_t k = 0; k < terms; ++k)
          for (std::size_t power = 0; power <= k; ++power)
            weight[power][j] += (k ? 2.0 : 1.0) / terms * std::cos(static_cast<double>(k) * angle) *
                                chebyshev[k][power];
      }
    }
  };
};

template <std::size_t count, std::size_t terms = 8, std::size_t octaves = 14>
class Tabulated {
  typedef plastigran::Panel<count, terms> Panel;
  static constexpr std::size_t capacity = 160;   // panels
  static constexpr std::size_t per_octave = 32;  // buckets, each of which knows its first panel
  static constexpr std::size_t buckets = octaves * per_octave;
  static constexpr std::size_t widest = 32;  // buckets in a panel

 public:
  typedef typename Panel::Values Values;

  // Covers nothing.
  Tabulated() = default;

  // Covers from `begin` > 0 on, its octaves or as far as the panels reach. `functions` returns
  // Values; a kink among `kinks` is found sooner.
  template <class Functions, class Kinks = std::array<double, 0>>
  Tabulated(double begin, const Functions& functions, const Kinks& kinks = {})
      : begin_(begin), end_(begin) {
    if (!(begin > 0 && begin < 1e300)) return;
    std::size_t width = 1, bucket = 0;
    for (std::size_t panel = 0; panel < capacity && end_ < edge(buckets) && width > 0; ++panel) {
      width = add(panels_[panel], width, functions, kinks);
      for (; bucket < buckets && edge(bucket) < end_; ++bucket)
        panel_of_[bucket] = static_cast<std::uint8_t>(panel);
    }
  }

  bool covers(double x) const { return x >= begin_ && x < end_; }
  double end() const { return end_; }

  // At an x that is covered.
  Values operator()(double x) const {
    const Panel* panel = &panels_[panel_of_[bucket_of(x)]];
    while (x >= panel->end) ++panel;
    return panel->at(x);
  }

  // The integral of one function, `constant` at the begin.
  Tabulated<1, terms + 1, octaves> integral(double constant) const {
    static_assert(count == 1);
    Tabulated<1, terms + 1, octaves> sum;
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
  template <std::size_t, std::size_t, std::size_t>
  friend class Tabulated;

  static std::uint64_t leading_bits(double x) {
    std::uint64_t bits;
    std::memcpy(&bits, &x, sizeof bits);
    return bits >> 47;  // exponent and five bits
  }
  std::size_t bucket_of(double x) const { return leading_bits(x) - leading_bits(begin_); }
  double edge(std::size_t bucket) const {
    const std::uint64_t bits = (leading_bits(begin_) + bucket) << 47;
    double x;
    std::memcpy(&x, &bits, sizeof x);
    return x;
  }

  // A panel from end_ on, of at most `width` buckets; within a bucket, up to where the functions
  // have a kink. Returns the number of buckets to try next, 0 where no panel begins.
  template <class Functions, class Kinks>
  std::size_t add(Panel& panel, std::size_t width, const Functions& functions, const Kinks& kinks) {
    const double begin = end_;
    const std::size_t bucket = bucket_of(begin);
    for (; width > 0; --width) {
      end_ = edge(std::min(bucket + width, buckets));
      const double off = panel.fit(begin, end_, functions);
      if (off <= 1) return off < 0.2 ? std::min(width + 1, widest) : width;
    }
    double fits = begin;
    const auto narrow = [&](double x) {
      if (x > fits && x < end_) (panel.fit(begin, x, functions) <= 1 ? fits : end_) = x;
    };
    for (double kink : kinks) narrow(kink * (1 - 1e-12)), narrow(kink * (1 + 1e-12));
    while (end_ - fits > Panel::ulp * fits) narrow(0.5 * (fits + end_));
    if (fits > begin && panel.fit(begin, fits, functions) <= 1)
      panel.end = end_;
    else
      panel.hold(begin, end_, functions(begin));
    return std::isfinite(panel.at(begin)[0]);  // 0 where there is no number
  }

  double begin_ = 0, end_ = 0;
  std::array<std::uint8_t, buckets> panel_of_{};
  std::array<Panel, capacity> panels_{};
};

}  // namespace plastigran
