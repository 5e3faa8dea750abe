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

// ID of a law in LIGGGHTS' hash of a combination, and the state values that follow the normal
// vector.
template <class Law>
struct TangentialHistory;

template <>
struct TangentialHistory<Incremental> {
  static constexpr int id = 40, values = 4;
  static void add(LIGGGHTS::IContactHistorySetup& setup) {
    add_number(setup, "stick_stiffness");
    add_vector(setup, "stick_force");
  }
};

template <>
struct TangentialHistory<PartialSlip<4>> {
  static constexpr int id = 41, values = 17;
  static void add(LIGGGHTS::IContactHistorySetup& setup) {
    add_number(setup, "ring_compliance");
    for (const char* const ring : {"1", "2", "3", "4"}) {
      add_number(setup, std::string("ring_edge") + ring);
      add_vector(setup, std::string("ring_share") + ring);
    }
  }
};

template <class Law>
class TangentialLawModel : public LIGGGHTS::ContactModels::TangentialModelBase {
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;
  typedef LIGGGHTS::ContactModels::SurfacesCloseData CloseContact;
  typedef LIGGGHTS::ContactModels::ForceData Load;
  typedef typename Law::State State;
  static_assert(sizeof(State) == (3 + TangentialHistory<Law>::values) * sizeof(double),
                "the contact history must have one value per number of the state");

 public:
  TangentialLawModel(LAMMPS_NS::LAMMPS* engine, ContactSetup& setup,
                     LIGGGHTS::ContactModels::ContactModelBase* contact_model)
      : TangentialModelBase(engine, &setup, contact_model), setup_(setup) {
    history_offset_ = add_vector(setup, "stick_normal");
    TangentialHistory<Law>::add(setup);
  }

  void registerSettings(Settings&) override {}
  void postSettings(LIGGGHTS::IContactHistorySetup*,
                    LIGGGHTS::ContactModels::ContactModelBase*) override {}

  void connectToProperties(PropertyRegistry& registry) override {
    registry.registerProperty("coeffFrict", &MODEL_PARAMS::createCoeffFrict);
    registry.connect("coeffFrict", friction_,
                     (std::string("tangential_model ") + Law::name).c_str());
  }

  void surfacesIntersect(const Contact& contact, Load& on_i, Load& on_j) override {
    if (contact.contact_flags)
      *contact.contact_flags |= LIGGGHTS::ContactModels::CONTACT_TANGENTIAL_MODEL;
    const double friction = friction_[contact.itype][contact.jtype];
    // The setup of a run advances no contact, because no particle has moved since the last step.
    const bool advances = contact.computeflag && contact.shearupdate;
    const Vector3 normal = vector(contact.en);
    const Vector3 velocity{contact.vtr1, contact.vtr2, contact.vtr3};
    TangentialMotion motion;
    motion.normal = normal;
    if (advances) {
      const double dt = this->update->dt;
      const double spin_j = contact.is_wall ? 0 : dot(vector(contact.omega_j), normal);
      motion.displacement = dt * velocity;
      motion.spin = 0.5 * dt * (dot(vector(contact.omega_i), normal) + spin_j);
    }
    const NormalLoad load{std::max(0.0, contact.kn * contact.deltan), contact.kt};

    double* const history = contact.contact_history + history_offset_;
    State state;
    std::memcpy(static_cast<void*>(&state), history, sizeof(State));
    const TangentialResponse response = Law(friction).respond(load, motion, state);
    if (advances) std::memcpy(history, &state, sizeof(State));
    if (setup_.counted_load) setup_.counted_load->tangential_energy = response.stored_energy;

    Vector3 force = response.force + contact.gammat * velocity;
    const double size = length(force), limit = friction * load.force;
    if (size > limit) force = limit / size * force;
    apply(-1.0 * force, normal, contact, on_i, on_j);
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

  // Adds the force on particle i, and the opposite force on particle j.
  static void apply(const Vector3& force, const Vector3& normal, const Contact& contact, Load& on_i,
                    Load& on_j) {
    const Vector3 turn = cross(normal, force);
    const double share = contact.is_wall ? contact.area_ratio : 1;
    add(share * force, on_i.delta_F);
    add(-share * contact.cri * turn, on_i.delta_torque);
    if (contact.is_wall) return;
    add(-1.0 * force, on_j.delta_F);
    add(-contact.crj * turn, on_j.delta_torque);
  }

  ContactSetup& setup_;
  double** friction_ = nullptr;  // mu of two particle types
  int history_offset_;
};

}  // namespace plastigran
