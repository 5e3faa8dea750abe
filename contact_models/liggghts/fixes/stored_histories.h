// SPDX-License-Identifier: GPL-2.0-or-later
//
// The engine's fixes that store what contacts remember, by particle: those of pairs and of meshes
// have a list of partners with values for each, those of primitive walls the values of one contact.
#pragma once

#include <cstdint>
#include <vector>

#include "fix.h"
#include "liggghts/fixes/particle_numbers.h"

namespace LAMMPS_NS {
class LAMMPS;
}

namespace plastigran {

class StoredHistories {
 public:
  explicit StoredHistories(LAMMPS_NS::Fix* fix);

  // Pairs: takes the histories from the neighbour lists. All: makes what follows possible.
  void update() {
    if (listed_) fix_->setup_pre_exchange();
  }

  int width() const;  // values of a contact
  bool listed() const { return listed_; }

  // How many values of() has.
  int size_of(int i) const;

  // The values of a particle, with the number of its contacts first, if any.
  std::vector<double> of(int i) const;

  // The same for particles numbered anew; a contact whose partner is gone is left out.
  void set(int i, const double* values, int count, const NewNumbers& numbers);

  void forget(int i);

  // Whether a particle's contacts remember anything: values other than zero.
  bool remembers(int i) const;

  // The same of what of() has returned.
  static bool remembers(const double* values, int count, int width, bool listed);

 private:
  LAMMPS_NS::Fix* fix_;
  bool listed_, of_pairs_;
};

// A number for where the primitive wall is whose histories these are, the same on each rank; 0 for
// others.
std::uint64_t primitive_wall_position(LAMMPS_NS::LAMMPS* engine, const LAMMPS_NS::Fix* histories);

// A number for where the wall or the triangles of the mesh are whose histories these are; 0 for
// pairs. All ranks together.
std::uint64_t wall_position(LAMMPS_NS::LAMMPS* engine, const LAMMPS_NS::Fix* histories);

}  // namespace plastigran
