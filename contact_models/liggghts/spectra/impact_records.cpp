// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/spectra/impact_records.h"

#include <algorithm>
#include <cstring>
#include <type_traits>
#include <unordered_map>

namespace plastigran {

static_assert(std::is_trivially_copyable_v<Impact> && sizeof(Impact) % sizeof(double) == 0,
              "an impact is its doubles and nothing else");

Impact* ImpactRecords::find(int i, double partner) {
  for (Impact& impact : held_[i].impacts)
    if (impact.partner == partner) return &impact;
  return nullptr;
}

Impact& ImpactRecords::begin(int i, double partner) {
  held_[i].impacts.emplace_back();
  held_[i].impacts.back().partner = partner;
  return held_[i].impacts.back();
}

std::size_t ImpactRecords::count(int count) const {
  std::size_t sum = 0;
  for (int i = 0; i < count; ++i) sum += held_[i].impacts.size();
  return sum;
}

void ImpactRecords::remember(const int* numbers, int count) {
  for (int i = 0; i < count; ++i) held_[i].number = numbers[i];
}

void ImpactRecords::follow(const int* numbers, int count, long total_before, MPI_Comm ranks) {
  std::vector<int> before(count);
  for (int i = 0; i < count; ++i) before[i] = held_[i].number;
  const NewNumbers now(before.data(), numbers, count, total_before, ranks);
  std::vector<double> sent;  // to the new holders: each one's number, and the impact
  for (int i = 0; i < count; ++i) {
    std::vector<Impact> kept;
    for (Impact impact : held_[i].impacts) {
      if (!impact.is_with_wall()) impact.partner = now.of(static_cast<int>(impact.partner));
      if (impact.partner == 0) continue;
      if (impact.is_with_wall() || impact.partner > numbers[i]) {
        kept.push_back(impact);
        continue;
      }
      const double holder = impact.partner;
      impact.turn(numbers[i]);
      sent.push_back(holder);
      sent.resize(sent.size() + values_each);
      std::memcpy(&sent[sent.size() - values_each], &impact, sizeof impact);
    }
    held_[i].impacts = kept;
  }
  sent = gather_all(sent, ranks);
  if (sent.empty()) return;
  std::unordered_map<int, int> places;
  for (int i = 0; i < count; ++i) places[numbers[i]] = i;
  for (std::size_t k = 0; k < sent.size(); k += 1 + values_each) {
    const auto holder = places.find(static_cast<int>(sent[k]));
    if (holder == places.end()) continue;
    held_[holder->second].impacts.emplace_back();
    std::memcpy(static_cast<void*>(&held_[holder->second].impacts.back()), &sent[k + 1],
                sizeof(Impact));
  }
}

int ImpactRecords::largest_size(int count) const {
  int largest = 0;
  for (int i = 0; i < count; ++i) largest = std::max(largest, size(i));
  return largest;
}

int ImpactRecords::write(int i, double* buffer) const {
  const Held& held = held_[i];
  buffer[0] = held.number;
  buffer[1] = held.impacts.size();
  if (!held.impacts.empty())
    std::memcpy(buffer + 2, held.impacts.data(), held.impacts.size() * sizeof(Impact));
  return size(i);
}

int ImpactRecords::read(int i, const double* buffer) {
  Held& held = held_[i];
  held.number = static_cast<int>(buffer[0]);
  held.impacts.resize(static_cast<std::size_t>(buffer[1]));
  if (!held.impacts.empty())
    std::memcpy(static_cast<void*>(held.impacts.data()), buffer + 2,
                held.impacts.size() * sizeof(Impact));
  return size(i);
}

}  // namespace plastigran
