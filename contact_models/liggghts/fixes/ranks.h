// SPDX-License-Identifier: GPL-2.0-or-later
//
// Collective operations on the ranks of a communicator.
#pragma once

#include <mpi.h>

#include <numeric>
#include <vector>

namespace plastigran {

inline bool on_any_rank(bool condition, MPI_Comm ranks) {
  int any = condition;
  MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_MAX, ranks);
  return any;
}

inline double sum_over_ranks(double value, MPI_Comm ranks) {
  double sum;
  MPI_Allreduce(&value, &sum, 1, MPI_DOUBLE, MPI_SUM, ranks);
  return sum;
}

inline long sum_over_ranks(long value, MPI_Comm ranks) {
  MPI_Allreduce(MPI_IN_PLACE, &value, 1, MPI_LONG, MPI_SUM, ranks);
  return value;
}

// Returns the values of all ranks, in the order of ranks. Collective.
template <class Value>
std::vector<Value> gather_all(const std::vector<Value>& values, MPI_Comm ranks) {
  const MPI_Datatype type = sizeof(Value) == sizeof(int) ? MPI_INT : MPI_DOUBLE;
  int count = values.size(), rank_count;
  MPI_Comm_size(ranks, &rank_count);
  std::vector<int> counts(rank_count), places(rank_count, 0);
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, ranks);
  std::partial_sum(counts.begin(), counts.end() - 1, places.begin() + 1);
  std::vector<Value> all(places.back() + counts.back());
  MPI_Allgatherv(values.data(), count, type, all.data(), counts.data(), places.data(), type, ranks);
  return all;
}

}  // namespace plastigran
