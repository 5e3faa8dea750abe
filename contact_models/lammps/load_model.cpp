// SPDX-License-Identifier: GPL-2.0-or-later
#include "lammps/load_model.h"

#include "lammps/normal_model.h"

namespace plastigran {

using LAMMPS_NS::Granular_NS::GranularModel;

namespace {

struct Access : GranularModel {
  static constexpr int GranularModel::*heat_defined = &Access::heat_defined;
};

}  // namespace

LoadModel::LoadModel(GranularModel* model, LAMMPS_NS::LAMMPS* lammps, const NormalModel& normal,
                     ContactTally& tally)
    : GranSubModHeat(model, lammps), normal_(normal), tally_(tally) {
  name = "none";
  history_index = 0;
}

void LoadModel::add(GranularModel* model, LAMMPS_NS::LAMMPS* lammps, const NormalModel& normal,
                    ContactTally& tally) {
  auto*& slot = model->sub_models[LAMMPS_NS::Granular_NS::HEAT];
  if (slot->name != "none") {
    tally.lacks_loads = true;
    return;
  }
  delete slot;
  slot = model->heat_model = new LoadModel(model, lammps, normal, tally);
}

void LoadModel::enable(GranularModel* model) {
  if (dynamic_cast<LoadModel*>(model->heat_model)) model->*Access::heat_defined = 1;
}

double LoadModel::calculate_heat() {
  tally_.add_loads(*gm, gm->Fntot - normal_.conservative_force());
  return 0;
}

}  // namespace plastigran
