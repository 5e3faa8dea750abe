// SPDX-License-Identifier: GPL-2.0-or-later
//
// `fix ID all heat/dissipation`: contact dissipation heats the particles of fix heat/gran.
// docs/heat.md defines how the bodies share the heat.
//
// Heat is added to LIGGGHTS' heat flux, which fix heat/gran integrates at the end of a step and
// clears at the beginning of the next one. The laws return the plastic work. The work of friction
// and dashpots is integrated as in velocity Verlet: half a step with the old force and half a step
// with the new force. This work is summed per contact, because each of the two bodies receives half
// of the heat. A rank does not have the velocities of ghosts at that time, so it computes only the
// work on its own particles. It then sends the ghost's share of the heat to the rank that owns the
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
  // Elements of the fix's vector f_ID[1], f_ID[2], ...: energies since the fix was created [J].
  enum Entry {
    FROM_PLASTIC_WORK,  // heat of the particles from plastic work
    FROM_FRICTION,      // heat of the particles, from friction, rolling friction and dashpots
    TO_WALLS,           // heat of walls from plastic work, friction and dashpots
    STORED,             // plastic work of particles and walls that does not become heat
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

  // Adds the heat of the old forces. At this time, positions are new and velocities are at
  // mid-step.
  void post_integrate() override { deliver(); }

  // Adds the heat of the new forces. At this time, velocities are at mid-step.
  void pre_final_integrate() override { deliver(); }

  int pack_reverse_comm(int count, int first, double* buffer) override;
  void unpack_reverse_comm(int count, int* list, double* buffer) override;

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
  LAMMPS_NS::FixPropertyAtom* flux_ = nullptr;  // heat flux of each particle in LIGGGHTS [W]
  std::vector<PairContact> pairs_;  // contacts on this rank in the last force computation
  std::vector<WallContact> walls_;
  std::vector<double> heat_;   // heat of local and ghost particles, not yet in the flux [J]
  double sums_[ENTRIES] = {};  // elements of the fix's vector, summed on this rank [J]
};

}  // namespace plastigran
