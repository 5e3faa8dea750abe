// SPDX-License-Identifier: GPL-2.0-or-later
#include "lammps/normal_model.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "atom.h"
#include "lammps/load_model.h"
#include "lammps/tangential_model.h"

namespace plastigran {

using LAMMPS_NS::Granular_NS::GranSubModNormal;
using LAMMPS_NS::Granular_NS::GranularModel;

namespace {

// Returns the Young's modulus E for which LAMMPS' own model has a given effective shear modulus G*.
// LAMMPS then computes the right tangential stiffness. The model has two equal bodies with shear
// modulus G and Poisson's ratio 0: G* = G/4 and E = 2 G, therefore E = 8 G*.
double equivalent_modulus(double shear_modulus_eff) { return 8 * shear_modulus_eff; }

}  // namespace

NormalModel::NormalModel(GranularModel* model, LAMMPS_NS::LAMMPS* lammps, Laws laws,
                         ContactTally& tally)
    : GranSubModNormal(model, lammps), laws_(std::move(laws)), tally_(tally) {
  const RuntimeLaw& one = *laws_.front();  // all laws of a wall are equal except for their bodies
  const GranSubModNormal& placeholder = *model->normal_model;
  name = "hertz/material";
  num_coeffs = 3;
  allocate_coeffs();
  std::copy_n(placeholder.coeffs, num_coeffs, coeffs);
  coeffs[0] = Emod = equivalent_modulus(one.bodies.shear_modulus_eff);
  damp = coeffs[1];
  poiss = coeffs[2];
  material_properties = 1;
  contact_radius_flag = 1;
  cohesive_flag = one.attracts;
  beyond_contact = one.stretches;
  state_at_ = one.stretches ? 1 : 0;
  factor_at_ = state_at_ + one.state_size;
  has_rate_ =
      std::any_of(laws_.begin(), laws_.end(), [](const auto& law) { return law->has_rate(); });
  size_history = static_cast<int>(factor_at_ + (has_rate_ ? 1 : 0));
  history_index = placeholder.history_index;
  nondefault_history_transfer = 1;
  transfer_history_factor = new double[size_history];
  std::fill_n(transfer_history_factor, size_history, 1.0);
}

NormalModel::~NormalModel() {
  delete[] transfer_history_factor;
  transfer_history_factor = nullptr;
}

void NormalModel::replace(GranularModel* model, LAMMPS_NS::LAMMPS* lammps, Laws laws,
                          const TangentialLine& tangential, ContactTally& tally) {
  auto* const normal = new NormalModel(model, lammps, std::move(laws), tally);
  delete model->sub_models[LAMMPS_NS::Granular_NS::NORMAL];
  model->normal_model = normal;
  model->sub_models[LAMMPS_NS::Granular_NS::NORMAL] = normal;
  if (!tangential.law.empty()) TangentialModel::add(model, lammps, *normal, tangential, tally);
  // If the deck gives the tangential stiffness as `NULL`, LAMMPS computes it from the modulus of
  // the normal model.
  model->tangential_model->coeffs_to_local();
  delete[] model->transfer_history_factor;  // init() allocates the factors again
  model->transfer_history_factor = nullptr;
  model->init();
  LoadModel::add(model, lammps, *normal, tally);
}

// Returns the law of the current contact. At a wall, the law depends on the type of the particle,
// whose index follows from the address of its velocity.
const RuntimeLaw& NormalModel::law() const {
  if (laws_.size() == 1) return *laws_.front();
  const auto particle = (gm->vi - atom->v[0]) / 3;
  return *laws_[static_cast<std::size_t>(atom->type[particle]) - 1];
}

// Extends a contact to twice the pull-off distance, so that the law also computes the step in which
// the contact breaks. The energy lost in this step is then counted.
bool NormalModel::touch() {
  double reach = gm->radsum;
  if (gm->touch && beyond_contact) reach += largest_reach(gm->Reff);
  return gm->rsq < reach * reach;
}

double NormalModel::pulloff_distance(double radius, double other_radius) {
  return largest_reach(other_radius > 0 ? radius * other_radius / (radius + other_radius) : radius);
}

// Returns twice the largest pull-off distance of all laws. touch() cannot use law(), because a wall
// calls touch() before it sets the velocity of the particle.
double NormalModel::largest_reach(double radius_eff) const {
  double distance = 0;
  for (const auto& law : laws_) distance = std::max(distance, law->pull_off_distance(radius_eff));
  return 2 * distance;
}

double NormalModel::calculate_contact_radius() {
  const RuntimeLaw& contact_law = law();
  double* const values = gm->history + history_index;
  double* state = values + state_at_;
  double before[RuntimeLaw::capacity], copy[RuntimeLaw::capacity];
  if (!gm->history_update) {
    std::copy_n(state, contact_law.state_size, copy);
    state = copy;
  }
  double factor = 1;
  if (contact_law.has_rate()) {
    factor = values[factor_at_];
    if (factor == 0) factor = contact_law.rate_factor(gm->Reff, -gm->vnnr);
  }
  const double range = factor == 1 ? contact_law.range : contact_law.range_at(factor);
  const bool is_deep = gm->history_update && account_ && gm->delta > range * gm->Reff;
  const bool counts = tally_.counts_energies();
  if (counts || is_deep) std::copy_n(state, contact_law.state_size, before);
  const Response response = counts
                                ? contact_law.respond(gm->Reff, gm->delta, -gm->vnnr, factor, state)
                                : contact_law.forces(gm->Reff, gm->delta, -gm->vnnr, factor, state);
  if (gm->history_update && has_rate_) values[factor_at_] = factor;
  if (counts) {
    double plastic_work = 0, adhesion_loss = 0;
    if (gm->history_update && !std::equal(before, before + contact_law.state_size, state)) {
      plastic_work = response.plastic_work - contact_law.plastic_work(gm->Reff, factor, before);
      if (contact_law.stretches) adhesion_loss = contact_law.lost_at_ends(gm->Reff, before, state);
    }
    tally_.add(*gm, response, plastic_work, adhesion_loss);
  }
  if (is_deep) tally_.add_deep(*gm, contact_law, *account_, factor, before, state);
  force_ = response.force;
  viscous_force_ = response.viscous_force;
  pull_off_force_ =
      contact_law.attracts && response.contact_radius > 0 ? response.pull_off_force : 0;
  // LAMMPS may still list a broken contact, so clear its history here. Do so only when the bodies
  // do not overlap, because flattened bodies can separate at a positive overlap and touch again.
  if (gm->history_update && contact_law.stretches && gm->delta <= 0 &&
      !contact_law.in_contact(state))
    std::fill(state, values + size_history, 0.0);
  return response.contact_radius;
}

// The pull-off force F_c raises the limit of the tangential force T: |T| <= mu (F + F_c), with the
// normal force F and the coefficient of friction mu (Derjaguin 1934).
void NormalModel::set_fncrit() { Fncrit = std::abs(gm->Fntot + pull_off_force_); }

}  // namespace plastigran
