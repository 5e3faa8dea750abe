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

// What all line contacts there are have in common, tabulated once. 1/w where w - ln w = ln(1/x),
// the share of an overlap that its load is: x is the overlap over the reach.
inline double load_share(double x) { return 1 / lambert_root(std::max(1.25, -std::log(x))); }
inline const Tabulated<1, 8, 30> load_shares(0x1p-31,
                                             [](double x) { return std::array{load_share(x)}; });

// The elastic line contact, overlap = q ln(reach/q): what a load q [m] does, and which load an
// overlap asks for.
class LineCompliance {
 public:
  explicit LineCompliance(double reach) : reach_(reach), tangent_from_(reach * tangent_share) {}

  // Of a load and log = ln(reach/load) [m].
  double overlap(double load, double log) const {
    return log > 2 ? load * log : load + tangent_from_;
  }
  double load(double overlap) const {
    if (!(overlap < 2 * tangent_from_)) return overlap - tangent_from_;
    const double x = overlap / reach_;
    return overlap * (load_shares.covers(x) ? load_shares(x)[0] : load_share(x));
  }
  // Of the load over its overlap [m^2].
  double work(double load, double overlap) const {
    return load < tangent_from_ ? 0.25 * load * (2 * overlap - load)
                                : 0.5 * load * load + 0.25 * tangent_from_ * tangent_from_;
  }

 private:
  static constexpr double tangent_share = 0.13533528323661269;  // exp(-2)
  double reach_;
  double tangent_from_;
};

// A contact whose area a^2 has grown beyond that at yield; load and work in those of yield.
class LineYielding {
 public:
  // load/load_y; ln(area); integral of area p/1.5 over s from yield, the work beyond it over
  // F_Y a_Y^2/R.
  struct Loaded {
    double load, log_area, work;
  };
  static Loaded at(double area) {
    const auto [load, log_area, work] = table.covers(area) ? table(area) : computed(area);
    return {load, log_area, work};
  }

 private:
  static constexpr double hardening = 0.38490017945975051;    // (1/sqrt(3))/1.5
  static constexpr double pressure_cap = 1.6;                 // 2.4/1.5
  static constexpr double plastic_from = 4.7533314343482855;  // s there, exp(0.9 sqrt(3))

  static std::array<double, 3> computed(double area) {
    const double s = std::sqrt(area), log_s = 0.5 * std::log(area);
    return {s * std::min(1 + hardening * log_s, pressure_cap), 2 * log_s, work(s, log_s)};
  }
  static double work(double s, double log_s) {
    const double cube = s * s * s;
    if (s > plastic_from) {
      const double full = plastic_from * plastic_from * plastic_from;
      return work(plastic_from, 0.9 * 1.7320508075688772) + pressure_cap / 3 * (cube - full);
    }
    return (cube - 1) / 3 + hardening * (cube * log_s - (cube - 1) / 3) / 3;
  }

  static const Tabulated<3> table;
};
inline const Tabulated<3> LineYielding::table(1, computed, std::array{plastic_from * plastic_from});

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
        log_reach_(std::log(4 * reach_)),
        load_ratio_(std::pow(6 * pair.yield_strength / (pi * pair.youngs_modulus_eff), 2)),
        log_yield_(std::log(reach_ / load_ratio_)),
        energy_guard_(given.energy_guard == 1) {}

  Response respond(double radius_eff, double overlap, State& state) const {
    const LineCompliance undented(reach_ / radius_eff);
    const double load_y = load_ratio_ * radius_eff;
    const double log_y = log_yield_ - 2 * natural_log(radius_eff);  // ln(reach/(R load_y))
    const double overlap_y = undented.overlap(load_y, log_y);
    Response response;
    if (state.overlap_max == 0 && overlap <= overlap_y) {
      if (!(overlap > overlap_min)) return response;
      const double load = undented.load(overlap);
      response.force = stiffness_ * load;
      response.contact_radius = 2 * std::sqrt(load * radius_eff);
      response.elastic_energy = stiffness_ * undented.work(load, overlap);
      return response;
    }
    if (overlap > state.overlap_max) state.overlap_max = overlap;

    // At the largest overlap: loads in q, works over stiffness_.
    const double area = 1 + (state.overlap_max - overlap_y) / (2 * load_y);  // s^2
    const LineYielding::Loaded loaded = LineYielding::at(area);
    const double load_max = load_y * loaded.load;
    const double flattening = loaded.load / area;
    const double work = undented.work(load_y, overlap_y) + 4 * load_y * load_y * loaded.work;
    const LineCompliance crater(reach_ / radius_eff * flattening);
    const double crater_overlap = crater.overlap(load_max, log_y - loaded.log_area);
    const double fullness =
        Rebound::straight ? 0.5
                          : crater.work(load_max, crater_overlap) / (load_max * crater_overlap);
    double recovery = Rebound::recovery(load_y, overlap_y, load_max, flattening);
    if (energy_guard_) recovery = std::min(recovery, work / (load_max * fullness));

    const double x = 1 - (state.overlap_max - overlap) / recovery;
    if (x > 0 && overlap > 0) {
      const double load = Rebound::straight ? x * load_max : crater.load(x * crater_overlap);
      response.force = stiffness_ * load;
      response.contact_radius = 2 * std::sqrt(load * radius_eff / flattening);
      response.elastic_energy =
          stiffness_ * recovery *
          (Rebound::straight ? 0.5 * load * x
                             : crater.work(load, x * crater_overlap) / crater_overlap);
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
  static constexpr double overlap_min = 1e-200;  // [m] no ratio overflows above it
  static constexpr double square_min = 1e-300;   // [m^2] a narrower contact has no width yet

  // ln(4 D^2/a^2) - k
  double compliance(double half_width) const {
    const double square = half_width * half_width;
    return square > square_min ? log_reach_ - natural_log(square) : unlimited;
  }

  double stiffness_;   // pi E* L [N/m]: F = stiffness q
  double lateral_;     // k
  double reach_;       // D^2 exp(-k): overlap = q ln(reach/(R q))
  double log_reach_;   // ln(4 reach)
  double load_ratio_;  // load_y/R = (a_Y/(2R))^2
  double log_yield_;   // ln(reach/load_ratio)
  bool energy_guard_;
};

}  // namespace plastigran
