// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef NORMAL_MODEL
NORMAL_MODEL(STRONGE, stronge, 34)
#else
#ifndef NORMAL_MODEL_STRONGE_H
#define NORMAL_MODEL_STRONGE_H

#include "plastigran/laws/stronge.h"
#include "liggghts/model/elastoplastic_normal_model.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class NormalModel<STRONGE> : public ElastoplasticNormalModel<plastigran::Stronge> {
  using ElastoplasticNormalModel::ElastoplasticNormalModel;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
