// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef NORMAL_MODEL
NORMAL_MODEL(BRAKE_2015, brake_2015, 41)
#else
#ifndef NORMAL_MODEL_BRAKE_2015_H
#define NORMAL_MODEL_BRAKE_2015_H

#include "plastigran/laws/brake_2015.h"
#include "liggghts/model/elastoplastic_normal_model.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class NormalModel<BRAKE_2015> : public ElastoplasticNormalModel<plastigran::Brake2015> {
  using ElastoplasticNormalModel::ElastoplasticNormalModel;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
