// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/particle_ids.h"

#include <algorithm>

#include "liggghts/fixes/ranks.h"

namespace plastigran {

NewIds::NewIds(const int* former, const int* current, int count, long former_total,
               MPI_Comm ranks) {
  long kept = 0;  // particles with their former ID
  for (int i = 0; i < count; ++i) kept += former[i] && former[i] == current[i];
  unchanged_ = sum_over_ranks(kept, ranks) == former_total;
  if (unchanged_) return;
  std::vector<int> pairs;
  for (int i = 0; i < count; ++i)
    if (former[i]) pairs.insert(pairs.end(), {former[i], current[i]});
  pairs = gather_all(pairs, ranks);
  for (std::size_t k = 0; k < pairs.size(); k += 2) ids_[pairs[k]] = pairs[k + 1];
}

void ParticleRecords::reserve(std::size_t particles, std::size_t values) {
  spans_.reserve(particles);
  values_.reserve(values);
}

void ParticleRecords::add(int id, const double* values, int count) {
  spans_[id] = {values_.size(), count};
  values_.insert(values_.end(), values, values + count);
}

void ParticleRecords::fetch(const int* ids, int count, MPI_Comm ranks) {
  std::vector<int> missing;
  for (int i = 0; i < count; ++i)
    if (!spans_.count(ids[i])) missing.push_back(ids[i]);
  if (!on_any_rank(!missing.empty(), ranks)) return;
  std::vector<double> sent;  // for each record: ID, number of values, values
  for (const int id : gather_all(missing, ranks))
    if (const Record record = find(id); record.values) {
      sent.insert(sent.end(), {static_cast<double>(id), static_cast<double>(record.count)});
      sent.insert(sent.end(), record.values, record.values + record.count);
    }
  std::sort(missing.begin(), missing.end());
  const std::vector<double> received = gather_all(sent, ranks);
  for (std::size_t k = 0; k < received.size();) {
    const int id = static_cast<int>(received[k]), length = static_cast<int>(received[k + 1]);
    if (std::binary_search(missing.begin(), missing.end(), id)) add(id, &received[k + 2], length);
    k += 2 + length;
  }
}

ParticleRecords::Record ParticleRecords::find(int id) const {
  const auto span = spans_.find(id);
  if (span == spans_.end()) return {};
  return {values_.data() + span->second.begin, span->second.count};
}

}  // namespace plastigran
