// SPDX-License-Identifier: GPL-2.0-or-later
//
// Central impact of two bodies for any law, without a host program. The outcome follows from the
// energies of the law, or from the equation of motion if the force depends on the overlap rate.
#pragma once

#include <algorithm>
#include <cmath>

#include "plastigran/shared/adhesion.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

struct ImpactOutcome {
  double overlap_max = 0;  // largest overlap [m]
  double force_max = 0;    // largest force [N]
  double overlap_res = 0;  // overlap at which the force vanishes during unloading [m]
  double coefficient_of_restitution = 0;  // rebound speed/impact speed [-]; 0 if the bodies stick
  double stiffness_max = 0;               // largest dF/d(overlap) [N/m]
  double damping_max = 0;                 // dF/d(overlap rate) at overlap_max [N s/m]
  bool in_range = true;                   // whether overlap_max is in the validity range of the law
};

// Whether a law has overlap_breaks(): overlaps at which its force of first loading may jump.
template <class Law, class = void>
constexpr bool has_breaks = false;
template <class Law>
constexpr bool has_breaks<Law, std::void_t<decltype(&Law::overlap_breaks)>> = true;

// Returns the overlaps at which the force may jump, divided by R*. They depend on R* if the law has
// adhesion.
template <class Law>
auto overlap_breaks(const Law& law, [[maybe_unused]] double radius_eff) {
  if constexpr (std::is_invocable_v<decltype(&Law::overlap_breaks), const Law&>)
    return law.overlap_breaks();
  else
    return law.overlap_breaks(radius_eff);
}

// Computes the central impact of a rate-dependent law by integrating m* d^2 overlap/dt^2 = -F from
// first touch until the force vanishes. With root = sqrt(overlap), rate = d overlap/dt and a new
// time tau, defined by dt = root dtau, the equations are smooth even if the force begins as
// sqrt(overlap):
//
//   d root/dtau = rate/2,   d rate/dtau = -root F/m*
//
// The integrator is Runge-Kutta of fourth order. Each step is computed once in full and once as two
// half steps. The difference estimates the error, which is subtracted (Richardson extrapolation).
// The error of root is at most 1e-12 times the larger root of the step. The error of the rate is at
// most 1e-12 times the impact speed.
template <class Law>
ImpactOutcome rate_dependent_impact(const Law& law, double radius_eff, double mass_eff,
                                    double speed) {
  struct Point {
    double root, rate;
    Point after(double h, Point slope) const {
      return {root + h * slope.root, rate + h * slope.rate};
    }
  };
  typename Law::State state;
  const auto force = [&](Point p) {
    typename Law::State trial = state;
    return p.root > 0 ? law.respond(radius_eff, p.root * p.root, trial, p.rate).force : 0.0;
  };
  const auto slope = [&](Point p) { return Point{0.5 * p.rate, -p.root * force(p) / mass_eff}; };
  const auto once = [&](Point p, double h) {
    const Point a = slope(p), b = slope(p.after(h / 2, a)), c = slope(p.after(h / 2, b)),
                d = slope(p.after(h, c));
    return p.after(h / 6, a).after(h / 3, b).after(h / 3, c).after(h / 6, d);
  };
  double error = 0;  // error of the last trial step, divided by the allowed error
  const auto step = [&](Point p, double h) {
    const Point whole = once(p, h), half = once(once(p, h / 2), h / 2);
    const Point off{(half.root - whole.root) / 15, (half.rate - whole.rate) / 15};
    error = std::max(std::abs(off.root) / (1e-12 * std::max(p.root, half.root)),
                     std::abs(off.rate) / (1e-12 * speed));
    return half.after(1, off);
  };
  // Finds by bisection the point in a step at which a condition becomes true.
  const auto turn = [&](Point p, double h, auto condition) {
    double before = 0, after = h;
    halve(before, after, [&](double part) { return condition(step(p, part)); });
    return step(p, after);
  };

  ImpactOutcome impact;
  const auto back = [](Point p) { return p.rate < 0; };
  const auto gone = [&](Point p) { return p.rate < 0 && force(p) == 0; };
  Point now{0, speed};
  double h = 1e-6 * std::sqrt(radius_eff) / speed;
  for (int tried = 0; tried < 100000; ++tried) {
    const Point next = step(now, h);
    const double growth = 0.9 * std::pow(std::max(error, 1e-10), -0.2);
    if (error > 1) {
      h *= std::max(growth, 0.1);
      continue;
    }
    // The force is largest while the bodies approach: search for its maximum in this step.
    if (!back(now)) {
      const auto along = [&](double part) { return force(step(now, part * h)); };
      impact.force_max = std::max(impact.force_max, along(golden_section(along, 0, 1, 30)));
    }
    if (back(next) && !back(now)) {
      const Point top = turn(now, h, back);
      impact.overlap_max = top.root * top.root;
    }
    if (gone(next)) {
      now = turn(now, h, gone);
      break;
    }
    now = next;
    law.respond(radius_eff, now.root * now.root, state, now.rate);
    h *= std::min(growth, 4.0);
  }
  impact.coefficient_of_restitution = -now.rate / speed;
  const double overlap_res = now.root > 0 ? now.root * now.root : 0;
  impact.overlap_res = overlap_res < 1e-9 * impact.overlap_max ? 0 : overlap_res;
  impact.in_range = impact.overlap_max <= overlap_range(law) * radius_eff;

  const auto at = [&](double overlap, double rate) { return force({std::sqrt(overlap), rate}); };
  const double still = at(impact.overlap_max, 0), less = 1e-4 * impact.overlap_max;
  impact.stiffness_max = (still - at(impact.overlap_max - less, 0)) / less;
  impact.damping_max = (at(impact.overlap_max, speed) - still) / speed;
  return impact;
}

// Computes the unloading from `impact.overlap_max` for a law without rate dependence: largest
// force, residual overlap and steepest slope. Returns the response at the largest overlap.
template <class Law>
Response follow_rebound(const Law& law, double radius_eff, ImpactOutcome& impact) {
  typename Law::State state;
  const Response peak = law.respond(radius_eff, impact.overlap_max, state);
  impact.force_max = peak.force;
  impact.in_range = impact.overlap_max <= overlap_range(law) * radius_eff;
  const auto force = [&](double overlap) {
    typename Law::State unloading = state;
    return law.respond(radius_eff, overlap, unloading).force;
  };
  double low = 0, high = impact.overlap_max;
  halve(low, high, [&](double middle) { return force(middle) > 0; });
  impact.overlap_res = high < 1e-9 * impact.overlap_max ? 0 : high;

  // Compute the slope from a small finite difference. The overlap has a relative round-off of about
  // 1e-14. Therefore, if unloading covers less than 1e-7 of the overlap, use the slope of a Hertz
  // contact with the same force and elastic energy.
  const double step = 1e-4 * (impact.overlap_max - impact.overlap_res);
  impact.stiffness_max = step > 1e-11 * impact.overlap_max
                             ? (peak.force - force(impact.overlap_max - step)) / step
                             : 0.6 * peak.force * peak.force / peak.elastic_energy;
  return peak;
}

// Returns the response at first touch. Without adhesion, force and energies are zero.
template <class Law>
Response first_touch([[maybe_unused]] const Law& law, [[maybe_unused]] double radius_eff) {
  if constexpr (adhesive<Law>) {
    typename Law::State state;
    return law.respond(radius_eff, std::numeric_limits<double>::min(), state);
  } else {
    return {};
  }
}

// Returns the response just before the contact ends, after first loading to `overlap_max`.
template <class Law>
Response end_of_contact(const Law& law, double radius_eff, double overlap_max) {
  typename Law::State loaded;
  law.respond(radius_eff, overlap_max, loaded);
  const auto unloaded_to = [&](double overlap) {
    typename Law::State state = loaded;
    return law.respond(radius_eff, overlap, state);
  };
  double low = -1.001 * pull_off_distance(law, radius_eff), high = overlap_max;
  halve(low, high, [&](double middle) { return unloaded_to(middle).contact_radius > 0; });
  return unloaded_to(high);
}

// Computes the central impact of bodies with effective mass mass_eff [kg] at relative speed `speed`
// [m/s]. At the largest overlap, the work of loading equals 1/2 m* v^2. Unloading releases the
// elastic energy. With adhesion, separation takes work; the bodies stick if this work exceeds the
// released energy.
template <class Law>
ImpactOutcome central_impact(const Law& law, double radius_eff, double mass_eff, double speed) {
  if constexpr (rate_dependent<Law>) return rate_dependent_impact(law, radius_eff, mass_eff, speed);
  ImpactOutcome impact;
  const double energy = 0.5 * mass_eff * speed * speed;
  if (!(energy > 0)) return impact;
  const double at_touch = contact_energy(first_touch(law, radius_eff));
  const auto excess = [&](double overlap) {
    typename Law::State state;
    return contact_energy(law.respond(radius_eff, overlap, state)) - at_touch - energy;
  };
  double low = 0, high = 1e-6 * radius_eff;
  for (; excess(high) < 0 && high < 1e6 * radius_eff; high *= 2) low = high;
  halve(low, high, [&](double middle) { return !(excess(middle) < 0); });
  impact.overlap_max = 0.5 * (low + high);
  const Response peak = follow_rebound(law, radius_eff, impact);
  double released = peak.elastic_energy;
  if constexpr (adhesive<Law>) {
    const Response end = end_of_contact(law, radius_eff, impact.overlap_max);
    released = std::max(0.0, energy + at_touch - contact_energy(end));
  }
  impact.coefficient_of_restitution = std::sqrt(released / energy);
  return impact;
}

// Returns the smallest kinetic energy of an impact after which the bodies separate [J].
template <class Law>
double sticking_energy(const Law& law, double radius_eff) {
  const double at_touch = contact_energy(first_touch(law, radius_eff));
  const auto at_end = [&](double overlap_max) {
    return contact_energy(end_of_contact(law, radius_eff, overlap_max)) - at_touch;
  };
  if constexpr (elastic_first<Law>)
    return std::max(0.0, at_end(std::numeric_limits<double>::min()));
  const auto loaded = [&](double overlap) {
    typename Law::State state;
    return contact_energy(law.respond(radius_eff, overlap, state)) - at_touch;
  };
  double low = 0, high = radius_eff;
  halve(low, high, [&](double overlap) { return loaded(overlap) > at_end(overlap); });
  return std::max(0.0, loaded(high));
}

// Returns the relative error of restitution due to jumps of the force, divided by the time step
// [1/s]. The force may jump in first loading; with adhesion, it also jumps where a contact forms
// and breaks. In the step that passes a jump, the integrator keeps the force from before the jump
// for up to half a step after it.
template <class Law>
double jump_error([[maybe_unused]] const Law& law, [[maybe_unused]] double radius_eff,
                  double mass_eff, double speed) {
  double power = 0;  // sum of force jump times speed [W]
  if constexpr (has_breaks<Law>)
    for (const double depth : overlap_breaks(law, radius_eff)) {
      typename Law::State before, after;
      const Response below = law.respond(radius_eff, depth * radius_eff * (1 - 1e-9), before);
      const Response above = law.respond(radius_eff, depth * radius_eff * (1 + 1e-9), after);
      const double energy = below.elastic_energy + below.plastic_work;
      const double speed_squared = speed * speed - 2 * energy / mass_eff;
      if (speed_squared > 0)
        power += std::abs(above.force - below.force) * std::sqrt(speed_squared);
    }
  if constexpr (adhesive<Law>) {
    // If the bodies stick, there is no restitution to resolve: use the lowest speed at which they
    // rebound.
    const Response touch = first_touch(law, radius_eff);
    if (touch.force != 0)
      speed = std::max(speed, std::sqrt(2 * sticking_energy(law, radius_eff) / mass_eff));
    power += 2 * std::abs(touch.force) * speed;  // 2: the contact forms and breaks
  }
  return 0.5 * power / (mass_eff * speed * speed);
}

// Constants of the recommended time step, 0.1 sqrt(m*/k) with the largest stiffness k during the
// impact. If the force depends on the overlap rate, the step is shorter, because hosts use the rate
// of half a step earlier; c is dF/d(overlap rate). For a smooth force, the error of restitution is
// at most 9e-4 and of second order in the step. For a force with jumps, the step is shorter, so
// that the total error is 1e-3. Kinks of the force add up to 2e-4 (docs/timestep.md).
constexpr double timestep_fraction = 0.1;
constexpr double timestep_damping = 16;  // coefficient of c^2/(k m*)
constexpr double smooth_error = 9e-4, restitution_error = 1e-3;

template <class Law>
double recommended_timestep(const Law& law, double radius_eff, double mass_eff, double speed,
                            const ImpactOutcome& impact) {
  const double stiffness = impact.stiffness_max, damping = impact.damping_max;
  const double step = timestep_fraction * std::sqrt(mass_eff / stiffness) /
                      (1 + timestep_damping * damping * damping / (stiffness * mass_eff));
  const double jumps = jump_error(law, radius_eff, mass_eff, speed) * step;
  const double share = 2 * restitution_error /
                       (jumps + std::sqrt(jumps * jumps + 4 * smooth_error * restitution_error));
  return step * std::min(1.0, share);
}

template <class Law>
double recommended_timestep(const Law& law, double radius_eff, double mass_eff, double speed) {
  return recommended_timestep(law, radius_eff, mass_eff, speed,
                              central_impact(law, radius_eff, mass_eff, speed));
}

// Returns the recommended time step [s] of an impact at `speed` whose largest overlap is `overlap`.
// The given overlap saves the search for the largest overlap, except for rate-dependent laws.
template <class Law>
double recommended_timestep_of_load(const Law& law, double radius_eff, double mass_eff,
                                    double speed, double overlap) {
  if constexpr (rate_dependent<Law>) return recommended_timestep(law, radius_eff, mass_eff, speed);
  ImpactOutcome impact;
  impact.overlap_max = overlap;
  follow_rebound(law, radius_eff, impact);
  return recommended_timestep(law, radius_eff, mass_eff, speed, impact);
}

}  // namespace plastigran
