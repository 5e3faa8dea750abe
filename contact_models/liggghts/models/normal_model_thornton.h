// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef NORMAL_MODEL
NORMAL_MODEL(THORNTON, thornton, 33)
#else
#ifndef NORMAL_MODEL_THORNTON_H
#define NORMAL_MODEL_THORNTON_H

#include "plastigran/laws/thornton.h"
#include "liggghts/model/elastoplastic_normal_model.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class NormalModel<THORNTON> : public ElastoplasticNormalModel<plastigran::Thornton> {
  using ElastoplasticNormalModel::ElastoplasticNormalModel;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
