// SPDX-License-Identifier: GPL-2.0-or-later
//
// Rate factor of the yield strength in a contact. The impact speed at first touch determines this
// factor, which is constant until the contact ends. The factor is a history value, which exists
// only if a yield strength depends on the strain rate. Walls register the value when they are made.
// For pair styles, a fix registers it before the first run, because the deck may define its
// properties after the pair style or after a restart.
#pragma once

#include "contact_interface.h"
#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/model/deck_properties.h"
#include "plastigran/shared/contact.h"
#include "plastigran/shared/rate_factor.h"

namespace plastigran {

class RateHistory : public LAMMPS_NS::Fix {
 public:
  RateHistory(LAMMPS_NS::LAMMPS* engine, int count, char** words) : Fix(engine, count, words) {}
  static const char* id() { return "plastigran_rate"; }
  static const char* style() { return "plastigran/rate"; }

  // Call begin() for a new pair style with a law that yields, and end() when it is deleted.
  void begin() { needed_ = Needed::unknown; }
  void end() { needed_ = Needed::no; }

  // Returns the offset of the rate factor in the contact history; -1 if there is none.
  int offset() const;

  int setmask() override { return 0; }
  int n_history_extra() override;
  bool history_args(char** words) override;

 private:
  enum class Needed { unknown, no, yes } needed_ = Needed::no;
};

class ContactRates {
  typedef LIGGGHTS::ContactModels::SurfacesIntersectData Contact;

 public:
  ContactRates(LAMMPS_NS::LAMMPS* engine, bool is_wall) : engine_(engine), is_wall_(is_wall) {}
  ~ContactRates() {
    const auto rates = find_fix<RateHistory>(engine_);
    if (rates && !is_wall_) rates->end();
  }
  ContactRates(const ContactRates&) = delete;

  // Registers the history value of the rate factor. The constructor of a contact model calls this
  // function.
  void begin(LIGGGHTS::IContactHistorySetup& setup, const DeckProperties& deck, bool has_types);

  // Stops in the setup if a yield strength depends on the rate (`rate_matters`), but the contact
  // history has no value for the rate factor.
  void connect(const DeckProperties& deck, bool rate_matters);

  // Returns whether the contact history stores a rate factor.
  bool stored() const { return offset_ >= 0; }

  // Returns the rate factor of a contact; computes it at first touch, when the history contains 0.
  // `writes` allows this function to store it in the history.
  double factor(const Contact& contact, const MaterialPair& bodies, double radius_eff,
                bool writes) const {
    const double factor = contact.contact_history[offset_];
    return factor != 0 ? factor : first_factor(contact, bodies, radius_eff, writes);
  }

  void clear(double* history) const {
    if (stored()) history[offset_] = 0;
  }

 private:
  [[gnu::noinline]] double first_factor(const Contact& contact, const MaterialPair& bodies,
                                        double radius_eff, bool writes) const {
    const double factor = rate_factor(bodies, radius_eff, -contact.vn);
    if (writes) contact.contact_history[offset_] = factor;
    return factor;
  }

  LAMMPS_NS::LAMMPS* engine_;
  bool is_wall_;
  int offset_ = -1;  // offset of the rate factor in the contact history; -1 if none
};

}  // namespace plastigran
