// SPDX-License-Identifier: GPL-2.0-or-later
//
// LIGGGHTS' contact model with three additions: it reports every contact to the energy ledger and
// the observers, adds the setting `energy_ledger on|off`, and restores the settings of its
// pair_style or wall line from a restart file.
#pragma once

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "atom.h"
#include "contact_models.h"
#include "liggghts/fixes/history_keeper.h"
#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/ledger/cohesive_energy.h"
#include "liggghts/ledger/energy_ledger.h"
#include "liggghts/model/accounted_load.h"
#include "liggghts/model/contact_owner.h"
#include "liggghts/model/contact_setup.h"
#include "liggghts/model/line_settings.h"
#include "liggghts/observers/contact_observer.h"
#include "pair_gran.h"

namespace plastigran {

// ContactSetup is the first base class, because the contact models use it during their
// construction.
template <class Style>
class AccountedContact : private ContactSetup, public LIGGGHTS::ContactModels::ContactModel<Style> {
  typedef LIGGGHTS::ContactModels::ContactModel<Style> Base;
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;
  typedef LIGGGHTS::ContactModels::ForceData Load;

 public:
  // Whether two bodies may exert forces on each other before they touch.
  static constexpr bool acts_at_a_distance =
      Style::COHESION != LIGGGHTS::ContactModels::COHESION_OFF;

  template <class Owner>
  AccountedContact(LAMMPS_NS::LAMMPS* engine, Owner* owner, bool is_wall, int64_t hash)
      : ContactSetup(owner, hash),
        Base(engine, static_cast<ContactSetup*>(this), is_wall, hash),
        engine_(engine),
        owner_(owner),
        spring_offset_(has_model("tangential", "history") ? offset_of("shearx") : -1) {
    for (const auto& action : when_constructed) action();
    if constexpr (std::is_same_v<Owner, LAMMPS_NS::PairGran>) pair_ = owner;
  }

  // Returns the hash of the models in the deck. The base class is compiled with the placeholder ANY
  // (any_model.h) for some models, so its hash does not identify them.
  int64_t hashcode() { return hash(); }
  bool contact_match(const std::string& kind, const std::string& name) {
    return has_model(kind, name);
  }

  // Returns the offset of a history value, or -1 if no model has registered it.
  int get_history_offset(const std::string& name) {
    const int offset = offset_of(name);
    return offset < 0 ? Base::get_history_offset(name) : offset;
  }

  void registerSettings(Settings& settings) {
    line_read_ = true;
    Base::registerSettings(settings);
    settings.registerOnOff("energy_ledger", requests_ledger_, false);
  }

  void postSettings(LIGGGHTS::IContactHistorySetup* owner) {
    if (this->is_wall()) refuse_replacement(engine_);
    Base::postSettings(owner);
    // Only a pair style adds the energy ledger, because LIGGGHTS cannot add a fix while it creates
    // a wall.
    if (requests_ledger_ && !this->is_wall()) EnergyLedger::open(engine_);
  }

  void connectToProperties(PropertyRegistry& registry) {
    if (!line_read_) restore_line();
    in_contact_offset_ = offset_of("in_contact");
    ledger_ = find_fix<EnergyLedger>(engine_);
    const char* const complaint =
        EnergyLedger::complaint(ledger_, requests_ledger_, this->is_wall());
    if (complaint) stop(engine_, complaint);
    if (!requests_ledger_) ledger_ = nullptr;
    if (ledger_) refuse_uncounted("energy_ledger on");
    if (ledger_) ledger_->attach(owner_);
    observers_ = ContactObserver::attach(engine_, owner_);
    for (const ContactObserver* const observer : observers_)
      refuse_uncounted(std::string("fix ") + observer->id + ' ' + observer->style);
    Base::connectToProperties(registry);
  }

  // Returns whether the energy ledger or an observer needs the energies of these contacts.
  bool counts_energies() const { return ledger_ || !observers_.empty(); }

  // Computes the forces of an overlapping pair. LIGGGHTS' loops call this function with loads that
  // do not store energies.
  void surfacesIntersect(Contact& contact, Load& on_i, Load& on_j) {
    if (counts_energies() && contact.computeflag)
      on_i = counted(contact, on_i, on_j);
    else
      compute(contact, on_i, on_j);
  }

  // Returns whether adhesion keeps two bodies in contact, even if they do not overlap.
  bool in_contact(const LIGGGHTS::ContactModels::SurfacesCloseData& contact) const {
    return in_contact_offset_ >= 0 && contact.contact_history &&
           contact.contact_history[in_contact_offset_] != 0;
  }

  // Computes the forces of a close pair without overlap, for LIGGGHTS' loops.
  void surfacesClose(LIGGGHTS::ContactModels::SurfacesCloseData& close, Load& on_i, Load& on_j) {
    // The cast is safe, because all callers pass a SurfacesIntersectData.
    Contact& contact = static_cast<Contact&>(close);
    if (in_contact(contact)) {
      if (!this->is_wall()) complete(contact);
      surfacesIntersect(contact, on_i, on_j);
      contact.has_force_update = true;
    }
    if (!in_contact(contact)) Base::surfacesClose(contact, on_i, on_j);
    // Do not leave the overlap negative, because LIGGGHTS next computes the heat flux from the wall
    // with this overlap.
    if (this->is_wall()) contact.deltan = std::max(0.0, contact.deltan);
  }

  // Computes the forces of all contact models without energies.
  void compute(Contact& contact, Load& on_i, Load& on_j) {
    Base::surfacesIntersect(contact, on_i, on_j);
  }

  // Computes the forces and energies, and reports them to the energy ledger and the observers.
  void compute_and_count(Contact& contact, AccountedLoad& on_i, Load& on_j) {
    compute_with_energies(contact, on_i, on_j);
    if (ledger_) ledger_->add(contact, on_i, on_j);
    // Do not report the contacts of `run 0` to the observers: this run does not advance the
    // contacts, so the next setup reports the same energies again.
    if (!contact.shearupdate && engine_->update->nsteps == 0) return;
    for (ContactObserver* const observer : observers_) observer->add(contact, on_i, on_j, owner_);
  }

  // Reports the stored energies to the energy ledger. The caller passes a copy of the contact
  // history, because some models write to it in this call.
  void count_stored(Contact& contact, AccountedLoad& on_i, Load& on_j) {
    compute_with_energies(contact, on_i, on_j);
    add_stored(contact, on_i);
  }

  // Registers `contacts` with the energy ledger, which computes the stored energies when it needs
  // them.
  void defer_stored_energies(StoredEnergies& contacts) {
    if (ledger_) ledger_->defer(contacts);
  }

 private:
  void compute_with_energies(Contact& contact, AccountedLoad& on_i, Load& on_j) {
    counted_load = &on_i;
    compute(contact, on_i, on_j);
    counted_load = nullptr;
  }

  // Restores the settings of the pair_style or wall line from a restart file.
  void restore_line() {
    const std::string name = ContactOwner(owner(), this->is_wall()).name();
    restore_settings(engine_, *this, ensure_fix<HistoryKeeper>(engine_)->restarted_settings(name),
                     [&] { postSettings(owner()); });
  }

  void refuse_uncounted(const std::string& counter) {
    if (!CohesiveEnergy::is_known(model(2)))
      stop(engine_,
           counter +
               ": the energy of liquid between particles is not counted. Use cohesion sjkr, "
               "sjkr2 or off, or remove " +
               counter);
    if (!has_model("surface", "default"))
      stop(engine_,
           counter +
               ": the energy of multicontact is not counted. Use surface default, or remove " +
               counter);
  }

  [[gnu::noinline]] AccountedLoad counted(Contact& contact, const Load& before, Load& on_j) {
    AccountedLoad on_i(before);
    on_i.needs_elastic_energy = ledger_ != nullptr;
    compute_and_count(contact, on_i, on_j);
    if (ledger_) add_stored(contact, on_i);
    return on_i;
  }

  void add_stored(const Contact& contact, const AccountedLoad& on_i) {
    ledger_->add_stored(contact, on_i.elastic_energy, on_i.surface_energy,
                        on_i.tangential_energy + spring_energy(contact));
  }

  // Computes the contact data that LIGGGHTS' loop over pairs lacks for pairs without overlap.
  void complete(Contact& contact) const {
    const LAMMPS_NS::Atom* const atom = engine_->atom;
    contact.r = std::sqrt(contact.rsq);
    contact.rinv = 1 / contact.r;
    for (int axis = 0; axis < 3; ++axis) contact.en[axis] = contact.delta[axis] * contact.rinv;
    contact.omega_i = atom->omega[contact.i];
    contact.omega_j = atom->omega[contact.j];
    contact.mi = atom->rmass[contact.i];
    contact.mj = atom->rmass[contact.j];
    if (pair_->fr_pair()) {
      const double* const of_body = pair_->mr_pair();
      if (of_body[contact.i] > 0) contact.mi = of_body[contact.i];
      if (of_body[contact.j] > 0) contact.mj = of_body[contact.j];
    }
    contact.meff = contact.mi * contact.mj / (contact.mi + contact.mj);
    if (atom->mask[contact.i] & pair_->freeze_group_bit()) contact.meff = contact.mj;
    if (atom->mask[contact.j] & pair_->freeze_group_bit()) contact.meff = contact.mi;
  }

  double spring_energy(const Contact& contact) const {
    if (spring_offset_ < 0) return 0;
    const double* const spring = contact.contact_history + spring_offset_;
    return 0.5 * contact.kt *
           (spring[0] * spring[0] + spring[1] * spring[1] + spring[2] * spring[2]);
  }

  LAMMPS_NS::LAMMPS* engine_;
  const void* owner_;  // the Pair or Fix of these contacts; observers compare its address
  const LAMMPS_NS::PairGran* pair_ = nullptr;  // pair style; null for a wall
  EnergyLedger* ledger_ = nullptr;
  std::vector<ContactObserver*> observers_;
  int spring_offset_;  // offset of the tangential spring in the history, -1 if there is none
  int in_contact_offset_ = -1;  // offset of `in_contact`; -1: contacts end with the overlap
  bool requests_ledger_ = false;
  bool line_read_ = false;  // false if LIGGGHTS made the models from a restart file
};

}  // namespace plastigran
