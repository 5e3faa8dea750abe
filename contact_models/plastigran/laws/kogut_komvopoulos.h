// SPDX-License-Identifier: GPL-2.0-or-later
//
// Kogut & Komvopoulos 2004 (J. Mater. Res. 19:3641): indentation by a rigid sphere, fitted to
// finite elements. The equations are those of Ghaednia et al. 2015 (Int. J. Impact Eng. 86:307),
// eqs 20-22, corrected as in docs/laws/kogut_komvopoulos.md. r' is the radius at which a rigid
// plane would cut the undeformed sphere:
//
//   r'^2 = overlap (2R - overlap),  t = overlap/r',  yield at (E'/sigma_Y) t = 1.78
//   F = pi r'^2 sigma_Y N/D
//   N = 0.839 + ln((E'/sigma_Y)^0.656 t^0.651),  D = 2.192 - ln((E'/sigma_Y)^0.394 t^0.419)
//   overlap_max - overlap_res = 0.591 (E'/sigma_Y)^-0.156 overlap_max
//
// R and E' belong to the fitted sphere, which fitted_sphere.h defines for two bodies.
//
// At yield, the force jumps by +11 % and the residual overlap jumps from 0 to three quarters of the
// overlap. Restitution therefore drops from 1 to one half and stays there. Use the law only well
// beyond yield. For deep indentation, D would become zero. Therefore D is at least 0.71, its value
// in ye_komvopoulos.h at full plasticity. Beyond overlap = R, pressure and area are constant.
#pragma once

#include "plastigran/shared/fitted_sphere.h"
#include "plastigran/tables/power_unloading.h"

namespace plastigran {

struct KogutKomvopoulosCurve : ReadingAlone {
  static constexpr const char* name = "kogut_komvopoulos";
  static constexpr const char* source = "Kogut & Komvopoulos 2004, J. Mater. Res. 19:3641";
  static constexpr const char* range = "well-developed plasticity; overlap <= 0.1 R";
  static constexpr bool indentation = true;

  std::array<double, 3> breaks;
  double yield_radius_ratio;
  FittedSphere sphere;
  double stiffness;    // E'/sigma_Y [-]
  double yield_depth;  // overlap_y/R [-]

  KogutKomvopoulosCurve(const MaterialPair& pair, const Parameters& constants)
      : sphere(pair, constants.reading), stiffness(sphere.modulus / pair.yield_strength) {
    const double slope = 1.78 / stiffness;
    yield_depth = 2 * slope * slope / (1 + slope * slope);
    yield_radius_ratio = std::sqrt(yield_depth) * sphere.radius_ratio;
    const double t = std::exp((2.192 - 0.71 - 0.394 * std::log(stiffness)) / 0.419);
    const double held = std::max(1.0, 2 * t * t / (1 + t * t) / yield_depth);
    breaks = {1, std::min(held, 1 / yield_depth), std::max(held, 1 / yield_depth)};
  }

  PLASTIGRAN_DEVICE double depth(double x) const { return std::min(x * yield_depth, 1.0); }
  double overlap_range() const { return sphere.overlap_range(widest_overlap_range); }
  PLASTIGRAN_DEVICE double area(double x) const {  // returns A/R^2 [-]
    const double z = depth(x), log_t = 0.5 * std::log(z / (2 - z));
    return pi * z * (2 - z) / std::max(0.71, 2.192 - 0.394 * std::log(stiffness) - 0.419 * log_t);
  }
  PLASTIGRAN_DEVICE double force(double x) const {
    const double z = depth(x), log_t = 0.5 * std::log(z / (2 - z));
    const double pressure = 0.839 + 0.656 * std::log(stiffness) + 0.651 * log_t;
    return 0.75 * pressure * area(x) / (stiffness * yield_depth * std::sqrt(yield_depth));
  }
  PLASTIGRAN_DEVICE double recovery(double x) const {
    return x * 0.591 * std::pow(stiffness, -0.156);
  }
  PLASTIGRAN_DEVICE double contact_radius(double x) const {
    return std::sqrt(area(x) / (pi * yield_depth));
  }
};

using KogutKomvopoulos = PowerUnloading<KogutKomvopoulosCurve>;

}  // namespace plastigran
