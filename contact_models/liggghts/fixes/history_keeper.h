// SPDX-License-Identifier: GPL-2.0-or-later
//
// Keeps contact histories that LIGGGHTS would lose, in three cases:
//
// - Between two runs. LIGGGHTS finds the histories of pairs by particle indices and IDs, which
//   commands may change (delete_atoms, create_atoms, displace_atoms, change_box). At the end of a
//   run, this fix therefore lets LIGGGHTS store the histories by particle. In the next setup, this
//   fix replaces partner IDs that have changed. LIGGGHTS also discards the histories of a line that
//   is given again. This fix copies them first (kept_fixes.h), and restores them in the next setup
//   if the line has the same law with the same options. The log reports contacts that start without
//   history, or continue with other constants.
// - In restart files. LIGGGHTS stores the models of the contacts. This fix adds their settings.
// - At a step of the `restart` command. LIGGGHTS stores the histories of pairs as they are at the
//   beginning of the step. This fix stores them again at its end.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "liggghts/fixes/contact_line.h"
#include "liggghts/fixes/particle_ids.h"
#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/fixes/stored_histories.h"

namespace plastigran {

class HistoryKeeper : public PluginFix {
 public:
  HistoryKeeper(LAMMPS_NS::LAMMPS* engine, int count, char** words);
  ~HistoryKeeper();
  static const char* id() { return "plastigran_history"; }
  static const char* style() { return "plastigran/history"; }

  // Returns the HistoryKeeper; adds it if there is none. Callers must call restarted_lines() in
  // their own constructor, save the result, and pass it as `restarted`. Later, the lines may be
  // missing: LIGGGHTS discards the data of the restart file when it initializes the first wall.
  static HistoryKeeper* of(LAMMPS_NS::LAMMPS* engine, const std::string& restarted);

  // Returns the contact lines from the restart file, as text of restart_text(). They are available
  // until the first run.
  static std::string restarted_lines(LAMMPS_NS::LAMMPS* engine);

  // Registers the pair_style or wall line of a contact model before each run. Stops if the restart
  // file has contacts of other models. Collective.
  void connect(const std::string& owner, const ContactLine& line);

  // Returns the settings of the pair style or wall `owner` from the restart file. If the file has
  // none, warns and returns an empty string.
  std::string restarted_settings(const std::string& owner) const;

  // Copies the histories of a fix before LIGGGHTS deletes it. Does nothing if the keeper does not
  // keep the histories of this fix.
  void copy(LAMMPS_NS::Fix* fix);

  int setmask() override;
  void setup_pre_exchange() override;
  void setup(int) override { stored_.clear(); }
  void end_of_step() override;
  void post_run() override;

  void write_restart(FILE* file) override;
  void restart(char* data) override { restarted_ = read_restart_text(data); }

  void grow_arrays(int size) override { ids_.resize(size); }
  void copy_arrays(int from, int to, int) override { ids_[to] = ids_[from]; }
  void set_arrays(int i) override { ids_[i] = 0; }
  int pack_exchange(int i, double* buffer) override { return *buffer = ids_[i], 1; }
  int unpack_exchange(int i, double* buffer) override { return ids_[i] = *buffer, 1; }
  double memory_usage() override { return ids_.size() * sizeof(int); }

 private:
  // Histories of one fix of LIGGGHTS at the end of a run.
  struct Stored {
    std::string owner, models, fix;
    StoredHistories::Layout layout;
    std::uint64_t position;  // hash from wall_position(); 0 for pairs
    bool is_copy;            // false: the fix has the histories; true: `records` has them
    ParticleRecords records;
  };

  ContactLines with_host_pair_style(const ContactLines& lines) const;
  void begin_storage();
  void restore_lost_histories();
  bool can_continue(const Stored& stored, const ContactLine& line, LAMMPS_NS::Fix* fix) const;
  bool any_history(const Stored& stored) const;
  bool any_history(const ContactLine& line) const;
  void restore(const Stored& stored, LAMMPS_NS::Fix* fix) const;
  void clear_moved_walls(const ContactLines& restarted);
  void warn_of_new_constants(const ContactLines& former) const;
  void warn_on_first_rank(const std::string& text) const;

  ContactLines connected_;      // lines that models have registered since the last setup
  ContactLines lines_;          // lines of the current or last run, or of the restart file
  ContactLines restarted_;      // lines of the restart file whose owners have not connected yet
  std::vector<Stored> stored_;  // histories kept between two runs
  std::vector<int> ids_;        // IDs of local particles at the end of the last run, 0 if new
  long particle_total_ = 0;     // number of particles on all ranks at the end of the last run
};

}  // namespace plastigran
