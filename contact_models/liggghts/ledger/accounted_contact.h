// SPDX-License-Identifier: GPL-2.0-or-later
//
// The engine's contact model, which tells the energy ledger and the observers what all models of a
// contact did together; the normal model tells its own part. It has one setting more,
// `energy_ledger on|off`, knows which models its setup asks for, and takes a line's settings from
// restart files.
#pragma once

#include "contact_models.h"
#include "error.h"
#include "liggghts/fixes/history_keeper.h"
#include "liggghts/fixes/own_fix.h"
#include "liggghts/ledger/cohesive_energy.h"
#include "liggghts/ledger/energy_ledger.h"
#include "liggghts/model/accounted_load.h"
#include "liggghts/model/contact_owner.h"
#include "liggghts/model/contact_setup.h"
#include "liggghts/model/line_settings.h"
#include "liggghts/observers/contact_observer.h"

namespace plastigran {

// The setup comes first: models ask it, and register their history values, as they are made.
template <class Style>
class AccountedContact : private ContactSetup,
                         public LIGGGHTS::ContactModels::ContactModel<Style>,
                         public AccountTaker {
  typedef LIGGGHTS::ContactModels::ContactModel<Style> Base;
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;
  typedef LIGGGHTS::ContactModels::ForceData Load;

 public:
  // Whether two bodies may act on each other without having touched.
  static constexpr bool acts_at_a_distance =
      Style::COHESION != LIGGGHTS::ContactModels::COHESION_OFF;

  template <class Owner>
  AccountedContact(LAMMPS_NS::LAMMPS* engine, Owner* owner, bool is_wall, int64_t hash)
      : ContactSetup(owner, hash),
        Base(engine, static_cast<ContactSetup*>(this), is_wall, hash),
        engine_(engine),
        owner_(owner),
        spring_offset_(has_model("tangential", "history") ? offset_of("shearx") : -1) {}

  // The engine asks which models these are: those of the setup's hash.
  int64_t hashcode() { return hash(); }
  bool contact_match(const std::string& kind, const std::string& name) {
    return has_model(kind, name);
  }

  // Where a value stands in a contact's history, -1 when no model has it.
  int get_history_offset(const std::string& name) {
    const int offset = offset_of(name);
    return offset < 0 ? Base::get_history_offset(name) : offset;
  }

  void registerSettings(Settings& settings) {
    line_read_ = true;
    Base::registerSettings(settings);
    settings.registerOnOff("energy_ledger", asked_, false);
  }

  void postSettings(LIGGGHTS::IContactHistorySetup* owner) {
    if (this->is_wall()) refuse_replacement(engine_);
    Base::postSettings(owner);
    // Not for a wall: its fix is only being made, and the engine adds one fix at a time.
    if (asked_ && !this->is_wall()) EnergyLedger::open(engine_);
  }

  void connectToProperties(PropertyRegistry& registry) {
    if (!line_read_) restore_line();
    ledger_ = find_own_fix<EnergyLedger>(engine_);
    const char* const complaint = EnergyLedger::complaint(ledger_, asked_, this->is_wall());
    if (complaint) engine_->error->all(FLERR, complaint);
    if (!asked_) ledger_ = nullptr;
    if (ledger_) refuse_what_is_not_counted("energy_ledger on");
    if (ledger_) ledger_->attach(owner_);
    observers_ = ContactObserver::attach(engine_, owner_);
    for (const ContactObserver* const observer : observers_)
      refuse_what_is_not_counted(std::string("fix ") + observer->id + ' ' + observer->style);
    takes_accounts = ledger_ || !observers_.empty();
    Base::connectToProperties(registry);
  }

  // As the engine's loops call it: with a load that has no room for an account.
  void surfacesIntersect(Contact& contact, Load& on_i, Load& on_j) {
    if (takes_accounts && contact.computeflag) {
      on_i = accounted(contact, on_i, on_j);
    } else {
      compute(contact, on_i, on_j);
    }
  }

  // The models' forces alone.
  void compute(Contact& contact, Load& on_i, Load& on_j) {
    Base::surfacesIntersect(contact, on_i, on_j);
  }

  // The forces, told to the ledger and the observers.
  void account(Contact& contact, AccountedLoad& on_i, Load& on_j) {
    compute(contact, on_i, on_j);
    if (ledger_) ledger_->add(contact, on_i, on_j);
    // The next set-up reports again what `run 0` would.
    if (!contact.shearupdate && engine_->update->nsteps == 0) return;
    for (ContactObserver* const observer : observers_) observer->add(contact, on_i, on_j, owner_);
  }

  // What the contact stores, told to the ledger. Some models write to its history meanwhile.
  void count_stored(Contact& contact, AccountedLoad& on_i, Load& on_j) {
    compute(contact, on_i, on_j);
    add_stored(contact, on_i);
  }

  // The forces at hand are computed, and their loads did not ask for elastic energies: `contacts`
  // can say what they store.
  void defer_stored_energies(StoredEnergies& contacts) {
    if (ledger_) ledger_->defer(contacts);
  }

 private:
  // From a restart file.
  void restore_line() {
    LIGGGHTS::IContactHistorySetup* const owner = owner_of(this);
    const std::string name = ContactOwner(owner, this->is_wall()).name();
    restore_settings(engine_, *this, own_fix<HistoryKeeper>(engine_)->restarted_settings(name),
                     [&] { postSettings(owner); });
  }

  void refuse_what_is_not_counted(const std::string& counter) {
    const char* const reason =
        !CohesiveEnergy::is_known(model(2))
            ? ": it does not count what liquid between particles stores and dissipates; leave it "
              "off, or use cohesion sjkr, sjkr2 or off"
        : !has_model("surface", "default")
            ? ": it does not count what contacts of a particle store by pressing on each other; "
              "leave it off, or use surface default"
            : nullptr;
    if (reason) engine_->error->all(FLERR, (counter + reason).c_str());
  }

  // All at once: the forces, and what the contact stores.
  [[gnu::noinline]] AccountedLoad accounted(Contact& contact, const Load& before, Load& on_j) {
    AccountedLoad on_i(before);
    on_i.asks_elastic_energy = ledger_ != nullptr;
    account(contact, on_i, on_j);
    if (ledger_) add_stored(contact, on_i);
    return on_i;
  }

  void add_stored(const Contact& contact, const AccountedLoad& on_i) {
    ledger_->add_stored(contact, on_i.elastic_energy, spring_energy(contact));
  }

  double spring_energy(const Contact& contact) const {
    if (spring_offset_ < 0) return 0;
    const double* const spring = contact.contact_history + spring_offset_;
    return 0.5 * contact.kt *
           (spring[0] * spring[0] + spring[1] * spring[1] + spring[2] * spring[2]);
  }

  LAMMPS_NS::LAMMPS* engine_;
  const void* owner_;  // the PairGran or FixWallGran
  EnergyLedger* ledger_ = nullptr;
  std::vector<ContactObserver*> observers_;
  int spring_offset_;  // of the tangential model's three values, -1 when it has no spring
  bool asked_ = false;
  bool line_read_ = false;
};

}  // namespace plastigran
