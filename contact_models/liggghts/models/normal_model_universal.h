// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef NORMAL_MODEL
NORMAL_MODEL(UNIVERSAL, universal, 45)
#else
#ifndef NORMAL_MODEL_UNIVERSAL_H
#define NORMAL_MODEL_UNIVERSAL_H

#include "plastigran/laws/universal.h"
#include "liggghts/model/elastoplastic_normal_model.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class NormalModel<UNIVERSAL> : public ElastoplasticNormalModel<plastigran::Universal> {
  using ElastoplasticNormalModel::ElastoplasticNormalModel;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
