// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/companions.h"

#include "contact_models.h"
#include "liggghts/tangential/tangential_model.h"

namespace plastigran {

const std::array<CompanionKind, 4>& companion_kinds() {
  using namespace LIGGGHTS::ContactModels;
  static const std::array<CompanionKind, 4> kinds{{
      {"tangential",
       {
           {"off", TANGENTIAL_OFF},
#define TANGENTIAL_MODEL(identifier, name, id) {#name, id},
#include "style_tangential_model.h"
#undef TANGENTIAL_MODEL
           {Incremental::name, TANGENTIAL_INCREMENTAL},
           {PartialSlip<4>::name, TANGENTIAL_PARTIAL_SLIP},
       }},
      {"cohesion",
       {
           {"off", COHESION_OFF},
#define COHESION_MODEL(identifier, name, id) {#name, id},
#include "style_cohesion_model.h"
#undef COHESION_MODEL
       }},
      {"rolling_friction",
       {
           {"off", ROLLING_OFF},
#define ROLLING_MODEL(identifier, name, id) {#name, id},
#include "style_rolling_model.h"
#undef ROLLING_MODEL
       }},
      {"surface",
       {
#define SURFACE_MODEL(identifier, name, id) {#name, id},
#include "style_surface_model.h"
#undef SURFACE_MODEL
       }},
  }};
  return kinds;
}

bool is_tangential_law(int id) {
  using namespace LIGGGHTS::ContactModels;
  return id == TANGENTIAL_INCREMENTAL || id == TANGENTIAL_PARTIAL_SLIP;
}

bool has_model(std::int64_t hash, const std::string& keyword, const std::string& name) {
  if (keyword == "normal")
    return LIGGGHTS::ContactModels::Factory::instance().getNormalModelId(name) == model_of(hash, 0);
  if (keyword == "adhesion") return name == "jkr" && (hash & with_adhesion);
  if (keyword == "rings")
    return hash_of_rings(rings_of(hash)) && name == std::to_string(rings_of(hash));
  const auto& kinds = companion_kinds();
  for (std::size_t k = 0; k < kinds.size(); ++k)
    for (const Companion& companion : kinds[k].models)
      if (keyword == kinds[k].keyword && name == companion.name)
        return companion.id == model_of(hash, k + 1);
  return false;
}

}  // namespace plastigran
