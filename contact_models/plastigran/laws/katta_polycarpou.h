// SPDX-License-Identifier: GPL-2.0-or-later
//
// Katta & Polycarpou 2010 (J. Tribol. 132:041402): the cylinder of Lim & Stronge (lim_stronge.h)
// with a smaller residual indentation and curved unloading. Misprints are corrected. As in
// line_loading.h, R is the effective radius, R_e the radius of the unloaded surface, D the
// thickness of the yielding body, and k = nu/(1-nu). q = F/(pi E* L) is the load on the length L,
// and a is the half-width of the contact:
//
//   overlap_res = a_res^2/(2 R_b),   1/R_b = 1/R - 1/R_e
//   a_res^2 = a_max^2 - a_el^2,      a_el^2 = 4 q_max/(1/R + 1/R_b)
//   y = F/F_max,  y (1 - ln(y)/C) = (overlap - overlap_res)/(overlap_max - overlap_res),
//   C = ln(4 D^2/a_max^2) - k
//
// a_res is the half-width of the residual indentation, and R_b its radius of curvature. In print,
// the sign in 1/R + 1/R_b is illegible. It must be plus: with a minus sign, there would be no
// residual indentation, because a_el = a_max.
//
// Range: length >= 10 R*, half-width a below 0.6 D (nu near 0.25).
#pragma once

#include "plastigran/tables/line_contact.h"

namespace plastigran {

struct CurvedRebound {
  static constexpr const char* name = "katta_polycarpou";
  static constexpr const char* source = "Katta & Polycarpou 2010, J. Tribol. 132:041402";
  static constexpr bool straight = false;
  // Returns overlap_max - overlap_res. This is the value of Lim & Stronge, plus the fraction
  // r/(2 - r) of their residual overlap 2 (1 - r) load/r, where r = R/R_e is `flattening`.
  PLASTIGRAN_DEVICE static double recovery(double load_y, double overlap_y, double load,
                                           double flattening) {
    return overlap_y + 2 * (load - load_y) + 2 * load * (1 - flattening) / (2 - flattening);
  }
};

using KattaPolycarpou = LineContact<CurvedRebound>;

}  // namespace plastigran
