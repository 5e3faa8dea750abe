// SPDX-License-Identifier: GPL-2.0-or-later
//
// Decks may number particles anew between two runs (delete_atoms, create_atoms) and move them to
// other ranks (displace_atoms, change_box): who is who afterwards, over all ranks.
#pragma once

#include <mpi.h>

#include <cstddef>
#include <unordered_map>
#include <vector>

namespace plastigran {

// What each rank has, one after the other, on all of them. All ranks together.
std::vector<int> gather_all(const std::vector<int>& mine, MPI_Comm ranks);
std::vector<double> gather_all(const std::vector<double>& mine, MPI_Comm ranks);

// The present numbers of particles by their old ones; those that are gone are missing.
class NewNumbers {
 public:
  // `before` and `now`: of the `count` particles of this rank; 0 before: a new one. `total_before`:
  // particles of all ranks before. All ranks together.
  NewNumbers(const int* before, const int* now, int count, long total_before, MPI_Comm ranks);

  // 0 when the particle is gone.
  int of(int before) const {
    if (unchanged_) return before;
    const auto found = numbers_.find(before);
    return found == numbers_.end() ? 0 : found->second;
  }

 private:
  bool unchanged_;
  std::unordered_map<int, int> numbers_;
};

// What is known of particles, by their numbers, as spans of one list of values. First all are
// begun, then they are fetched, and then asked for.
class ParticleRecords {
 public:
  // Room for the records of so many particles, and so many values of all together.
  void reserve(std::size_t particles, std::size_t values);

  // Begins the record of a particle; values are then appended to it.
  void begin(int number);
  void append(const double* values, int count);

  // Gets the records of the particles `wanted` (0: none) that other ranks have. All ranks together.
  void fetch(const int* wanted, int count, MPI_Comm ranks);

  // The values of a particle's record and how many they are; null without a record.
  const double* of(int number, int& count) const;

 private:
  struct Entry {
    int number;
    std::size_t place;  // in values_: number, length, values
  };
  typedef std::vector<Entry>::const_iterator Found;

  void sort();
  Found find(int number) const;

  std::vector<Entry> entries_;  // sorted by number from fetch() on
  std::vector<double> values_;
};

}  // namespace plastigran
