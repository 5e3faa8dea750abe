// SPDX-License-Identifier: GPL-2.0-or-later
//
// Fix `fix ID all collision_spectra EVERY file FILE [per_decade N]`. Counts impacts by speed,
// energy and force, for each pair of atom types and each wall. Writes a table every EVERY steps.
// docs/collision_spectra.md defines an impact.
//
// An impact begins with the first step in which its contact is reported, and ends with the first
// step in which it is not. Neighbor lists and contact histories do not affect the counts. The work
// of friction and dashpots is integrated as in velocity Verlet: mean of the old and new force times
// the displacement of the step.
#pragma once

#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "liggghts/observers/contact_observer.h"
#include "liggghts/spectra/impact_records.h"
#include "liggghts/spectra/tally.h"

namespace plastigran {

class CollisionSpectra : public ContactObserver {
 public:
  enum Quantity { NORMAL_SPEED, DISSIPATED_ENERGY, LARGEST_FORCE };

  // Elements of the fix's vector f_ID[1], f_ID[2], ...: totals since the fix was created.
  enum Entry {
    IMPACTS,         // number of counted impacts
    CURRENT,         // number of current contacts
    IMPACT_ENERGY,   // energy dissipated in counted impacts [J]
    CONTACT_ENERGY,  // energy dissipated in current contacts and contacts older than the fix [J]
    ENTRIES
  };

  CollisionSpectra(LAMMPS_NS::LAMMPS* engine, int count, char** words);
  ~CollisionSpectra();
  static const char* style() { return "collision_spectra"; }

  int setmask() override;
  void init() override;
  void add(const Contact& contact, const AccountedLoad& on_i, const Load& on_j,
           const void* owner) override;
  void setup_pre_exchange() override;
  void pre_exchange() override;
  void end_of_step() override;
  void post_run() override;

  double compute_scalar() override { return compute_vector(IMPACTS); }
  double compute_vector(int entry) override;

  void grow_arrays(int size) override { records_.resize(size), contacts_.resize(size); }
  void copy_arrays(int from, int to, int) override { records_.copy(from, to); }
  void set_arrays(int i) override { records_.clear(i); }
  int pack_exchange(int i, double* buffer) override { return records_.write(i, buffer); }
  int unpack_exchange(int i, double* buffer) override { return records_.read(i, buffer); }
  int pack_restart(int i, double* buffer) override;
  void unpack_restart(int i, int nth) override;
  int size_restart(int i) override { return 1 + records_.size(i); }
  int maxsize_restart() override;
  void write_restart(FILE* file) override;
  void restart(char* data) override;

 private:
  void read_words(int count, char** words);
  void open(const std::string& path);
  std::size_t wall_number(const void* owner) const;
  void advance(Impact& impact, const Contact& contact, const AccountedLoad& on_i,
               const LossyLoad& load, bool exchanged, bool first);
  void count(Partner partner, const Impact& impact);
  void write_table();

  LAMMPS_NS::bigint every_ = 0;  // number of steps between two tables
  int per_decade_ = 10;
  std::string path_;
  std::unique_ptr<FILE, int (*)(FILE*)> file_;  // output file, open on rank 0
  ImpactRecords records_;
  std::vector<int> contacts_;               // number of contacts of each particle in this step
  int most_contacts_ = 0;                   // largest number of contacts of a particle so far
  Tally tally_;                             // impacts on this rank since the last table
  double impacts_ = 0, impact_energy_ = 0;  // number and energy [J] of counted impacts, this rank
  double energy_ = 0;                       // dissipated energy of all contacts on this rank [J]
  long particle_total_ = 0;            // particles at the end of the last run; 0 before the first
  std::vector<std::string> wall_ids_;  // IDs of walls; the index of a wall never changes
  std::vector<const void*> walls_;     // walls at the same indices; null if removed
};

}  // namespace plastigran
