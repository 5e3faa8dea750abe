// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef NORMAL_MODEL
NORMAL_MODEL(VU_QUOC_ZHANG, vu_quoc_zhang, 32)
#else
#ifndef NORMAL_MODEL_VU_QUOC_ZHANG_H
#define NORMAL_MODEL_VU_QUOC_ZHANG_H

#include "plastigran/laws/vu_quoc_zhang.h"
#include "liggghts/model/elastoplastic_normal_model.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class NormalModel<VU_QUOC_ZHANG> : public ElastoplasticNormalModel<plastigran::VuQuocZhang> {
  using ElastoplasticNormalModel::ElastoplasticNormalModel;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
