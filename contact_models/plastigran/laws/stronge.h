// SPDX-License-Identifier: GPL-2.0-or-later
//
// Stronge 2000 (Impact Mechanics, ch. 6): elastic, then elastic-plastic with a mean pressure that
// rises with the logarithm of the contact radius, then fully plastic at a mean pressure of 2.8
// sigma_Y. th is the mean pressure at yield divided by sigma_Y; f is F divided by the force at
// yield:
//
//   a_Y = (3 pi/4) th sigma_Y R*/E*, th = 1.1;  x = overlap/overlap_Y;  q = 2x - 1 = (a/a_Y)^2
//   f = x^1.5                  x <= 1
//   f = q (1 + ln q/(3 th))    until the mean pressure is 2.8 sigma_Y, at q = exp(3 (2.8 - th))
//   f = q 2.8/th               beyond
//
// The sources do not state the unloading curve. Three versions are in use, all with a force
// proportional to (overlap - overlap_res)^(3/2). They differ in overlap_max - overlap_res:
//   book             overlap_Y sqrt(q)                     (default)
//   area             3 F_max/(4 E* a_max)                  Hertz, from the contact radius a_max
//   original_radius  (3 F_max/(4 E* sqrt(R*)))^(2/3)       Hertz with the undeformed R*
//
// The force is continuous, but its slope increases by a factor of 1.74 at yield. Up to x = 1.9
// (`book`) or 4.0 (the other two), every version would therefore release more energy than loading
// took. The energy guard prevents this. Residual overlaps are at least 0.
#pragma once

#include "plastigran/tables/power_unloading.h"

namespace plastigran {

struct StrongeCurve {
  static constexpr const char* name = "stronge";
  static constexpr const char* source = "Stronge 2000, Impact Mechanics, ch. 6";
  static constexpr const char* range =
      "a << R*; small strain; the sources do not define the unloading";
  static constexpr bool self_similar = true;
  enum Unloading { book, area, original_radius };
  struct Parameters {
    int unloading = book;
  };
  static constexpr std::array<Option<Parameters>, 1> options{{
      {"unloading",
       &Parameters::unloading,
       {"book", "area", "original_radius"},
       "version of the unloading curve"},
  }};

  static constexpr double threshold = 1.1;      // th: mean pressure/sigma_Y at yield
  static constexpr double fully_plastic = 2.8;  // mean pressure/sigma_Y when fully plastic
  double yield_radius_ratio;
  int unloading;
  double plastic_area = std::exp(3 * (fully_plastic - threshold));  // q at full plasticity
  std::array<double, 2> breaks{1, 0.5 * (plastic_area + 1)};

  StrongeCurve(const MaterialPair& pair, const Parameters& constants)
      : yield_radius_ratio(0.75 * pi * threshold * pair.yield_strength / pair.youngs_modulus_eff),
        unloading(constants.unloading) {}

  PLASTIGRAN_DEVICE double force(double x) const {
    const double q = 2 * x - 1;
    return q < plastic_area ? q * (1 + std::log(q) / (3 * threshold))
                            : q * fully_plastic / threshold;
  }
  PLASTIGRAN_DEVICE double recovery(double x) const {
    const double q = 2 * x - 1;
    double way = std::sqrt(q);
    if (unloading == area) way = force(x) / std::sqrt(q);
    if (unloading == original_radius) way = std::cbrt(force(x) * force(x));
    return std::min(x, way);
  }
  PLASTIGRAN_DEVICE double contact_radius(double x) const { return std::sqrt(2 * x - 1); }
};

using Stronge = PowerUnloading<StrongeCurve>;

}  // namespace plastigran
