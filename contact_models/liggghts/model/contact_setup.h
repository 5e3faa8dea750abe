// SPDX-License-Identifier: GPL-2.0-or-later
//
// Stands before the owner of contacts, a pair style or wall, while the models of a contact are
// made. It tells them what an owner of the engine cannot be asked: which models the deck names, and
// where each value stands in a contact's history.
#pragma once

#include <cstdint>
#include <map>
#include <string>

#include "contact_interface.h"

namespace plastigran {

class ContactSetup : public LIGGGHTS::IContactHistorySetup {
 public:
  ContactSetup(LIGGGHTS::IContactHistorySetup* owner, int64_t hash) : owner_(owner), hash_(hash) {}
  virtual ~ContactSetup() {}

  int add_history_value(std::string name, std::string newtonflag) override {
    const int offset = owner_->add_history_value(name, newtonflag);
    offsets_.emplace(name, offset);
    return offset;
  }

  // The engine's hash of the combination of models.
  int64_t hash() const { return hash_; }

  // The place of the value of that name, -1 when no model has registered one.
  int offset_of(const std::string& name) const {
    const auto found = offsets_.find(name);
    return found == offsets_.end() ? -1 : found->second;
  }

  // The pair style or wall itself, from the one that stands before it or from itself.
  static LIGGGHTS::IContactHistorySetup* owner_of(LIGGGHTS::IContactHistorySetup* setup) {
    const auto before = dynamic_cast<ContactSetup*>(setup);
    return before ? before->owner_ : setup;
  }

 private:
  LIGGGHTS::IContactHistorySetup* owner_;
  int64_t hash_;
  std::map<std::string, int> offsets_;
};

}  // namespace plastigran
