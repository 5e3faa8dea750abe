// SPDX-License-Identifier: GPL-2.0-or-later
//
// Companions of a law: the tangential, cohesion, rolling and surface models that a deck combines
// with the law.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "plastigran/friction/partial_slip.h"

namespace plastigran {

struct Companion {
  const char* name;  // name in decks
  int id;            // ID in LIGGGHTS' hash; 0 for the model used if the line names none
};

struct CompanionKind {
  const char* keyword;  // keyword in decks
  std::vector<Companion> models;
};

// Returns the kinds of models in their order in LIGGGHTS' hash of a model combination. The normal
// model comes first in the hash, but is not in this list.
const std::array<CompanionKind, 4>& companion_kinds();

// Returns the ID of the model at `place` of LIGGGHTS' hash: 0 normal, 1 tangential, 2 cohesion, 3
// rolling, 4 surface. Each place has six bits.
inline int model_of(std::int64_t hash, std::size_t place) { return hash >> 6 * place & 63; }

// Smallest, default and largest number of rings of the contact area in `tangential partial_slip`.
constexpr int least_rings = PartialSlip<>::least_rings,
              default_rings = PartialSlip<>::default_rings, most_rings = PartialSlip<>::most_rings;

// Bit 30 of the hash, the first bit after the IDs of the five models. It marks a law with the
// option `adhesion jkr`. Restart files contain the hash, so the same history values are registered
// after a restart.
constexpr std::int64_t with_adhesion = std::int64_t{1} << 30;

// Bits 31 to 33 of the hash contain the number of rings of `tangential partial_slip` minus 1; 0
// stands for the default number.
inline int rings_of(std::int64_t hash) {
  const int bits = hash >> 31 & 7;
  return bits == 0 ? default_rings : bits + 1;
}
inline std::int64_t hash_of_rings(int rings) {
  return rings == default_rings ? 0 : std::int64_t{rings - 1} << 31;
}

// Returns whether `id`, the ID of a tangential model in LIGGGHTS, belongs to a law of this plugin.
bool is_tangential_law(int id);

// Returns whether the hash contains the model `name` after `keyword`: "normal", "tangential", ...,
// or the option "adhesion" "jkr", or a number of "rings" other than the default.
bool has_model(std::int64_t hash, const std::string& keyword, const std::string& name);

}  // namespace plastigran
