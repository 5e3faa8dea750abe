// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef NORMAL_MODEL
NORMAL_MODEL(KATTA_POLYCARPOU, katta_polycarpou, 43)
#else
#ifndef NORMAL_MODEL_KATTA_POLYCARPOU_H
#define NORMAL_MODEL_KATTA_POLYCARPOU_H

#include "plastigran/laws/katta_polycarpou.h"
#include "liggghts/model/elastoplastic_normal_model.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class NormalModel<KATTA_POLYCARPOU> : public ElastoplasticNormalModel<plastigran::KattaPolycarpou> {
  using ElastoplasticNormalModel::ElastoplasticNormalModel;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
