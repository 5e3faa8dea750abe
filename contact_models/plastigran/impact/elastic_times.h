// SPDX-License-Identifier: GPL-2.0-or-later
//
// Reference times of elastic spheres with which DEM time steps are usually compared.
#pragma once

#include <cmath>

#include "plastigran/shared/contact.h"

namespace plastigran {

// Returns the duration of an elastic impact [s] (Hertz 1881; Johnson, Contact Mechanics, 1985, sec.
// 11.4).
inline double hertz_duration(double radius_eff, double mass_eff, double youngs_modulus_eff,
                             double speed) {
  return 2.868266 * std::pow(mass_eff * mass_eff /
                                 (radius_eff * youngs_modulus_eff * youngs_modulus_eff * speed),
                             0.2);
}

// Returns the travel time of a surface wave from pole to pole of a sphere [s]. The speed of the
// wave divided by the shear wave speed is 0.8766 + 0.1631 nu, the usual linear fit to the root of
// Rayleigh's equation (Li, Xu & Thornton 2005, Powder Technol. 160:219).
inline double rayleigh_time(double radius, double density, double youngs_modulus,
                            double poissons_ratio) {
  const double shear_modulus = 0.5 * youngs_modulus / (1 + poissons_ratio);
  return pi * radius * std::sqrt(density / shear_modulus) / (0.8766 + 0.1631 * poissons_ratio);
}

}  // namespace plastigran
