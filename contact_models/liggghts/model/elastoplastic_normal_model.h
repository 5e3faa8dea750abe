// SPDX-License-Identifier: GPL-2.0-or-later
//
// A normal contact model of the engine over any law: it keeps the law's state in the engine's
// contact history and hands force and tangential stiffness on.
//
// History values carry the flag "0": they are scalars, the same seen from either particle. ("1"
// would flip their sign whenever the pair is stored from the other side.)
//
// The engine's contact_models.h includes every model, and so this file: it comes before the guard.
#include "contact_models.h"
#ifndef PLASTIGRAN_ELASTOPLASTIC_NORMAL_MODEL_H
#define PLASTIGRAN_ELASTOPLASTIC_NORMAL_MODEL_H

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "global_properties.h"
#include "liggghts/fixes/history_keeper.h"
#include "liggghts/fixes/motion_watch.h"
#include "liggghts/fixes/own_fix.h"
#include "liggghts/fixes/parted_walls.h"
#include "liggghts/fixes/print.h"
#include "liggghts/model/accounted_load.h"
#include "liggghts/model/contact_owner.h"
#include "liggghts/model/contact_setup.h"
#include "liggghts/model/contact_watch.h"
#include "liggghts/model/impact_forecast.h"
#include "liggghts/model/line_settings.h"
#include "liggghts/model/normal_model_settings.h"
#include "liggghts/model/normal_models.h"
#include "liggghts/model/rate_memory.h"
#include "liggghts/model/type_pair.h"
#include "neighbor.h"
#include "plastigran/shared/contact.h"
#include "update.h"

namespace LIGGGHTS {
namespace ContactModels {

template <class Law>
class ElastoplasticNormalModel : public NormalModelBase {
  typedef typename Law::State State;
  typedef plastigran::TypePair<Law> TypePair;
  static constexpr std::size_t state_size = Law::state_names.size() * sizeof(double);
  static_assert(state_size == 0 || state_size == sizeof(State),
                "a law's State is its named doubles and nothing else");
  static constexpr bool is_cylinder = plastigran::is_cylinder<Law>;

 public:
  ElastoplasticNormalModel(LAMMPS* lmp, IContactHistorySetup* setup,
                           ContactModelBase* contact_model)
      : NormalModelBase(lmp, setup, contact_model),
        contact_model_(contact_model),
        owner_(plastigran::ContactSetup::owner_of(setup), contact_model->is_wall()),
        rates_(lmp, contact_model->is_wall()),
        watch_(lmp),
        restarted_lines_(plastigran::HistoryKeeper::restarted_lines(lmp)) {
    plastigran::refuse_replacement(lmp);
    // A new line needs a set-up: `run ... pre no` would not know it.
    if (!update->whichflag) update->first_update = 0;
    for (std::size_t k = 0; k < Law::state_names.size(); ++k) {
      const int offset = setup->add_history_value(Law::state_names[k], "0");
      if (k == 0) history_offset_ = offset;
    }
    if (plastigran::yields<Law>)
      rates_.begin(setup, plastigran::DeckProperties(lmp, caller(), atom->ntypes),
                   domain->box_exist);
  }

  void registerSettings(Settings& settings) override { settings_.declare(settings); }

  void postSettings(IContactHistorySetup*, ContactModelBase*) override {
    const std::string complaint = settings_.read();
    if (!complaint.empty()) fail(complaint);
  }

  // Called by the engine before every run, on all ranks together.
  void connectToProperties(PropertyRegistry& registry) override {
#ifdef SUPERQUADRIC_ACTIVE_FLAG
    if (atom->superquadric_flag) fail("it is for spheres; this atom style is not");
#endif
    if (is_cylinder && domain->dimension != 2)
      fail("it is for cylinders, the discs of a 2D deck (dimension 2); this deck is 3D");
    const std::string unsuitable = owner_.unsuitable_model(is_cylinder);
    if (!unsuitable.empty()) fail(unsuitable);
    const bool is_late =
        owner_.is_wall() && !plastigran::find_own_fix<plastigran::MotionWatch>(lmp);
    const auto motion = plastigran::own_fix<plastigran::MotionWatch>(lmp);
    if (is_late) motion->list_fixes_again();
    if (!owner_.is_wall() && !owner_.histories().empty()) motion->check_periodic_sides(caller());
    const auto parted = plastigran::own_fix<plastigran::PartedWalls>(lmp);
    const auto keeper = plastigran::HistoryKeeper::of(lmp, restarted_lines_);
    const std::string owner = owner_.name();
    parted->set_state(owner, history_offset_, Law::state_names.size());
    if (settings_.text().empty())
      plastigran::restore_settings(lmp, *this, keeper->restarted_settings(owner),
                                   [this] { postSettings(nullptr, nullptr); });
    const std::string options = plastigran::options_text<Law>(settings_.choices, " ");
    const plastigran::DeckProperties deck(lmp, caller(), registry.max_type());
    pairs_.build(deck, registry.max_type(), settings_.choices);
    const std::string constants =
        pairs_.describe(caller() + (owner_.is_wall() ? ", wall" : ""), deck, settings_.choices, "");
    keeper->connect(
        owner, {caller() + owner_.other_models() + options, settings_.text(), owner_.histories(),
                Law::state_names.empty() ? "" : constants, !reported_,
                reported_ ? "" : pairs_.describe(caller(), deck, settings_.choices, " (default)")});
    deck.check_friction();
    if (plastigran::yields<Law>) rates_.connect(deck, pairs_.rate_matters());
    watch_.begin(caller(), settings_.overlap_limit);
    const auto taker = dynamic_cast<plastigran::AccountTaker*>(contact_model_);
    accounts_ = taker && taker->takes_accounts;
    if (settings_.viscous_damping) {
      registry.registerProperty("betaeff", &MODEL_PARAMS::createBetaEff);
      registry.connect("betaeff", damping_, caller().c_str());
    }
    smooth_friction_ = owner_.tangential_model_is("no_history");
    // Ask for surfacesClose() just outside contact, where the history is cleared: otherwise a pair
    // that parts and meets again before the next neighbour build would remember its dent.
    neighbor->register_contact_dist_factor(1.01);
    const plastigran::MixedModels mixed = plastigran::mixed_models(lmp);
    if (!reported_ && comm->me == 0) report_unused(deck, mixed.has_foreign);
    if (comm->me == 0 && !mixed.text.empty() && mixed.first == owner)
      watch_.warn_once("lines have different normal models: " + mixed.text +
                       ". Use one model in all lines, unless this is intended");
    reported_ = true;
    forecast_impacts(deck);
  }

  // Force as a power of overlap while elastic: Hertz, or the nearly straight line contact.
  double stressStrainExponent() override { return is_cylinder ? 1 : 1.5; }

  void surfacesIntersect(SurfacesIntersectData& contact, ForceData& i_forces,
                         ForceData& j_forces) override {
    if (accounts_ && contact.computeflag)
      press<true>(contact, i_forces, j_forces);
    else
      press<false>(contact, i_forces, j_forces);
  }

  void surfacesClose(SurfacesCloseData& contact, ForceData&, ForceData&) override {
    if (contact.contact_flags) *contact.contact_flags &= ~CONTACT_NORMAL_MODEL;
    if (!contact.contact_history) return;
    std::memset(contact.contact_history + history_offset_, 0, state_size);
    rates_.forget(contact.contact_history);
  }

  void beginPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}
  void endPass(SurfacesIntersectData&, ForceData&, ForceData&) override {}

 private:
  static std::string caller() { return std::string("model ") + Law::name; }
  void fail(const std::string& reason) { error->all(FLERR, (caller() + ": " + reason).c_str()); }

  // The attribute `flatten` inlines the law. The compiler then drops its energies where no account
  // is kept.
  template <bool accounts>
  [[gnu::flatten, gnu::noinline]] void press(SurfacesIntersectData& contact, ForceData& i_forces,
                                             ForceData& j_forces) {
    if (contact.contact_flags) *contact.contact_flags |= CONTACT_NORMAL_MODEL;
    const double radius_eff = contact.is_wall
                                  ? contact.radi
                                  : contact.radi * contact.radj / (contact.radi + contact.radj);
    TypePair& at_rest = pairs_(contact.itype, contact.jtype);
    // Particles of these types may have been inserted since the check before the run.
    if (!at_rest.refusal.empty()) watch_.stop(at_rest.refusal);
    // `run 0` computes forces and moves nothing: it leaves the history as it is. Otherwise the
    // set-up writes it too, because its forces move the particles.
    const bool writes = contact.computeflag && (contact.shearupdate || update->nsteps > 0);
    TypePair& pair =
        rates_.kept() ? rates_.strengthened(contact, at_rest, radius_eff, writes) : at_rest;

    double* const history = contact.contact_history + history_offset_;
    State state;
    std::memcpy(static_cast<void*>(&state), history, state_size);
    const plastigran::Response response =
        plastigran::respond(pair.law, radius_eff, contact.deltan, state, -contact.vn);
    if (contact.computeflag) {
      if (contact.deltan > pair.watched * radius_eff)
        note(contact, pair, radius_eff, writes ? state : state_before(contact));
      if (accounts)
        accounted(i_forces).take(pair.law, radius_eff, contact.deltan, state_before(contact),
                                 state);
      if (writes) std::memcpy(history, &state, state_size);
    }

    // A residual dent carries no force and so no friction, but a tangential spring needs a
    // stiffness to be released against: give it the undeformed sphere's.
    const double contact_radius =
        response.force > 0 ? response.contact_radius : std::sqrt(radius_eff * contact.deltan);
    const plastigran::Stiffness elastic = plastigran::elastic_stiffness(
        pair.law, pair.bodies.youngs_modulus_eff, pair.bodies.shear_modulus_eff, contact_radius);
    contact.kt = elastic.tangential;
    contact.kn = contact.deltan > 0 ? response.force / contact.deltan : 0;  // secant
    contact.gamman = 0;
    // Friction without a spring is a viscous force cut at mu F: critical damping of the spring it
    // stands for makes the cut the rule and creep the exception.
    contact.gammat = smooth_friction_ ? 2 * std::sqrt(contact.kt * contact.meff) : 0;
    double force = response.force;
    if (settings_.viscous_damping) {
      // Tsuji, Tanaka & Ishida 1992 (Powder Technol. 71:239) with the law's own contact radius.
      const double beta =
          -1.8257418583505538 * damping_[contact.itype][contact.jtype];  // 2 sqrt(5/6)
      contact.gamman = beta * std::sqrt(elastic.normal * contact.meff);
      if (settings_.tangential_damping && !smooth_friction_)
        contact.gammat = beta * std::sqrt(contact.kt * contact.meff);
      force = std::max(0.0, force - contact.gamman * contact.vn);
    }
    contact.Fn = force;
    if (accounts)
      accounted(i_forces).dashpot_force = force - response.force + response.viscous_force;

    const double applied = contact.is_wall ? force * contact.area_ratio : force;
    for (int axis = 0; axis < 3; ++axis) {
      i_forces.delta_F[axis] += applied * contact.en[axis];
      if (!contact.is_wall) j_forces.delta_F[axis] -= applied * contact.en[axis];
    }
  }

  // The state before this step: the history is written at the end of it.
  State state_before(const SurfacesIntersectData& contact) const {
    State before;
    std::memcpy(static_cast<void*>(&before), contact.contact_history + history_offset_, state_size);
    return before;
  }

  [[gnu::noinline]] void note(const SurfacesIntersectData& contact, TypePair& pair,
                              double radius_eff, const State& now) {
    watch_.note(contact, pair, radius_eff, state_before(contact), now);
  }

  static plastigran::AccountedLoad& accounted(ForceData& load) {
    return static_cast<plastigran::AccountedLoad&>(load);
  }

  // What the deck gives and no model uses, or that looks like a slip.
  void report_unused(const plastigran::DeckProperties& deck, bool has_foreign) {
    plastigran::print(lmp, std::string("plastigran law ") + Law::name + '\n');
    plastigran::print(lmp,
                      settings_.describe_unused(caller(), deck, owner_.is_wall(), has_foreign));
    const bool cohesive = owner_.other_models().find(" cohesion ") != std::string::npos;
    for (const std::string& doubt : deck.doubts(pairs_.bodies(), cohesive)) watch_.warn_once(doubt);
    if (neighbor->style == 2)
      watch_.warn_once("this engine misses contacts with `neighbor multi`; give `bin`");
  }

  void forecast_impacts(const plastigran::DeckProperties& deck) {
    const plastigran::ImpactForecast forecast(lmp, owner_, pairs_.type_count());
    const std::string refusal = plastigran::refusal(forecast, pairs_);
    if (!refusal.empty()) deck.fail(refusal);
    if (comm->me == 0) watch_.expect(plastigran::impact_times(forecast, pairs_));
  }

  ContactModelBase* contact_model_;
  plastigran::ContactOwner owner_;
  plastigran::RateMemory rates_;
  plastigran::NormalModelSettings<Law> settings_;
  plastigran::TypePairs<Law> pairs_;
  plastigran::ContactWatch<Law> watch_;
  const std::string restarted_lines_;  // by HistoryKeeper
  int history_offset_ = 0;
  bool smooth_friction_ = false;
  bool accounts_ = false;       // the loads on particle i are AccountedLoads
  double** damping_ = nullptr;  // the engine's beta(coefficientRestitution) of each type pair
  bool reported_ = false;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
