// SPDX-License-Identifier: GPL-2.0-or-later
//
// Where each value stands in a contact's history. The engine's owners of histories (pair styles and
// walls) hand out places and cannot be asked for them by name; this one stands before an owner
// while the models of a contact register their values.
#pragma once

#include <map>
#include <string>

#include "contact_interface.h"

namespace plastigran {

class HistoryNames : public LIGGGHTS::IContactHistorySetup {
 public:
  explicit HistoryNames(LIGGGHTS::IContactHistorySetup* owner) : owner_(owner) {}
  virtual ~HistoryNames() {}

  int add_history_value(std::string name, std::string newtonflag) override {
    const int offset = owner_->add_history_value(name, newtonflag);
    offsets_.emplace(name, offset);
    return offset;
  }

  // The place of the value of that name, -1 when no model has registered one.
  int offset_of(const std::string& name) const {
    const auto found = offsets_.find(name);
    return found == offsets_.end() ? -1 : found->second;
  }

  // The pair style or wall itself, with or without its names.
  static LIGGGHTS::IContactHistorySetup* owner_of(LIGGGHTS::IContactHistorySetup* setup) {
    const auto names = dynamic_cast<HistoryNames*>(setup);
    return names ? names->owner_ : setup;
  }

 private:
  LIGGGHTS::IContactHistorySetup* owner_;
  std::map<std::string, int> offsets_;
};

}  // namespace plastigran
