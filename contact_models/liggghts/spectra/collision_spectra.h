// SPDX-License-Identifier: GPL-2.0-or-later
//
// `fix ID all collision_spectra EVERY file FILE [per_decade N]`: how many impacts there
// were, by speed, by energy and by force, between which atom types and with which walls. Written as
// a table every so many steps. docs/collision_spectra.md says what counts as an impact.
//
// A contact that is reported in a step and was not in the step before begins an impact; one that is
// no longer reported has ended it. So neither neighbour lists nor contact histories matter. Work of
// friction and dashpots is summed as velocity Verlet does it: the mean of a step's two forces along
// the displacement between them.
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

  // Elements of the fix's vector, in the order users see, from 1 on, since the fix was made.
  enum Entry {
    IMPACTS,         // counted
    UNDER_WAY,       // contacts at present
    IMPACT_ENERGY,   // dissipated in the impacts counted [J]
    CONTACT_ENERGY,  // dissipated in other contacts: under way, or there before counting began [J]
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

  // Impacts counted since the fix was made.
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
  std::size_t number_of(const void* owner) const;
  void go_on(Impact& impact, const Contact& contact, const AccountedLoad& on_i,
             const LossyLoad& load, bool turned, bool first);
  void count(Partner partner, const Impact& impact);
  void write_table();

  LAMMPS_NS::bigint every_ = 0;  // steps
  int per_decade_ = 10;
  std::string path_;
  std::unique_ptr<FILE, int (*)(FILE*)> file_;  // on the first rank
  ImpactRecords records_;
  std::vector<int> contacts_;                            // of each particle in this step
  int most_contacts_ = 0;                                // that one had
  Tally tally_;                                          // of this rank since the last table
  double impacts_ = 0, impact_energy_ = 0, energy_ = 0;  // the last of all contacts; on this rank
  long total_ = 0;                     // particles as the last run ended, 0 before the first
  std::vector<std::string> wall_ids_;  // by number; a wall keeps its number
  std::vector<const void*> walls_;     // the same, null when there is none of that ID now
};

}  // namespace plastigran
