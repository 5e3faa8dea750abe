// SPDX-License-Identifier: GPL-2.0-or-later
//
// Interface between a pair style or wall and its contact models. It provides data that LIGGGHTS
// does not: the models named in the deck, the offset of each value in the contact history, and the
// object that stores the energies of a contact.
#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "contact_interface.h"
#include "liggghts/model/accounted_load.h"
#include "liggghts/model/companions.h"

namespace plastigran {

class ContactSetup : public LIGGGHTS::IContactHistorySetup {
 public:
  ContactSetup(LIGGGHTS::IContactHistorySetup* owner, int64_t hash) : owner_(owner), hash_(hash) {}
  virtual ~ContactSetup() {}

  // Returns, as a ContactSetup, the setup object that LIGGGHTS passes to the models of an
  // AccountedContact.
  static ContactSetup& of(LIGGGHTS::IContactHistorySetup* setup) {
    return dynamic_cast<ContactSetup&>(*setup);
  }

  int add_history_value(std::string name, std::string newtonflag) override {
    const int offset = owner_->add_history_value(name, newtonflag);
    offsets_.emplace(name, offset);
    return offset;
  }

  // Returns the pair style or wall.
  LIGGGHTS::IContactHistorySetup* owner() const { return owner_; }

  // Returns LIGGGHTS' hash of the combination of models.
  int64_t hash() const { return hash_; }
  bool has_adhesion() const { return hash_ & with_adhesion; }
  void add_adhesion() { hash_ |= with_adhesion; }
  int rings() const { return rings_of(hash_); }
  void set_rings(int rings) { hash_ |= hash_of_rings(rings); }
  int model(std::size_t place) const { return model_of(hash_, place); }
  bool has_model(const std::string& keyword, const std::string& name) const {
    return plastigran::has_model(hash_, keyword, name);
  }

  // Returns the offset of a history value; -1 if no model has registered this value.
  int offset_of(const std::string& name) const {
    const auto entry = offsets_.find(name);
    return entry == offsets_.end() ? -1 : entry->second;
  }

  // Functions that models may add. They are called when all models are constructed.
  std::vector<std::function<void()>> when_constructed;

  // Load on particle i in the current call, if its energies are counted; otherwise null.
  AccountedLoad* counted_load = nullptr;

 private:
  LIGGGHTS::IContactHistorySetup* owner_;
  int64_t hash_;
  std::map<std::string, int> offsets_;
};

}  // namespace plastigran
