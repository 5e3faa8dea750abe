// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/history_keeper.h"

#include <mpi.h>

#include <algorithm>
#include <utility>

#include "atom.h"
#include "comm.h"
#include "force.h"
#include "liggghts/fixes/engine_access.h"
#include "liggghts/fixes/stored_histories.h"
#include "modify.h"
#include "neighbor.h"
#include "pair_gran.h"
#include "liggghts/fixes/print.h"

namespace plastigran {

HistoryKeeper::HistoryKeeper(LAMMPS_NS::LAMMPS* engine, int count, char** words)
    : PluginFix(engine, count, words) {
  nevery = 1;
  restart_global = 1;
  create_attribute = 1;
  grow_arrays(atom->nmax);
  atom->add_callback(0);
}

HistoryKeeper::~HistoryKeeper() { atom->delete_callback(Fix::id, 0); }

int HistoryKeeper::setmask() {
  using namespace LAMMPS_NS::FixConst;
  return PRE_EXCHANGE | END_OF_STEP;  // the first for setup_pre_exchange
}

// With the line of a pair style of the engine's own, whose contacts are kept as well.
HistoryKeeper::Lines HistoryKeeper::all_lines(const Lines& ours) const {
  Lines lines = ours;
  LAMMPS_NS::Pair* const pair = force->pair_match("gran", 1);
  if (pair && !lines.count(pair_owner)) {
    const auto hash = static_cast<LAMMPS_NS::PairGran*>(pair)->hashcode();
    lines[pair_owner] = {"the engine's " + std::to_string(hash), "", {pair_histories}, ""};
  }
  return lines;
}

void HistoryKeeper::post_run() {
  forget();
  std::vector<StoredHistories> stored;
  for (const auto& [owner, line] : all_lines(lines_))
    for (const std::string& id : line.histories) {
      LAMMPS_NS::Fix* const fix = modify->find_fix_id(id.c_str());
      if (!fix) continue;
      stored.emplace_back(fix);
      stored.back().update();
      kept_.push_back({owner, line.models, id, stored.back().width(), stored.back().listed(),
                       wall_position(lmp, fix)});
    }
  std::size_t values = 0;
  for (int i = 0; i < atom->nlocal; ++i)
    for (const StoredHistories& histories : stored) values += 1 + histories.size_of(i);
  records_.reserve(atom->nlocal, values);
  for (int i = 0; i < atom->nlocal; ++i) {
    numbers_[i] = atom->tag[i];
    records_.begin(atom->tag[i]);
    for (const StoredHistories& histories : stored) {
      const std::vector<double> values = histories.of(i);
      const double count = values.size();
      records_.append(&count, 1);
      records_.append(values.data(), values.size());
    }
  }
  page_ = neighbor->pgsize, largest_ = neighbor->oneatom;
  total_ = atom->nlocal;
  MPI_Allreduce(MPI_IN_PLACE, &total_, 1, MPI_LONG, MPI_SUM, world);
}

// Whether those who have these histories now can go on with them.
bool HistoryKeeper::goes_on(const Kept& kept, const Line& line, LAMMPS_NS::Fix* fix) const {
  return line.models == kept.models && StoredHistories(fix).width() == kept.width &&
         wall_position(lmp, fix) == kept.place;
}

void HistoryKeeper::setup_pre_exchange() {
  const Lines former = std::exchange(lines_, std::exchange(connected_, {}));
  report_constants();
  note_places();
  if (kept_.empty())
    forget_walls_elsewhere(former);
  else
    give_back_what_is_lost();
  warn_of_other_constants(former);
}

void HistoryKeeper::note_places() {
  for (auto& [owner, line] : lines_)
    for (const std::string& id : line.histories)
      if (const LAMMPS_NS::Fix* const fix = modify->find_fix_id(id.c_str()))
        line.place = primitive_wall_position(lmp, fix);
}

// After a restart: a wall of the same ID elsewhere is another one.
void HistoryKeeper::forget_walls_elsewhere(const Lines& restarted) {
  for (const auto& [owner, line] : lines_) {
    const auto before = restarted.find(owner);
    if (before == restarted.end() || !before->second.place || before->second.place == line.place)
      continue;
    if (remembers(owner) && comm->me == 0)
      warn(lmp, owner +
                    ": contacts start without history, because the wall stands elsewhere than "
                    "when the restart file was written");
    for (const std::string& id : line.histories)
      for (int i = 0; i < atom->nlocal; ++i)
        StoredHistories(modify->find_fix_id(id.c_str())).forget(i);
  }
}

void HistoryKeeper::give_back_what_is_lost() {
  records_.fetch(numbers_.data(), atom->nlocal, world);
  const Lines lines = all_lines(lines_);
  std::vector<LAMMPS_NS::Fix*> fixes;  // null: nothing is handed back
  for (std::size_t k = 0; k < kept_.size(); ++k) {
    const Kept& kept = kept_[k];
    fixes.push_back(nullptr);
    const auto line = lines.find(kept.owner);
    LAMMPS_NS::Fix* const fix = modify->find_fix_id(kept.fix.c_str());
    if (line == lines.end()) continue;
    // Walls lose theirs with their line alone.
    if (kept.owner != pair_owner && !line->second.given_anew) continue;
    if (fix && !fix->just_created && is_intact(k, fix)) continue;
    if (fix && goes_on(kept, line->second, fix)) {
      fixes.back() = fix;
      fix->just_created = 0;  // the engine blanks what a new fix has as a run begins
    } else if (any_remembers(k) && comm->me == 0) {
      warn(lmp,
           kept.owner + ": contacts start without history, because " +
               (kept.models == line->second.models ? "the wall moved: `" + kept.models + '`'
                                                   : "their models changed from `" + kept.models +
                                                         "` to `" + line->second.models + '`'));
    }
  }
  if (std::any_of(fixes.begin(), fixes.end(), [](const auto* fix) { return fix; }))
    hand_back(fixes);
}

// Whether a fix still has what was kept of it, and no particle has another number. All ranks
// together. Where the deck has changed the sizes of pages, the engine has freed what the fix points
// to: that is not looked at.
bool HistoryKeeper::is_intact(std::size_t which, LAMMPS_NS::Fix* fix) const {
  int intact = page_ == neighbor->pgsize && largest_ == neighbor->oneatom;
  for (int i = 0; intact && i < atom->nlocal; ++i) {
    const double* const record = record_of(i, which);
    intact = record && numbers_[i] == atom->tag[i];
    if (!intact) break;
    const std::vector<double> held = StoredHistories(fix).of(i);
    intact = held.size() == *record && std::equal(held.begin(), held.end(), record + 1);
  }
  MPI_Allreduce(MPI_IN_PLACE, &intact, 1, MPI_INT, MPI_MIN, world);
  return intact;
}

// What was kept of a particle in one of the histories, its length first; null for a new one.
const double* HistoryKeeper::record_of(int i, std::size_t which) const {
  int length = 0;
  const double* values = records_.of(numbers_[i], length);
  for (std::size_t k = 0; values && k < which; ++k) values += 1 + static_cast<int>(*values);
  return values;
}

// Whether a contact had a memory in one of the histories kept. All ranks together.
bool HistoryKeeper::any_remembers(std::size_t which) const {
  int remembers = 0;
  for (int i = 0; i < atom->nlocal; ++i) {
    const double* const record = record_of(i, which);
    const Kept& kept = kept_[which];
    if (record && StoredHistories::remembers(record + 1, *record, kept.width, kept.listed))
      remembers = 1;
  }
  MPI_Allreduce(MPI_IN_PLACE, &remembers, 1, MPI_INT, MPI_MAX, world);
  return remembers;
}

void HistoryKeeper::hand_back(const std::vector<LAMMPS_NS::Fix*>& fixes) {
  const NewNumbers numbers(numbers_.data(), atom->tag, atom->nlocal, total_, world);
  for (int i = 0; i < atom->nlocal; ++i) {
    int length = 0;
    const double* values = records_.of(numbers_[i], length);
    for (LAMMPS_NS::Fix* const fix : fixes) {
      const int count = values ? static_cast<int>(*values) : 0;
      if (fix && values) StoredHistories(fix).set(i, values + 1, count, numbers);
      if (fix && !values) StoredHistories(fix).forget(i);
      if (values) values += 1 + count;
    }
  }
}

}  // namespace plastigran
