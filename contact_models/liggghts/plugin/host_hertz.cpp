// SPDX-License-Identifier: GPL-2.0-or-later
//
// Registers LIGGGHTS' normal model `hertz` for pair_style and wall lines that combine `hertz` with
// a tangential law.
#include "liggghts/plugin/any_model.h"  // first, because it includes LIGGGHTS without warnings
#include "liggghts/model/host_hertz.h"

#include "liggghts/plugin/registered.h"

namespace plastigran {

using LIGGGHTS::ContactModels::ContactModelBase;

static RegisteredLaw::Model make(LAMMPS_NS::LAMMPS* engine, ContactSetup& setup,
                                 ContactModelBase* contact_model) {
  return std::make_shared<HostHertz>(engine, setup, contact_model);
}

static RegisteredLaw::Model refuse_adhesion(LAMMPS_NS::LAMMPS* engine, ContactSetup&,
                                            ContactModelBase*, const std::string&) {
  stop(engine, "model hertz: adhesion jkr is not available with this model. Use model jkr");
}

extern const RegisteredLaw host_hertz{"hertz", LIGGGHTS::ContactModels::HERTZ, make,
                                      refuse_adhesion};

}  // namespace plastigran
