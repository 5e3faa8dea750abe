// SPDX-License-Identifier: GPL-2.0-or-later
//
// One normal model of the engine that stands for all of ours: it hands every call on to the model
// of the law that the deck names. So each law and each combination with other models is compiled
// once, and not every law in every combination.
#ifdef NORMAL_MODEL
NORMAL_MODEL(ANY_LAW, any_law, 63)
#else
#include "contact_models.h"  // it includes this file: before the guard
#ifndef PLASTIGRAN_ANY_LAW_H
#define PLASTIGRAN_ANY_LAW_H

#include <memory>

#include "fix_mesh_surface.h"  // the engine's tangential models use it without including it

namespace plastigran {

// The model that a contact's setup, a ContactSetup, asks for.
std::shared_ptr<LIGGGHTS::ContactModels::NormalModelBase> make_normal_model(
    LAMMPS_NS::LAMMPS* engine, LIGGGHTS::IContactHistorySetup* setup,
    LIGGGHTS::ContactModels::ContactModelBase* contact_model);

}  // namespace plastigran

namespace LIGGGHTS {
namespace ContactModels {

template <>
class NormalModel<ANY_LAW> : public NormalModelBase {
 public:
  NormalModel(LAMMPS* engine, IContactHistorySetup* setup, ContactModelBase* contact_model)
      : NormalModelBase(engine, setup, contact_model),
        model_(plastigran::make_normal_model(engine, setup, contact_model)) {}

  void registerSettings(Settings& settings) override { model_->registerSettings(settings); }
  void postSettings(IContactHistorySetup* setup, ContactModelBase* contact_model) override {
    model_->postSettings(setup, contact_model);
  }
  void connectToProperties(PropertyRegistry& registry) override {
    model_->connectToProperties(registry);
  }
  double stressStrainExponent() override { return model_->stressStrainExponent(); }
  void surfacesIntersect(SurfacesIntersectData& contact, ForceData& on_i,
                         ForceData& on_j) override {
    model_->surfacesIntersect(contact, on_i, on_j);
  }
  void surfacesClose(SurfacesCloseData& contact, ForceData& on_i, ForceData& on_j) override {
    model_->surfacesClose(contact, on_i, on_j);
  }
  void beginPass(SurfacesIntersectData& contact, ForceData& on_i, ForceData& on_j) override {
    model_->beginPass(contact, on_i, on_j);
  }
  void endPass(SurfacesIntersectData& contact, ForceData& on_i, ForceData& on_j) override {
    model_->endPass(contact, on_i, on_j);
  }

 private:
  std::shared_ptr<NormalModelBase> model_;  // the engine's base has no virtual destructor
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
