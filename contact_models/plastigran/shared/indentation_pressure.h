// SPDX-License-Identifier: GPL-2.0-or-later
//
// Pressure of a fully plastic indentation (hardness), a constant of several laws. The default is
// 2.8 times the yield strength (Tabor, The Hardness of Metals, 1951).
#pragma once

#include "plastigran/shared/contact.h"

namespace plastigran {

inline double indentation_pressure(const MaterialPair& pair, double given) {
  return given > 0 ? given : 2.8 * pair.yield_strength;
}

template <class Parameters>
constexpr Parameter<Parameters> indentation_pressure_parameter(double Parameters::*value) {
  return {"indentation_pressure",
          "Pa",
          value,
          1e5,
          1e13,
          "pressure of a fully plastic indentation, 9.80665e6 times a hardness in kgf/mm2; 0 means "
          "2.8 times the yield strength"};
}

}  // namespace plastigran
