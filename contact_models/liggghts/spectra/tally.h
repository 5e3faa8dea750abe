// SPDX-License-Identifier: GPL-2.0-or-later
//
// Counts of impacts by wall, atom types, and logarithmic classes of a quantity.
#pragma once

#include <mpi.h>

#include <array>
#include <map>
#include <vector>

namespace plastigran {

class Tally {
 public:
  // Key of a count. `wall` is -1 for impacts between particles.
  struct Key {
    int quantity, wall, type, other_type, bin;
    bool operator<(const Key& other) const { return in_order() < other.in_order(); }
    std::array<int, 5> in_order() const { return {quantity, wall, type, other_type, bin}; }
  };
  struct Count {
    double number = 0, sum = 0;  // number of impacts, and sum of the quantity over them
    void operator+=(const Count& other) { number += other.number, sum += other.sum; }
  };
  static constexpr int no_bin = -1000000;  // class of zero and negative values

  // Return the logarithmic class of a value, and the lower edge of a class.
  static int bin_of(double value, int per_decade);
  static double edge(int bin, int per_decade);

  void add(const Key& key, const Count& count) { counts_[key] += count; }

  // Returns the counts summed over all ranks. Collective.
  Tally of_all(MPI_Comm ranks) const;

  // Returns the counts as a list of values, which merge() reads.
  std::vector<double> packed() const;
  void merge(const std::vector<double>& packed);

  void clear() { counts_.clear(); }
  const std::map<Key, Count>& counts() const { return counts_; }

 private:
  std::map<Key, Count> counts_;
};

}  // namespace plastigran
