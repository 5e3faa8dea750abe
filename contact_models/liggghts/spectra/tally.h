// SPDX-License-Identifier: GPL-2.0-or-later
//
// Counts of impacts by what met, and by classes of a quantity of equal width on a logarithmic
// scale.
#pragma once

#include <mpi.h>

#include <array>
#include <map>
#include <vector>

namespace plastigran {

class Tally {
 public:
  // What is counted: a quantity, of impacts with particles (partner -1) or a wall, of two atom
  // types, in a class.
  struct Key {
    int quantity, wall, type, other_type, bin;
    bool operator<(const Key& other) const { return in_order() < other.in_order(); }
    std::array<int, 5> in_order() const { return {quantity, wall, type, other_type, bin}; }
  };
  struct Count {
    double number = 0, sum = 0;  // impacts, and the sum of their values
    void operator+=(const Count& other) { number += other.number, sum += other.sum; }
  };
  static constexpr int no_bin = -1000000;  // of values that are not positive

  // The class of a value, and where it begins.
  static int bin_of(double value, int per_decade);
  static double edge(int bin, int per_decade);

  void add(const Key& key, const Count& count) { counts_[key] += count; }

  // The counts of all ranks, on all of them. All ranks together.
  Tally of_all(MPI_Comm ranks) const;

  // As a list of values, and back.
  std::vector<double> packed() const;
  void merge(const std::vector<double>& packed);

  void clear() { counts_.clear(); }
  const std::map<Key, Count>& counts() const { return counts_; }

 private:
  std::map<Key, Count> counts_;
};

}  // namespace plastigran
