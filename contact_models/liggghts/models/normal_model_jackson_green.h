// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef NORMAL_MODEL
NORMAL_MODEL(JACKSON_GREEN, jackson_green, 35)
#else
#ifndef NORMAL_MODEL_JACKSON_GREEN_H
#define NORMAL_MODEL_JACKSON_GREEN_H

#include "plastigran/laws/jackson_green.h"
#include "liggghts/model/elastoplastic_normal_model.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class NormalModel<JACKSON_GREEN> : public ElastoplasticNormalModel<plastigran::JacksonGreen> {
  using ElastoplasticNormalModel::ElastoplasticNormalModel;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
