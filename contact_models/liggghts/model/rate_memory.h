// SPDX-License-Identifier: GPL-2.0-or-later
//
// A contact remembers the rate factor of its first touch, as long as it lasts. The value is in the
// history only where a rate matters: walls add it when they are made, pair styles before a run.
#pragma once

#include <string>

#include "contact_interface.h"
#include "liggghts/fixes/own_fix.h"
#include "liggghts/model/deck_properties.h"
#include "liggghts/model/rate_history.h"
#include "plastigran/pairs/type_pair.h"
#include "plastigran/shared/rate_factor.h"

namespace plastigran {

class RateMemory {
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;

 public:
  RateMemory(LAMMPS_NS::LAMMPS* engine, bool is_wall) : engine_(engine), is_wall_(is_wall) {}
  ~RateMemory() {
    const auto rates = find_own_fix<RateHistory>(engine_);
    if (rates && !is_wall_) rates->end();
  }
  RateMemory(const RateMemory&) = delete;

  // As the contact model is made.
  void begin(LIGGGHTS::IContactHistorySetup* setup, const DeckProperties& deck, bool has_types) {
    if (!is_wall_ && has_types)
      own_fix<RateHistory>(engine_)->begin();
    else if (is_wall_ && deck.positive("rate_coefficient"))
      offset_ = setup->add_history_value("rate_factor", "0");
  }

  // Before a run. Stops where rates matter and contacts cannot remember them.
  void connect(const DeckProperties& deck, bool rate_matters) {
    if (!is_wall_) offset_ = own_fix<RateHistory>(engine_)->offset();
    if (offset_ < 0 && rate_matters)
      deck.fail(property_name("rate_coefficient") + " must be given before " +
                (is_wall_ ? "the wall" : "the first run") +
                ", when it is decided what contacts remember");
  }

  // Whether contacts remember a rate factor.
  bool kept() const { return offset_ >= 0; }

  // The two bodies with their strength at the contact's rate factor; 0 in the history is none yet.
  // `writes`: the history keeps the factor.
  template <class Law>
  [[gnu::noinline]] TypePair<Law>& strengthened(const Contact& contact, TypePair<Law>& pair,
                                                double radius_eff, bool writes) const {
    double factor = contact.contact_history[offset_];
    if (factor == 0) {
      factor = rate_factor(pair.bodies, radius_eff, -contact.vn);
      if (writes) contact.contact_history[offset_] = factor;
    }
    return pair.strengthened(factor);
  }

  void forget(double* history) const {
    if (kept()) history[offset_] = 0;
  }

 private:
  LAMMPS_NS::LAMMPS* engine_;
  bool is_wall_;
  int offset_ = -1;  // in a contact's history
};

}  // namespace plastigran
