// SPDX-License-Identifier: GPL-2.0-or-later
//
// Setup of a normal model for any law: reads settings and properties of the deck, checks them, and
// builds the table of type pairs.
//
// History values have the flag "0", because they are scalars, equal for both particles. With the
// flag "1", LIGGGHTS would reverse their sign when it stores the pair for the other particle.
//
// The include guard follows contact_models.h, because that header includes this one.
#include "contact_models.h"
#ifndef PLASTIGRAN_NORMAL_MODEL_SETUP_H
#define PLASTIGRAN_NORMAL_MODEL_SETUP_H

#include <algorithm>
#include <sstream>
#include <string>

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "global_properties.h"
#include "liggghts/fixes/history_keeper.h"
#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/model/contact_owner.h"
#include "liggghts/model/contact_setup.h"
#include "liggghts/model/contact_checks.h"
#include "liggghts/model/deck_properties.h"
#include "liggghts/model/kept_histories.h"
#include "liggghts/model/line_settings.h"
#include "liggghts/model/normal_model_settings.h"
#include "liggghts/model/radius_range.h"
#include "liggghts/model/contact_rates.h"
#include "liggghts/model/type_extremes.h"
#include "neighbor.h"
#include "plastigran/pairs/impact_forecast.h"
#include "plastigran/pairs/type_pairs.h"
#include "plastigran/shared/adhesion.h"
#include "plastigran/shared/contact.h"
#include "update.h"

namespace LIGGGHTS {
namespace ContactModels {

template <class Law>
class NormalModelSetup : public NormalModelBase {
 public:
  NormalModelSetup(LAMMPS* lmp, plastigran::ContactSetup& setup, ContactModelBase* contact_model)
      : NormalModelBase(lmp, &setup, contact_model),
        setup_(setup),
        rates_(lmp, contact_model->is_wall()),
        checks_(lmp),
        owner_(setup.owner(), contact_model->is_wall()),
        restarted_lines_(plastigran::HistoryKeeper::restarted_lines(lmp)) {
    plastigran::refuse_replacement(lmp);
    // Force a setup of the next run, because a new pair_style or wall line needs one even with
    // `run ... pre no`.
    if (!update->whichflag) update->first_update = 0;
    for (std::size_t k = 0; k < Law::state_names.size(); ++k) {
      const int offset = setup.add_history_value(Law::state_names[k], "0");
      if (k == 0) history_offset_ = offset;
    }
    if (plastigran::yields<Law>)
      rates_.begin(setup, DeckProperties(lmp, caller(), atom->ntypes), domain->box_exist);
  }

  void registerSettings(Settings& settings) override { settings_.declare(settings); }

  void postSettings(IContactHistorySetup*, ContactModelBase*) override {
    const std::string complaint = settings_.read();
    if (!complaint.empty()) fail(complaint);
  }

  // Reads the settings from `text`, the settings that another model has read from the line.
  void read(const std::string& text) {
    plastigran::restore_settings(lmp, *this, text, [this] { postSettings(nullptr, nullptr); });
    settings_.set_text(text);
  }

  // LIGGGHTS calls this before every run. Collective.
  void connectToProperties(PropertyRegistry& registry) override {
    refuse_unsuitable();
    HistoryKeeper& keeper = keep_histories();
    const DeckProperties deck(lmp, caller(), registry.max_type());
    deck.check(pairs_.build(deck.materials<Law>(), settings_.choices));
    describe_line(keeper, deck);
    deck.check_friction();
    if (plastigran::yields<Law>) rates_.connect(deck, pairs_.rate_matters());
    checks_.begin(caller(), settings_.overlap_limit);
    prepare_forces(registry);
    if constexpr (plastigran::can_stretch<Law>) extend_contacts();
    report(deck);
    forecast_impacts(deck);
  }

 protected:
  static constexpr bool is_cylinder = plastigran::is_cylinder<Law>;

  plastigran::ContactSetup& setup_;
  plastigran::TypePairs<Law> pairs_;
  plastigran::ContactRates rates_;
  plastigran::NormalModelSettings<Law> settings_;
  plastigran::ContactChecks<Law> checks_;
  int history_offset_ = 0;
  bool smooth_friction_ = false;
  double least_radius_eff_ = 0;  // least R* in the setup; the run stops at contacts with smaller R*
  double** damping_ = nullptr;   // LIGGGHTS' beta(coefficientRestitution) by type pair

 private:
  typedef plastigran::DeckProperties DeckProperties;
  typedef plastigran::HistoryKeeper HistoryKeeper;

  static std::string caller() {
    return std::string("model ") + Law::name + plastigran::line_option<Law>;
  }
  void fail(const std::string& reason) { plastigran::stop(lmp, caller() + ": " + reason); }

  // Stops if the law does not support the particles, the dimension or the other models.
  void refuse_unsuitable() {
#ifdef SUPERQUADRIC_ACTIVE_FLAG
    if (atom->superquadric_flag)
      fail(
          "the law supports only spheres, but the atom style is superquadric. Use `atom_style "
          "granular`");
#endif
    if (is_cylinder && domain->dimension != 2)
      fail(
          "the law is for cylinders, but this deck is 3D. Use `dimension 2`, or a law for spheres");
    const std::string unsuitable =
        owner_.unsuitable_model(Law::name, is_cylinder, plastigran::adhesive<Law>);
    if (!unsuitable.empty()) fail(unsuitable);
  }

  // Adds the fixes that keep histories. If LIGGGHTS made the model from a restart file, restores
  // the settings of the `pair_style` line from this file.
  HistoryKeeper& keep_histories() {
    HistoryKeeper& keeper = plastigran::keep_histories(lmp, owner_, caller(), restarted_lines_,
                                                       {history_offset_, Law::state_names.size()});
    if (settings_.text().empty())
      plastigran::restore_settings(lmp, *this, keeper.restarted_settings(owner_.name()),
                                   [this] { postSettings(nullptr, nullptr); });
    return keeper;
  }

  // Registers the models and constants of the pair_style or wall line with the HistoryKeeper.
  void describe_line(HistoryKeeper& keeper, const DeckProperties& deck) {
    const auto constants = [&](const std::string& name, const char* assumed) {
      return pairs_.describe(name, deck.words(), settings_.choices, assumed);
    };
    plastigran::ContactLine line;
    line.models =
        caller() + owner_.other_models() + plastigran::options_text<Law>(settings_.choices, " ");
    line.settings = settings_.text();
    line.histories = owner_.histories();
    if (!Law::state_names.empty())
      line.constants = constants(caller() + (owner_.is_wall() ? ", wall" : ""), "");
    if (!reported_) line.report = constants(caller(), " (default)");
    keeper.connect(owner_.name(), line);
  }

  void prepare_forces(PropertyRegistry& registry) {
    if (settings_.viscous_damping) {
      registry.registerProperty("betaeff", &MODEL_PARAMS::createBetaEff);
      registry.connect("betaeff", damping_, caller().c_str());
    }
    smooth_friction_ = owner_.has_model("tangential", "no_history");
    // Makes LIGGGHTS call surfacesClose() just outside of contact, which clears the history.
    // Otherwise a pair that separates and touches again before the next neighbor-list build would
    // keep its history.
    neighbor->register_contact_dist_factor(1.01);
  }

  // Makes LIGGGHTS call surfacesClose() up to twice the distance at which adhesion can keep two
  // bodies in contact. A contact then breaks before LIGGGHTS stops calling this function for it.
  void extend_contacts() {
    const plastigran::RadiusRange radii = plastigran::radius_range(lmp);
    const double bodies = owner_.is_wall() ? 1 : 2, smallest = radii.smallest;
    // R* of two equal particles is half their radius. The factor 1 - 1e-9 allows for round-off.
    least_radius_eff_ = smallest / bodies * (1 - 1e-9);
    if (radii.largest == 0) return;
    double share = 0, distance = 0;
    for (int type = 1; type <= pairs_.type_count(); ++type)
      for (int other = 1; other <= pairs_.type_count(); ++other) {
        const auto& pair = pairs_(type, other);
        if (!pair.refusal.empty()) continue;
        const auto pull_off = [&](double radius) {
          return plastigran::pull_off_distance(pair.law, radius / bodies);
        };
        share = std::max(share, pull_off(smallest) / (bodies * smallest));
        distance = std::max(distance, pull_off(radii.largest));
      }
    std::ostringstream text;
    if (share > 0.2)
      text << "adhesion keeps the smallest particles, of radius " << smallest
           << ", in contact up to a separation of " << share << " times their "
           << (owner_.is_wall() ? "radius" : "diameter")
           << "; the limit is 0.2. Reduce surfaceEnergy, or raise youngsModulus";
    else if (owner_.is_wall() && neighbor->skin < distance)
      text << "the neighbor skin is " << neighbor->skin << "; it must be at least " << distance
           << ", the separation at which a contact with the wall breaks. Raise the skin in the "
           << "neighbor command";
    if (!text.str().empty()) fail(text.str());
    neighbor->register_contact_dist_factor(1 + 2 * share);
  }

  // Reports unused properties and doubtful values once, and lines with different normal models.
  void report(const DeckProperties& deck) {
    const plastigran::MixedModels mixed = plastigran::mixed_models(lmp);
    if (comm->me == 0) {
      if (!reported_) report_unused(deck, mixed.has_foreign);
      if (!mixed.text.empty() && mixed.first == owner_.name())
        checks_.warn_once(
            "the pair_style and wall lines have different normal models: " + mixed.text +
            ". Use one model in all lines, unless the difference is intended");
    }
    reported_ = true;
  }

  void report_unused(const DeckProperties& deck, bool has_foreign) {
    plastigran::print(lmp, std::string("plastigran law ") + Law::name + '\n');
    plastigran::print(lmp,
                      settings_.describe_unused(caller(), deck, owner_.is_wall(), has_foreign));
    const bool cohesive = owner_.other_models().find(" cohesion ") != std::string::npos;
    for (const std::string& doubt : deck.doubts(pairs_.bodies(), cohesive))
      checks_.warn_once(doubt);
    if (neighbor->style == 2)  // multi
      checks_.warn_once("LIGGGHTS misses contacts with `neighbor ... multi`. Use `bin`");
  }

  // Stops if the law does not support two atom types that may touch. Finds the fastest impacts.
  void forecast_impacts(const DeckProperties& deck) {
    const int type_count = pairs_.type_count();
    const plastigran::ImpactForecast forecast(
        plastigran::type_extremes(lmp, type_count, owner_.group()),
        owner_.partner_types(type_count), owner_.is_wall(), plastigran::wall_types(modify));
    deck.check(plastigran::refusal(forecast.meetings(), forecast.expected(), pairs_));
    if (comm->me != 0) return;
    const double rayleigh =
        is_cylinder ? plastigran::ImpactTimes::unknown : forecast.rayleigh_time(pairs_.bodies());
    checks_.expect(plastigran::impact_times(forecast.meetings(), pairs_), rayleigh,
                   owner_.is_wall());
  }

  plastigran::ContactOwner owner_;
  const std::string restarted_lines_;  // HistoryKeeper::restarted_lines() at construction
  bool reported_ = false;  // whether an earlier run has printed the constants of this model
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
