// SPDX-License-Identifier: GPL-2.0-or-later
//
// Ye & Komvopoulos 2003 (J. Tribol. 125:685): indentation by a rigid sphere, fitted to finite
// elements. The equations are those of Ghaednia et al. 2015 (Int. J. Impact Eng. 86:307), eqs
// 23-27, corrected as in docs/laws/ye_komvopoulos.md. p is the mean pressure and A the contact
// area. r' is the radius at which a rigid plane would cut the undeformed sphere:
//
//   r'^2 = overlap (2R - overlap),  Q = (E'/sigma_Y) overlap/r',  yield at Q = 1.78
//   F = p A;  p/sigma_Y = 0.70 ln Q + 0.66, 2.9 above Q = 21
//   A = pi r'^2/(0.05 ln^2 Q - 0.57 ln Q + 2.41), pi r'^2/0.71 above Q = 400
//   residual overlap as in jackson_green.h (Ghaednia et al. 2015), at least 0
//
// The force jumps by -5 % at yield, +4 % at Q = 21 and +11 % at Q = 400. Below yield, this law is
// Hertz' law. The published elastic curve differs from Hertz' law by terms of order overlap/R.
// Beyond overlap = R, pressure and area are constant. R and E' belong to the fitted sphere, which
// fitted_sphere.h defines for two bodies.
#pragma once

#include "plastigran/laws/jackson_green.h"
#include "plastigran/shared/fitted_sphere.h"
#include "plastigran/tables/power_unloading.h"

namespace plastigran {

struct YeKomvopoulosCurve : ReadingAlone {
  static constexpr const char* name = "ye_komvopoulos";
  static constexpr const char* source = "Ye & Komvopoulos 2003, J. Tribol. 125:685";
  static constexpr const char* range = "indentation; overlap <= 0.1 R";
  static constexpr bool indentation = true;

  FittedSphere sphere;
  double compliance;  // sigma_Y/E' [-]
  JacksonGreenCurve flattening;
  double yield_depth;       // overlap_y/R [-]
  double flattening_scale;  // yield overlap of this law divided by overlap_c of Jackson & Green [-]
  double yield_radius_ratio;
  std::array<double, 4> breaks;

  YeKomvopoulosCurve(const MaterialPair& pair, const Parameters& constants)
      : sphere(pair, constants.reading),
        compliance(pair.yield_strength / sphere.modulus),
        flattening(pair, {JacksonGreenCurve::cosine, constants.reading}),
        yield_depth(depth_at(1.78)),
        flattening_scale(yield_depth / (flattening.yield_radius * flattening.yield_radius)),
        yield_radius_ratio(std::sqrt(yield_depth) * sphere.radius_ratio),
        breaks{1, depth_at(21) / yield_depth, depth_at(400) / yield_depth, 1 / yield_depth} {
    std::sort(breaks.begin(), breaks.end());
  }

  // Returns overlap/R at which Q, the ratio (E'/sigma_Y) overlap/r' of the law, equals q.
  double depth_at(double q) const {
    const double slope = q * compliance;
    return 2 * slope * slope / (1 + slope * slope);
  }
  PLASTIGRAN_DEVICE double depth(double x) const { return std::min(x * yield_depth, 1.0); }
  double overlap_range() const { return sphere.overlap_range(widest_overlap_range); }
  PLASTIGRAN_DEVICE double strain(double x) const {  // returns Q [-]
    const double z = depth(x);
    return std::sqrt(z / (2 - z)) / compliance;
  }
  PLASTIGRAN_DEVICE double area(double x) const {  // returns A/R^2 [-]
    const double z = depth(x), circle = pi * z * (2 - z), q = strain(x);
    if (q > 400) return circle / 0.71;
    const double log_q = std::log(q);
    return circle / ((0.05 * log_q - 0.57) * log_q + 2.41);
  }
  PLASTIGRAN_DEVICE double force(double x) const {
    const double q = strain(x), pressure = q > 21 ? 2.9 : 0.70 * std::log(q) + 0.66;
    return 0.75 * pressure * compliance * area(x) / (yield_depth * std::sqrt(yield_depth));
  }
  PLASTIGRAN_DEVICE double recovery(double x) const {
    const double flat = x * flattening_scale;
    return flat <= 1.9 ? x : std::min(x, flattening.recovery(flat) / flattening_scale);
  }
  PLASTIGRAN_DEVICE double contact_radius(double x) const {
    return std::sqrt(area(x) / (pi * yield_depth));
  }
};

using YeKomvopoulos = PowerUnloading<YeKomvopoulosCurve>;

}  // namespace plastigran
