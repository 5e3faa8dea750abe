// SPDX-License-Identifier: GPL-2.0-or-later
//
// The engine's contact model with one setting more, `energy_ledger on|off`: the place where the
// forces of all models of a contact are known together. The normal model reports its own part.
#ifndef PLASTIGRAN_ACCOUNTED_CONTACT_H
#define PLASTIGRAN_ACCOUNTED_CONTACT_H

#include "contact_models.h"
#include "energy_ledger.h"
#include "fix_wall_gran.h"
#include "pair_gran.h"

namespace plastigran {

template <class Style>
class AccountedContact : public LIGGGHTS::ContactModels::ContactModel<Style>, public LedgerUser {
  typedef LIGGGHTS::ContactModels::ContactModel<Style> Base;
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;
  typedef LIGGGHTS::ContactModels::ForceData Load;

  static constexpr bool has_springs =
      Style::TANGENTIAL == LIGGGHTS::ContactModels::TANGENTIAL_HISTORY;
  static constexpr int rolling_values =
      Style::ROLLING == LIGGGHTS::ContactModels::ROLLING_EPSD2 ? 3 : 0;

 public:
  template <class Owner>
  AccountedContact(LAMMPS_NS::LAMMPS* engine, Owner* owner, bool is_wall, int64_t hash)
      : Base(engine, owner, is_wall, hash),
        engine_(engine),
        owner_(owner),
        // Models add their history values in a fixed order, rolling last, tangential before it.
        spring_offset_(history_values(owner) - rolling_values - 3) {}

  void registerSettings(Settings& settings) {
    Base::registerSettings(settings);
    settings.registerOnOff("energy_ledger", asked_, false);
  }

  void postSettings(LIGGGHTS::IContactHistorySetup* owner) {
    Base::postSettings(owner);
    // Not for a wall: its fix is only being made, and the engine adds one fix at a time.
    if (asked_ && !this->is_wall()) EnergyLedger::open(engine_);
  }

  void connectToProperties(PropertyRegistry& registry) {
    ledger = asked_ ? find_own_fix<EnergyLedger>(engine_) : nullptr;
    if (asked_ && !ledger)
      engine_->error->all(FLERR, "energy_ledger on: the pair_style line must have it too");
    if (ledger) ledger->attach(owner_);
    Base::connectToProperties(registry);
  }

  void surfacesIntersect(Contact& contact, Load& on_i, Load& on_j) {
    Base::surfacesIntersect(contact, on_i, on_j);
    if (ledger && contact.computeflag)
      ledger->add_forces(contact, on_i, on_j, spring_energy(contact));
  }

 private:
  static int history_values(LAMMPS_NS::PairGran* pair) { return pair->dnum_pair(); }
  static int history_values(LAMMPS_NS::FixWallGran* wall) { return wall->dnum(); }

  double spring_energy(const Contact& contact) const {
    if (!has_springs) return 0;
    const double* const spring = contact.contact_history + spring_offset_;
    return 0.5 * contact.kt *
           (spring[0] * spring[0] + spring[1] * spring[1] + spring[2] * spring[2]);
  }

  LAMMPS_NS::LAMMPS* engine_;
  const void* owner_;  // the PairGran or FixWallGran
  int spring_offset_;
  bool asked_ = false;
};

}  // namespace plastigran

#endif
