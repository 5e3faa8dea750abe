// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/spectra/impact_records.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <unordered_map>

#include "liggghts/fixes/ranks.h"

namespace plastigran {

static_assert(std::is_trivially_copyable_v<Impact> && sizeof(Impact) % sizeof(double) == 0,
              "struct Impact must contain only doubles");

namespace {

void append(std::vector<double>& values, Partner partner, const Impact& impact) {
  values.push_back(partner);
  values.resize(values.size() + sizeof impact / sizeof(double));
  std::memcpy(values.data() + values.size() - sizeof impact / sizeof(double), &impact,
              sizeof impact);
}

Impact impact_at(const double* values) {
  Impact impact;
  std::memcpy(static_cast<void*>(&impact), values, sizeof impact);
  return impact;
}

}  // namespace

int ImpactRecords::begin(int i, Partner partner, const Impact& impact) {
  held_[i].keys.push_back({partner, false});
  held_[i].impacts.push_back(impact);
  return held_[i].keys.size() - 1;
}

std::size_t ImpactRecords::count(int count) const {
  std::size_t sum = 0;
  for (int i = 0; i < count; ++i) sum += held_[i].keys.size();
  return sum;
}

void ImpactRecords::store_ids(const int* ids, int count) {
  for (int i = 0; i < count; ++i) held_[i].id = ids[i];
}

void ImpactRecords::renumber(const int* ids, int count, long former_total, MPI_Comm ranks) {
  std::vector<int> former(count);
  for (int i = 0; i < count; ++i) former[i] = held_[i].id;
  const NewIds new_ids(former.data(), ids, count, former_total, ranks);
  std::vector<double> sent;  // records for new holders: ID of the holder, partner, impact
  for (int i = 0; i < count; ++i) {
    const Held old = held_[i];
    held_[i].keys.clear();
    held_[i].impacts.clear();
    for (std::size_t k = 0; k < old.keys.size(); ++k) {
      Partner partner = old.keys[k].partner;
      if (!is_wall(partner)) partner = new_ids.of(partner);
      if (partner == 0) continue;
      if (is_wall(partner) || partner > ids[i]) {
        begin(i, partner, old.impacts[k]);
      } else {
        sent.push_back(partner);
        append(sent, ids[i], old.impacts[k].exchanged());
      }
    }
  }
  sent = gather_all(sent, ranks);
  if (sent.empty()) return;
  std::unordered_map<int, int> places;
  for (int i = 0; i < count; ++i) places[ids[i]] = i;
  for (std::size_t k = 0; k < sent.size(); k += 1 + values_each) {
    const auto holder = places.find(static_cast<int>(sent[k]));
    if (holder != places.end())
      begin(holder->second, static_cast<Partner>(sent[k + 1]), impact_at(&sent[k + 2]));
  }
}

int ImpactRecords::largest_size(int count) const {
  int largest = 0;
  for (int i = 0; i < count; ++i) largest = std::max(largest, size(i));
  return largest;
}

int ImpactRecords::write(int i, double* buffer) const {
  const Held& held = held_[i];
  std::vector<double> values{static_cast<double>(held.id), static_cast<double>(held.keys.size())};
  for (std::size_t k = 0; k < held.keys.size(); ++k)
    append(values, held.keys[k].partner, held.impacts[k]);
  std::copy(values.begin(), values.end(), buffer);
  return values.size();
}

int ImpactRecords::read(int i, const double* buffer) {
  held_[i] = Held();
  held_[i].id = static_cast<int>(buffer[0]);
  const double* values = buffer + 2;
  for (int left = static_cast<int>(buffer[1]); left > 0; --left, values += values_each)
    begin(i, static_cast<Partner>(values[0]), impact_at(values + 1));
  return size(i);
}

}  // namespace plastigran
