// SPDX-License-Identifier: GPL-2.0-or-later
//
// Access to the fixes in which LIGGGHTS stores contact histories by particle. A fix for pairs or
// meshes stores a list of partners with values for each. A fix for a primitive wall stores the
// values of one contact.
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
  // Layout of the history values of one particle. With `has_partners`, they are the number of
  // contacts, and for each contact the ID of the partner and `width` values. Otherwise they are the
  // `width` values of one contact.
  struct Layout {
    bool has_partners, has_particles;  // has_particles: the partners are particles
    int width;

    // Returns whether any history value differs from zero.
    bool any(const double* values, int count) const;

    // For pairs: replaces the IDs of partners by their new IDs, and omits contacts with deleted
    // partners. Returns the new number of values.
    int replace_partner_ids(double* values, int count, const NewIds& ids) const;
  };

  explicit StoredHistories(LAMMPS_NS::Fix* fix);

  Layout layout() const { return {has_partners_, of_pairs_, width()}; }

  // Copies the histories of pairs from the neighbor lists to the fix. Call this function before the
  // functions below.
  void update() {
    if (has_partners_) fix_->setup_pre_exchange();
  }

  std::size_t size_of(int i) const;
  std::vector<double> of(int i) const;

  // For pairs: replaces the IDs of partners of `count` particles by their new IDs, and omits
  // contacts with deleted partners.
  void replace_partner_ids(int count, const NewIds& ids);

  // Sets the history values of a particle.
  void set(int i, const double* values, int count);

  void clear(int i);

 private:
  int width() const;

  LAMMPS_NS::Fix* fix_;
  bool has_partners_, of_pairs_;
};

// Returns a hash of the geometry of the primitive wall to which `histories` belongs; 0 for meshes
// and pairs.
std::uint64_t primitive_wall_position(LAMMPS_NS::LAMMPS* engine, const LAMMPS_NS::Fix* histories);

// Returns a hash of the geometry of the primitive wall or mesh to which `histories` belongs; 0 for
// pairs. Collective.
std::uint64_t wall_position(LAMMPS_NS::LAMMPS* engine, const LAMMPS_NS::Fix* histories);

}  // namespace plastigran
