// SPDX-License-Identifier: GPL-2.0-or-later
//
// Instantiates LIGGGHTS' tangential, cohesion and rolling models, so that each is compiled once.
#include "liggghts/plugin/any_model.h"
#include "liggghts/tangential/tangential_model.h"

namespace plastigran {

using namespace LIGGGHTS::ContactModels;

#define MODEL(kind, place, identifier, id) \
  if (setup.model(place) == id)            \
    return std::make_shared<kind<identifier>>(engine, &setup, contact_model);
#define TANGENTIAL_MODEL(identifier, name, id) MODEL(TangentialModel, 1, identifier, id)
#define COHESION_MODEL(identifier, name, id) MODEL(CohesionModel, 2, identifier, id)
#define ROLLING_MODEL(identifier, name, id) MODEL(RollingModel, 3, identifier, id)

template <>
std::shared_ptr<TangentialModelBase> make_model(LAMMPS_NS::LAMMPS* engine, ContactSetup& setup,
                                                ContactModelBase* contact_model) {
#include "style_tangential_model.h"
  MODEL(TangentialModel, 1, TANGENTIAL_INCREMENTAL, TANGENTIAL_INCREMENTAL)
  MODEL(TangentialModel, 1, TANGENTIAL_PARTIAL_SLIP, TANGENTIAL_PARTIAL_SLIP)
  return std::make_shared<TangentialModel<TANGENTIAL_OFF>>(engine, &setup, contact_model);
}

template <>
std::shared_ptr<CohesionModelBase> make_model(LAMMPS_NS::LAMMPS* engine, ContactSetup& setup,
                                              ContactModelBase* contact_model) {
#include "style_cohesion_model.h"
  return std::make_shared<CohesionModel<COHESION_OFF>>(engine, &setup, contact_model);
}

template <>
std::shared_ptr<RollingModelBase> make_model(LAMMPS_NS::LAMMPS* engine, ContactSetup& setup,
                                             ContactModelBase* contact_model) {
#include "style_rolling_model.h"
  return std::make_shared<RollingModel<ROLLING_OFF>>(engine, &setup, contact_model);
}

}  // namespace plastigran
