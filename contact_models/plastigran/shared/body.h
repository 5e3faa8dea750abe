// SPDX-License-Identifier: GPL-2.0-or-later
//
// The constants of one body, each declared once. Checks, deck properties, the Python module, the
// lab and the reference table of the docs read this table.
#pragma once

#include <array>
#include <limits>

namespace plastigran {

// Strength of a body that never yields.
constexpr double unlimited = std::numeric_limits<double>::infinity();

// Default of a constant that has none and must be given.
constexpr double required = std::numeric_limits<double>::quiet_NaN();

// Bodies with a larger modulus stand for rigid ones, and larger strengths for none [Pa].
constexpr double rigid_modulus = 1e15;

// SI units.
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
  const char* name;  // decks use camel case
  const char* symbol;
  const char* unit;
  double Body::*value;
  double lower, upper;  // allowed range, which includes `upper`
  bool above;           // whether the range excludes `lower`
  double standard;      // default; it may lie outside the range
  const char* meaning;
};

// Source of the rate coefficient: Johnson & Cook 1983, 7th Int. Symp. Ballistics: 541.
constexpr std::array<BodyConstant, 7> body_constants{{
    {"youngs_modulus", "E", "Pa", &Body::youngs_modulus, 0, unlimited, true, required,
     "Young's modulus"},
    {"poissons_ratio", "ν", "-", &Body::poissons_ratio, -1, 0.5, true, required, "Poisson's ratio"},
    {"yield_strength", "σ_Y", "Pa", &Body::yield_strength, 0, unlimited, true, unlimited,
     "uniaxial yield strength; 1e30: none"},
    {"yield_pressure_factor", "p_y/σ_Y", "-", &Body::yield_pressure_factor, 0.5, 10, false, 0,
     "contact yield pressure divided by yield strength; 0: Hertz-von Mises value"},
    {"tangent_modulus", "E_t", "Pa", &Body::tangent_modulus, 0, unlimited, false, 0,
     "slope of stress over total strain beyond yield, less than Young's modulus; 0: perfectly "
     "plastic"},
    {"rate_coefficient", "C", "-", &Body::rate_coefficient, 0, 1, false, 0,
     "relative increase of yield strength per e-fold increase of strain rate"},
    {"reference_rate", "ε̇₀", "1/s", &Body::reference_rate, 0, unlimited, true, 1,
     "strain rate at which the yield strength holds"},
}};

}  // namespace plastigran
