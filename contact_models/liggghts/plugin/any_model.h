// SPDX-License-Identifier: GPL-2.0-or-later
//
// One forwarding contact model for each kind (normal, tangential, cohesion, rolling). It passes
// every call to the model that the deck names. Therefore each law and each other model is compiled
// once, instead of every law in every combination.
#pragma once

#include <memory>

#include "liggghts/fixes/engine_access.h"
#include "liggghts/ledger/cohesive_energy.h"
#include "liggghts/model/contact_setup.h"
#include "liggghts/model/line_settings.h"
#include "liggghts/plugin/engine_styles.h"

namespace plastigran {

// Creates the model of the kind `Base` that the deck names.
template <class Base>
std::shared_ptr<Base> make_model(LAMMPS_NS::LAMMPS* engine, ContactSetup& setup,
                                 LIGGGHTS::ContactModels::ContactModelBase* contact_model);

// Creates the law that the setup names, with the option `adhesion jkr`.
std::shared_ptr<LIGGGHTS::ContactModels::NormalModelBase> make_adhesive_model(
    LAMMPS_NS::LAMMPS* engine, ContactSetup& setup,
    LIGGGHTS::ContactModels::ContactModelBase* contact_model, const std::string& settings);

template <class Base>
class AnyModel : public Base {
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;
  typedef LIGGGHTS::ContactModels::SurfacesCloseData CloseContact;
  typedef LIGGGHTS::ContactModels::ForceData Load;

 public:
  AnyModel(LAMMPS_NS::LAMMPS* engine, LIGGGHTS::IContactHistorySetup* setup,
           LIGGGHTS::ContactModels::ContactModelBase* contact_model)
      : Base(engine, setup, contact_model),
        setup_(ContactSetup::of(setup)),
        model_(make_model<Base>(engine, setup_, contact_model)) {}

  void registerSettings(Settings& settings) override { model_->registerSettings(settings); }
  void postSettings(LIGGGHTS::IContactHistorySetup* setup,
                    LIGGGHTS::ContactModels::ContactModelBase* contact_model) override {
    model_->postSettings(setup, contact_model);
  }
  void connectToProperties(PropertyRegistry& registry) override {
    model_->connectToProperties(registry);
  }
  void surfacesClose(CloseContact& contact, Load& on_i, Load& on_j) override {
    model_->surfacesClose(contact, on_i, on_j);
  }
  void beginPass(Contact& contact, Load& on_i, Load& on_j) override {
    model_->beginPass(contact, on_i, on_j);
  }
  void endPass(Contact& contact, Load& on_i, Load& on_j) override {
    model_->endPass(contact, on_i, on_j);
  }

 protected:
  ContactSetup& setup_;
  // A shared_ptr, which calls the destructor of the model's own class, because LIGGGHTS' base
  // classes have no virtual destructor.
  std::shared_ptr<Base> model_;
};

}  // namespace plastigran

namespace LIGGGHTS {
namespace ContactModels {

constexpr int ANY = 63;  // an ID that no model of LIGGGHTS has

template <>
class NormalModel<ANY> : public plastigran::AnyModel<NormalModelBase> {
 public:
  NormalModel(LAMMPS* engine, IContactHistorySetup* setup, ContactModelBase* contact_model)
      : AnyModel(engine, setup, contact_model), engine_(engine), contact_model_(contact_model) {
    if (setup_.has_adhesion()) setup_.when_constructed.push_back([this] { add_adhesion(""); });
    // LIGGGHTS' tangential and rolling models `luding` read the adhesion of its normal model
    // `luding` from the history. The laws have no such value; a history value that stays zero
    // replaces it.
    if (setup_.model(1) != TANGENTIAL_LUDING && setup_.model(3) != ROLLING_LUDING) return;
    const int no_adhesion = setup->add_history_value("no_adhesion", "0");
    for (const char* name : {"kc_offset", "fo_offset"})
      contact_model->add_history_offset(name, no_adhesion);
  }

  void registerSettings(Settings& settings) override {
    model_->registerSettings(settings);
    static const char* const words[] = {"off", "jkr"};
    adhesion_ = setup_.has_adhesion();
    plastigran::add_choice(settings, "adhesion", words, 2, adhesion_);
    being_read_ = &settings;
  }
  void postSettings(IContactHistorySetup* setup, ContactModelBase* contact_model) override {
    if (adhesion_ && !setup_.has_adhesion())
      add_adhesion(plastigran::settings_text(*being_read_));
    else
      model_->postSettings(setup, contact_model);
  }

  double stressStrainExponent() override { return model_->stressStrainExponent(); }
  void surfacesIntersect(SurfacesIntersectData& contact, ForceData& on_i,
                         ForceData& on_j) override {
    model_->surfacesIntersect(contact, on_i, on_j);
  }

 private:
  // Replaces the law by the law with adhesion. The contact history contains the values of both
  // models, so that its layout is the same for a line of a deck and for a restart file.
  void add_adhesion(const std::string& settings) {
    setup_.add_adhesion();
    model_.reset();
    model_ = plastigran::make_adhesive_model(engine_, setup_, contact_model_, settings);
  }

  LAMMPS* engine_;
  ContactModelBase* contact_model_;
  Settings* being_read_ = nullptr;
  int adhesion_ = 0;
};

template <>
class TangentialModel<ANY> : public plastigran::AnyModel<TangentialModelBase> {
 public:
  using AnyModel::AnyModel;

  void surfacesIntersect(const SurfacesIntersectData& contact, ForceData& on_i,
                         ForceData& on_j) override {
    model_->surfacesIntersect(contact, on_i, on_j);
  }
};

template <>
class CohesionModel<ANY> : public plastigran::AnyModel<CohesionModelBase> {
 public:
  using AnyModel::AnyModel;

  void surfacesIntersect(SurfacesIntersectData& contact, ForceData& on_i,
                         ForceData& on_j) override {
    if (setup_.counted_load)
      count_energy(contact, on_i, on_j);
    else
      model_->surfacesIntersect(contact, on_i, on_j);
  }

  void endSurfacesIntersect(SurfacesIntersectData& contact, ForceData& on_i,
                            ForceData& on_j) override {
    model_->endSurfacesIntersect(contact, on_i, on_j);
  }

 private:
  [[gnu::noinline]] void count_energy(SurfacesIntersectData& contact, ForceData& on_i,
                                      ForceData& on_j) {
    const ForceData before = on_i;
    model_->surfacesIntersect(contact, on_i, on_j);
    double pull = 0;
    for (int axis = 0; axis < 3; ++axis)
      pull += (on_i.delta_F[axis] - before.delta_F[axis]) * contact.en[axis];
    setup_.counted_load->elastic_energy +=
        plastigran::CohesiveEnergy(setup_.model(2)).of(contact, pull);
  }
};

template <>
class RollingModel<ANY> : public plastigran::AnyModel<RollingModelBase> {
 public:
  using AnyModel::AnyModel;

  void surfacesIntersect(SurfacesIntersectData& contact, ForceData& on_i,
                         ForceData& on_j) override {
    model_->surfacesIntersect(contact, on_i, on_j);
  }
};

}  // namespace ContactModels
}  // namespace LIGGGHTS
