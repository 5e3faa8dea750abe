// SPDX-License-Identifier: GPL-2.0-or-later
//
// What the keeper of histories knows of the lines they are of, from run to run and in restart
// files.
#include <mpi.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <sstream>
#include <utility>

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "liggghts/fixes/engine_access.h"
#include "liggghts/fixes/history_keeper.h"
#include "liggghts/fixes/print.h"
#include "liggghts/fixes/stored_histories.h"
#include "modify.h"
#include "output.h"
#include "update.h"

namespace plastigran {

namespace {

// The constants of the first two atom types that have others now, and these, in words; empty where
// there are none. Types that only one of the texts is about do not count.
std::string first_change(const std::string& before, const std::string& now) {
  const std::string others = '\n' + now;
  std::istringstream lines(before);
  for (std::string line; std::getline(lines, line);) {
    const std::size_t begin = others.find('\n' + line.substr(0, line.find(": ") + 1));
    if (begin == std::string::npos) continue;
    const std::string other = others.substr(begin + 1, others.find('\n', begin + 1) - begin - 1);
    if (other != line) return '`' + line + "` is now `" + other + '`';
  }
  return {};
}

}  // namespace

void HistoryKeeper::connect(const std::string& owner, const Line& line) {
  Line& connected = connected_[owner];
  const bool given_anew = line.given_anew || connected.given_anew;
  const std::string report = line.report.empty() ? connected.report : line.report;
  connected = line;
  connected.given_anew = given_anew;
  connected.report = report;
  const auto found = in_file_.find(owner);
  if (found == in_file_.end()) return;
  const std::string models = found->second.models;
  lines_[owner] = found->second;
  in_file_.erase(found);
  if (models.empty() || models == line.models || line.histories.empty()) return;
  refuse_other_models(lmp, owner, models, line.models);
}

void HistoryKeeper::refuse_other_models(LAMMPS_NS::LAMMPS* engine, const std::string& owner,
                                        const std::string& restarted, const std::string& models) {
  const std::string text =
      owner + ": the restart file has contacts of `" + restarted + "`, but the line has `" +
      models +
      "`. Give the line as it was. To discard the histories, do `run 0` with that line first";
  engine->error->all(FLERR, text.c_str());
  std::abort();  // not reached
}

std::string HistoryKeeper::restarted_settings(const std::string& owner) const {
  const auto found = in_file_.find(owner);
  if (found != in_file_.end()) return found->second.settings;
  if (comm->me == 0)
    warn(lmp, owner +
                  ": the restart file has no settings of this line, so they have their "
                  "defaults. Repeat the line if it had others");
  return {};
}

// Each line of constants once, and behind those that the same owners have, these owners.
void HistoryKeeper::report_constants() const {
  if (comm->me != 0) return;
  std::vector<std::pair<std::string, std::string>> owners_of;  // of each line, in order
  for (const auto& [owner, line] : lines_) {
    std::istringstream report(line.report);
    for (std::string each; std::getline(report, each);) {
      const auto found = std::find_if(owners_of.begin(), owners_of.end(),
                                      [&each](const auto& pair) { return pair.first == each; });
      if (found == owners_of.end())
        owners_of.emplace_back(each, owner);
      else
        found->second += ", " + owner;
    }
  }
  std::string text;
  for (std::size_t k = 0; k < owners_of.size(); ++k) {
    const auto& [line, owners] = owners_of[k];
    text += line + '\n';
    if (k + 1 == owners_of.size() || owners_of[k + 1].second != owners)
      text += "these constants hold for " + owners + '\n';
  }
  print(lmp, text);
}

// Of contacts that go on. All ranks together.
void HistoryKeeper::warn_of_other_constants(const Lines& former) const {
  for (const auto& [owner, line] : lines_) {
    const auto before = former.find(owner);
    if (before == former.end() || before->second.models != line.models) continue;
    const std::string change = first_change(before->second.constants, line.constants);
    if (!change.empty() && remembers(owner) && comm->me == 0)
      warn(lmp, owner + ": contacts continue with other constants: " + change);
  }
}

// Whether any contact of an owner remembers anything. All ranks together.
bool HistoryKeeper::remembers(const std::string& owner) const {
  int remembers = 0;
  for (const std::string& id : lines_.at(owner).histories)
    if (LAMMPS_NS::Fix* const fix = modify->find_fix_id(id.c_str()))
      for (int i = 0; i < atom->nlocal && !remembers; ++i)
        remembers = StoredHistories(fix).remembers(i);
  MPI_Allreduce(MPI_IN_PLACE, &remembers, 1, MPI_INT, MPI_MAX, world);
  return remembers;
}

void HistoryKeeper::end_of_step() {
  if (next_restart(output) != update->ntimestep) return;
  for (int k = 0; k < modify->n_fixes_style_strict(pair_histories); ++k)
    modify->find_fix_style_strict(pair_histories, k)->setup_pre_exchange();
}

// Lines of text for each owner: its ID, its models, its settings and the place of a primitive wall,
// between tabs; behind a tab each, its constants.
void HistoryKeeper::write_restart(FILE* file) {
  if (comm->me != 0) return;
  std::string text;
  for (const auto& [owner, line] : lines_)
    if (!line.histories.empty() || owner == pair_owner) {
      text += owner + '\t' + (line.histories.empty() ? "" : line.models) + '\t' + line.settings +
              '\t' + std::to_string(line.place) + '\n';
      std::istringstream constants(line.constants);
      for (std::string each; std::getline(constants, each);) text += '\t' + each + '\n';
    }
  const int size = text.size() + 1;
  fwrite(&size, sizeof size, 1, file);
  fwrite(text.c_str(), 1, size, file);
}

HistoryKeeper::Lines HistoryKeeper::lines_of_file(const std::string& text) {
  Lines lines;
  std::istringstream words(text);
  for (std::string owner, models, settings, place, constant;
       std::getline(words, owner, '\t') && std::getline(words, models, '\t') &&
       std::getline(words, settings, '\t') && std::getline(words, place);) {
    Line& line = lines[owner] = {models, settings, {}, ""};
    line.place = std::strtoull(place.c_str(), nullptr, 10);
    while (words.peek() == '\t' && std::getline(words.ignore(), constant))
      line.constants += constant + '\n';
  }
  return lines;
}

void HistoryKeeper::restart(char* data) { in_file_ = lines_of_file(data); }

HistoryKeeper* HistoryKeeper::of(LAMMPS_NS::LAMMPS* engine, const std::string& restarted) {
  if (HistoryKeeper* const keeper = find_fix<HistoryKeeper>(engine)) return keeper;
  HistoryKeeper* const keeper = ensure_fix<HistoryKeeper>(engine);
  keeper->in_file_ = lines_of_file(restarted);
  return keeper;
}

std::string HistoryKeeper::restarted_lines(LAMMPS_NS::LAMMPS* engine) {
  const char* const text = restarted_state(engine->modify, id(), style());
  return text ? text : "";
}

std::string HistoryKeeper::restarted_models(LAMMPS_NS::LAMMPS* engine, const std::string& owner) {
  const Lines lines = lines_of_file(restarted_lines(engine));
  const auto found = lines.find(owner);
  return found == lines.end() ? std::string() : found->second.models;
}

}  // namespace plastigran
