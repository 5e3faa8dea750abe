// SPDX-License-Identifier: GPL-2.0-or-later
//
// Adhesion for a law that is elastic first: the adhesive contact of Johnson, Kendall & Roberts 1971
// (shared/adhesion.h), generalized to any relation of force F_1 and overlap_1 without adhesion
// (Maugis 2000, Contact, Adhesion and Rupture of Elastic Solids, ch. 4). S is the slope of
// unloading and c = (2 pi Gamma/E*)^(1/2):
//
//   overlap = overlap_1 - D,   F = F_1 - S D,   D = c (R* overlap_1)^(1/4)        first loading
//   D^2 over S constant                                                          unloading
//   elastic + surface energy = U_1 - F_1 D + S D^2/4,   surface energy = -S D^2/4
//
// Up to yield this is JKR, and S D^2/4 = pi Gamma a^2. First loading has the relation of overlap
// and (R* overlap_1)^(1/2) that JKR has for the contact radius, as in Thornton & Ning 1998.
//
// Yield (Thornton & Ning 1998): adhesion lowers the pressure in the center of the contact by
// p_c = (2 Gamma E*/(pi a))^(1/2). So the contact yields at a_y with p_y + p_c = 2 E* a_y/(pi R*),
// where p_y is the pressure at which the law without adhesion yields. The law then has
// k = 1 + p_c/p_y times its yield strength, F_k(R*, overlap) = F(k^2 R*, overlap)/k. The contact
// stores k, which depends on R* only.
//
// In yield units of the stronger law, x = overlap_1/overlap_y, D = B d with d = x^(1/4), and
// B = c R*/a_y^(3/2) = 2 (1 - 1/k). The work of first loading and the energy at the largest overlap
// are polynomials in B, whose coefficients are tables of x. Plastic work is their difference.
//
// Plastic work would fall with x for a large B, as in Thornton & Ning's law. The constructor finds
// the largest B up to 0.8 for which plastic work grows, and a contact has at least the k of this B.
// A law whose own energy guard keeps the plastic work constant has no such B. There the slope of
// unloading rises by the factor 1 + B eta(x).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <type_traits>
#include <vector>

#include "plastigran/shared/adhesion.h"
#include "plastigran/shared/contact.h"
#include "plastigran/shared/device.h"
#include "plastigran/shared/numerics.h"
#include "plastigran/tables/tabulated.h"
#include "plastigran/tables/unloading.h"

namespace plastigran {

// Whether a law can have adhesion.
template <class Law, class = void>
constexpr bool takes_adhesion = false;
template <class Law>
constexpr bool takes_adhesion<Law, std::void_t<decltype(&Law::Rebound::shape_at)>> = true;

template <class Law, class = void>
constexpr bool energy_guarded = false;
template <class Law>
constexpr bool energy_guarded<Law, std::void_t<decltype(Law::has_guard)>> = Law::has_guard;

template <class Law>
class Adhesive {
 public:
  static constexpr const char* name = Law::name;
  static constexpr const char* line_option = " adhesion jkr";
  static constexpr const char* source = Law::source;
  static constexpr const char* range = Law::range;
  static constexpr bool adhesive = true;
  static constexpr bool hardens = plastigran::hardens<Law>;
  static constexpr bool indentation = plastigran::indentation<Law>;

  struct Parameters : Law::Parameters {
    double surface_energy = required;
  };
  static constexpr auto parameters = [] {
    std::array<Parameter<Parameters>, parameters_of<Law>.size() + 1> all{};
    std::size_t k = 0;
    for (const auto& p : parameters_of<Law>)
      all[k++] = {p.name, p.unit, p.value, p.lower, p.upper, p.meaning, p.per_body};
    all[k] = {"surface_energy",
              "J/m^2",
              &Parameters::surface_energy,
              0,
              1e3,
              "work of adhesion Gamma of the two surfaces"};
    return all;
  }();
  static constexpr auto options = [] {
    std::array<Option<Parameters>, options_of<Law>.size()> all{};
    std::size_t k = 0;
    for (const auto& o : options_of<Law>) all[k++] = {o.name, o.value, o.choices, o.meaning};
    return all;
  }();

  struct State {
    double in_contact = 0;       // 1 from first touch to pull-off
    double strength_factor = 0;  // k; 0 before first touch
    double overlap_max = 0;      // largest overlap_1 beyond yield [m]; 0 while elastic
  };
  static constexpr std::array<const char*, 3> state_names{"in_contact", "strength_factor",
                                                          "overlap_max"};

  Adhesive(const MaterialPair& pair, const Parameters& constants)
      : law_(pair, constants),
        contact_(pair.youngs_modulus_eff, constants.surface_energy),
        elastic_range_(law_.elastic_range()),
        onset_(0.5 * contact_.pull() / std::pow(elastic_range_, 0.75)) {
    tabulate_works();
    guard();
    loaded_ = Tabulated<quantities>(
        1, [this](double x) { return loaded(x); }, kinks());
  }

  double overlap_range() const { return plastigran::overlap_range(law_); }
  double pull_off_distance(double radius_eff) const {
    return -contact_.pull_off_overlap(radius_eff);
  }
  // Overlaps over R* at which the force of first loading may jump.
  std::vector<double> overlap_breaks(double radius_eff) const {
    std::vector<double> all;
    const double k = strength_factor(1, radius_eff);
    if constexpr (energy_guarded<Law>)
      for (const double x : kinks()) {
        const double without = x * k * k * elastic_range_;
        const double overlap =
            without - contact_.pull() / std::sqrt(radius_eff) * std::sqrt(std::sqrt(without));
        if (overlap > 0) all.push_back(overlap);
      }
    return all;
  }
  // Largest B that a contact has.
  double largest_number() const { return largest_number_; }

  PLASTIGRAN_DEVICE double pull_off_force(double radius_eff, double, const State& state) const {
    if (state.overlap_max == 0) return contact_.pull_off_force(radius_eff);
    return pull_off_force(peak_of(radius_eff, state));
  }

  // Elastic and surface energy of a contact that has just formed, or is about to break [J].
  double energy_at_end(double radius_eff, const State& before, bool forms) const {
    if (before.overlap_max == 0) return contact_.energy_at_end(radius_eff, forms);
    const Peak peak = peak_of(radius_eff, before);
    double broken = -2, joined = 0;  // overlap beyond the residual one, over the recovery
    if (!forms) halve(broken, joined, [&](double beyond) { return root(peak, beyond) > 0; });
    const Response end = unloading(peak, root(peak, joined));
    return end.elastic_energy + end.surface_energy;
  }

  PLASTIGRAN_DEVICE Response respond(double radius_eff, double overlap, State& state) const {
    return respond_stronger(1, radius_eff, overlap, state);
  }
  PLASTIGRAN_DEVICE Response respond_stronger(double factor, double radius_eff, double overlap,
                                              State& state) const {
    if (state.overlap_max == 0) {
      if (state.in_contact == 0) {
        if (!(overlap > 0)) return {};
        state.strength_factor = strength_factor(factor, radius_eff);
      } else if (!(overlap > 0) && !(overlap >= contact_.pull_off_overlap(radius_eff))) {
        state.in_contact = 0;
        return {};
      }
      state.in_contact = 1;
      const double s = contact_.root(radius_eff, overlap), without = s * s * s * s / radius_eff;
      if (!(without > overlap_y(radius_eff, state))) return contact_.at(radius_eff, s);
      state.overlap_max = without;
      const Peak peak = peak_of(radius_eff, state);
      return with_work(unloading(peak, 1), peak, radius_eff, state);
    }
    const double reached = state.overlap_max - pull_of(radius_eff, state.overlap_max);
    double w = 1;
    if (overlap > reached) {
      const double s = contact_.root(radius_eff, overlap);
      state.overlap_max = std::max(state.overlap_max, s * s * s * s / radius_eff);
    }
    const Peak peak = peak_of(radius_eff, state);
    if (!(overlap > reached)) {
      const double beyond =
          1 - peak.pull * peak.inverse_recovery - (reached - overlap) * peak.inverse_recovery;
      w = state.in_contact == 0 && !(beyond > 0) ? 0 : root(peak, beyond);
    }
    state.in_contact = w > 0;
    return with_work(w > 0 ? unloading(peak, w) : Response(), peak, radius_eff, state);
  }

 private:
  typedef typename Law::Rebound Rebound;
  static constexpr bool may_stiffen = energy_guarded<Law>;
  enum Quantity { FORCE, SLOPE, INVERSE_RECOVERY, RADIUS };
  static constexpr std::size_t stiffening = 4, shape = stiffening + may_stiffen,
                               quantities = shape + Rebound::has_shape;
  typedef std::array<double, quantities> Values;

  // The contact at its largest overlap.
  struct Peak {
    double force, slope, pull;  // F_1, S and D
    double contact_radius, inverse_recovery, shape;
  };

  // The values of a law after loading to x, in yield units, without the factor 1 + B eta.
  struct Loaded {
    double force, slope, contact_radius, recovery, shape, energy;
  };
  PLASTIGRAN_DEVICE Loaded after_loading(double x) const {
    const auto at = law_.after_loading(x);
    const double recovery = 1 / at.inverse_recovery;
    return {at.force,          Rebound::largest_slope(at.shape) * at.force / recovery,
            at.contact_radius, recovery,
            at.shape,          at.force * recovery * rebound_.shape_at(1, at.shape).energy};
  }
  PLASTIGRAN_DEVICE Values loaded(double x) const {
    const Loaded at = after_loading(x);
    Values values{at.force, at.slope, 1 / at.recovery, at.contact_radius};
    if constexpr (may_stiffen) values[stiffening] = eta(x, at);
    if constexpr (Rebound::has_shape) values[shape] = at.shape;
    return values;
  }
  [[gnu::noinline, gnu::cold]] PLASTIGRAN_DEVICE Values computed(double x) const {
    return loaded(x);
  }

  auto kinks() const {
    if constexpr (energy_guarded<Law>)
      return law_.kinks();
    else
      return std::array<double, 1>{1};
  }

  // k, by which a_y is larger than without adhesion, but at least that of the largest B.
  [[gnu::noinline, gnu::cold]] PLASTIGRAN_DEVICE double strength_factor(double factor,
                                                                        double radius_eff) const {
    const double b = onset_ / std::sqrt(radius_eff * factor * factor * factor);
    const double q = root_at_yield(b);
    return factor * std::max(q * q, std::cbrt(4 * b * b / (largest_number_ * largest_number_)));
  }

  PLASTIGRAN_DEVICE double overlap_y(double radius_eff, const State& state) const {
    return state.strength_factor * state.strength_factor * elastic_range_ * radius_eff;
  }
  // B of a contact.
  PLASTIGRAN_DEVICE double number(double radius_eff, const State& state) const {
    const double k = state.strength_factor;
    return 2 * onset_ / std::sqrt(radius_eff * k * k * k);
  }

  PLASTIGRAN_DEVICE double pull_of(double radius_eff, double overlap_max) const {
    return contact_.pull() * std::sqrt(std::sqrt(radius_eff * overlap_max));
  }
  PLASTIGRAN_DEVICE Peak peak_of(double radius_eff, const State& state) const {
    const double unit = overlap_y(radius_eff, state), per_unit = 1 / unit;
    const double x = state.overlap_max * per_unit;
    const Values at = loaded_.covers(x) ? loaded_(x) : computed(x);
    const double radius_y = std::sqrt(unit * radius_eff);  // a_y
    const double stiffness = 4.0 / 3.0 * contact_.modulus() * radius_y;
    double slope = stiffness * at[SLOPE], inverse_recovery = per_unit * at[INVERSE_RECOVERY];
    if constexpr (may_stiffen) {
      const double stiffer = 1 + number(radius_eff, state) * at[stiffening];
      slope *= stiffer, inverse_recovery *= stiffer;
    }
    double shape_at_x = Rebound::usual_shape;
    if constexpr (Rebound::has_shape) shape_at_x = at[shape];
    return {stiffness * unit * at[FORCE],
            slope,
            pull_of(radius_eff, state.overlap_max),
            radius_y * at[RADIUS],
            inverse_recovery,
            shape_at_x};
  }

  // Of unloading like Hertz; otherwise at the w of such unloading, up to 8 % too small.
  PLASTIGRAN_DEVICE double pull_off_force(const Peak& peak) const {
    const double b = peak.pull * peak.inverse_recovery;
    if constexpr (Rebound::is_hertzian) return 0.375 * peak.slope * peak.pull * b;
    const ShapeOfUnloading at = rebound_.shape_at(std::cbrt(0.75 * b), peak.shape);
    return peak.slope * peak.pull * at.slope * std::sqrt(at.slope) - peak.force * at.force;
  }

  // w > 0 on unloading, with y = w^4 = (overlap_1 - overlap_res)/(overlap_max - overlap_res), and
  // `beyond` the same for the overlap. It is the largest root of w^4 - b S^(1/2)/S_max^(1/2) =
  // beyond; 0 if there is none, because the contact breaks.
  PLASTIGRAN_DEVICE double root(const Peak& peak, double beyond) const {
    const double b = peak.pull * peak.inverse_recovery;
    if (b == 0) return beyond > 0 ? std::sqrt(std::sqrt(beyond)) : 0;
    double w = adhesive_root(beyond, b);
    if constexpr (!Rebound::is_hertzian) {
      w = refined_root(peak.shape, b, beyond, w);
      return w > 0 ? w : refined_root(peak.shape, b, beyond, 1);
    }
    // At the least w there is no root below the least value.
    return beyond > 0 || 4 * w * w * w > b * (1 + 1e-7) || w * (w * w * w - b) <= beyond ? w : 0;
  }
  // Newton's method, for a function that is convex where it rises: all but the first steps go down.
  // A step of 1e-7 leaves an error of about 1e-14, because the error is squared each time.
  PLASTIGRAN_DEVICE double refined_root(double shape_at_x, double b, double beyond,
                                        double w) const {
    for (int k = 0; k < 100; ++k) {
      const RootOfSlope at = rebound_.root_of_slope(w, shape_at_x);
      const double cube = w * w * w, rise = 4 * cube - b * at.derivative;
      if (!(rise > 0)) return 0;
      const double step = (cube * w - b * at.value - beyond) / rise;
      w -= step;
      if (!(w > 0)) return 0;
      if (std::abs(step) <= 1e-7 * w || (k > 8 && step <= 0)) return std::min(w, 1.0);
    }
    return 0;
  }

  PLASTIGRAN_DEVICE Response unloading(const Peak& peak, double w) const {
    const ShapeOfUnloading at = rebound_.shape_at(w, peak.shape);
    const double slope = peak.slope * at.slope, pull = peak.pull * std::sqrt(at.slope);
    const double force = peak.force * at.force, pulling = slope * pull;
    Response response;
    response.force = force - pulling;
    response.contact_radius = peak.contact_radius * at.contact_radius;
    response.elastic_energy =
        peak.force / peak.inverse_recovery * at.energy - (force - 0.5 * pulling) * pull;
    response.surface_energy = -0.25 * pulling * pull;
    response.pull_off_force = pull_off_force(peak);
    return response;
  }

  // Adds the plastic work: the work of first loading less the energy at the largest overlap.
  PLASTIGRAN_DEVICE Response with_work(Response response, const Peak& peak, double radius_eff,
                                       const State& state) const {
    const double unit = overlap_y(radius_eff, state);
    const Response largest = unloading(peak, 1);
    response.plastic_work =
        4.0 / 3.0 * contact_.modulus() * std::sqrt(unit * radius_eff) * unit * unit *
            work_of_loading(state.overlap_max / unit, number(radius_eff, state)) -
        largest.elastic_energy - largest.surface_energy;
    return response;
  }

  // Over F_y overlap_y, at the number B.
  PLASTIGRAN_DEVICE double work_of_loading(double x, double B) const {
    if (!(x >= 1 && x < works_end_)) return summed_work(x, B);
    const auto at = [&](std::size_t k) { return works_[k](x)[0]; };
    return at(0) - B * (at(1) - B * (at(2) + (may_stiffen ? B * at(3) : 0)));
  }
  // The same beyond the end of the tables.
  [[gnu::noinline, gnu::cold, gnu::pure]] PLASTIGRAN_DEVICE double summed_work(double x,
                                                                               double B) const {
    const Works at = summed_works(x);
    return at[0] - B * (at[1] - B * (at[2] + B * at[3]));
  }
  double plastic_work(double x, double B) const {
    const Loaded at = after_loading(x);
    const double d = std::sqrt(std::sqrt(x)), stiffer = 1 + B * eta(x, at);
    return work_of_loading(x, B) - at.energy / stiffer +
           B * d * (at.force - 0.25 * B * d * at.slope * stiffer);
  }

  // Coefficients of B in the work of first loading to x: 1, -B, B^2, B^3.
  typedef std::array<double, 4> Works;
  PLASTIGRAN_DEVICE Works power_of_loading(double x) const {
    const Loaded at = after_loading(x);
    const double d = std::sqrt(std::sqrt(x)), slope_of_d = 0.25 * d / x,
                 more = eta(x, at) * at.slope;
    return {at.force, at.slope * d + at.force * slope_of_d, d * (at.slope * slope_of_d - more),
            more * d * slope_of_d};
  }
  void tabulate_works() {
    constexpr std::array<double, 4> at_yield{0.4, 1, 0.375, 0};  // JKR
    for (std::size_t k = 0; k < works_.size(); ++k)
      works_[k] = Tabulated<1>(
                      1, [&](double x) { return std::array{power_of_loading(x)[k]}; }, kinks())
                      .integral(at_yield[k]);
    works_end_ = works_[0].end();
    for (const auto& table : works_) works_end_ = std::min(works_end_, table.end());
  }
  // Beyond the end of the tables.
  PLASTIGRAN_DEVICE Works summed_works(double x) const {
    Works sum;
    for (std::size_t k = 0; k < sum.size(); ++k) {
      double left = std::min(x, works_[k].end());
      sum[k] = works_[k](left * (1 - 1e-15))[0];
      for (double right; left < x; left = right) {
        right = std::min(2 * left, x);
        sum[k] += gauss_legendre([&](double at) { return power_of_loading(at)[k]; }, left, right);
      }
    }
    return sum;
  }

  // A law with an energy guard: stretches of x on which plastic work would fall with B. There the
  // contact loses the share B `lost` of the work of loading, which makes eta U_1 this work.
  struct Stretch {
    double begin = 0, end = 0;
  };
  static constexpr double guarded_number = 0.4;
  PLASTIGRAN_DEVICE double eta(double x, const Loaded& at) const {
    if constexpr (!energy_guarded<Law>) return 0;
    double work = 0;
    for (const Stretch& stretch : stretches_)
      if (x > stretch.begin && stretch.end > 0)
        work += loading_(std::min(x, stretch.end))[0] - loading_(stretch.begin)[0];
    return lost_ * work / at.energy;
  }
  // Points at which plastic work is compared: close to both sides of each kink.
  std::vector<double> points() const {
    std::vector<double> all;
    const auto edges = kinks();
    for (double x = 1 + 1e-9; x < 1e3;) {
      all.push_back(x);
      double last = 1, next = 1e3;
      for (const double edge : edges) {
        if (edge <= x) last = std::max(last, edge);
        if (edge > x) next = std::min(next, edge);
      }
      const double below = next * (1 - 1e-9);
      const double further = x + std::min(0.003 * x, std::max(0.25 * (x - last), 1e-9 * x));
      x = x >= below ? next * (1 + 1e-9) : std::min(further, below);
    }
    return all;
  }
  bool falls(double from, double to, double B) const {
    return plastic_work(to, B) < plastic_work(from, B) - 1e-13 * work_of_loading(to, 0);
  }
  // The stretches, longer by 2 % on each side.
  void find_stretches() {
    const std::vector<double> all = points();
    std::size_t count = 0;
    for (std::size_t k = 1; k < all.size(); ++k) {
      if (!falls(all[k - 1], all[k], largest_number_) &&
          !falls(all[k - 1], all[k], 0.1 * largest_number_))
        continue;
      const double begin = std::max(1.0, all[k - 1] / 1.02);
      const bool is_new = count == 0 || begin > 1.2 * stretches_[count - 1].end;
      if (is_new && count < stretches_.size()) stretches_[count++].begin = begin;
      stretches_[count - 1].end = 1.02 * all[k];
    }
  }
  // Finds the largest number, and for laws with an energy guard the least loss for which it is 0.4.
  void guard() {
    const auto lower_to = [this](double least) {
      for (largest_number_ = 0.8; largest_number_ > least; largest_number_ *= 0.95)
        if (loses_energy(largest_number_)) return true;
      return false;
    };
    if (!energy_guarded<Law> || lower_to(guarded_number)) {
      lower_to(0.01);
      return;
    }
    largest_number_ = guarded_number;
    loading_ = works_[0];
    find_stretches();
    for (lost_ = 0.02; lost_ < 1; lost_ *= 1.5) {
      tabulate_works();
      if (loses_energy(largest_number_)) return;
    }
    lost_ = 0;
    tabulate_works();
    lower_to(0.01);
  }
  // Whether plastic work grows for all numbers up to B.
  bool loses_energy(double B) const {
    const std::vector<double> all = points();
    for (const double part : {0.1, 0.4, 0.7, 1.0})
      for (std::size_t k = 1; k < all.size(); ++k)
        if (falls(all[k - 1], all[k], part * B)) return false;
    return true;
  }

  Law law_;
  Rebound rebound_;
  JkrContact contact_;
  double elastic_range_;       // overlap_y/R*
  double onset_;               // b R*^(1/2) [m^(1/2)]
  double largest_number_ = 0;  // largest B
  std::array<Stretch, 4> stretches_{};
  double lost_ = 0;
  Tabulated<1, 9> loading_;  // work of loading without adhesion
  std::array<Tabulated<1, 9>, 4> works_;
  double works_end_ = 0;
  Tabulated<quantities> loaded_;
};

}  // namespace plastigran
