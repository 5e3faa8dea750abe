// SPDX-License-Identifier: GPL-2.0-or-later
#include "lammps/contact_tally.h"

#include <algorithm>

#include "atom.h"
#include "force.h"
#include "lammps.h"
#include "update.h"

namespace plastigran {

using LAMMPS_NS::Granular_NS::GranularModel;

void ContactTally::begin(LAMMPS_NS::LAMMPS* lammps) {
  LAMMPS_NS::Atom* const atom = lammps->atom;
  active_ = true;
  newton_ = lammps->force->newton_pair;
  nlocal_ = atom->nlocal;
  velocities_ = atom->nmax > 0 ? atom->v[0] : nullptr;
  balance_ = EnergyBalance::of(lammps);
  run_begins_ = lammps->update->ntimestep <= lammps->update->firststep + 1;
  contacts = elastic_energy = surface_energy = spring_energy = 0;
  wall_load_ = WallLoad();
}

// Adds half of the plastic work to each particle of a pair. With `newton off`, two ranks compute a
// pair that has a ghost particle. Each of them then adds only the half of its own particle.
void ContactTally::add_dissipated(const GranularModel& contact, double plastic_work,
                                  double adhesion_loss) {
  const bool is_pair = contact.contact_type == LAMMPS_NS::Granular_NS::PAIR;
  const bool shared = is_shared(contact);
  balance_->add_dissipated((shared ? 0.5 : 1) * plastic_work, (shared ? 0.5 : 1) * adhesion_loss);
  balance_->add_to_particle(index(contact.vi), (is_pair ? 0.5 : 1) * plastic_work);
  if (is_pair && !shared) balance_->add_to_particle(index(contact.vj), 0.5 * plastic_work);
}

// Decks can move particles between two runs, so an overlap in the first step of a run may result
// from a command instead of motion. Therefore the RangeAccount also receives `run_begins_`, which
// marks this step.
void ContactTally::add_deep(const GranularModel& contact, const RuntimeLaw& law,
                            RangeAccount& account, double factor, const double* before,
                            const double* now) {
  if (!active_) return;
  const double closing = std::max(0.0, -contact.vnnr) * contact.dt;
  law.count(account, factor,
            {contact.Reff, contact.delta, closing, before, now, run_begins_,
             is_shared(contact) ? 0.5 : 1});
}

void ContactTally::add_loads(const GranularModel& contact, double viscous) {
  if (!active_) return;
  const bool is_pair = contact.contact_type == LAMMPS_NS::Granular_NS::PAIR;
  if (!is_pair)
    for (int k = 0; k < 3; ++k) wall_load_.force[k] += contact.forces[k];
  if (!balance_) return;
  ParticleLoad on_i, on_j;
  for (int k = 0; k < 3; ++k) {
    on_i.friction[k] = contact.forces[k] - contact.Fntot * contact.nx[k];
    on_i.dashpot[k] = viscous * contact.nx[k];
    on_i.torque[k] = contact.torquesi[k];
    on_j.friction[k] = -on_i.friction[k];
    on_j.dashpot[k] = -on_i.dashpot[k];
    on_j.torque[k] = contact.torquesj[k];
  }
  balance_->add_load(index(contact.vi), on_i);
  if (!is_pair) {
    balance_->add_wall(contact.forces, on_i, contact.vj);
    for (int k = 0; k < 3; ++k) {
      wall_load_.lossy.friction[k] += on_i.friction[k];
      wall_load_.lossy.dashpot[k] += on_i.dashpot[k];
    }
  } else if (!is_shared(contact)) {
    balance_->add_load(index(contact.vj), on_j);
  }
}

}  // namespace plastigran
