// SPDX-License-Identifier: GPL-2.0-or-later
//
// One panel of a table: polynomials in x - centre that interpolate functions at Chebyshev points.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <type_traits>

#include "plastigran/shared/device.h"

namespace plastigran {

// Two doubles in one vector register.
typedef double Two __attribute__((vector_size(2 * sizeof(double))));

// Chebyshev points on (-1, 1), and the matrix that converts function values at these points to
// polynomial coefficients.
template <std::size_t terms>
struct Interpolation {
  double point[terms];
  double weight[terms][terms] = {};

  Interpolation() {
    double chebyshev[terms][terms] = {{1}, {0, 1}};  // coefficients by [degree][power]
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

// Polynomials of `count` functions, valid for x < `end`.
template <std::size_t count, std::size_t terms>
struct Panel {
  typedef std::array<double, count> Values;
  // Values are packed in pairs for vector instructions, unless there is only one function.
  typedef std::conditional_t<count == 1, double, Two> Pack;
  static constexpr std::size_t packs = (count + 1) / 2;
  typedef std::array<Pack, packs> Row;

  double end = 0;
  double centre = 0;
  std::array<Row, terms> coefficient{};  // coefficients of powers of x - centre

  PLASTIGRAN_DEVICE Values at(double x) const {
    double power[levels];  // x - centre to the powers 1, 2, 4, 8
    power[0] = x - centre;
    for (std::size_t k = 1; k < levels; ++k) power[k] = power[k - 1] * power[k - 1];
    return unpacked(sum<0, terms>(power));
  }

  // Interpolates the functions at the Chebyshev points of [begin, right]. Returns the largest ratio
  // of error to allowed error at four check points, or infinity if a ratio exceeds 1.
  template <class Functions>
  double fit(double begin, double right, const Functions& functions,
             const Interpolation<terms>& through) {
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
    // Interpolate the difference from the value near the middle: the round-off of the interpolation
    // weights then scales with the variation on the panel.
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
    double error_ratio = 0;
    for (double x : {right * (1 - ulp), begin * (1 + ulp), centre, centre + 0.6 * half}) {
      const Values interpolated = at(x), exact = functions(x);
      for (std::size_t i = 0; i < count; ++i) {
        const double error = std::abs(interpolated[i] - exact[i]);
        if (!(error <= tolerance * largest[i])) return infinite;
        if (error > 0) error_ratio = std::max(error_ratio, error / (tolerance * largest[i]));
      }
    }
    return error_ratio;
  }

  // Sets the functions to the constant `value` on the whole panel.
  void hold(double begin, double right, const Values& value) {
    *this = {};
    centre = begin;
    end = right;
    coefficient[0] = packed(value);
  }

  static constexpr double infinite = std::numeric_limits<double>::infinity();
  static constexpr double tolerance = 3e-14;
  static constexpr double ulp = 4e-16;  // relative size of one or two units in the last place

 private:
  static constexpr std::size_t levels = 4;
  static_assert(terms <= 16);

  // Returns the sum of `length` terms of the polynomials, from the term `first`, divided by
  // (x - centre)^first. Uses Estrin's scheme.
  template <std::size_t first, std::size_t length, std::size_t level = levels - 1>
  PLASTIGRAN_DEVICE Row sum(const double (&power)[levels]) const {
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
  PLASTIGRAN_DEVICE static Values unpacked(const Row& row) {
    if constexpr (count == 1) return {row[0]};
    Values values;
    if constexpr (count > 1)
      for (std::size_t i = 0; i < count; ++i) values[i] = row[i / 2][i % 2];
    return values;
  }
};

}  // namespace plastigran
