// SPDX-License-Identifier: GPL-2.0-or-later
//
// LIGGGHTS' normal model `hertz`, combined with a tangential law of Plastigran. Keeps the contact
// histories of the tangential law, and reports the energies of the normal force.
#pragma once

#include <string>

#include "contact_models.h"
#include "liggghts/fixes/messages.h"
#include "liggghts/model/accounted_load.h"
#include "liggghts/model/contact_owner.h"
#include "liggghts/model/contact_setup.h"
#include "liggghts/model/kept_histories.h"
#include "liggghts/model/line_settings.h"
#include "neighbor.h"
#include "update.h"

namespace plastigran {

class HostHertz : public LIGGGHTS::ContactModels::NormalModel<LIGGGHTS::ContactModels::HERTZ> {
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;
  typedef LIGGGHTS::ContactModels::ForceData Load;

 public:
  HostHertz(LAMMPS_NS::LAMMPS* engine, ContactSetup& setup,
            LIGGGHTS::ContactModels::ContactModelBase* contact_model)
      : NormalModel(engine, &setup, contact_model),
        setup_(setup),
        owner_(setup.owner(), contact_model->is_wall()),
        restarted_lines_(HistoryKeeper::restarted_lines(engine)) {
    // Force a setup of the next run, because a new pair_style or wall line needs one even with
    // `run ... pre no`.
    if (!update->whichflag) update->first_update = 0;
  }

  void registerSettings(Settings& settings) override {
    NormalModel::registerSettings(settings);
    being_read_ = &settings;
  }

  void postSettings(LIGGGHTS::IContactHistorySetup*,
                    LIGGGHTS::ContactModels::ContactModelBase*) override {
    text_ = settings_text(*being_read_);
    for (const auto& [used, name] : {std::pair(elasticpotflag_, "computeElasticPotential"),
                                     std::pair(dissipatedflag_, "computeDissipatedEnergy"),
                                     std::pair(disable_when_bonded_, "disableNormalWhenBonded"),
                                     std::pair(heating, "heating_normal_hertz")})
      if (used)
        stop(lmp, std::string("model hertz: ") + name +
                      " is not supported with a tangential law of this plugin. Remove it, or use "
                      "`tangential history`");
  }

  void connectToProperties(PropertyRegistry& registry) override {
    HistoryKeeper& keeper = keep_histories(lmp, owner_, "model hertz", restarted_lines_, {});
    if (text_.empty())
      restore_settings(lmp, *this, keeper.restarted_settings(owner_.name()),
                       [this] { postSettings(nullptr, nullptr); });
    ContactLine line;
    line.models = "model hertz" + owner_.other_models();
    line.settings = text_;
    line.histories = owner_.histories();
    keeper.connect(owner_.name(), line);
    NormalModel::connectToProperties(registry);
    // Makes LIGGGHTS call surfacesClose() just outside of contact, which clears the history.
    neighbor->register_contact_dist_factor(1.01);
  }

  void surfacesIntersect(Contact& contact, Load& on_i, Load& on_j) override {
    NormalModel::surfacesIntersect(contact, on_i, on_j);
    if (!setup_.counted_load) return;
    // The elastic force kn overlap grows with overlap^(3/2), so its energy is 2/5 force x overlap.
    const double force = contact.kn * contact.deltan;
    setup_.counted_load->elastic_energy = 0.4 * force * contact.deltan;
    setup_.counted_load->dashpot_force = contact.Fn - force;
  }

 private:
  ContactSetup& setup_;
  ContactOwner owner_;
  const std::string restarted_lines_;  // HistoryKeeper::restarted_lines() at construction
  Settings* being_read_ = nullptr;
  std::string text_;  // settings as NAME WORD NAME WORD ...; empty before a line was read
};

}  // namespace plastigran
