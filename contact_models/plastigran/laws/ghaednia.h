// SPDX-License-Identifier: GPL-2.0-or-later
//
// Ghaednia, Marghitu & Jackson 2014 (J. Tribol. 137:011403): the law of Jackson & Green refitted to
// the impact of a rod on a flat, with deformation of both bodies. The equations are those of
// Ghaednia et al. 2015 (Int. J. Impact Eng. 86:307), eqs 32-34. overlap_c is the overlap at yield
// and x = overlap/overlap_c. f is F divided by the Hertz force at overlap_c. H is the hardness, and
// C sigma_Y the yield pressure (jackson_green.h):
//
//   f = exp(-0.17 x^(5/12)) x^1.5 + 4H/(C sigma_Y) (1 - exp(-x^(5/9)/78)) x^1.1   x > 1.9
//   overlap_res = 0.8 overlap_max (1 - ((x + 5.5)/6.5)^-2)                        x > 1.9
//
// The printed equation leaves open whether 1.1 is an exponent of x (option `loading exponent`, the
// default) or a factor of x (option `loading prefactor`). The force jumps by -10 % at x = 1.9.
// Range: one steel on iron, overlaps to about 1000 overlap_c.
#pragma once

#include "plastigran/laws/jackson_green.h"
#include "plastigran/tables/power_unloading.h"

namespace plastigran {

struct GhaedniaCurve : JacksonGreenCurve {
  static constexpr const char* name = "ghaednia";
  static constexpr const char* source = "Ghaednia, Marghitu & Jackson 2014, J. Tribol. 137:011403";
  static constexpr const char* range =
      "overlap <= 1000 times that at yield; fitted to a steel rod on an iron flat";
  enum Loading { exponent_of_overlap, prefactor };
  struct Parameters {
    int loading = exponent_of_overlap;
    int reading = of_yielding_body;
  };
  static constexpr std::array<Option<Parameters>, 2> options{{
      {"loading",
       &Parameters::loading,
       {"exponent", "prefactor", nullptr},
       "meaning of 1.1 in the loading curve: exponent or factor"},
      reading_option(&Parameters::reading),
  }};

  int loading;

  GhaedniaCurve(const MaterialPair& pair, const Parameters& constants)
      : JacksonGreenCurve(pair, {cosine, constants.reading}), loading(constants.loading) {}

  PLASTIGRAN_DEVICE double force(double x) const {
    const double growth = loading == prefactor ? 1.1 * x : std::pow(x, 1.1);
    return std::exp(-0.17 * std::pow(x, 5.0 / 12)) * x * std::sqrt(x) +
           4 * hardness_ratio(contact_radius(x)) / pressure_factor *
               -std::expm1(-std::pow(x, 5.0 / 9) / 78) * growth;
  }
  double overlap_range() const { return sphere.overlap_range(1000 * yield_radius * yield_radius); }
  PLASTIGRAN_DEVICE double recovery(double x) const {
    const double t = 6.5 / (x + 5.5);
    return x * (1 - 0.8 * (1 - t * t));
  }
};

using Ghaednia = PowerUnloading<GhaedniaCurve>;

}  // namespace plastigran
