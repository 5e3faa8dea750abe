// SPDX-License-Identifier: GPL-2.0-or-later
#include "lammps/contact_tally.h"

#include <algorithm>

#include "atom.h"
#include "force.h"
#include "lammps.h"

namespace plastigran {

void ContactTally::begin(LAMMPS_NS::LAMMPS* lammps, bool clears_ghosts) {
  LAMMPS_NS::Atom* const atom = lammps->atom;
  active_ = true;
  newton_ = lammps->force->newton_pair;
  nlocal_ = atom->nlocal;
  velocities_ = atom->nmax > 0 ? atom->v[0] : nullptr;
  contacts = elastic_energy = surface_energy = 0;
  for (int k = 0; k < 2; ++k) {
    int is_double, columns;
    const int at = atom->find_custom(particle_values[k], is_double, columns);
    dissipated_[k] = at >= 0 && is_double == 1 && columns == 0 ? atom->dvector[at] : nullptr;
    if (dissipated_[k] && clears_ghosts) std::fill_n(dissipated_[k] + nlocal_, atom->nghost, 0.0);
  }
}

// Each particle of a pair gets half. With `newton off`, the other rank adds the half of the ghost.
void ContactTally::add_dissipated(const LAMMPS_NS::Granular_NS::GranularModel& contact,
                                  const Dissipated& dissipated) {
  const bool is_pair = contact.contact_type == LAMMPS_NS::Granular_NS::PAIR;
  for (int k = 0; k < 2; ++k) {
    if (!dissipated_[k]) continue;
    dissipated_[k][index(contact.vi)] += (is_pair ? 0.5 : 1) * dissipated.energy[k];
    if (is_pair && !is_shared(contact))
      dissipated_[k][index(contact.vj)] += 0.5 * dissipated.energy[k];
  }
}

}  // namespace plastigran
