// SPDX-License-Identifier: GPL-2.0-or-later
//
// A contact remembers the rate factor of its first touch, as long as it lasts. The value is in the
// history only where a rate matters: walls add it when they are made, pair styles before a run.
#pragma once

#include <string>

#include "contact_interface.h"
#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/model/deck_properties.h"
#include "liggghts/model/rate_history.h"
#include "plastigran/shared/contact.h"
#include "plastigran/shared/rate_factor.h"

namespace plastigran {

class ContactRates {
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;

 public:
  ContactRates(LAMMPS_NS::LAMMPS* engine, bool is_wall) : engine_(engine), is_wall_(is_wall) {}
  ~ContactRates() {
    const auto rates = find_fix<RateHistory>(engine_);
    if (rates && !is_wall_) rates->end();
  }
  ContactRates(const ContactRates&) = delete;

  // As the contact model is made.
  void begin(LIGGGHTS::IContactHistorySetup& setup, const DeckProperties& deck, bool has_types) {
    if (!is_wall_ && has_types)
      ensure_fix<RateHistory>(engine_)->begin();
    else if (is_wall_ && deck.positive("rate_coefficient"))
      offset_ = setup.add_history_value("rate_factor", "0");
  }

  // Before a run. Stops where rates matter and contacts cannot remember them.
  void connect(const DeckProperties& deck, bool rate_matters) {
    if (!is_wall_) offset_ = ensure_fix<RateHistory>(engine_)->offset();
    if (offset_ < 0 && rate_matters)
      deck.fail(property_name("rate_coefficient") + " must be given before " +
                (is_wall_ ? "the wall" : "the first run") +
                ", when the values of the contact history are chosen");
  }

  // Whether contacts remember a rate factor.
  bool stored() const { return offset_ >= 0; }

  // The rate factor of a contact; 0 in the history is none yet. `writes`: the history keeps it.
  double factor(const Contact& contact, const MaterialPair& bodies, double radius_eff,
                bool writes) const {
    const double kept_factor = contact.contact_history[offset_];
    return kept_factor != 0 ? kept_factor : first_touch(contact, bodies, radius_eff, writes);
  }

  void clear(double* history) const {
    if (stored()) history[offset_] = 0;
  }

 private:
  [[gnu::noinline]] double first_touch(const Contact& contact, const MaterialPair& bodies,
                                       double radius_eff, bool writes) const {
    const double factor = rate_factor(bodies, radius_eff, -contact.vn);
    if (writes) contact.contact_history[offset_] = factor;
    return factor;
  }

  LAMMPS_NS::LAMMPS* engine_;
  bool is_wall_;
  int offset_ = -1;  // in a contact's history
};

}  // namespace plastigran
