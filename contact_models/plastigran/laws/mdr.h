// SPDX-License-Identifier: GPL-2.0-or-later
//
// Zunker & Kamrin 2024 (J. Mech. Phys. Solids 183:105492), method of dimensionality reduction for
// one contact without adhesion: a sphere on a rigid flat is mapped to an elliptical indenter that
// is pressed into a bed of springs. Equations as in LAMMPS' `normal mdr`; the equations for several
// contacts on one body (bulk response, growth of the radius) are not included.
//
// For a sphere of modulus E' and radius R, let xi = overlap/R, and let y be the depth of the
// indenter divided by half its height:
//
//   h(y) = 2/pi (acos(1-y) - (1-y) sqrt(2y - y^2)),   p(xi) = sigma_Y (1.75 exp(-4.4 xi) + 1)
//   F = pi E' R^2 h(y),  a = R sqrt(2y - y^2),  y = xi/2      while 4 E' sqrt(xi)/(3 pi) <= p(xi)
//   yield at xi_Y, where 4 E' sqrt(xi_Y)/(3 pi) = p(xi_Y); beyond yield, with xi = overlap_max/R:
//   a_max^2 = R^2 (2 xi - xi^2 + xi_Y^2 - xi_Y),   F_max = pi a_max^2 p(xi)
//   F = F_max h(y),  a = a_max sqrt(2y - y^2),  y = 1 - (overlap_max - overlap)/recovery
//   recovery = A/2 (1 - a_max/s (1 - (1-2 nu) z/(2 (1-nu) (s+z)))),
//   A/2 = 2 p a_max/E',  z = R - overlap_max + A/2,  s^2 = a_max^2 + z^2
//
// For y < 1 the indenter is elliptical; beyond (overlaps above 2 R without yield) it is a flat
// punch. Two bodies are replaced by one sphere on a rigid flat (shared/fitted_sphere.h), as LAMMPS
// does for equal bodies.
//
// Just beyond yield, the released energy of the published law grows faster than the work of
// loading. The energy guard (on by default) then keeps the plastic work from decreasing. Beyond an
// overlap of 0.7 R, where the published recovery tends to zero, the contact area is constant.
// Range: contacts that do not influence other contacts of the same body.
#pragma once

#include "plastigran/shared/fitted_sphere.h"
#include "plastigran/shared/numerics.h"
#include "plastigran/tables/curve_table.h"
#include "plastigran/tables/elliptical_unloading.h"

namespace plastigran {

// Curve of the law in the units x = overlap/R and f = F/(4/3 E' R^2).
struct MdrCurve : NoConstants {
  static constexpr const char* name = "mdr";
  static constexpr const char* source = "Zunker & Kamrin 2024, J. Mech. Phys. Solids 183:105492";
  static constexpr const char* range =
      "overlap <= 0.1 R; contacts of a body do not influence each other";
  static constexpr double largest = 0.7;  // overlap/R up to which the contact area grows

  FittedSphere sphere;
  double strength;             // sigma_Y/E' [-]
  double correction;           // (1 - 2 nu)/(2 (1 - nu)) [-]
  double yield_radius_ratio;   // R/R* [-], because this curve has R as its unit of length
  double depth_y = unlimited;  // xi_Y, overlap/R at yield [-]
  std::array<double, 2> breaks;

  MdrCurve(const MaterialPair& pair, const Parameters&)
      : sphere(pair, of_yielding_body),
        strength(pair.yield_strength / sphere.modulus),
        correction((1 - 2 * pair.poissons_ratio) / (2 * (1 - pair.poissons_ratio))),
        yield_radius_ratio(sphere.radius_ratio) {
    // Bisection is safe: the mean Hertz pressure increases with overlap, and the yield pressure
    // decreases.
    const auto yielded = [this](double x) { return 4 * std::sqrt(x) > 3 * pi * pressure(x); };
    if (yielded(largest)) {
      double low = 0, high = largest;
      halve(low, high, yielded);
      depth_y = high;
    }
    breaks = {depth_y, std::max(depth_y, largest)};
  }

  // Returns p/E' [-], with the mean pressure p beyond yield.
  PLASTIGRAN_DEVICE double pressure(double x) const {
    return strength * (1.75 * std::exp(-4.4 * std::min(x, largest)) + 1);
  }
  // Returns (a_max/R)^2 [-], with the contact radius a_max at the largest overlap.
  PLASTIGRAN_DEVICE double area(double x) const {
    const double grown = std::min(x, largest);
    return grown * (2 - grown) - depth_y * (1 - depth_y);
  }
  PLASTIGRAN_DEVICE double force(double x) const { return 0.75 * pi * area(x) * pressure(x); }
  PLASTIGRAN_DEVICE double contact_radius(double x) const { return std::sqrt(area(x)); }
  PLASTIGRAN_DEVICE double recovery(double x) const {
    const double radius = std::sqrt(area(x)), half_height = 2 * pressure(x) * radius;
    const double z = 1 - std::min(x, largest) + half_height, slant = std::hypot(radius, z);
    return half_height * (1 - radius / slant * (1 - correction * z / (slant + z)));
  }
  double overlap_range() const { return sphere.overlap_range(0.1); }
};

using Mdr = GuardedTable<MdrCurve, EllipticalUnloading>;

}  // namespace plastigran
