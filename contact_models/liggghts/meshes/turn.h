// SPDX-License-Identifier: GPL-2.0-or-later
#pragma once

#include "vector_liggghts.h"

namespace plastigran {

// Turns `vector` by the smallest turn that takes the direction `from` to the direction `to`; leaves
// it where there is none, for opposite or vanishing directions.
inline void turn(const double* from, const double* to, double* vector) {
  const double lengths = vectorMag3D(from) * vectorMag3D(to);
  const double cosine = vectorDot3D(from, to) / lengths;
  if (!(lengths > 0 && cosine > -1)) return;
  double axis[3], once[3], twice[3];
  vectorCross3D(from, to, axis);
  vectorScalarDiv3D(axis, lengths);
  vectorCross3D(axis, vector, once);
  vectorCross3D(axis, once, twice);
  for (int k = 0; k < 3; ++k) vector[k] += once[k] + twice[k] / (1 + cosine);
}

}  // namespace plastigran
