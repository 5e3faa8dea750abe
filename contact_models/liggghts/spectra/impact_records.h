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

  // The place among a particle's impacts of the one with that partner; -1 when there is none.
  int find(int i, Partner partner) const {
    const std::vector<Key>& keys = held_[i].keys;
    for (std::size_t k = 0; k < keys.size(); ++k)
      if (keys[k].partner == partner) return k;
    return -1;
  }
  int begin(int i, Partner partner, const Impact& impact = Impact());
  Impact& at(int i, int place) { return held_[i].impacts[place]; }

  // Marks an impact as touched in this step; whether it was before.
  bool touch(int i, int place) {
    const bool before = held_[i].keys[place].touched;
    held_[i].keys[place].touched = true;
    return before;
  }

  // Of the first `count` particles.
  std::size_t count(int count) const;

  // The impacts of a particle that was not touched in this step are over and taken out; the others
  // wait for the next step.
  template <class Count>
  void advance(int i, Count count) {
    Held& held = held_[i];
    for (std::size_t k = 0; k < held.keys.size();) {
      if (held.keys[k].touched) {
        held.keys[k++].touched = false;
        continue;
      }
      count(held.keys[k].partner, held.impacts[k]);
      held.keys[k] = held.keys.back(), held.keys.pop_back();
      held.impacts[k] = held.impacts.back(), held.impacts.pop_back();
    }
  }

  // As a run ends: the particles' numbers. Decks may then number them anew.
  void remember(const int* numbers, int count);

  // As the next begins: partners and holders by the present numbers. An impact ends uncounted when
  // one of the two is gone. `total_before`: particles of all ranks then. All ranks together.
  void follow(const int* numbers, int count, long total_before, MPI_Comm ranks);

  // A particle's record in a buffer: how many values it is, and it written or read.
  int size(int i) const { return 2 + values_each * held_[i].keys.size(); }
  int largest_size(int count) const;
  int write(int i, double* buffer) const;
  int read(int i, const double* buffer);

 private:
  static constexpr int values_each = 1 + sizeof(Impact) / sizeof(double);  // with the partner

  // Apart from the impacts, for all of them are looked through in every step.
  struct Key {
    Partner partner;
    bool touched;  // in this step
  };
  struct Held {
    int number = 0;  // of the particle when the last run ended, 0 for a new one
    std::vector<Key> keys;
    std::vector<Impact> impacts;
  };
  std::vector<Held> held_;  // by local particle
};

}  // namespace plastigran
