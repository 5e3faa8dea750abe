// SPDX-License-Identifier: GPL-2.0-or-later
//
// Run-time checks of contacts for a model: the overlap limit, the validity range of the law, and
// the time step. A contact is checked only if its overlap is 10 % larger than in earlier contacts
// of the same atom types, or exceeds a limit.
#pragma once

#include <algorithm>
#include <cmath>
#include <string>

#include "atom.h"
#include "contact_interface.h"
#include "force.h"
#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/fixes/range_check.h"
#include "liggghts/fixes/time_step_check.h"
#include "liggghts/model/deck_properties.h"
#include "liggghts/model/deck_units.h"
#include "plastigran/impact/central_impact.h"
#include "plastigran/pairs/impact_times.h"
#include "plastigran/pairs/range_report.h"
#include "plastigran/pairs/type_pair.h"
#include "plastigran/shared/adhesion.h"
#include "pointers.h"
#include "update.h"

namespace plastigran {

// Return the error messages for an overlap beyond `overlap_limit` (both in radii of the smaller
// body), and for a particle that is about to cross a wall.
std::string describe_overlap(const LAMMPS_NS::Atom* atom,
                             const LIGGGHTS::ContactModels::SurfacesIntersectData& contact,
                             double overlap, double overlap_limit);
std::string describe_crossing(const LAMMPS_NS::Atom* atom,
                              const LIGGGHTS::ContactModels::SurfacesIntersectData& contact);

template <class Law>
class ContactChecks : protected LAMMPS_NS::Pointers {
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;
  typedef typename Law::State State;

 public:
  explicit ContactChecks(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}

  // Prepares the checks in each setup, after the laws were built. Collective.
  void begin(const std::string& model, double overlap_limit) {
    model_ = model;
    overlap_limit_ = overlap_limit;
    excess_ = RangeCheck::of(lmp, model, Law::range);
    time_step_check_ = ensure_fix<TimeStepCheck>(lmp);
    time_step_check_->reset();
  }

  // Passes the times of the expected impacts to the check of the time step, and warns of impacts
  // beyond the validity range of the law. Each setup calls this function on rank 0.
  void expect(const ImpactTimes& times, double rayleigh, bool is_wall) {
    time_step_check_->expect(model_, {times.step, times.step_speed, is_wall}, rayleigh,
                             times.hertz);
    if (times.outside_speed <= 1.01 * excess_->warned_speed) return;
    // Warn once for all walls, and again only for higher speeds.
    excess_->warned_speed = times.outside_speed;
    warn(lmp, model_ + ": " +
                  range_forecast(Law::range, times.outside_speed,
                                 unit_in_deck(update->unit_style, "m/s")));
  }

  // Prints a warning once for all walls. Each setup calls this function on rank 0.
  void warn_once(const std::string& text) {
    if (excess_->unique_warnings.insert(text).second) warn(lmp, model_ + ": " + text);
  }

  // Checks a contact whose overlap/R* exceeds `pair.checked_from`. `factor` is its rate factor, and
  // its state changes from `before` to `now`.
  [[gnu::noinline]] void check(const Contact& contact, TypePair<Law>& pair, double factor,
                               double radius_eff, const State& before, const State& now) {
    const double smaller = contact.is_wall ? contact.radi : std::min(contact.radi, contact.radj);
    if (contact.deltan > overlap_limit_ * smaller)
      fail(describe_overlap(atom, contact, contact.deltan / smaller, overlap_limit_));
    // Stop before the center of the particle crosses the wall. The wall would then push the
    // particle out on the other side.
    if (contact.is_wall && overlap_limit_ <= 1 && contact.deltan + 2 * approach(contact) > smaller)
      fail(describe_crossing(atom, contact));
    // overlap_limit_ refers to the smaller radius. R* is at most this radius, so a check of every
    // overlap above overlap_limit_ R* finds all overlaps beyond the limit.
    // A contact with adhesion is checked when it unloads: while it loads, it passes the overlaps of
    // slower impacts, which need a shorter time step.
    const bool loads = can_stretch<Law> && contact.vn < 0;
    const bool deeper = !loads && pair.deepens(contact.deltan / radius_eff, overlap_limit_);
    pair.at_factor(factor, [&](const auto& law, double range) {
      if (contact.deltan > range * radius_eff)
        check_range(contact, law, range, radius_eff, before, now);
      if (deeper) check_time_step(contact, law, radius_eff);
    });
  }

  // Stops the run in the force loop, because the law does not support two atom types.
  [[gnu::noinline, gnu::cold]] void refuse(const Complaint& complaint) {
    fail(sentence_in_deck(update->unit_style, complaint.worded(property_name)));
  }

 private:
  // Stops the run from one rank, because other ranks compute other contacts.
  void fail(const std::string& reason) { stop_from_rank(lmp, model_ + ": " + reason); }

  // Returns the distance by which the two bodies approach each other in a step [m].
  double approach(const Contact& contact) const { return std::max(0.0, -contact.vn) * update->dt; }

  // Records the recommended time step of an impact that reaches the same overlap as `contact`.
  template <class AnyLaw>
  void check_time_step(const Contact& contact, const AnyLaw& law, double radius_eff) {
    State state;
    const Response loading = law.respond(radius_eff, contact.deltan, state);
    const double energy = contact_energy(loading) - contact_energy(first_touch(law, radius_eff));
    if (!(energy > 0)) return;  // adhesion loads the contact to this overlap without an impact
    const double speed = std::sqrt(2 * energy / contact.meff);
    const double* const x = atom->x[contact.i];
    time_step_check_->add(
        {recommended_timestep_of_load(law, radius_eff, contact.meff, speed, contact.deltan),
         speed,
         {x[0], x[1], x[2]},
         atom->tag[contact.i],
         contact.is_wall ? 0 : atom->tag[contact.j]});
  }

  // Counts a contact that exceeds the validity range. Marks contacts in the first step of a run:
  // their overlap may result from a command instead of motion, because decks can move particles
  // between runs. Two ranks check a contact across their border, and each counts half of it.
  template <class AnyLaw>
  void check_range(const Contact& contact, const AnyLaw& law, double range, double radius_eff,
                   const State& before, const State& now) {
    const bool shared = !contact.is_wall && !force->newton_pair && contact.j >= atom->nlocal;
    excess_->add(law, range,
                 {radius_eff, contact.deltan, approach(contact), before, now,
                  update->ntimestep <= update->firststep + 1, shared ? 0.5 : 1});
  }

  std::string model_;
  double overlap_limit_ = 1;
  RangeCheck::Excess* excess_ = nullptr;
  TimeStepCheck* time_step_check_ = nullptr;
};

}  // namespace plastigran
