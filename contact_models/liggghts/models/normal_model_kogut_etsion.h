// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef NORMAL_MODEL
NORMAL_MODEL(KOGUT_ETSION, kogut_etsion, 37)
#else
#ifndef NORMAL_MODEL_KOGUT_ETSION_H
#define NORMAL_MODEL_KOGUT_ETSION_H

#include "plastigran/laws/kogut_etsion.h"
#include "liggghts/model/elastoplastic_normal_model.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class NormalModel<KOGUT_ETSION> : public ElastoplasticNormalModel<plastigran::KogutEtsion> {
  using ElastoplasticNormalModel::ElastoplasticNormalModel;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
