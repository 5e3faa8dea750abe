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
  const char* name;  // in decks
  int id;            // in LIGGGHTS' hash; 0 is the model of a line that names none
};

struct CompanionKind {
  const char* keyword;  // in decks
  std::vector<Companion> models;
};

// In the order of LIGGGHTS' hash, in which the normal model comes first.
const std::array<CompanionKind, 4>& companion_kinds();

// The ID of the model in a place of LIGGGHTS' hash: 0 normal, 1 tangential, 2 cohesion, 3 rolling,
// 4 surface. Each place has six bits.
inline int model_of(std::int64_t hash, std::size_t place) { return hash >> 6 * place & 63; }

// Whether the hash has the model `name` of the kind "normal", "tangential", ...
bool has_model(std::int64_t hash, const std::string& kind, const std::string& name);

}  // namespace plastigran
