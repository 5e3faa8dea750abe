// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef NORMAL_MODEL
NORMAL_MODEL(YE_KOMVOPOULOS, ye_komvopoulos, 39)
#else
#ifndef NORMAL_MODEL_YE_KOMVOPOULOS_H
#define NORMAL_MODEL_YE_KOMVOPOULOS_H

#include "plastigran/laws/ye_komvopoulos.h"
#include "liggghts/model/elastoplastic_normal_model.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class NormalModel<YE_KOMVOPOULOS> : public ElastoplasticNormalModel<plastigran::YeKomvopoulos> {
  using ElastoplasticNormalModel::ElastoplasticNormalModel;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
