// SPDX-License-Identifier: GPL-2.0-or-later
//
// Powers of numbers for the force loop: log2 and exp2 from short tables and short series, which
// inline. The C library's pow takes three times as long, for a last digit that no law needs.
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstring>

namespace plastigran {

constexpr double ln_2 = 0.69314718055994530942;

// 256 stretches of [1, 2) for the logarithm, 128 of [0, 1) for the exponential.
struct PowerTables {
  struct Stretch {
    double inverse, log2;  // of its middle
  };
  std::array<Stretch, 256> stretches;
  std::array<double, 128> exp2;  // of the begin of each

  PowerTables() {
    for (std::size_t k = 0; k < stretches.size(); ++k) {
      const double middle = 1 + (static_cast<double>(k) + 0.5) / 256;
      stretches[k] = {1 / middle, std::log2(middle)};
    }
    for (std::size_t k = 0; k < exp2.size(); ++k) exp2[k] = std::exp2(static_cast<double>(k) / 128);
  }
};
inline const PowerTables power_tables;

// The logarithm to base 2 of a normal number above 0, to 2e-16 and 2e-16 of it.
inline double binary_log(double x) {
  std::uint64_t bits;
  std::memcpy(&bits, &x, sizeof bits);
  const PowerTables::Stretch& stretch = power_tables.stretches[bits >> 44 & 255];
  const double whole = static_cast<double>(static_cast<std::int64_t>(bits >> 52) - 1023);
  bits = (bits & ((std::uint64_t{1} << 52) - 1)) | std::uint64_t{1023} << 52;
  double mantissa;
  std::memcpy(&mantissa, &bits, sizeof mantissa);
  // log2(1 + r), |r| < 1/512
  const double r = mantissa * stretch.inverse - 1, r_2 = r * r;
  const double series = (1 - 0.5 * r) + r_2 * ((1.0 / 3 - 0.25 * r) + r_2 * 0.2);
  return whole + (stretch.log2 + r * (1 / ln_2) * series);
}

// The natural logarithm, as well.
inline double natural_log(double x) { return ln_2 * binary_log(x); }

// base^exponent to 3e-15 of it and 2e-16 |exponent log2(base)| for base > 0, neither so small or
// large that the one or the other is not a normal number.
inline double power(double base, double exponent) {
  const double way = exponent * binary_log(base);
  constexpr double round = 6755399441055744.0 / 128;  // 1.5 2^52, over 128: rounds to a 128th
  const double near = way + round;
  std::int64_t steps;
  std::memcpy(&steps, &near, sizeof steps);
  // e^s, |s| < 0.0028
  const double s = (way - (near - round)) * ln_2, s_2 = s * s;
  const double rest = (1 + s) + s_2 * ((0.5 + 1.0 / 6 * s) + s_2 * (1.0 / 24));
  // The low bits of `near` are the number of 128ths.
  const std::int64_t powers =
      static_cast<std::int64_t>(static_cast<std::uint64_t>(steps) << 13) >> 20;
  const std::uint64_t scale = static_cast<std::uint64_t>(powers + 1023) << 52;
  double two;
  std::memcpy(&two, &scale, sizeof two);
  return two * (power_tables.exp2[static_cast<std::size_t>(steps & 127)] * rest);
}

}  // namespace plastigran
