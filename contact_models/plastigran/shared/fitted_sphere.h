// SPDX-License-Identifier: GPL-2.0-or-later
//
// Laws fitted to one yielding sphere on a rigid plane, for two bodies that both deform.
//
// Such a fit depends on the sphere's own plane strain modulus E' = E/(1-nu^2) and radius R, as in
// sigma_Y/E' and a/R. For two bodies (option reading yielding_body, the default) the sphere is the
// one of the yielding body's material that has their Hertzian force and contact radius:
//
//   E',   R = R* E'/E*,   its overlap is overlap E*/E'
//
// Of two equal spheres that is each sphere with its half of the overlap; on a rigid plane it is the
// sphere itself. So two equal spheres that meet and one of them on a rigid plane are the same
// collision. Reading pair takes E* and R* instead.
//
// A curve in yield units, x = overlap/overlap_y and f = F/F_y, is the same in either; with
// the fitted sphere's a_y/R the pair's is (a_y/R) radius_ratio.
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

  // The law's overlap_range(), of the fit's largest overlap over R. The other body's share of the
  // overlap, 1 - E*/E', is held against that body's sphere likewise.
  double overlap_range(double depth) const {
    const double others_share = 1 - 1 / radius_ratio;
    return std::min(std::min(depth, widest_overlap_range) * radius_ratio * radius_ratio,
                    widest_overlap_range / (others_share * others_share));
  }
};

template <class Parameters>
constexpr Option<Parameters> reading_option(int Parameters::*value) {
  return {"reading",
          value,
          {"yielding_body", "pair", nullptr},
          "whose modulus and radius the fit to one sphere takes"};
}

// Laws with no other option and no constants of their own say so with this base.
struct ReadingAlone {
  struct Parameters {
    int reading = of_yielding_body;
  };
  static constexpr std::array<Option<Parameters>, 1> options{{
      reading_option(&Parameters::reading),
  }};
};

}  // namespace plastigran
