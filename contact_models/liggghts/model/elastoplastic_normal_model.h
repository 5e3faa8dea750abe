// SPDX-License-Identifier: GPL-2.0-or-later
//
// Normal contact model of LIGGGHTS for any law. Stores the state of the law in the contact history,
// and sets the normal force and the tangential stiffness.
//
// The include guard follows contact_models.h, because that header includes this one.
#include "contact_models.h"
#ifndef PLASTIGRAN_ELASTOPLASTIC_NORMAL_MODEL_H
#define PLASTIGRAN_ELASTOPLASTIC_NORMAL_MODEL_H

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>
#include <type_traits>

#include "liggghts/model/accounted_load.h"
#include "liggghts/model/normal_model_setup.h"
#include "plastigran/pairs/type_pair.h"
#include "plastigran/shared/adhesion.h"
#include "plastigran/shared/contact.h"
#include "update.h"

namespace LIGGGHTS {
namespace ContactModels {

template <class Law>
class ElastoplasticNormalModel : public NormalModelSetup<Law> {
  typedef NormalModelSetup<Law> Setup;
  typedef typename Law::State State;
  typedef plastigran::TypePair<Law> TypePair;
  static constexpr std::size_t state_size = Law::state_names.size() * sizeof(double);
  static_assert(state_size == 0 || state_size == sizeof(State),
                "struct State of a law must contain exactly the doubles in state_names");

  using Setup::checks_, Setup::damping_, Setup::history_offset_, Setup::pairs_, Setup::rates_,
      Setup::least_radius_eff_, Setup::settings_, Setup::setup_, Setup::smooth_friction_,
      Setup::update;

 public:
  using Setup::Setup;

  // Returns the exponent of the overlap in the elastic force: 1.5 for spheres (Hertz), 1 for the
  // nearly linear line contact of cylinders.
  double stressStrainExponent() override { return Setup::is_cylinder ? 1 : 1.5; }

  void surfacesIntersect(SurfacesIntersectData& contact, ForceData& i_forces,
                         ForceData& j_forces) override {
    if (plastigran::AccountedLoad* const load = setup_.counted_load)
      apply_force(contact, *load, j_forces);
    else
      apply_force(contact, i_forces, j_forces);
  }

  void surfacesClose(SurfacesCloseData& contact, ForceData&, ForceData&) override {
    if (contact.contact_flags) *contact.contact_flags &= ~CONTACT_NORMAL_MODEL;
    if (!contact.contact_history) return;
    std::memset(contact.contact_history + history_offset_, 0, state_size);
    rates_.clear(contact.contact_history);
  }

  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}

 private:
  // The attribute `flatten` inlines the law. The compiler then omits the computation of its
  // energies if the load does not count them.
  template <class Load>
  [[gnu::flatten, gnu::noinline]] void apply_force(SurfacesIntersectData& contact, Load& i_forces,
                                                   ForceData& j_forces) {
    constexpr bool counts_energies = std::is_same_v<Load, plastigran::AccountedLoad>;
    if (contact.contact_flags) *contact.contact_flags |= CONTACT_NORMAL_MODEL;
    const double radius_eff = contact.is_wall
                                  ? contact.radi
                                  : contact.radi * contact.radj / (contact.radi + contact.radj);
    TypePair& pair = pairs_(contact.itype, contact.jtype);
    // Check again whether the law supports both atom types, because particles of these types may
    // have been inserted during the run.
    if (!pair.refusal.empty()) checks_.refuse(pair.refusal);
    if constexpr (plastigran::can_stretch<Law>)
      if (radius_eff < least_radius_eff_) checks_.refuse(too_small(contact));
    // Do not write the history in `run 0`, which moves no particle. Any other run writes the
    // history in its setup too, because the forces of the setup move the particles.
    const bool writes = contact.computeflag && (contact.shearupdate || update->nsteps > 0);
    const double factor =
        rates_.stored() ? rates_.factor(contact, pair.bodies, radius_eff, writes) : 1;

    double* const history = contact.contact_history + history_offset_;
    State state;
    std::memcpy(static_cast<void*>(&state), history, state_size);
    const plastigran::Response response =
        factor == 1 ? plastigran::respond(pair.law, radius_eff, contact.deltan, state, -contact.vn)
                    : respond_at_factor(pair, factor, radius_eff, contact.deltan, state);
    if (contact.computeflag) {
      if (contact.deltan > pair.checked_from * radius_eff)
        check(contact, pair, factor, radius_eff, writes ? state : state_before(contact));
      if constexpr (counts_energies)
        count_energies(pair, factor, radius_eff, contact, state, i_forces);
      if (writes) std::memcpy(history, &state, state_size);
    }

    // Below the residual overlap there is no force and no friction. A tangential spring still needs
    // a stiffness while it relaxes: use the stiffness of the undeformed sphere.
    const bool carries =
        plastigran::adhesive<Law> ? response.contact_radius > 0 : response.force > 0;
    const double contact_radius =
        carries ? response.contact_radius : std::sqrt(radius_eff * std::abs(contact.deltan));
    const plastigran::Stiffness elastic = plastigran::elastic_stiffness(
        pair.law, pair.bodies.youngs_modulus_eff, pair.bodies.shear_modulus_eff, contact_radius);
    contact.kt = elastic.tangential;
    // LIGGGHTS limits friction to mu kn deltan, where deltan is the overlap. Therefore kn is set to
    // a secant stiffness: a force divided by the overlap. With adhesion, this force is `limiting`,
    // the normal force plus the pull-off force.
    const double limiting =
        response.force +
        plastigran::pull_off_force(pair.law, radius_eff, contact.deltan, state, response);
    if constexpr (plastigran::adhesive<Law>)
      contact.kn = contact.deltan != 0 && carries ? limiting / contact.deltan : 0;
    else
      contact.kn = contact.deltan > 0 ? response.force / contact.deltan : 0;
    contact.gamman = 0;
    // `tangential no_history` is a viscous force limited to mu F. With critical damping of the
    // equivalent spring, contacts usually reach this limit and hardly creep.
    contact.gammat = smooth_friction_ ? 2 * std::sqrt(contact.kt * contact.meff) : 0;
    double force = response.force;
    if (settings_.viscous_damping) {
      // Normal dashpot after Tsuji, Tanaka & Ishida 1992 (Powder Technol. 71:239), with the contact
      // radius of the law.
      const double beta =
          -1.8257418583505538 * damping_[contact.itype][contact.jtype];  // 2 sqrt(5/6)
      if (carries || !plastigran::adhesive<Law>)
        contact.gamman = beta * std::sqrt(elastic.normal * contact.meff);
      if (settings_.tangential_damping && !smooth_friction_)
        contact.gammat = beta * std::sqrt(contact.kt * contact.meff);
      force -= contact.gamman * contact.vn;
      if (!plastigran::adhesive<Law>) force = std::max(0.0, force);
    }
    contact.Fn = plastigran::adhesive<Law> ? (carries ? std::max(0.0, limiting) : 0) : force;
    if constexpr (counts_energies)
      i_forces.dashpot_force = force - response.force + response.viscous_force;

    const double applied = contact.is_wall ? force * contact.area_ratio : force;
    for (int axis = 0; axis < 3; ++axis) {
      i_forces.delta_F[axis] += applied * contact.en[axis];
      if (!contact.is_wall) j_forces.delta_F[axis] -= applied * contact.en[axis];
    }
  }

  [[gnu::noinline]] static plastigran::Complaint too_small(const SurfacesIntersectData& contact) {
    return plastigran::Complaint(
        "a particle of radius " +
        std::to_string(contact.is_wall ? contact.radi : std::min(contact.radi, contact.radj)) +
        " is smaller than all particles at the start of the run, for which the range of adhesion "
        "was computed. After you create smaller particles, give `run 0`");
  }

  // Returns the state before this step. The history contains this state until the end of the step.
  State state_before(const SurfacesIntersectData& contact) const {
    State before;
    std::memcpy(static_cast<void*>(&before), contact.contact_history + history_offset_, state_size);
    return before;
  }

  [[gnu::noinline]] void check(const SurfacesIntersectData& contact, TypePair& pair, double factor,
                               double radius_eff, const State& now) {
    checks_.check(contact, pair, factor, radius_eff, state_before(contact), now);
  }

  // Returns the response of the law at a rate factor above 1.
  [[gnu::flatten, gnu::noinline]] static plastigran::Response respond_at_factor(
      const TypePair& pair, double factor, double radius_eff, double overlap, State& state) {
    return pair.at_factor(factor, [&](const auto& law, double) {
      return plastigran::respond(law, radius_eff, overlap, state, 0);
    });
  }

  void count_energies(const TypePair& pair, double factor, double radius_eff,
                      const SurfacesIntersectData& contact, const State& now,
                      plastigran::AccountedLoad& load) const {
    const State before = state_before(contact);
    if (factor == 1)
      load.count(pair.law, radius_eff, contact.deltan, before, now);
    else
      count_at_factor(pair, factor, radius_eff, contact.deltan, before, now, load);
  }

  // Adds the energies of the law at a rate factor above 1 to the load.
  [[gnu::flatten, gnu::noinline]] static void count_at_factor(const TypePair& pair, double factor,
                                                              double radius_eff, double overlap,
                                                              const State& before, const State& now,
                                                              plastigran::AccountedLoad& load) {
    pair.at_factor(factor, [&](const auto& law, double) {
      load.count(law, radius_eff, overlap, before, now);
    });
  }
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
