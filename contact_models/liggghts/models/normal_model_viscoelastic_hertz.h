// SPDX-License-Identifier: GPL-2.0-or-later
#ifdef NORMAL_MODEL
NORMAL_MODEL(VISCOELASTIC_HERTZ, viscoelastic_hertz, 44)
#else
#ifndef NORMAL_MODEL_VISCOELASTIC_HERTZ_H
#define NORMAL_MODEL_VISCOELASTIC_HERTZ_H

#include "plastigran/laws/viscoelastic_hertz.h"
#include "liggghts/model/elastoplastic_normal_model.h"

namespace LIGGGHTS {
namespace ContactModels {

template <>
class NormalModel<VISCOELASTIC_HERTZ>
    : public ElastoplasticNormalModel<plastigran::ViscoelasticHertz> {
  using ElastoplasticNormalModel::ElastoplasticNormalModel;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS

#endif
#endif
