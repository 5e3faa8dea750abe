// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef NORMAL_MODEL
NORMAL_MODEL(GHAEDNIA_2019, ghaednia_2019, 46)
#else
#ifndef NORMAL_MODEL_GHAEDNIA_2019_H
#define NORMAL_MODEL_GHAEDNIA_2019_H

#include "plastigran/laws/ghaednia_2019.h"
#include "liggghts/model/elastoplastic_normal_model.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class NormalModel<GHAEDNIA_2019> : public ElastoplasticNormalModel<plastigran::Ghaednia2019> {
  using ElastoplasticNormalModel::ElastoplasticNormalModel;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
