// SPDX-License-Identifier: GPL-2.0-or-later
//
// Times of an elastic sphere that time steps are usually compared with.
#pragma once

#include <cmath>

#include "plastigran/shared/contact.h"

namespace plastigran {

// Duration of an elastic impact [s] (Hertz 1881; Johnson, Contact Mechanics, 1985, sec. 11.4).
inline double hertz_duration(double radius_eff, double mass_eff, double youngs_modulus_eff,
                             double speed) {
  return 2.868266 * std::pow(mass_eff * mass_eff /
                                 (radius_eff * youngs_modulus_eff * youngs_modulus_eff * speed),
                             0.2);
}

// Time of a surface wave from pole to pole [s]. The ratio of its speed to the shear wave's is
// 0.8766 + 0.1631 nu, the usual linear fit to the root of Rayleigh's equation (Li, Xu & Thornton
// 2005, Powder Technol. 160:219).
inline double rayleigh_time(double radius, double density, double youngs_modulus,
                            double poissons_ratio) {
  const double shear_modulus = 0.5 * youngs_modulus / (1 + poissons_ratio);
  return pi * radius * std::sqrt(density / shear_modulus) / (0.8766 + 0.1631 * poissons_ratio);
}

}  // namespace plastigran
