// SPDX-License-Identifier: GPL-2.0-or-later
//
// What the laws of a cylinder pressed into an elastic-plastic body share: the line contact in plane
// strain, elastic and beyond yield. Lim & Stronge 1998 (Math. Comput. Model. 28:323) and Katta &
// Polycarpou 2010 (J. Tribol. 132); elastic part after Johnson, Contact Mechanics (1985), sec. 5.6.
//
//   L  length of the cylinder          D  thickness of the body that yields    R  R* of the pair
//   p  F/L, force a length             a  half-width of the contact            Y  yield strength
//   q  p/(pi E*), a load in metres     k  nu/(1-nu)                            s  a/a_Y
//
//   elastic      overlap = q (ln(4 D^2/a^2) - k),  a^2 = 4 q R            mean pressure <= 1.5 Y
//   yield        a_Y = 12 Y R/(pi E*)
//   beyond       overlap = overlap_Y + (a^2 - a_Y^2)/(2R),  F = 2 a L Y p
//                p = min(1.5 + ln(s)/sqrt(3), 2.4)
//   unloading    a^2 = 4 q R_e with the radius R_e that the rebound gives back: flatter than R
//
// A line contact, unlike a point contact, has no overlap without a place to measure it from: the
// far side of the body, D away; hence the logarithm. Its slope falls short as a grows; from
// ln(4 D^2/a^2) - k = 2 on (a = 0.6 D for nu near 0.25, out of range) the load follows its tangent
// instead.
//
// The laws differ in the rebound. Both return more than was put in just above yield, because the
// loading beyond it forgets the logarithm (the slope jumps up by about 3). With the energy guard
// the rebound is shortened to what was put in; from where the published one returns less, the work
// lost only grows.
#pragma once

#include <algorithm>

#include "plastigran/shared/contact.h"
#include "plastigran/shared/largest_overlap.h"
#include "plastigran/shared/power.h"
#include "plastigran/shared/tabulated.h"

namespace plastigran {

// The root w > 1 of w - ln w = t, for t >= 1.25: -W(-exp(-t)) on the lower branch of Lambert's
// function. Halley from two terms of its asymptotic series; four steps leave rounding only.
inline double lambert_root(double t) {
  const double log_t = std::log(t);
  double w = t + log_t + log_t / t;
  for (int i = 0; i < 4; ++i) {
    const double off = w - std::log(w) - t, s = w - 1;
    w -= 2 * off * s * w / (2 * s * s - off);
  }
  return w;
}

// The same from a table, which serves all line contacts there are: t is the logarithm of a ratio of
// lengths, and the table ends at 20 000. A step of Newton's leaves rounding only here, too.
inline const Tabulated<1> lambert_roots(1.25, [](double t) { return std::array{lambert_root(t)}; });

inline double tabulated_lambert_root(double t) {
  const double w = lambert_roots(t)[0];
  return w - (w - natural_log(w) - t) * w / (w - 1);
}

// The elastic line contact: what a load q [m] does, and which load an overlap asks for.
class LineCompliance {
 public:
  // reach [m]: overlap = q ln(reach/q)
  explicit LineCompliance(double reach) : reach_(reach), tangent_from_(reach * std::exp(-2.0)) {}

  // At a load: the overlap [m] and the work [m^2] of the load over it.
  struct Pressed {
    double overlap, work;
  };
  Pressed pressed(double load) const {
    const double bent = std::min(load, tangent_from_), straight = load - bent;
    const double log = natural_log(reach_ / bent);
    return {bent * log + straight,
            bent * bent * (2 * log - 1) / 4 + straight * (bent + straight / 2)};
  }
  double load(double overlap) const {
    return overlap < 2 * tangent_from_
               ? overlap / tabulated_lambert_root(natural_log(reach_ / overlap))
               : overlap - tangent_from_;
  }

 private:
  double reach_;
  double tangent_from_;
};

// The law that a Rebound makes of a line contact. A rebound has the law's `name` and `source`;
// `recovery(load_y, overlap_y, load, flattening)`, the way back from the largest overlap [m]; and
// `straight`, whether it is a straight line (else the elastic curve of a cylinder of radius R_e,
// stretched to that length). flattening = R/R_e.
template <class Rebound>
class LineContact : public Rebound, public LargestOverlap {
 public:
  static constexpr const char* shape = "cylinder";
  static constexpr const char* range = "cylinder 10 radii long or more, contact narrower than body";
  struct Parameters {
    double cylinder_length = required;  // L [m]
    double body_thickness = required;   // D [m]
    int energy_guard = 1;
  };
  static constexpr std::array<Parameter<Parameters>, 2> parameters{{
      {"cylinder_length", "m", &Parameters::cylinder_length, 1e-12, 1e6, "length of the cylinder",
       true},
      {"body_thickness", "m", &Parameters::body_thickness, 1e-12, 1e6,
       "thickness of the body that yields, to where the overlap is measured from", true},
  }};
  static constexpr std::array<Option<Parameters>, 1> options{{
      energy_guard_option(&Parameters::energy_guard),
  }};

  LineContact(const MaterialPair& pair, const Parameters& given)
      : stiffness_(pi * pair.youngs_modulus_eff * given.cylinder_length),
        lateral_(pair.poissons_ratio / (1 - pair.poissons_ratio)),
        reach_(given.body_thickness * given.body_thickness * std::exp(-lateral_)),
        half_width_ratio_(12 * pair.yield_strength / (pi * pair.youngs_modulus_eff)),
        energy_guard_(given.energy_guard == 1) {}

  Response respond(double radius_eff, double overlap, State& state) const {
    const LineCompliance undented(reach_ / radius_eff);
    const double load_y = 0.25 * half_width_ratio_ * half_width_ratio_ * radius_eff;
    const auto [overlap_y, work_y] = undented.pressed(load_y);
    Response response;
    if (state.overlap_max == 0 && overlap <= overlap_y) {
      if (!(overlap > overlap_min)) return response;
      const double load = undented.load(overlap);
      response.force = stiffness_ * load;
      response.contact_radius = 2 * std::sqrt(load * radius_eff);
      response.elastic_energy = stiffness_ * undented.pressed(load).work;
      return response;
    }
    if (overlap > state.overlap_max) state.overlap_max = overlap;

    // At the largest overlap: loads in q, lengths in a_Y, works over stiffness_.
    const double area = 1 + (state.overlap_max - overlap_y) / (2 * load_y);  // s^2
    const double s = std::sqrt(area), log_s = 0.5 * natural_log(area);
    const double load_max = load_y * s * std::min(1 + hardening * log_s, pressure_cap);
    const double flattening = load_max / (load_y * area);
    const double work = work_y + 4 * load_y * load_y * plastic_share(s, log_s);
    const LineCompliance crater(reach_ / radius_eff * flattening);
    const auto [crater_overlap, crater_work] = crater.pressed(load_max);
    const double fullness = Rebound::straight ? 0.5 : crater_work / (load_max * crater_overlap);
    double recovery = Rebound::recovery(load_y, overlap_y, load_max, flattening);
    if (energy_guard_) recovery = std::min(recovery, work / (load_max * fullness));

    const double x = 1 - (state.overlap_max - overlap) / recovery;
    if (x > 0 && overlap > 0) {
      const double load = Rebound::straight ? x * load_max : crater.load(x * crater_overlap);
      response.force = stiffness_ * load;
      response.contact_radius = 2 * std::sqrt(load * radius_eff / flattening);
      response.elastic_energy =
          stiffness_ * recovery *
          (Rebound::straight ? 0.5 * load * x : crater.pressed(load).work / crater_overlap);
    }
    response.plastic_work = stiffness_ * (work - load_max * recovery * fullness);
    return response;
  }

  // Stiffness of the undented contact [N/m]. Normal: slope of the elastic force. Tangential: a
  // strip of that half-width sticking to the body and shifted along it against the same far side;
  // from the displacements of a line force, Johnson (1985) sec. 2.2-2.3.
  Stiffness elastic_stiffness(double contact_radius) const {
    const double far = std::max(compliance(contact_radius), 2.0);
    return {stiffness_ / (far - 1), stiffness_ / (far + 2 * lateral_ + 1)};
  }

 private:
  static constexpr double overlap_min = 1e-200;               // [m] no ratio overflows above it
  static constexpr double hardening = 0.38490017945975051;    // (1/sqrt(3))/1.5
  static constexpr double pressure_cap = 1.6;                 // 2.4/1.5
  static constexpr double plastic_from = 4.7533314343482855;  // s there, exp(0.9 sqrt(3))

  // ln(4 D^2/a^2) - k; without end where the contact has no width yet
  double compliance(double half_width) const {
    const double square = half_width * half_width;
    return square > 0 ? natural_log(4 * reach_ / square) : unlimited;
  }

  // Integral of s^2 p/1.5 from yield: the work beyond it over F_Y a_Y^2/R.
  static double plastic_share(double s, double log_s) {
    const double cube = s * s * s;
    if (s > plastic_from) {
      const double full = plastic_from * plastic_from * plastic_from;
      return plastic_share(plastic_from, 0.9 * 1.7320508075688772) +
             pressure_cap / 3 * (cube - full);
    }
    return (cube - 1) / 3 + hardening * (cube * log_s - (cube - 1) / 3) / 3;
  }

  double stiffness_;         // pi E* L [N/m]: F = stiffness q
  double lateral_;           // k
  double reach_;             // D^2 exp(-k): overlap = q ln(reach/(R q))
  double half_width_ratio_;  // a_Y/R
  bool energy_guard_;
};

}  // namespace plastigran
