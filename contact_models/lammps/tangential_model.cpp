// SPDX-License-Identifier: GPL-2.0-or-later
#include "lammps/tangential_model.h"

#include <algorithm>
#include <cstring>

#include "lammps/normal_model.h"
#include "plastigran/friction/incremental.h"
#include "plastigran/friction/partial_slip.h"

namespace plastigran {

using LAMMPS_NS::Granular_NS::GranularModel;

namespace {

Vector3 vector(const double* values) { return {values[0], values[1], values[2]}; }

template <class Law>
class TangentialModelOf : public TangentialModel {
  typedef typename Law::State State;

 public:
  TangentialModelOf(GranularModel* model, LAMMPS_NS::LAMMPS* lammps, const NormalModel& normal,
                    const TangentialLine& line, ContactTally& tally)
      : TangentialModel(model, lammps, normal, Law::state_size(line.rings), Law::changes_sign,
                        tally),
        law_(line.friction, line.rings) {}

  void calculate_forces() override {
    // The setup of a run advances no contact, because no particle has moved since the last step.
    TangentialMotion motion;
    motion.normal = vector(gm->nx);
    if (gm->history_update) {
      const bool is_pair = gm->contact_type == LAMMPS_NS::Granular_NS::PAIR;
      const double spin_j = is_pair ? dot(vector(gm->omegaj), motion.normal) : 0;
      motion.displacement = gm->dt * vector(gm->vtr);
      motion.separation = gm->dt * gm->vnnr;
      motion.spin = 0.5 * gm->dt * (dot(vector(gm->omegai), motion.normal) + spin_j);
    }
    const NormalLoad load{std::max(0.0, normal_.limiting_force()), normal_.tangential_stiffness()};
    const std::size_t bytes = static_cast<std::size_t>(size_history) * sizeof(double);
    double* const values = gm->history + history_index;
    State state;
    std::memcpy(static_cast<void*>(&state), values, bytes);
    const TangentialResponse response = law_.respond(load, motion, state);
    if (gm->history_update) std::memcpy(values, static_cast<const void*>(&state), bytes);
    gm->fs[0] = -response.force.x;
    gm->fs[1] = -response.force.y;
    gm->fs[2] = -response.force.z;
    tally_.add_spring(*gm, response.stored_energy);
  }

 private:
  Law law_;
};

}  // namespace

TangentialModel::TangentialModel(GranularModel* model, LAMMPS_NS::LAMMPS* lammps,
                                 const NormalModel& normal, std::size_t values,
                                 bool (*changes_sign)(std::size_t), ContactTally& tally)
    : GranSubModTangential(model, lammps), normal_(normal), tally_(tally) {
  const auto& placeholder = *model->tangential_model;
  name = placeholder.name;
  num_coeffs = placeholder.num_coeffs;
  allocate_coeffs();
  std::copy_n(placeholder.coeffs, num_coeffs, coeffs);
  contact_radius_flag = 1;
  size_history = static_cast<int>(values);
  history_index = placeholder.history_index;
  // LAMMPS multiplies the values by these factors when it stores the history with the other
  // particle of the pair.
  nondefault_history_transfer = 1;
  transfer_history_factor = new double[values];
  for (std::size_t k = 0; k < values; ++k) transfer_history_factor[k] = changes_sign(k) ? -1 : 1;
}

TangentialModel::~TangentialModel() {
  delete[] transfer_history_factor;
  transfer_history_factor = nullptr;
}

void TangentialModel::add(GranularModel* model, LAMMPS_NS::LAMMPS* lammps,
                          const NormalModel& normal, const TangentialLine& line,
                          ContactTally& tally) {
  TangentialModel* made = nullptr;
  if (line.law == Incremental::name)
    made = new TangentialModelOf<Incremental>(model, lammps, normal, line, tally);
  else
    made = new TangentialModelOf<PartialSlip<>>(model, lammps, normal, line, tally);
  delete model->sub_models[LAMMPS_NS::Granular_NS::TANGENTIAL];
  model->sub_models[LAMMPS_NS::Granular_NS::TANGENTIAL] = model->tangential_model = made;
}

}  // namespace plastigran
