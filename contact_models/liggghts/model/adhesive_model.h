// SPDX-License-Identifier: GPL-2.0-or-later
//
// Normal model of a law with the option `adhesion jkr` (plastigran/tables/adhesive.h).
#pragma once

#include <memory>
#include <string>

#include "liggghts/fixes/messages.h"
#include "liggghts/model/elastoplastic_normal_model.h"
#include "plastigran/pairs/type_pairs.h"
#include "plastigran/tables/adhesive.h"

namespace plastigran {

// Creates the model. `settings` are the settings of the pair_style or wall line, as text from
// settings_text(); empty for a model that LIGGGHTS makes from a restart file.
template <class Law>
std::shared_ptr<LIGGGHTS::ContactModels::NormalModelBase> make_adhesive_model(
    LAMMPS_NS::LAMMPS* engine, ContactSetup& setup,
    LIGGGHTS::ContactModels::ContactModelBase* contact_model, const std::string& settings) {
  if constexpr (takes_adhesion<Law>) {
    using Model = LIGGGHTS::ContactModels::ElastoplasticNormalModel<Adhesive<Law>>;
    const auto model = std::make_shared<Model>(engine, setup, contact_model);
    if (!settings.empty()) model->read(settings);
    return model;
  } else {
    stop(engine,
         std::string("model ") + Law::name + ": adhesion jkr is not supported, because " +
             refusal_of_adhesion<Law>() +
             ". Remove the option, or use a law for spheres that begins with Hertz' contact");
  }
}

}  // namespace plastigran
