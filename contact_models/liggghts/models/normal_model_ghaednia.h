// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef NORMAL_MODEL
NORMAL_MODEL(GHAEDNIA, ghaednia, 36)
#else
#ifndef NORMAL_MODEL_GHAEDNIA_H
#define NORMAL_MODEL_GHAEDNIA_H

#include "plastigran/laws/ghaednia.h"
#include "liggghts/model/elastoplastic_normal_model.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class NormalModel<GHAEDNIA> : public ElastoplasticNormalModel<plastigran::Ghaednia> {
  using ElastoplasticNormalModel::ElastoplasticNormalModel;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
