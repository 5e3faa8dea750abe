// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef NORMAL_MODEL
NORMAL_MODEL(KOGUT_KOMVOPOULOS, kogut_komvopoulos, 38)
#else
#ifndef NORMAL_MODEL_KOGUT_KOMVOPOULOS_H
#define NORMAL_MODEL_KOGUT_KOMVOPOULOS_H

#include "plastigran/laws/kogut_komvopoulos.h"
#include "liggghts/model/elastoplastic_normal_model.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class NormalModel<KOGUT_KOMVOPOULOS>
    : public ElastoplasticNormalModel<plastigran::KogutKomvopoulos> {
  using ElastoplasticNormalModel::ElastoplasticNormalModel;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
