// SPDX-License-Identifier: GPL-2.0-or-later
//
// Base of laws with linear or power-law springs, a residual overlap and an adhesive limit
// (laws/luding_2008.h, laws/edinburgh_2014.h). The adhesive limit is the most attractive force at
// each overlap. On this limit, overlap_max decreases so that the contact stays on its unloading
// curve. A law defines:
//
//   scale(radius_eff)                   constants that depend on R*
//   limited(scale, overlap)             overlap_max after first loading to `overlap`
//   force(scale, overlap, max)          force on the unloading curve from the largest overlap `max`
//   elastic_energy(scale, overlap, max)
//   loading_work(scale, overlap)        work of first loading from 0
//   limit_work(scale, overlap)          work along the adhesive limit from 0
//   limit_begins(scale, max)            overlap at which unloading from `max` meets the limit
//   max_on_limit(scale, overlap)        `max` of a contact on the limit
#pragma once

#include <algorithm>
#include <array>
#include <cmath>

#include "plastigran/shared/contact.h"
#include "plastigran/shared/device.h"

namespace plastigran {

template <class Law>
class AdhesiveLimit {
 public:
  static constexpr bool yields = false;
  static constexpr bool elastic_first = false;
  static constexpr bool adhesive = true;

  struct State {
    double overlap_max = 0;   // largest overlap, reduced on the adhesive limit [m]
    double plastic_work = 0;  // plastic work so far [J]
  };
  static constexpr std::array<const char*, 2> state_names{"overlap_max", "plastic_work"};

  PLASTIGRAN_DEVICE static double plastic_work_in(const State& state) { return state.plastic_work; }

  PLASTIGRAN_DEVICE Response respond(double radius_eff, double overlap, State& state) const {
    const auto scale = law().scale(radius_eff);
    const double at = overlap > 0 ? overlap : 0;
    if (at > state.overlap_max)
      load(scale, law().limited(scale, at), state);
    else
      unload(scale, at, state);
    Response response;
    response.plastic_work = state.plastic_work;
    if (at == 0) return response;
    response.force = law().force(scale, at, state.overlap_max);
    response.contact_radius = std::sqrt(radius_eff * at);
    response.elastic_energy = law().elastic_energy(scale, at, state.overlap_max);
    return response;
  }

 private:
  PLASTIGRAN_DEVICE const Law& law() const { return static_cast<const Law&>(*this); }

  // Updates the state for first loading from overlap_max to `overlap`.
  template <class Scale>
  PLASTIGRAN_DEVICE void load(const Scale& scale, double overlap, State& state) const {
    const double before = state.overlap_max;
    if (!(overlap > before)) return;
    state.plastic_work += law().loading_work(scale, overlap) - law().loading_work(scale, before) -
                          law().elastic_energy(scale, overlap, overlap) +
                          law().elastic_energy(scale, before, before);
    state.overlap_max = overlap;
  }

  // Updates the state for unloading or reloading to `overlap`, along the adhesive limit if it is
  // reached.
  template <class Scale>
  PLASTIGRAN_DEVICE void unload(const Scale& scale, double overlap, State& state) const {
    const double lower = law().max_on_limit(scale, overlap);
    if (!(lower < state.overlap_max)) return;
    const double begin = law().limit_begins(scale, state.overlap_max);
    state.plastic_work += law().limit_work(scale, begin) - law().limit_work(scale, overlap) +
                          law().elastic_energy(scale, begin, state.overlap_max) -
                          law().elastic_energy(scale, overlap, lower);
    state.overlap_max = lower;
  }
};

}  // namespace plastigran
