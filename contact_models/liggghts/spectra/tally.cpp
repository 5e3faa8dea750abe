// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/spectra/tally.h"

#include <cmath>

#include "liggghts/fixes/ranks.h"

namespace plastigran {

int Tally::bin_of(double value, int per_decade) {
  return value > 0 ? static_cast<int>(std::floor(per_decade * std::log10(value))) : no_bin;
}

double Tally::edge(int bin, int per_decade) {
  return bin == no_bin ? 0 : std::pow(10, static_cast<double>(bin) / per_decade);
}

Tally Tally::of_all(MPI_Comm ranks) const {
  Tally all;
  all.merge(gather_all(packed(), ranks));
  return all;
}

std::vector<double> Tally::packed() const {
  std::vector<double> values;
  for (const auto& [key, count] : counts_) {
    for (const int part : key.in_order()) values.push_back(part);
    values.insert(values.end(), {count.number, count.sum});
  }
  return values;
}

void Tally::merge(const std::vector<double>& packed) {
  const auto part = [&](std::size_t place) { return static_cast<int>(packed[place]); };
  for (std::size_t k = 0; k < packed.size(); k += 7)
    add({part(k), part(k + 1), part(k + 2), part(k + 3), part(k + 4)},
        {packed[k + 5], packed[k + 6]});
}

}  // namespace plastigran
