// SPDX-License-Identifier: GPL-2.0-or-later
//
// Looks at contacts as they grow deeper, for a model: is the law still good for the load, is the
// time step short enough for it, has the overlap left all bounds? A contact is looked at only when
// it is a tenth deeper than those of its pair of types were, or beyond a limit.
#pragma once

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string>

#include "atom.h"
#include "contact_interface.h"
#include "error.h"
#include "force.h"
#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/fixes/print.h"
#include "liggghts/fixes/range_check.h"
#include "liggghts/fixes/time_step_check.h"
#include "liggghts/model/deck_properties.h"
#include "liggghts/model/deck_units.h"
#include "plastigran/impact/central_impact.h"
#include "plastigran/pairs/impact_times.h"
#include "plastigran/pairs/type_pair.h"
#include "pointers.h"
#include "update.h"

namespace plastigran {

// What to say of an overlap beyond `overlap_limit`, both in radii of the smaller body.
std::string describe_overlap(const LAMMPS_NS::Atom* atom,
                             const LIGGGHTS::ContactModels::SurfacesIntersectData& contact,
                             double overlap, double overlap_limit);

// What to say of a particle whose centre is about to pass a wall.
std::string describe_passage(const LAMMPS_NS::Atom* atom,
                             const LIGGGHTS::ContactModels::SurfacesIntersectData& contact);

template <class Law>
class ContactChecks : protected LAMMPS_NS::Pointers {
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;
  typedef typename Law::State State;

 public:
  explicit ContactChecks(LAMMPS_NS::LAMMPS* engine) : Pointers(engine) {}

  // Before a run, when the laws were built anew: contacts are looked at again. All ranks together.
  void begin(const std::string& model, double overlap_limit) {
    model_ = model;
    overlap_limit_ = overlap_limit;
    excess_ = RangeCheck::of(lmp, model, Law::range);
    time_step_check_ = ensure_fix<TimeStepCheck>(lmp);
    time_step_check_->forget();
  }

  // Called before a run, on the first rank. Hands the times of the coming impacts to the step
  // watch, which compares the time step with them. Warns of impacts that leave the law's range.
  void expect(const ImpactTimes& times, double rayleigh, bool is_wall) {
    time_step_check_->expect(model_, {times.step, times.step_speed, is_wall}, rayleigh,
                             times.hertz);
    if (times.outside_speed <= 1.01 * excess_->warned_speed) return;
    excess_->warned_speed = times.outside_speed;  // once for all walls, unless it gets worse
    std::ostringstream text;
    text << model_ << ": impacts at the present speeds (at most " << times.outside_speed << ' '
         << unit_in_deck(update->unit_style, "m/s") << ") leave the law's range (" << Law::range
         << ')';
    warn(lmp, text.str());
  }

  // Before a run, on the first rank: a warning that is given once, for all walls together.
  void warn_once(const std::string& text) {
    if (excess_->said.insert(text).second) warn(lmp, model_ + ": " + text);
  }

  // A contact deeper than `pair.checked_from`, at its rate factor, whose state was `before` and is
  // `now` after this step.
  [[gnu::noinline]] void check(const Contact& contact, TypePair<Law>& pair, double factor,
                               double radius_eff, const State& before, const State& now) {
    const double smaller = contact.is_wall ? contact.radi : std::min(contact.radi, contact.radj);
    if (contact.deltan > overlap_limit_ * smaller)
      stop(describe_overlap(atom, contact, contact.deltan / smaller, overlap_limit_));
    if (contact.is_wall && overlap_limit_ <= 1 && contact.deltan + 2 * closing(contact) > smaller)
      stop(describe_passage(atom, contact));
    const bool deeper = pair.deepens(contact.deltan / radius_eff, overlap_limit_);  // R* <= smaller
    pair.at_factor(factor, [&](const auto& law, double range) {
      if (contact.deltan > range * radius_eff)
        note_excess(contact, law, range, radius_eff, before, now);
      if (deeper) note_step(contact, law, radius_eff);
    });
  }

  // Stops in the force loop, at two types for which the law is none.
  [[gnu::noinline, gnu::cold]] void refuse(const Complaint& complaint) {
    stop(sentence_in_deck(update->unit_style, complaint.worded(property_name)));
  }

 private:
  // On this rank alone: the others are not in the force loop at the same contact.
  void stop(const std::string& reason) { error->one(FLERR, (model_ + ": " + reason).c_str()); }

  // How far the two close in on each other in a step [m].
  double closing(const Contact& contact) const { return std::max(0.0, -contact.vn) * update->dt; }

  // The time step for the rebound of an impact that would load as deeply.
  template <class AnyLaw>
  void note_step(const Contact& contact, const AnyLaw& law, double radius_eff) {
    State state;
    const Response virgin = law.respond(radius_eff, contact.deltan, state);
    const double energy = virgin.elastic_energy + virgin.plastic_work;
    const double speed = std::sqrt(2 * energy / contact.meff);
    const double* const x = atom->x[contact.i];
    time_step_check_->met(
        {recommended_timestep_of_load(law, radius_eff, contact.meff, speed, contact.deltan),
         speed,
         {x[0], x[1], x[2]},
         atom->tag[contact.i],
         contact.is_wall ? 0 : atom->tag[contact.j]});
  }

  // Positions move freely between runs: the first step of one looks at all contacts. A contact
  // over a border is seen from both sides.
  template <class AnyLaw>
  void note_excess(const Contact& contact, const AnyLaw& law, double range, double radius_eff,
                   const State& before, const State& now) {
    const bool shared = !contact.is_wall && !force->newton_pair && contact.j >= atom->nlocal;
    excess_->note(law, range,
                  {radius_eff, contact.deltan, closing(contact), before, now,
                   update->ntimestep <= update->firststep + 1, shared ? 0.5 : 1});
  }

  std::string model_;
  double overlap_limit_ = 1;
  RangeCheck::Excess* excess_ = nullptr;
  TimeStepCheck* time_step_check_ = nullptr;
};

}  // namespace plastigran
