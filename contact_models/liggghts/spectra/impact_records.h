// SPDX-License-Identifier: GPL-2.0-or-later
//
// The impacts under way, by the particles that hold them; and how they travel with these to other
// places, other ranks and restart files.
#pragma once

#include <mpi.h>

#include <vector>

#include "liggghts/fixes/particle_numbers.h"
#include "liggghts/spectra/impact.h"

namespace plastigran {

class ImpactRecords {
 public:
  void resize(int size) { held_.resize(size); }
  void copy(int from, int to) { held_[to] = held_[from]; }
  void clear(int i) { held_[i] = Held(); }

  // Null when there is none with that partner.
  Impact* find(int i, double partner);
  Impact& begin(int i, double partner);

  // Of the first `count` particles.
  std::size_t count(int count) const;

  // The impacts of a particle that was not touched in this step are over and taken out; the others
  // wait for the next step.
  template <class Count>
  void advance(int i, Count count) {
    std::vector<Impact>& impacts = held_[i].impacts;
    for (std::size_t k = 0; k < impacts.size();) {
      if (impacts[k].touched) {
        impacts[k++].touched = 0;
        continue;
      }
      count(impacts[k]);
      impacts[k] = impacts.back();
      impacts.pop_back();
    }
  }

  // As a run ends: the particles' numbers. Decks may then number them anew.
  void remember(const int* numbers, int count);

  // As the next begins: partners and holders by the present numbers. An impact ends uncounted when
  // one of the two is gone. `total_before`: particles of all ranks then. All ranks together.
  void follow(const int* numbers, int count, long total_before, MPI_Comm ranks);

  // A particle's record in a buffer: how many values it is, and it written or read.
  int size(int i) const { return 2 + values_each * held_[i].impacts.size(); }
  int largest_size(int count) const;
  int write(int i, double* buffer) const;
  int read(int i, const double* buffer);

 private:
  static constexpr int values_each = sizeof(Impact) / sizeof(double);

  struct Held {
    int number = 0;  // of the particle when the last run ended, 0 for a new one
    std::vector<Impact> impacts;
  };
  std::vector<Held> held_;  // by local particle
};

}  // namespace plastigran
