// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/contact_setup.h"

#include "contact_models.h"
#include "liggghts/model/companions.h"

namespace plastigran {

bool ContactSetup::has_model(const std::string& kind, const std::string& name) const {
  if (kind == "normal")
    return LIGGGHTS::ContactModels::Factory::instance().getNormalModelId(name) == model(0);
  const auto& kinds = companion_kinds();
  for (std::size_t k = 0; k < kinds.size(); ++k)
    for (const Companion& companion : kinds[k].models)
      if (kind == kinds[k].keyword && name == companion.name) return companion.id == model(k + 1);
  return false;
}

}  // namespace plastigran
