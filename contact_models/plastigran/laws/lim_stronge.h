// SPDX-License-Identifier: GPL-2.0-or-later
//
// Lim & Stronge 1998 (Math. Comput. Model. 28:323): a rigid cylinder on an elastic-plastic body in
// plane strain. Loading as in line_loading.h: R is the effective radius, R_e the radius of the
// unloaded surface, D the thickness of the yielding body. R_b is the radius of curvature of the
// residual indentation. The equations are those of Katta & Polycarpou 2010 (J. Tribol. 132:041402),
// with corrected misprints:
//
//   overlap_res = a_max^2/(2 R_b),   1/R_b = 1/R - 1/R_e
//   F = F_max (overlap - overlap_res)/(overlap_max - overlap_res)
//
//   F |          /     first loading, convex before yield and concave beyond
//     |        _//     linear unloading to overlap_res
//     |      _/ /
//     |_____/__/____ overlap
//
// A contact that has not yielded unloads along the elastic curve. The unloading curve therefore
// jumps at yield, but the force does not. Range: length >= 10 R*, half-width a below 0.6 D (nu near
// 0.25).
#pragma once

#include "plastigran/tables/line_contact.h"

namespace plastigran {

struct StraightRebound {
  static constexpr const char* name = "lim_stronge";
  static constexpr const char* source = "Lim & Stronge 1998, Math. Comput. Model. 28:323";
  static constexpr bool straight = true;
  // Returns overlap_max - overlap_res, using a_max^2 = 4 load R_e and the loading curve.
  PLASTIGRAN_DEVICE static double recovery(double load_y, double overlap_y, double load, double) {
    return overlap_y + 2 * (load - load_y);
  }
};

using LimStronge = LineContact<StraightRebound>;

}  // namespace plastigran
