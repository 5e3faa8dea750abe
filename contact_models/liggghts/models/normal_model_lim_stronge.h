// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef NORMAL_MODEL
NORMAL_MODEL(LIM_STRONGE, lim_stronge, 42)
#else
#ifndef NORMAL_MODEL_LIM_STRONGE_H
#define NORMAL_MODEL_LIM_STRONGE_H

#include "plastigran/laws/lim_stronge.h"
#include "liggghts/model/elastoplastic_normal_model.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class NormalModel<LIM_STRONGE> : public ElastoplasticNormalModel<plastigran::LimStronge> {
  using ElastoplasticNormalModel::ElastoplasticNormalModel;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
