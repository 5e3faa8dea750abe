// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/history_keeper.h"

#include <algorithm>
#include <iterator>
#include <utility>

#include "atom.h"
#include "comm.h"
#include "force.h"
#include "liggghts/fixes/engine_access.h"
#include "liggghts/fixes/kept_fixes.h"
#include "liggghts/fixes/messages.h"
#include "liggghts/fixes/ranks.h"
#include "output.h"
#include "pair_gran.h"

namespace plastigran {

namespace {

const char pair_histories[] = "contacthistory";

}  // namespace

HistoryKeeper::HistoryKeeper(LAMMPS_NS::LAMMPS* engine, int count, char** words)
    : PluginFix(engine, count, words) {
  nevery = 1;
  restart_global = 1;
  create_attribute = 1;
  grow_arrays(atom->nmax);
  atom->add_callback(0);
}

HistoryKeeper::~HistoryKeeper() { atom->delete_callback(Fix::id, 0); }

HistoryKeeper* HistoryKeeper::of(LAMMPS_NS::LAMMPS* engine, const std::string& restarted) {
  if (HistoryKeeper* const keeper = find_fix<HistoryKeeper>(engine)) return keeper;
  HistoryKeeper* const keeper = ensure_fix<HistoryKeeper>(engine);
  keeper->restarted_ = read_restart_text(restarted);
  return keeper;
}

std::string HistoryKeeper::restarted_lines(LAMMPS_NS::LAMMPS* engine) {
  const char* const text = restarted_state(engine->modify, id(), style());
  return text ? text : "";
}

void HistoryKeeper::connect(const std::string& owner, const ContactLine& line) {
  ContactLine& connected = connected_[owner];
  // The pair_style or wall line may have been registered before a run that had no setup. Keep the
  // report of its constants, because that run did not print it.
  const std::string earlier = std::exchange(connected, line).report;
  if (line.report.empty()) connected.report = earlier;
  const auto entry = restarted_.find(owner);
  if (entry == restarted_.end()) return;
  const ContactLine restarted = entry->second;
  restarted_.erase(entry);
  lines_[owner] = restarted;
  if (!restarted.models.empty() && restarted.models != line.models && !line.histories.empty())
    refuse_other_models(lmp, owner, restarted.models, line.models);
}

std::string HistoryKeeper::restarted_settings(const std::string& owner) const {
  const auto line = restarted_.find(owner);
  if (line != restarted_.end()) return line->second.settings;
  warn_on_first_rank(owner +
                     ": the restart file does not contain the settings of this line, so the "
                     "defaults are used. Repeat the line if it had other settings");
  return {};
}

int HistoryKeeper::setmask() {
  using namespace LAMMPS_NS::FixConst;
  return PRE_EXCHANGE | END_OF_STEP;  // PRE_EXCHANGE makes LIGGGHTS call setup_pre_exchange()
}

void HistoryKeeper::end_of_step() {
  if (next_restart(output) != update->ntimestep) return;
  for (int k = 0; k < modify->n_fixes_style_strict(pair_histories); ++k)
    modify->find_fix_style_strict(pair_histories, k)->setup_pre_exchange();
}

void HistoryKeeper::write_restart(FILE* file) {
  const std::string text = restart_text(lines_);
  write_state(file, text.c_str(), text.size() + 1);
}

// Adds the line of a pair style with LIGGGHTS' own models, because its histories are stored too.
ContactLines HistoryKeeper::with_host_pair_style(const ContactLines& lines) const {
  ContactLines all = lines;
  LAMMPS_NS::Pair* const pair = force->pair_match("gran", 1);
  if (!pair || all.count(pair_owner)) return all;
  ContactLine& line = all[pair_owner];
  line.models = "LIGGGHTS " + std::to_string(static_cast<LAMMPS_NS::PairGran*>(pair)->hashcode());
  line.histories = {pair_histories};
  return all;
}

void HistoryKeeper::post_run() {
  for (const auto& [owner, line] : with_host_pair_style(lines_))
    for (const std::string& id : line.histories)
      if (LAMMPS_NS::Fix* const fix = modify->find_fix_id(id.c_str()))
        StoredHistories(fix).update();
  begin_storage();
}

// Begins to keep the histories that the fixes of LIGGGHTS have now. Copies the histories of a fix
// that LIGGGHTS created before the first line with a law.
void HistoryKeeper::begin_storage() {
  stored_.clear();
  std::copy_n(atom->tag, atom->nlocal, ids_.begin());
  particle_total_ = sum_over_ranks(static_cast<long>(atom->nlocal), world);
  for (const auto& [owner, line] : with_host_pair_style(lines_))
    for (const std::string& id : line.histories) {
      LAMMPS_NS::Fix* const fix = modify->find_fix_id(id.c_str());
      if (!fix) continue;
      const StoredHistories::Layout layout = StoredHistories(fix).layout();
      stored_.push_back({owner, line.models, id, layout, wall_position(lmp, fix), false, {}});
      if (!dynamic_cast<AnyKeptFix*>(fix)) copy(fix);
    }
}

void HistoryKeeper::copy(LAMMPS_NS::Fix* fix) {
  const auto entry = std::find_if(stored_.begin(), stored_.end(), [fix](const Stored& stored) {
    return stored.fix == fix->id && !stored.is_copy;
  });
  if (entry == stored_.end()) return;
  entry->is_copy = true;
  const StoredHistories histories(fix);
  std::size_t size = 0;
  for (int i = 0; i < atom->nlocal; ++i) size += histories.size_of(i);
  entry->records.reserve(atom->nlocal, size);
  for (int i = 0; i < atom->nlocal; ++i) {
    if (!ids_[i]) continue;  // created after the last run
    const std::vector<double> values = histories.of(i);
    entry->records.add(ids_[i], values.data(), values.size());
  }
}

void HistoryKeeper::setup_pre_exchange() {
  const ContactLines former = std::exchange(lines_, std::exchange(connected_, {}));
  if (comm->me == 0) print(lmp, constants_report(lines_));
  for (auto& [owner, line] : lines_)
    for (const std::string& id : line.histories)
      if (const LAMMPS_NS::Fix* const fix = modify->find_fix_id(id.c_str()))
        line.position = primitive_wall_position(lmp, fix);
  // No histories are stored before the first run. If this run follows a restart, clear only the
  // histories of walls that have moved since the restart file was written.
  if (stored_.empty())
    clear_moved_walls(former);
  else
    restore_lost_histories();
  warn_of_new_constants(former);
}

// `write_restart` and `write_data` also call setup_pre_exchange(). The next run must still find the
// histories, including those of a pair_style or wall line that is missing when the file is written.
void HistoryKeeper::restore_lost_histories() {
  const NewIds new_ids(ids_.data(), atom->tag, atom->nlocal, particle_total_, world);
  const ContactLines lines = with_host_pair_style(lines_);
  std::vector<Stored> not_restored;
  for (Stored& stored : stored_) {
    LAMMPS_NS::Fix* const fix = modify->find_fix_id(stored.fix.c_str());
    if (!stored.is_copy) {
      if (fix && !new_ids.unchanged())
        StoredHistories(fix).replace_partner_ids(atom->nlocal, new_ids);
      continue;
    }
    if (!new_ids.unchanged())
      stored.records.replace_ids(new_ids, [&](double* values, int count) {
        return stored.layout.replace_partner_ids(values, count, new_ids);
      });
    stored.records.fetch(atom->tag, atom->nlocal, world);
    const auto entry = lines.find(stored.owner);
    if (entry != lines.end() && fix && can_continue(stored, entry->second, fix)) {
      fix->just_created = 0;  // LIGGGHTS clears fixes with just_created at the beginning of the run
      restore(stored, fix);
      continue;
    }
    if (entry != lines.end() && any_history(stored))
      warn_on_first_rank(stored.owner + ": contacts start without history, because " +
                         (stored.models == entry->second.models
                              ? "the position of the wall changed"
                              : "the models of these contacts changed from `" + stored.models +
                                    "` to `" + entry->second.models +
                                    "`. Repeat the earlier line to keep the " + "histories"));
    not_restored.push_back(std::move(stored));
  }
  begin_storage();
  std::move(not_restored.begin(), not_restored.end(), std::back_inserter(stored_));
}

bool HistoryKeeper::can_continue(const Stored& stored, const ContactLine& line,
                                 LAMMPS_NS::Fix* fix) const {
  return line.models == stored.models &&
         StoredHistories(fix).layout().width == stored.layout.width &&
         wall_position(lmp, fix) == stored.position;
}

bool HistoryKeeper::any_history(const Stored& stored) const {
  bool any = false;
  for (int i = 0; i < atom->nlocal && !any; ++i) {
    const auto record = stored.records.find(atom->tag[i]);
    any = record.values && stored.layout.any(record.values, record.count);
  }
  return on_any_rank(any, world);
}

bool HistoryKeeper::any_history(const ContactLine& line) const {
  bool any = false;
  for (const std::string& id : line.histories)
    if (LAMMPS_NS::Fix* const fix = modify->find_fix_id(id.c_str()))
      for (int i = 0; i < atom->nlocal && !any; ++i) {
        const std::vector<double> values = StoredHistories(fix).of(i);
        any = StoredHistories(fix).layout().any(values.data(), values.size());
      }
  return on_any_rank(any, world);
}

void HistoryKeeper::restore(const Stored& stored, LAMMPS_NS::Fix* fix) const {
  for (int i = 0; i < atom->nlocal; ++i)
    if (const auto record = stored.records.find(atom->tag[i]); record.values)
      StoredHistories(fix).set(i, record.values, record.count);
    else
      StoredHistories(fix).clear(i);
}

// Clears, after a restart, the histories of walls whose position differs from the restart file.
void HistoryKeeper::clear_moved_walls(const ContactLines& restarted) {
  for (const auto& [owner, line] : lines_) {
    const auto former = restarted.find(owner);
    if (former == restarted.end() || !former->second.position ||
        former->second.position == line.position)
      continue;
    if (any_history(line))
      warn_on_first_rank(owner +
                         ": contacts start without history, because the position of the wall "
                         "differs from the restart file");
    for (const std::string& id : line.histories)
      for (int i = 0; i < atom->nlocal; ++i)
        StoredHistories(modify->find_fix_id(id.c_str())).clear(i);
  }
}

void HistoryKeeper::warn_of_new_constants(const ContactLines& former) const {
  for (const auto& [owner, line] : lines_) {
    const auto before = former.find(owner);
    if (before == former.end() || before->second.models != line.models) continue;
    const std::string change = first_change(before->second.constants, line.constants);
    if (!change.empty() && any_history(line))
      warn_on_first_rank(owner + ": contacts continue with other constants: " + change);
  }
}

void HistoryKeeper::warn_on_first_rank(const std::string& text) const {
  if (comm->me == 0) warn(lmp, text);
}

}  // namespace plastigran
