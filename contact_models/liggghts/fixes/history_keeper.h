// SPDX-License-Identifier: GPL-2.0-or-later
//
// Keeps what contacts remember where the engine loses it.
//
// Between two runs the engine finds the pairs' histories by places and numbers of particles that
// commands may have changed since (delete_atoms, create_atoms, displace_atoms, change_box), and
// forgets those of a pair style or wall whose line is given again. Here they are stored at the end
// of a run, by particle, and handed back as the next one is set up, where the engine has not kept
// the same. They go to the contacts of the same law with the same options; where those are others,
// the log says that contacts begin anew, and where only their constants are others, it says that.
//
// Restart files: the engine's say which models contacts have, not their settings; this fix adds
// these. At a step of the `restart` command the engine stores the pairs' histories at the step's
// beginning, before its forces have advanced them: this fix stores them again at its end.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "liggghts/fixes/plugin_fix.h"
#include "liggghts/fixes/particle_numbers.h"

namespace plastigran {

class HistoryKeeper : public PluginFix {
 public:
  // The line of a pair style or wall.
  struct Line {
    std::string models;                  // the law, its options and the models beside it
    std::string settings;                // all that the line may set: NAME WORD NAME WORD ...
    std::vector<std::string> histories;  // IDs of the engine's fixes that store the memory, if any
    std::string constants;               // of each two atom types a line; empty: no memory
    bool given_anew = false;             // since the last run
    std::string report;                  // the constants as the log has them; empty: said before
    std::uint64_t place = 0;             // of a primitive wall, in the run that has the line
  };

  HistoryKeeper(LAMMPS_NS::LAMMPS* engine, int count, char** words);
  ~HistoryKeeper();
  static const char* id() { return "plastigran_history"; }
  static const char* style() { return "plastigran/history"; }

  // The keeper, made when there is none. `restarted` is what restarted_lines() was when the
  // caller's line was read: LIGGGHTS has discarded it when the first wall is initialised.
  static HistoryKeeper* of(LAMMPS_NS::LAMMPS* engine, const std::string& restarted);

  // What the restart file that was read holds of all lines, as long as no run has begun.
  static std::string restarted_lines(LAMMPS_NS::LAMMPS* engine);

  // From a model before each run: `owner` is "pair_style" or "fix ID". Stops when the contacts that
  // a restart file has of this owner are those of other models. All ranks together.
  void connect(const std::string& owner, const Line& line);

  // The models of an owner's contacts in the restart file that was read, as of `Line`, as long as
  // no run has begun; empty where they are none of ours.
  static std::string restarted_models(LAMMPS_NS::LAMMPS* engine, const std::string& owner);

  // Stops: the restart file has contacts of other models than the owner's line.
  [[noreturn]] static void refuse_other_models(LAMMPS_NS::LAMMPS* engine, const std::string& owner,
                                               const std::string& restarted,
                                               const std::string& models);

  // What a restart file says of an owner's settings; without a word of it, a warning and nothing.
  std::string restarted_settings(const std::string& owner) const;

  int setmask() override;
  void setup_pre_exchange() override;
  void setup(int) override { forget(); }
  void end_of_step() override;
  void post_run() override;

  void write_restart(FILE* file) override;
  void restart(char* data) override;

  void grow_arrays(int size) override { numbers_.resize(size); }
  void copy_arrays(int from, int to, int) override { numbers_[to] = numbers_[from]; }
  void set_arrays(int i) override { numbers_[i] = 0; }
  int pack_exchange(int i, double* buffer) override { return *buffer = numbers_[i], 1; }
  int unpack_exchange(int i, double* buffer) override { return numbers_[i] = *buffer, 1; }
  double memory_usage() override { return numbers_.size() * sizeof(int); }

 private:
  typedef std::map<std::string, Line> Lines;
  static Lines lines_of_file(const std::string& text);
  static constexpr char pair_owner[] = "pair_style", pair_histories[] = "contacthistory";

  // A fix with histories when they were stored.
  struct Kept {
    std::string owner, models, fix;
    int width;            // values of a contact
    bool listed;          // as of StoredHistories
    std::uint64_t place;  // of a wall's histories: where it is
  };

  void forget() { records_ = ParticleRecords(), kept_.clear(); }
  Lines all_lines(const Lines& ours) const;
  bool goes_on(const Kept& kept, const Line& line, LAMMPS_NS::Fix* fix) const;
  void give_back_what_is_lost();
  void note_places();
  void forget_walls_elsewhere(const Lines& restarted);
  void report_constants() const;
  void warn_of_other_constants(const Lines& former) const;
  bool remembers(const std::string& owner) const;
  void hand_back(const std::vector<LAMMPS_NS::Fix*>& fixes);
  bool is_intact(std::size_t which, LAMMPS_NS::Fix* fix) const;
  bool any_remembers(std::size_t which) const;
  const double* record_of(int i, std::size_t which) const;

  Lines connected_;         // since the last set-up
  Lines lines_;             // of the run under way, or the last one, which a restart file may be of
  Lines in_file_;           // what a restart file says, until the owner connects
  std::vector<Kept> kept_;  // what each record has, in this order
  ParticleRecords records_;     // by the particles' numbers at the end of the run
  std::vector<int> numbers_;    // by local particle: these numbers, 0 for new ones
  long total_ = 0;              // particles at the end of the run
  int page_ = 0, largest_ = 0;  // neigh_modify `page` and `one` at the end of the run
};

}  // namespace plastigran
