// SPDX-License-Identifier: GPL-2.0-or-later
//
// LIGGGHTS' tangential, cohesion, rolling and surface models, which a deck combines with a law.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace plastigran {

struct Companion {
  const char* name;  // name in decks
  int id;            // ID in LIGGGHTS' hash; 0 is the default model of a line
};

struct CompanionKind {
  const char* keyword;  // keyword in decks
  std::vector<Companion> models;
};

// Returns the kinds in the order in which LIGGGHTS' hash of a combination of models contains them.
// The normal model comes first in the hash and is not among them.
const std::array<CompanionKind, 4>& companion_kinds();

// Returns the ID of the model at `place` of LIGGGHTS' hash: 0 normal, 1 tangential, 2 cohesion, 3
// rolling, 4 surface. Each place has six bits.
inline int model_of(std::int64_t hash, std::size_t place) { return hash >> 6 * place & 63; }

// The next bit of the hash, which marks a law with the option `adhesion jkr`. Restart files contain
// the hash, so that the contact history after a restart has the same values.
constexpr std::int64_t with_adhesion = std::int64_t{1} << 30;

// Returns whether the hash contains the model `name` after `keyword`: "normal", "tangential", ...,
// or the option "adhesion" "jkr".
bool has_model(std::int64_t hash, const std::string& keyword, const std::string& name);

}  // namespace plastigran
