// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef NORMAL_MODEL
NORMAL_MODEL(BRAKE_2012, brake_2012, 40)
#else
#ifndef NORMAL_MODEL_BRAKE_2012_H
#define NORMAL_MODEL_BRAKE_2012_H

#include "plastigran/laws/brake_2012.h"
#include "liggghts/model/elastoplastic_normal_model.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class NormalModel<BRAKE_2012> : public ElastoplasticNormalModel<plastigran::Brake2012> {
  using ElastoplasticNormalModel::ElastoplasticNormalModel;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
