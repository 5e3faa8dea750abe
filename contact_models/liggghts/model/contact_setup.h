// SPDX-License-Identifier: GPL-2.0-or-later
//
// Stands between a pair style or wall and the models of its contacts. It tells the models what
// their owner cannot: which models the deck names, where each value stands in the contact history,
// and which load the energies of a contact go to.
#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <string>

#include "contact_interface.h"
#include "liggghts/model/accounted_load.h"
#include "liggghts/model/companions.h"

namespace plastigran {

class ContactSetup : public LIGGGHTS::IContactHistorySetup {
 public:
  ContactSetup(LIGGGHTS::IContactHistorySetup* owner, int64_t hash) : owner_(owner), hash_(hash) {}
  virtual ~ContactSetup() {}

  // The setup that LIGGGHTS passes to the models of an AccountedContact.
  static ContactSetup& of(LIGGGHTS::IContactHistorySetup* setup) {
    return dynamic_cast<ContactSetup&>(*setup);
  }

  int add_history_value(std::string name, std::string newtonflag) override {
    const int offset = owner_->add_history_value(name, newtonflag);
    offsets_.emplace(name, offset);
    return offset;
  }

  // The pair style or wall.
  LIGGGHTS::IContactHistorySetup* owner() const { return owner_; }

  // LIGGGHTS' hash of the combination of models.
  int64_t hash() const { return hash_; }
  int model(std::size_t place) const { return model_of(hash_, place); }
  bool has_model(const std::string& kind, const std::string& name) const {
    return plastigran::has_model(hash_, kind, name);
  }

  // The offset of a history value, -1 if no model has registered it.
  int offset_of(const std::string& name) const {
    const auto entry = offsets_.find(name);
    return entry == offsets_.end() ? -1 : entry->second;
  }

  // The load on particle i in the call that is being computed, if its energies are counted.
  AccountedLoad* counted_load = nullptr;

 private:
  LIGGGHTS::IContactHistorySetup* owner_;
  int64_t hash_;
  std::map<std::string, int> offsets_;
};

}  // namespace plastigran
