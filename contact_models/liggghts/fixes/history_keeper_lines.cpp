// SPDX-License-Identifier: GPL-2.0-or-later
//
// What the keeper of histories knows of the lines they are of, from run to run and in restart
// files.
#include <mpi.h>

#include <sstream>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "liggghts/fixes/engine_access.h"
#include "liggghts/fixes/history_keeper.h"
#include "liggghts/fixes/stored_histories.h"
#include "modify.h"
#include "output.h"
#include "update.h"

namespace plastigran {

namespace {

// The first line of a text that another does not begin with at the same place.
std::string first_difference(const std::string& text, const std::string& other) {
  std::istringstream lines(text), others(other);
  std::string line, beside;
  while (std::getline(lines, line) && std::getline(others, beside) && line == beside) continue;
  return line;
}

}  // namespace

void HistoryKeeper::connect(const std::string& owner, const Line& line) {
  Line& connected = connected_[owner];
  const bool given_anew = line.given_anew || connected.given_anew;
  connected = line;
  connected.given_anew = given_anew;
  const auto last = lines_.find(owner);
  if (last != lines_.end() && last->second.models != line.models) constants_.erase(owner);
  const auto found = in_file_.find(owner);
  if (found == in_file_.end()) return;
  const std::string models = found->second.models;
  in_file_.erase(found);
  if (models.empty() || models == line.models || line.histories.empty()) return;
  error->all(FLERR,
             (owner + ": the restart file has contacts of `" + models + "`, the line is of `" +
              line.models + "`. Give the line as it was; for contacts that begin anew, `run 0` " +
              "with that line comes before the other")
                 .c_str());
}

void HistoryKeeper::compare_constants(const std::string& owner, const std::string& constants) {
  std::string& before = constants_[owner];
  if (!before.empty() && before != constants)
    changes_[owner] = '`' + first_difference(before, constants) + "` is now `" +
                      first_difference(constants, before) + '`';
  before = constants;
}

std::string HistoryKeeper::restarted_settings(const std::string& owner) const {
  const auto found = in_file_.find(owner);
  if (found != in_file_.end()) return found->second.settings;
  if (comm->me == 0)
    error->warning(FLERR, (owner + ": the restart file does not hold the settings of the line, "
                                   "which now are the defaults; give the line if it had others")
                              .c_str());
  return {};
}

void HistoryKeeper::warn_of_changes() {
  for (const auto& [owner, change] : changes_)
    if (remembers(owner) && comm->me == 0)
      error->warning(FLERR, (owner + ": contacts go on with other constants: " + change).c_str());
  changes_.clear();
}

// Whether any contact of an owner does. All ranks together.
bool HistoryKeeper::remembers(const std::string& owner) const {
  int remembers = 0;
  for (const std::string& id : lines_.at(owner).histories)
    if (LAMMPS_NS::Fix* const fix = modify->find_fix_id(id.c_str()))
      for (int i = 0; i < atom->nlocal; ++i) {
        const StoredHistories histories(fix);
        const std::vector<double> values = histories.of(i);
        if (histories.remembers(values.data(), values.size(), histories.width())) remembers = 1;
      }
  MPI_Allreduce(MPI_IN_PLACE, &remembers, 1, MPI_INT, MPI_MAX, world);
  return remembers;
}

void HistoryKeeper::end_of_step() {
  if (next_restart(output) != update->ntimestep) return;
  for (int k = 0; k < modify->n_fixes_style_strict(pair_histories); ++k)
    modify->find_fix_style_strict(pair_histories, k)->setup_pre_exchange();
}

// Lines of text for each owner: its ID, its models and its settings, between tabs; behind a tab
// each, its constants.
void HistoryKeeper::write_restart(FILE* file) {
  if (comm->me != 0) return;
  std::string text;
  for (const auto& [owner, line] : lines_)
    if (!line.histories.empty() || owner == pair_owner) {
      text +=
          owner + '\t' + (line.histories.empty() ? "" : line.models) + '\t' + line.settings + '\n';
      std::istringstream constants(constants_[owner]);
      for (std::string each; std::getline(constants, each);) text += '\t' + each + '\n';
    }
  const int size = text.size() + 1;
  fwrite(&size, sizeof size, 1, file);
  fwrite(text.c_str(), 1, size, file);
}

void HistoryKeeper::restart(char* data) {
  std::istringstream text(data);
  for (std::string owner, models, settings, constant; std::getline(text, owner, '\t') &&
                                                      std::getline(text, models, '\t') &&
                                                      std::getline(text, settings);) {
    in_file_[owner] = {models, settings, {}, false};
    while (text.peek() == '\t' && std::getline(text.ignore(), constant))
      constants_[owner] += constant + '\n';
  }
}

}  // namespace plastigran
