// SPDX-License-Identifier: GPL-2.0-or-later
//
// Fitted sphere: it replaces two deforming bodies in laws that were fitted to one yielding sphere
// on a rigid plane.
//
// Such a fit depends on the plane strain modulus E' = E/(1-nu^2) and the radius R of the sphere,
// for example through sigma_Y/E' and a/R. The fitted sphere has the material of the yielding body,
// and the Hertz force and contact radius of the pair:
//
//   E',   R = R* E'/E*,   overlap of this sphere: overlap E*/E'
//
// For two equal spheres, the fitted sphere is one of the two, with half of the overlap. For a
// sphere on a rigid plane, the fitted sphere is the sphere itself. Therefore a collision of two
// equal spheres is equivalent to a collision of one of them with a rigid plane. The option
// `reading yielding_body` (the default) uses the fitted sphere. `reading pair` uses E* and R*
// instead of E' and R.
//
// A curve in yield units, x = overlap/overlap_y and f = F/F_y, is the same for the pair and for the
// fitted sphere. Contact radii convert by a/R* = (a/R) radius_ratio.
#pragma once

#include <algorithm>

#include "plastigran/shared/contact.h"

namespace plastigran {

enum Reading { of_yielding_body, of_pair };

struct FittedSphere {
  double modulus;       // E' [Pa]
  double radius_ratio;  // R/R* = E'/E*

  FittedSphere(const MaterialPair& pair, int reading)
      : modulus(reading == of_pair ? pair.youngs_modulus_eff : 1 / plane_strain_compliance(pair)),
        radius_ratio(modulus / pair.youngs_modulus_eff) {}

  // Returns the largest valid overlap/R* of a law that was fitted up to overlap/R = `depth`. This
  // limit applies to the overlap of the fitted sphere. The other body deforms by the fraction 1 -
  // E*/E' of the overlap; the limit for its deformation is widest_overlap_range.
  double overlap_range(double depth) const {
    const double others_share = 1 - 1 / radius_ratio;
    return std::min(std::min(depth, widest_overlap_range) * radius_ratio * radius_ratio,
                    widest_overlap_range / (others_share * others_share));
  }
};

template <class Parameters>
constexpr Option<Parameters> reading_option(int Parameters::*value) {
  return {
      "reading",
      value,
      {"yielding_body", "pair", nullptr},
      "whether the modulus and radius of the yielding body or of the pair enter the fitted law"};
}

// Base of laws that have no constants and only the option `reading`.
struct ReadingAlone {
  struct Parameters {
    int reading = of_yielding_body;
  };
  static constexpr std::array<Option<Parameters>, 1> options{{
      reading_option(&Parameters::reading),
  }};
};

}  // namespace plastigran
