// SPDX-License-Identifier: GPL-2.0-or-later
//
// Law of a line contact: loading as in shared/line_loading.h, and unloading as in a class Rebound.
// The law is trivially copyable. Rebound has `name` and `source` of the law, and
//
//   recovery(load_y, overlap_y, load, flattening)
//               returns overlap_max - overlap_res [m]; flattening = R/R_e
//   straight    whether unloading is a straight line; otherwise it is the elastic curve of a
//               cylinder of radius R_e, stretched to `recovery`
//
// Just above yield, the published unloading releases more energy than loading took, because the
// slope of loading jumps up by a factor of about 3: beyond yield, loading omits the logarithm. The
// energy guard limits the released energy to the work of loading. At larger overlaps, it has no
// effect.
#pragma once

#include <algorithm>

#include "plastigran/shared/contact.h"
#include "plastigran/shared/device.h"
#include "plastigran/shared/largest_overlap.h"
#include "plastigran/shared/line_loading.h"
#include "plastigran/tables/power_tables.h"
#include "plastigran/tables/tabulated.h"

namespace plastigran {

// Tables of dimensionless functions of line contacts; they are the same for all materials.
class LineTables {
 public:
  LineTables()
      : load_shares_(0x1p-31, [](double x) { return std::array{plastigran::load_share(x)}; }) {}

  PLASTIGRAN_DEVICE double load_share(double x) const {
    return load_shares_.covers(x) ? load_shares_(x)[0] : plastigran::load_share(x);
  }

  PowerTables logs;

 private:
  Tabulated<1, 8, 30> load_shares_;
};

// Elastic line contact: overlap = q ln(reach/q), with the load q [m] and the constant length
// `reach` [m].
class LineCompliance {
 public:
  PLASTIGRAN_DEVICE LineCompliance(const LineTables& tables, double reach)
      : tables_(tables), reach_(reach), tangent_from_(reach * tangent_share) {}

  // Returns the overlap [m] at a load [m]; `log` is ln(reach/load).
  PLASTIGRAN_DEVICE double overlap(double load, double log) const {
    return log > 2 ? load * log : load + tangent_from_;
  }
  PLASTIGRAN_DEVICE double load(double overlap) const {
    if (!(overlap < 2 * tangent_from_)) return overlap - tangent_from_;
    return overlap * tables_.load_share(overlap / reach_);
  }
  // Returns the integral of the load over the overlap [m^2].
  PLASTIGRAN_DEVICE double work(double load, double overlap) const {
    return load < tangent_from_ ? 0.25 * load * (2 * overlap - load)
                                : 0.5 * load * load + 0.25 * tangent_from_ * tangent_from_;
  }

 private:
  // Value of load/reach, exp(-2), beyond which the overlap follows the tangent of the logarithmic
  // formula.
  static constexpr double tangent_share = 0.13533528323661269;
  const LineTables& tables_;
  double reach_;
  double tangent_from_;
};

template <class Rebound>
class LineContact : public Rebound, public LargestOverlap {
 public:
  static constexpr const char* shape = "cylinder";
  static constexpr const char* range =
      "cylinder length >= 10 radii, contact narrower than the body";
  struct Parameters {
    double cylinder_length = required;  // length L of the cylinder [m]
    double body_thickness = required;   // thickness D of the yielding body [m]
    int energy_guard = 1;
  };
  static constexpr std::array<Parameter<Parameters>, 2> parameters{{
      {"cylinder_length", "m", &Parameters::cylinder_length, 1e-12, 1e6, "length of the cylinder",
       true},
      {"body_thickness", "m", &Parameters::body_thickness, 1e-12, 1e6,
       "thickness of the yielding body; the overlap is measured relative to its far side", true},
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

  PLASTIGRAN_DEVICE Response respond(double radius_eff, double overlap, State& state) const {
    return respond(load_ratio_, log_yield_, radius_eff, overlap, state);
  }
  // Returns the response with the yield strength multiplied by `factor`.
  PLASTIGRAN_DEVICE Response respond_stronger(double factor, double radius_eff, double overlap,
                                              State& state) const {
    const double log_yield = log_yield_ - 2 * tables_.logs.natural_log(factor);
    return respond(load_ratio_ * factor * factor, log_yield, radius_eff, overlap, state);
  }

  // Returns the stiffness of the elastic contact [N/m]. Normal: slope of the elastic force.
  // Tangential: a sticking strip of the same half-width moves relative to the far side of the body.
  // Its stiffness follows from the displacements of a line force, Johnson (1985) sec. 2.2-2.3.
  PLASTIGRAN_DEVICE Stiffness elastic_stiffness(double contact_radius) const {
    const double far = std::max(compliance(contact_radius), 2.0);
    return {stiffness_ / (far - 1), stiffness_ / (far + 2 * lateral_ + 1)};
  }

 private:
  static constexpr double overlap_min = 1e-200;  // overlap above which no ratio overflows [m]
  static constexpr double square_min = 1e-300;   // smallest a^2 in a logarithm [m^2]

  PLASTIGRAN_DEVICE Response respond(double yield_ratio, double log_yield, double radius_eff,
                                     double overlap, State& state) const {
    const LineCompliance undented(tables_, reach_ / radius_eff);
    const double load_y = yield_ratio * radius_eff;
    const double log_y =
        log_yield - 2 * tables_.logs.natural_log(radius_eff);  // ln(reach/(R load_y))
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

    // The next values belong to the largest overlap. Loads are q = F/stiffness_ [m]; works are
    // divided by stiffness_ [m^2].
    const double area = 1 + (state.overlap_max - overlap_y) / (2 * load_y);  // s^2
    const double s = std::sqrt(area), log_s = 0.5 * tables_.logs.natural_log(area);
    const double load_ratio = LineYielding::load(s, log_s);
    const double load_max = load_y * load_ratio;
    const double flattening = load_ratio / area;
    const double work =
        undented.work(load_y, overlap_y) + 4 * load_y * load_y * LineYielding::work(s, log_s);
    const LineCompliance crater(tables_, reach_ / radius_eff * flattening);
    const double crater_overlap = crater.overlap(load_max, log_y - 2 * log_s);
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

  // Returns overlap/q of the elastic contact, ln(4 D^2/a^2) - k, with the body thickness D and the
  // half-width a.
  PLASTIGRAN_DEVICE double compliance(double half_width) const {
    const double square = half_width * half_width;
    return square > square_min ? log_reach_ - tables_.logs.natural_log(square) : unlimited;
  }

  double stiffness_;   // pi E* L [N/m]: F = stiffness q
  double lateral_;     // k = nu/(1-nu) [-]
  double reach_;       // D^2 exp(-k) [m^2]: overlap = q ln(reach/(R q))
  double log_reach_;   // ln(4 reach)
  double load_ratio_;  // load_y/R = (a_Y/(2R))^2
  double log_yield_;   // ln(reach/load_ratio)
  bool energy_guard_;
  LineTables tables_;
};

}  // namespace plastigran
