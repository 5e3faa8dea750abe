// SPDX-License-Identifier: GPL-2.0-or-later
//
// `fix ID all heat/dissipation`: what contacts dissipate warms the particles that the engine's fix
// heat/gran follows. docs/heat.md says how it is shared.
//
// Heat is added to the engine's heat flux, which its transport equation integrates at the end of
// the step and clears at the next one's beginning. Plastic work comes from the laws as it is done.
// The work of friction and dashpots is summed as velocity Verlet does it, half a step of the old
// force and half a step of the new one, contact by contact, because its two bodies share it
// equally. A ghost's half goes to the rank of its particle, and the ghost's velocity, which a rank
// does not have at the right moment, is not needed: each rank takes the work done on its own
// particle.
#pragma once

#include <vector>

#include "fix_property_atom.h"
#include "liggghts/heat/body_shares.h"
#include "liggghts/model/lossy_load.h"
#include "liggghts/model/wall_point.h"
#include "liggghts/observers/contact_observer.h"

namespace plastigran {

class DissipationHeat : public ContactObserver {
 public:
  // Elements of the fix's vector, in the order users see, from 1 on, since the fix was made [J].
  enum Entry {
    FROM_PLASTIC_WORK,  // heat of the particles
    FROM_FRICTION,      // heat of the particles, from friction, rolling friction and dashpots
    TO_WALLS,           // heat that walls took, of both kinds
    STORED,             // plastic work that is not heat, of particles and walls
    ENTRIES
  };

  DissipationHeat(LAMMPS_NS::LAMMPS* engine, int count, char** words);
  static const char* style() { return "heat/dissipation"; }

  int setmask() override;
  void init() override;
  void add(const Contact& contact, const AccountedLoad& on_i, const Load& on_j,
           const void* owner) override;

  void setup_pre_force(int) override { begin_pass(); }
  void pre_force(int) override { begin_pass(); }

  // Positions are new, velocities those at mid-step, forces still the old ones.
  void post_integrate() override { deliver(); }

  // The new forces, and still the velocities at mid-step.
  void pre_final_integrate() override { deliver(); }

  int pack_reverse_comm(int count, int first, double* buffer) override;
  void unpack_reverse_comm(int count, int* list, double* buffer) override;

  // Heat of the particles.
  double compute_scalar() override;
  double compute_vector(int entry) override;

  void write_restart(FILE* file) override;
  void restart(char* data) override;

 private:
  struct PairContact {
    int i, j;
    LossyLoad load;
  };
  struct WallContact {
    int i;
    LossyLoad load;
    WallPoint point;
  };

  void add_plastic_work(const Contact& contact, double work);
  void begin_pass();
  void deliver();
  void add_lossy_work();
  double work_on(int i, const Vector& force, const Vector& torque) const;

  BodyShares shares_;
  bool described_ = false;
  LAMMPS_NS::FixPropertyAtom* flux_ = nullptr;  // the engine's [W]
  std::vector<PairContact> pairs_;              // of the last force computation, on this rank
  std::vector<WallContact> walls_;
  std::vector<double> heat_;   // by particle with ghosts, not yet delivered [J]
  double sums_[ENTRIES] = {};  // on this rank
};

}  // namespace plastigran
