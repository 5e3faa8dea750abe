// SPDX-License-Identifier: GPL-2.0-or-later
//
// The models beside the normal one in a contact: those of the engine's headers.
#pragma once

#include <array>
#include <vector>

namespace plastigran {

struct Companion {
  const char* name;  // as a deck has it
  int id;            // of the engine's hash; 0 is what a deck has that does not say
};

struct CompanionKind {
  const char* keyword;  // as a deck has it
  std::vector<Companion> models;
};

// In the order of the engine's hash, whose first place is the normal model's.
const std::array<CompanionKind, 4>& companion_kinds();

}  // namespace plastigran
