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
#include <cstddef>
#include <cstring>
#include <sstream>
#include <string>
#include <vector>

#include "atom.h"
#include "contact_models.h"
#include "global_properties.h"
#include "liggghts/fixes/messages.h"
#include "liggghts/model/contact_setup.h"
#include "plastigran/friction/incremental.h"
#include "plastigran/friction/partial_slip.h"
#include "tangential_model_base.h"
#include "update.h"

namespace plastigran {

// Registers values of a law's state in the contact history, from index k of the state on, and
// returns the offset of the first value. When LIGGGHTS stores a pair from the side of the other
// particle, it changes the sign of values with the flag "1".
template <class Law>
int add_values(LIGGGHTS::IContactHistorySetup& setup, std::size_t k,
               const std::vector<std::string>& names) {
  int first = -1;
  for (const std::string& name : names) {
    const int offset = setup.add_history_value(name, Law::changes_sign(k++) ? "1" : "0");
    if (first < 0) first = offset;
  }
  return first;
}

// Registers the state of a tangential law in the contact history.
template <class Law>
struct TangentialHistory;

template <>
struct TangentialHistory<Incremental> {
  static constexpr int values = 7;
  static constexpr bool has_rings = false;
  // Registers the values, and returns the offset of the first one.
  static int add(LIGGGHTS::IContactHistorySetup& setup) {
    return add_values<Incremental>(
        setup, 0,
        {"stick_normalx", "stick_normaly", "stick_normalz", "stick_stiffness", "stick_forcex",
         "stick_forcey", "stick_forcez"});
  }
};

template <>
struct TangentialHistory<PartialSlip<4>> {
  typedef PartialSlip<4> Law;
  static constexpr int values = 19;
  static constexpr bool has_rings = true;
  // Registers the values, and returns the offset of the first one.
  static int add(LIGGGHTS::IContactHistorySetup& setup) {
    const int offset =
        add_values<Law>(setup, 0,
                        {"stick_normalx", "stick_normaly", "stick_normalz", "stick_axisx",
                         "stick_axisy", "stick_axisz", "ring_compliance"});
    add_rings(setup, 1, default_rings);
    return offset;
  }
  // Registers the history values of the rings `first` to `last` of the contact area, and returns
  // the offset of the first value.
  static int add_rings(LIGGGHTS::IContactHistorySetup& setup, int first, int last) {
    int offset = -1;
    for (int k = first; k <= last; ++k) {
      const std::string ring = std::to_string(k);
      const int edge =
          add_values<Law>(setup, Law::state_size(k - 1),
                          {"ring_edge" + ring, "ring_sharex" + ring, "ring_sharey" + ring});
      if (k == first) offset = edge;
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
                "the contact history must have one value for each double in struct State");

 public:
  TangentialLawModel(LAMMPS_NS::LAMMPS* engine, LIGGGHTS::IContactHistorySetup* setup,
                     LIGGGHTS::ContactModels::ContactModelBase* contact_model)
      : TangentialModelBase(engine, setup, contact_model), setup_(ContactSetup::of(setup)) {
    history_offset_ = TangentialHistory<Law>::add(setup_);
    if (setup_.rings() != default_rings)  // after a restart
      setup_.when_constructed.push_back([this] { add_rings(); });
  }

  void registerSettings(Settings& settings) override {
    if constexpr (TangentialHistory<Law>::has_rings)
      settings.registerDoubleSetting("rings", rings_, setup_.rings());
  }

  void postSettings(LIGGGHTS::IContactHistorySetup*,
                    LIGGGHTS::ContactModels::ContactModelBase*) override {
    if (rings_ == setup_.rings()) return;
    if (!(rings_ >= least_rings && rings_ <= most_rings) || rings_ != static_cast<int>(rings_))
      stop(this->lmp, std::string("tangential ") + Law::name + ": rings is " + number_text(rings_) +
                          "; it must be a whole number, " + std::to_string(least_rings) + " to " +
                          std::to_string(most_rings));
    setup_.set_rings(static_cast<int>(rings_));
    add_rings();
  }

  void connectToProperties(PropertyRegistry& registry) override {
    registry.registerProperty("coeffFrict", &MODEL_PARAMS::createCoeffFrict);
    registry.connect("coeffFrict", friction_,
                     (std::string("tangential_model ") + Law::name).c_str());
  }

  // The attribute `flatten` inlines the law. The compiler then omits the computation of its
  // energies if they are not counted.
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
    if (contact.contact_history && extra_rings_offset_ >= 0)
      std::memset(contact.contact_history + extra_rings_offset_, 0, extra_bytes());
  }

  void beginPass(Contact&, Load&, Load&) override {}
  void endPass(Contact&, Load&, Load&) override {}

 private:
  // Adds the history values of the rings beyond the default number.
  void add_rings() {
    if constexpr (TangentialHistory<Law>::has_rings)
      extra_rings_offset_ =
          TangentialHistory<Law>::add_rings(setup_, default_rings + 1, setup_.rings());
  }
  std::size_t extra_bytes() const {
    return 3 * sizeof(double) * static_cast<std::size_t>(setup_.rings() - default_rings);
  }

  static std::string number_text(double number) {
    std::ostringstream text;
    text << number;
    return text.str();
  }

  // Advances the state of a contact whose number of rings is not the default. The history stores
  // the rings beyond the default number in a second part.
  [[gnu::noinline]] TangentialResponse respond_with_rings(double friction, const NormalLoad& load,
                                                          const TangentialMotion& motion,
                                                          double* history, bool writes) const {
    typedef PartialSlip<most_rings> LawOfRings;
    constexpr std::size_t first_part = LawOfRings::state_size(default_rings) * sizeof(double);
    LawOfRings::State state;
    char* const bytes = reinterpret_cast<char*>(&state);
    double* const extra = history + extra_rings_offset_;
    std::memcpy(bytes, history + history_offset_, first_part);
    if (extra_rings_offset_ >= 0) std::memcpy(bytes + first_part, extra, extra_bytes());
    const TangentialResponse response =
        LawOfRings(friction, setup_.rings()).respond(load, motion, state);
    if (writes) {
      std::memcpy(history + history_offset_, bytes, first_part);
      if (extra_rings_offset_ >= 0) std::memcpy(extra, bytes + first_part, extra_bytes());
    }
    return response;
  }

  static Vector3 vector(const double* value) { return {value[0], value[1], value[2]}; }

  static Vector3 velocity(const Contact& contact) {
    return {contact.vtr1, contact.vtr2, contact.vtr3};
  }

  // Adds `value` to `sum`. Reads all three components before writing, so that the compiler can
  // vectorize.
  static void add(const Vector3& value, double* sum) {
    const double x = sum[0] + value.x, y = sum[1] + value.y, z = sum[2] + value.z;
    sum[0] = x, sum[1] = y, sum[2] = z;
  }

  // Advances the state by one step, adds the forces, and returns the stored energy of the law.
  double add_forces(const Contact& contact, Load& on_i, Load& on_j) const {
    const double friction = friction_[contact.itype][contact.jtype];
    // The normal model sets kn such that kn deltan, with the overlap deltan, is the force that
    // limits friction.
    const NormalLoad load{std::max(0.0, contact.kn * contact.deltan), contact.kt};
    TangentialMotion motion;
    motion.normal = vector(contact.en);
    double* const history = contact.contact_history + history_offset_;
    TangentialResponse response;
    const bool advances = contact.computeflag && contact.shearupdate;
    // The setup of a run advances no contact, because no particle has moved since the last step.
    if (advances) {
      const double dt = this->update->dt;
      const Vector3 omega_i = vector(contact.omega_i);
      const Vector3 omega = contact.is_wall ? omega_i : omega_i + vector(contact.omega_j);
      motion.displacement = dt * velocity(contact);
      motion.separation = dt * contact.vn;
      motion.spin = 0.5 * dt * dot(omega, motion.normal);
    }
    if (TangentialHistory<Law>::has_rings && setup_.rings() != default_rings) {
      response = respond_with_rings(friction, load, motion, contact.contact_history, advances);
    } else if (advances) {
      // The history has the layout of the state, as the static_assert above checks.
      response = Law(friction).respond(load, motion, *reinterpret_cast<State*>(history));
    } else {
      State state;
      std::memcpy(static_cast<void*>(&state), history, sizeof(State));
      response = Law(friction).respond(load, motion, state);
    }
    Vector3 force = response.force;
    if (contact.gammat != 0) {
      force = force + contact.gammat * velocity(contact);
      const double square = dot(force, force), limit = friction * load.force;
      if (square > limit * limit) force = limit / std::sqrt(square) * force;
    }
    apply(force, motion.normal, contact, on_i, on_j);
    return response.stored_energy;
  }

  // Adds the force on particle j, and the opposite force on particle i.
  static void apply(const Vector3& force, const Vector3& normal, const Contact& contact, Load& on_i,
                    Load& on_j) {
    const Vector3 turn = cross(normal, force);
    if (contact.is_wall) {
      add(-contact.area_ratio * force, on_i.delta_F);
      add(contact.area_ratio * contact.cri * turn, on_i.delta_torque);
    } else {
      add(-1.0 * force, on_i.delta_F);
      add(contact.cri * turn, on_i.delta_torque);
      add(force, on_j.delta_F);
      add(contact.crj * turn, on_j.delta_torque);
    }
  }

  ContactSetup& setup_;
  double** friction_ = nullptr;  // friction coefficient mu of two atom types
  int history_offset_;
  int extra_rings_offset_ = -1;  // offset of the rings beyond the default number; -1 if none
  double rings_ = default_rings;
};

}  // namespace plastigran

namespace LIGGGHTS {
namespace ContactModels {

// IDs of the tangential laws in LIGGGHTS' hash of a combination of models.
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
