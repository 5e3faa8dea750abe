// SPDX-License-Identifier: GPL-2.0-or-later
//
// LIGGGHTS' fixes that store contact histories by particle. Those of pairs and meshes have a list
// of partners with values for each, those of primitive walls have the values of one contact.
#pragma once

#include <cstdint>
#include <vector>

#include "fix.h"
#include "liggghts/fixes/particle_ids.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace plastigran {

class StoredHistories {
 public:
  // The layout of the values of a particle.
  struct Layout {
    bool has_partners;  // number of contacts, then ID of the partner and values of each contact
    int width;          // values of a contact

    // Whether any history value differs from zero.
    bool any(const double* values, int count) const;
  };

  explicit StoredHistories(LAMMPS_NS::Fix* fix);

  Layout layout() const { return {has_partners_, width()}; }

  // Copies the histories of pairs from the neighbor lists. The functions below need that.
  void update() {
    if (has_partners_) fix_->setup_pre_exchange();
  }

  std::size_t size_of(int i) const;
  std::vector<double> of(int i) const;

  // Sets the values of a particle after a renumbering, without contacts of deleted partners.
  void set(int i, const double* values, int count, const NewIds& ids);

  void clear(int i);

 private:
  int width() const;

  LAMMPS_NS::Fix* fix_;
  bool has_partners_, of_pairs_;
};

// A hash of the geometry of the primitive wall with these histories; 0 for others.
std::uint64_t primitive_wall_position(LAMMPS_NS::LAMMPS* engine, const LAMMPS_NS::Fix* histories);

// A hash of the geometry of the primitive wall or the mesh with these histories; 0 for pairs.
// Collective.
std::uint64_t wall_position(LAMMPS_NS::LAMMPS* engine, const LAMMPS_NS::Fix* histories);

}  // namespace plastigran
