// SPDX-License-Identifier: GPL-2.0-or-later
//
// The engine's models beside the normal one, each compiled here once.
#include "liggghts/plugin/any_model.h"

namespace plastigran {

using namespace LIGGGHTS;
using namespace LIGGGHTS::ContactModels;

namespace {

int asked(IContactHistorySetup* setup, std::size_t place) {
  return static_cast<ContactSetup*>(setup)->model(place);
}

}  // namespace

template <>
std::shared_ptr<TangentialModelBase> make_model(LAMMPS_NS::LAMMPS* engine,
                                                IContactHistorySetup* setup,
                                                ContactModelBase* contact_model) {
#define TANGENTIAL_MODEL(identifier, name, id) \
  if (asked(setup, 1) == id)                   \
    return std::make_shared<TangentialModel<identifier>>(engine, setup, contact_model);
#include "style_tangential_model.h"
#undef TANGENTIAL_MODEL
  return std::make_shared<TangentialModel<TANGENTIAL_OFF>>(engine, setup, contact_model);
}

template <>
std::shared_ptr<CohesionModelBase> make_model(LAMMPS_NS::LAMMPS* engine,
                                              IContactHistorySetup* setup,
                                              ContactModelBase* contact_model) {
#define COHESION_MODEL(identifier, name, id) \
  if (asked(setup, 2) == id)                 \
    return std::make_shared<CohesionModel<identifier>>(engine, setup, contact_model);
#include "style_cohesion_model.h"
#undef COHESION_MODEL
  return std::make_shared<CohesionModel<COHESION_OFF>>(engine, setup, contact_model);
}

template <>
std::shared_ptr<RollingModelBase> make_model(LAMMPS_NS::LAMMPS* engine, IContactHistorySetup* setup,
                                             ContactModelBase* contact_model) {
#define ROLLING_MODEL(identifier, name, id) \
  if (asked(setup, 3) == id)                \
    return std::make_shared<RollingModel<identifier>>(engine, setup, contact_model);
#include "style_rolling_model.h"
#undef ROLLING_MODEL
  return std::make_shared<RollingModel<ROLLING_OFF>>(engine, setup, contact_model);
}

}  // namespace plastigran
