// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/particle_numbers.h"

#include <algorithm>
#include <numeric>

namespace plastigran {

namespace {

template <class Value>
std::vector<Value> gather(const std::vector<Value>& mine, MPI_Datatype type, MPI_Comm ranks) {
  int count = mine.size(), rank_count;
  MPI_Comm_size(ranks, &rank_count);
  std::vector<int> counts(rank_count), places(rank_count, 0);
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, ranks);
  std::partial_sum(counts.begin(), counts.end() - 1, places.begin() + 1);
  std::vector<Value> all(places.back() + counts.back());
  MPI_Allgatherv(mine.data(), count, type, all.data(), counts.data(), places.data(), type, ranks);
  return all;
}

bool on_any_rank(bool here, MPI_Comm ranks) {
  int any = here;
  MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_MAX, ranks);
  return any;
}

}  // namespace

std::vector<int> gather_all(const std::vector<int>& mine, MPI_Comm ranks) {
  return gather(mine, MPI_INT, ranks);
}

std::vector<double> gather_all(const std::vector<double>& mine, MPI_Comm ranks) {
  return gather(mine, MPI_DOUBLE, ranks);
}

NewNumbers::NewNumbers(const int* before, const int* now, int count, long total_before,
                       MPI_Comm ranks) {
  long total = count;
  MPI_Allreduce(MPI_IN_PLACE, &total, 1, MPI_LONG, MPI_SUM, ranks);
  bool differs = total != total_before;
  for (int i = 0; i < count; ++i) differs = differs || before[i] != now[i];
  unchanged_ = !on_any_rank(differs, ranks);
  if (unchanged_) return;
  std::vector<int> pairs;
  for (int i = 0; i < count; ++i)
    if (before[i]) pairs.insert(pairs.end(), {before[i], now[i]});
  pairs = gather_all(pairs, ranks);
  for (std::size_t k = 0; k < pairs.size(); k += 2) numbers_[pairs[k]] = pairs[k + 1];
}

void ParticleRecords::reserve(std::size_t particles, std::size_t values) {
  entries_.reserve(particles);
  values_.reserve(2 * particles + values);
}

void ParticleRecords::begin(int number) {
  entries_.push_back({number, values_.size()});
  values_.insert(values_.end(), {static_cast<double>(number), 0});
}

void ParticleRecords::append(const double* values, int count) {
  values_[entries_.back().place + 1] += count;
  values_.insert(values_.end(), values, values + count);
}

void ParticleRecords::sort() {
  std::sort(entries_.begin(), entries_.end(),
            [](const Entry& one, const Entry& other) { return one.number < other.number; });
}

ParticleRecords::Found ParticleRecords::find(int number) const {
  const Found found =
      std::lower_bound(entries_.begin(), entries_.end(), number,
                       [](const Entry& entry, int sought) { return entry.number < sought; });
  return found != entries_.end() && found->number == number ? found : entries_.end();
}

void ParticleRecords::fetch(const int* wanted, int count, MPI_Comm ranks) {
  sort();
  std::vector<int> missing;
  for (int i = 0; i < count; ++i)
    if (wanted[i] && find(wanted[i]) == entries_.end()) missing.push_back(wanted[i]);
  if (!on_any_rank(!missing.empty(), ranks)) return;
  std::vector<double> sent;
  for (const int number : gather_all(missing, ranks)) {
    const Found found = find(number);
    if (found == entries_.end()) continue;
    const double* const record = &values_[found->place];
    sent.insert(sent.end(), record, record + 2 + static_cast<std::size_t>(record[1]));
  }
  const std::vector<double> received = gather_all(sent, ranks);
  std::sort(missing.begin(), missing.end());
  for (std::size_t k = 0; k < received.size(); k += 2 + static_cast<std::size_t>(received[k + 1])) {
    const int number = static_cast<int>(received[k]);
    if (!std::binary_search(missing.begin(), missing.end(), number)) continue;
    begin(number);
    append(&received[k + 2], static_cast<int>(received[k + 1]));
  }
  sort();
}

const double* ParticleRecords::of(int number, int& count) const {
  const Found found = find(number);
  if (found == entries_.end()) return nullptr;
  count = static_cast<int>(values_[found->place + 1]);
  return &values_[found->place + 2];
}

}  // namespace plastigran
