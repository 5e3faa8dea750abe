// SPDX-License-Identifier: GPL-2.0-or-later
//
// Tangential contact model of LIGGGHTS for any tangential law (plastigran/friction/). Stores the
// state of the law in the contact history.
//
// A tangential dashpot is added to the force of the law. The sum is limited to mu times the
// limiting force of the normal model: the normal force without its dashpot, plus the pull-off
// force.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstring>
#include <string>

#include "atom.h"
#include "contact_models.h"
#include "global_properties.h"
#include "liggghts/model/contact_setup.h"
#include "plastigran/friction/incremental.h"
#include "plastigran/friction/partial_slip.h"
#include "tangential_model_base.h"
#include "update.h"

namespace plastigran {

// Add a number or a vector of the state to the contact history, and return its offset. LIGGGHTS
// changes the sign of a value with the flag "1" when it stores a pair from the side of the other
// particle.
inline int add_number(LIGGGHTS::IContactHistorySetup& setup, const std::string& name) {
  return setup.add_history_value(name, "0");
}
inline int add_vector(LIGGGHTS::IContactHistorySetup& setup, const std::string& name) {
  const int offset = setup.add_history_value(name + 'x', "1");
  setup.add_history_value(name + 'y', "1");
  setup.add_history_value(name + 'z', "1");
  return offset;
}

// State values of a law in the contact history.
template <class Law>
struct TangentialHistory;

template <>
struct TangentialHistory<Incremental> {
  static constexpr int values = 7;
  // Returns the offset of the first value.
  static int add(LIGGGHTS::IContactHistorySetup& setup) {
    const int offset = add_vector(setup, "stick_normal");
    add_number(setup, "stick_stiffness");
    add_vector(setup, "stick_force");
    return offset;
  }
};

template <>
struct TangentialHistory<PartialSlip<4>> {
  static constexpr int values = 19;
  // Returns the offset of the first value.
  static int add(LIGGGHTS::IContactHistorySetup& setup) {
    const int offset = add_vector(setup, "stick_normal");
    add_vector(setup, "stick_axis");
    add_number(setup, "ring_compliance");
    for (const char* const ring : {"1", "2", "3", "4"}) {
      add_number(setup, std::string("ring_edge") + ring);
      // Seen from the other particle, the normal and the x axis of the contact change their sign,
      // so the y axis remains. A share that changes its sign has the same x and the opposite y.
      add_number(setup, std::string("ring_sharex") + ring);
      setup.add_history_value(std::string("ring_sharey") + ring, "1");
    }
    return offset;
  }
};

template <class Law>
class TangentialLawModel : public LIGGGHTS::ContactModels::TangentialModelBase {
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;
  typedef LIGGGHTS::ContactModels::SurfacesCloseData CloseContact;
  typedef LIGGGHTS::ContactModels::ForceData Load;
  typedef typename Law::State State;
  static_assert(sizeof(State) == TangentialHistory<Law>::values * sizeof(double),
                "the contact history must have one value per number of the state");

 public:
  TangentialLawModel(LAMMPS_NS::LAMMPS* engine, LIGGGHTS::IContactHistorySetup* setup,
                     LIGGGHTS::ContactModels::ContactModelBase* contact_model)
      : TangentialModelBase(engine, setup, contact_model), setup_(ContactSetup::of(setup)) {
    history_offset_ = TangentialHistory<Law>::add(setup_);
  }

  void registerSettings(Settings&) override {}
  void postSettings(LIGGGHTS::IContactHistorySetup*,
                    LIGGGHTS::ContactModels::ContactModelBase*) override {}

  void connectToProperties(PropertyRegistry& registry) override {
    registry.registerProperty("coeffFrict", &MODEL_PARAMS::createCoeffFrict);
    registry.connect("coeffFrict", friction_,
                     (std::string("tangential_model ") + Law::name).c_str());
  }

  // The attribute `flatten` inlines the law. The compiler then removes its energies if they are not
  // counted.
  [[gnu::flatten]] void surfacesIntersect(const Contact& contact, Load& on_i, Load& on_j) override {
    if (contact.contact_flags)
      *contact.contact_flags |= LIGGGHTS::ContactModels::CONTACT_TANGENTIAL_MODEL;
    if (setup_.counted_load)
      setup_.counted_load->tangential_energy = add_forces(contact, on_i, on_j);
    else
      add_forces(contact, on_i, on_j);
  }

  void surfacesClose(CloseContact& contact, Load&, Load&) override {
    if (contact.contact_flags)
      *contact.contact_flags &= ~LIGGGHTS::ContactModels::CONTACT_TANGENTIAL_MODEL;
    if (contact.contact_history)
      std::memset(contact.contact_history + history_offset_, 0, sizeof(State));
  }

  void beginPass(Contact&, Load&, Load&) override {}
  void endPass(Contact&, Load&, Load&) override {}

 private:
  static Vector3 vector(const double* value) { return {value[0], value[1], value[2]}; }

  static void add(const Vector3& value, double* sum) {
    sum[0] += value.x;
    sum[1] += value.y;
    sum[2] += value.z;
  }

  // Advances the state by one step, adds the forces, and returns the stored energy of the law.
  double add_forces(const Contact& contact, Load& on_i, Load& on_j) const {
    const double friction = friction_[contact.itype][contact.jtype];
    const NormalLoad load{std::max(0.0, contact.kn * contact.deltan), contact.kt};
    const Vector3 velocity{contact.vtr1, contact.vtr2, contact.vtr3};
    TangentialMotion motion;
    motion.normal = vector(contact.en);
    double* const history = contact.contact_history + history_offset_;
    TangentialResponse response;
    // The setup of a run advances no contact, because no particle has moved since the last step.
    if (contact.computeflag && contact.shearupdate) {
      const double dt = this->update->dt;
      const Vector3 omega_i = vector(contact.omega_i);
      const Vector3 omega = contact.is_wall ? omega_i : omega_i + vector(contact.omega_j);
      motion.displacement = dt * velocity;
      motion.separation = dt * contact.vn;
      motion.spin = 0.5 * dt * dot(omega, motion.normal);
      // The history has the layout of the state (see the assertion above).
      response = Law(friction).respond(load, motion, *reinterpret_cast<State*>(history));
    } else {
      State state;
      std::memcpy(static_cast<void*>(&state), history, sizeof(State));
      response = Law(friction).respond(load, motion, state);
    }
    Vector3 force = -1.0 * response.force;
    if (contact.gammat != 0) {
      force = force - contact.gammat * velocity;
      const double square = dot(force, force), limit = friction * load.force;
      if (square > limit * limit) force = limit / std::sqrt(square) * force;
    }
    apply(force, motion.normal, contact, on_i, on_j);
    return response.stored_energy;
  }

  // Adds the force on particle i, and the opposite force on particle j.
  static void apply(const Vector3& force, const Vector3& normal, const Contact& contact, Load& on_i,
                    Load& on_j) {
    const Vector3 turn = cross(normal, force);
    if (contact.is_wall) {
      add(contact.area_ratio * force, on_i.delta_F);
      add(-contact.area_ratio * contact.cri * turn, on_i.delta_torque);
    } else {
      add(force, on_i.delta_F);
      add(-contact.cri * turn, on_i.delta_torque);
      add(-1.0 * force, on_j.delta_F);
      add(-contact.crj * turn, on_j.delta_torque);
    }
  }

  ContactSetup& setup_;
  double** friction_ = nullptr;  // mu of two particle types
  int history_offset_;
};

}  // namespace plastigran

namespace LIGGGHTS {
namespace ContactModels {

// IDs in LIGGGHTS' hash of a combination.
constexpr int TANGENTIAL_INCREMENTAL = 40, TANGENTIAL_PARTIAL_SLIP = 41;

template <>
class TangentialModel<TANGENTIAL_INCREMENTAL>
    : public plastigran::TangentialLawModel<plastigran::Incremental> {
  using TangentialLawModel::TangentialLawModel;
};

template <>
class TangentialModel<TANGENTIAL_PARTIAL_SLIP>
    : public plastigran::TangentialLawModel<plastigran::PartialSlip<4>> {
  using TangentialLawModel::TangentialLawModel;
};

}  // namespace ContactModels
}  // namespace LIGGGHTS
