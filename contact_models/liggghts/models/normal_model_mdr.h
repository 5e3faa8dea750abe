// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef NORMAL_MODEL
NORMAL_MODEL(MDR, mdr, 47)
#else
#ifndef NORMAL_MODEL_MDR_H
#define NORMAL_MODEL_MDR_H

#include "plastigran/laws/mdr.h"
#include "liggghts/model/elastoplastic_normal_model.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class NormalModel<MDR> : public ElastoplasticNormalModel<plastigran::Mdr> {
  using ElastoplasticNormalModel::ElastoplasticNormalModel;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
