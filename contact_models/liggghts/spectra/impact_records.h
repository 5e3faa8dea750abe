// SPDX-License-Identifier: GPL-2.0-or-later
//
// Current impacts, stored by the particle that holds them. LIGGGHTS moves them with the particle to
// other ranks and to restart files.
#pragma once

#include <mpi.h>

#include <vector>

#include "liggghts/fixes/particle_ids.h"
#include "liggghts/spectra/impact.h"

namespace plastigran {

class ImpactRecords {
 public:
  void resize(int size) { held_.resize(size); }
  void copy(int from, int to) { held_[to] = held_[from]; }
  void clear(int i) { held_[i] = Held(); }

  // Returns the index of a particle's impact with a partner; -1 if there is none.
  int find(int i, Partner partner) const {
    const std::vector<Key>& keys = held_[i].keys;
    for (std::size_t k = 0; k < keys.size(); ++k)
      if (keys[k].partner == partner) return k;
    return -1;
  }
  int begin(int i, Partner partner, const Impact& impact = Impact());
  Impact& at(int i, int place) { return held_[i].impacts[place]; }

  // Marks an impact as in contact in this step. Returns whether the impact was already marked.
  bool touch(int i, int place) {
    const bool before = held_[i].keys[place].touched;
    held_[i].keys[place].touched = true;
    return before;
  }

  // Returns the number of impacts of the first `count` particles.
  std::size_t count(int count) const;

  // Removes the impacts of a particle that have no contact in this step, after calling `count` for
  // each.
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

  // Stores the particle IDs at the end of a run, because decks may renumber particles.
  void store_ids(const int* ids, int count);

  // Updates partners and holders to the current IDs before the next run. Removes an impact without
  // counting it if one of its particles was deleted. `former_total`: number of particles on all
  // ranks at the end of the last run. Collective.
  void renumber(const int* ids, int count, long former_total, MPI_Comm ranks);

  // write() and read() convert the impacts of a particle to values in a buffer, and back. They
  // return the number of values, as size() does. largest_size() is the maximum of size() over the
  // first `count` particles.
  int size(int i) const { return 2 + values_each * held_[i].keys.size(); }
  int largest_size(int count) const;
  int write(int i, double* buffer) const;
  int read(int i, const double* buffer);

 private:
  // Number of values of one impact, with the ID of its partner.
  static constexpr int values_each = 1 + sizeof(Impact) / sizeof(double);

  // Key of an impact. Keys are separate from the impacts for speed, because every step searches the
  // keys.
  struct Key {
    Partner partner;
    bool touched;  // whether the contact was reported in this step
  };
  struct Held {
    int id = 0;  // ID of the particle at the end of the last run, 0 if new
    std::vector<Key> keys;
    std::vector<Impact> impacts;
  };
  std::vector<Held> held_;  // impacts by local particle index
};

}  // namespace plastigran
