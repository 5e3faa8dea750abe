// SPDX-License-Identifier: GPL-2.0-or-later
//
// Identification of particles from one run to the next. Between two runs, a deck may renumber
// particles (delete_atoms, create_atoms) and move them to other ranks (displace_atoms, change_box).
#pragma once

#include <mpi.h>

#include <cstddef>
#include <unordered_map>
#include <utility>
#include <vector>

namespace plastigran {

// Map from the former IDs of all particles to their current IDs.
class NewIds {
 public:
  // `former` and `current`: IDs of the `count` particles of this rank; 0 is the former ID of a new
  // particle. `former_total`: former number of particles on all ranks. Collective.
  NewIds(const int* former, const int* current, int count, long former_total, MPI_Comm ranks);

  // Returns whether all former particles still exist with their former IDs.
  bool unchanged() const { return unchanged_; }

  // Returns the current ID of a particle by its former ID; 0 if it was deleted.
  int of(int former) const {
    if (unchanged_) return former;
    const auto id = ids_.find(former);
    return id == ids_.end() ? 0 : id->second;
  }

 private:
  bool unchanged_;
  std::unordered_map<int, int> ids_;
};

// Values of particles by ID. Call add() for all local records, then fetch() to get records of other
// ranks, then find().
class ParticleRecords {
 public:
  struct Record {
    const double* values = nullptr;  // values of the particle; null if it has no record
    int count = 0;
  };

  void reserve(std::size_t particles, std::size_t values);
  void add(int id, const double* values, int count);

  // Replaces the IDs of the particles, and omits deleted particles. Calls change(values, count) for
  // the values of each particle. `change` returns the new number of values, at most `count`.
  template <class Change>
  void replace_ids(const NewIds& ids, Change change) {
    for (const auto& [former, span] : std::exchange(spans_, {}))
      if (const int id = ids.of(former))
        spans_[id] = {span.begin, change(values_.data() + span.begin, span.count)};
  }

  // Gets missing records of the particles `ids` from the ranks that have them. Collective.
  void fetch(const int* ids, int count, MPI_Comm ranks);

  Record find(int id) const;

 private:
  struct Span {
    std::size_t begin;
    int count;
  };
  std::unordered_map<int, Span> spans_;
  std::vector<double> values_;  // one array for all records, to save memory
};

}  // namespace plastigran
