// SPDX-License-Identifier: GPL-2.0-or-later
//
// Katta & Polycarpou 2010 (J. Tribol. 132:041402): Lim & Stronge's cylinder (lim_stronge.h,
// line_loading.h) with a shallower crater and a curved rebound. Equations repaired.
//
//   overlap_res = a_res^2/(2 R_b),   1/R_b = 1/R - 1/R_e
//   a_res^2 = a_max^2 - a_el^2,      a_el^2 = 4 q_max/(1/R + 1/R_b)
//   y = F/F_max,  y (1 - ln(y)/C) = (overlap - overlap_res)/(overlap_max - overlap_res),
//   C = ln(4 D^2/a_max^2) - k
//
// The crater is as wide as what the elastic part of the contact leaves. (The sign in 1/R + 1/R_b is
// illegible in print; with the other a_el = a_max and there would be no crater.)
//
// Range: length >= 10 R*, contact narrower than 0.6 thicknesses (nu near 0.25).
#pragma once

#include "plastigran/tables/line_contact.h"

namespace plastigran {

struct CurvedRebound {
  static constexpr const char* name = "katta_polycarpou";
  static constexpr const char* source = "Katta & Polycarpou 2010, J. Tribol. 132:041402";
  static constexpr bool straight = false;
  // Lim & Stronge's, longer by the share of their crater that is not there: r/(2 - r), r = R/R_e,
  // of 2 (1 - r) load/r.
  PLASTIGRAN_DEVICE static double recovery(double load_y, double overlap_y, double load,
                                           double flattening) {
    return overlap_y + 2 * (load - load_y) + 2 * load * (1 - flattening) / (2 - flattening);
  }
};

using KattaPolycarpou = LineContact<CurvedRebound>;

}  // namespace plastigran
