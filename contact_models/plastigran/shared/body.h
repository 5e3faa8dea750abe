// SPDX-License-Identifier: GPL-2.0-or-later
//
// Constants of one body. The table body_constants is their only declaration: the range checks, the
// deck properties, the Python module and the reference pages all read it.
#pragma once

#include <array>
#include <limits>

namespace plastigran {

// Yield strength of a body that never yields.
constexpr double unlimited = std::numeric_limits<double>::infinity();

// Default value that marks a constant without default, which the user must give.
constexpr double required = std::numeric_limits<double>::quiet_NaN();

// Limit for rigid bodies [Pa]: a larger modulus means rigid, and a larger strength means no yield.
constexpr double rigid_modulus = 1e15;

// Constants of one body in SI units; body_constants explains each.
struct Body {
  double youngs_modulus = 0;
  double poissons_ratio = 0;
  double yield_strength = unlimited;
  double yield_pressure_factor = 0;
  double tangent_modulus = 0;
  double rate_coefficient = 0;
  double reference_rate = 1;
};

struct BodyConstant {
  const char* name;  // field name; decks use it in camel case
  const char* symbol;
  const char* unit;
  double Body::*value;
  double lower, upper;  // allowed range, which includes `upper`
  bool above;           // whether the range excludes `lower`
  double standard;      // default value, which may lie outside the range
  const char* meaning;
};

// Table of all constants. Source of the rate coefficient: Johnson & Cook 1983, 7th Int. Symp.
// Ballistics: 541.
constexpr std::array<BodyConstant, 7> body_constants{{
    {"youngs_modulus", "E", "Pa", &Body::youngs_modulus, 0, unlimited, true, required,
     "Young's modulus"},
    {"poissons_ratio", "ν", "-", &Body::poissons_ratio, -1, 0.5, true, required, "Poisson's ratio"},
    {"yield_strength", "σ_Y", "Pa", &Body::yield_strength, 0, unlimited, true, unlimited,
     "uniaxial yield strength; 1e30 for a body that does not yield"},
    {"yield_pressure_factor", "p_y/σ_Y", "-", &Body::yield_pressure_factor, 0.5, 10, false, 0,
     "contact pressure at first yield, divided by yield strength; 0: value for Hertz contact and "
     "von Mises yield"},
    {"tangent_modulus", "E_t", "Pa", &Body::tangent_modulus, 0, unlimited, false, 0,
     "slope of the stress-strain curve beyond yield, below Young's modulus; 0: perfectly plastic"},
    {"rate_coefficient", "C", "-", &Body::rate_coefficient, 0, 1, false, 0,
     "relative increase of yield strength per e-fold increase of strain rate"},
    {"reference_rate", "ε̇₀", "1/s", &Body::reference_rate, 0, unlimited, true, 1,
     "strain rate at which the body has the given yield strength"},
}};

}  // namespace plastigran
