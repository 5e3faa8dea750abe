// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/fixes/contact_line.h"

#include <algorithm>
#include <cstdlib>
#include <sstream>
#include <utility>

#include "liggghts/fixes/messages.h"

namespace plastigran {

namespace {

std::vector<std::string> lines_of(const std::string& text) {
  std::vector<std::string> lines;
  std::istringstream stream(text);
  for (std::string line; std::getline(stream, line);) lines.push_back(line);
  return lines;
}

}  // namespace

// Returns one text line per pair style or wall fix: its name, models, settings and position,
// separated by tabs. One text line per pair of atom types follows it: a tab and the constants.
std::string restart_text(const ContactLines& lines) {
  std::string text;
  for (const auto& [owner, line] : lines) {
    const bool has_history = !line.histories.empty();
    if (!has_history && owner != pair_owner) continue;
    text += owner + '\t' + (has_history ? line.models : "") + '\t' + line.settings + '\t' +
            std::to_string(line.position) + '\n';
    for (const std::string& constants : lines_of(line.constants)) text += '\t' + constants + '\n';
  }
  return text;
}

ContactLines read_restart_text(const std::string& text) {
  ContactLines lines;
  std::istringstream stream(text);
  for (std::string owner, models, settings, position, constants;
       std::getline(stream, owner, '\t') && std::getline(stream, models, '\t') &&
       std::getline(stream, settings, '\t') && std::getline(stream, position);) {
    ContactLine& line = lines[owner];
    line.models = models;
    line.settings = settings;
    line.position = std::strtoull(position.c_str(), nullptr, 10);
    while (stream.peek() == '\t' && std::getline(stream.ignore(), constants))
      line.constants += constants + '\n';
  }
  return lines;
}

void refuse_other_models(LAMMPS_NS::LAMMPS* engine, const std::string& owner,
                         const std::string& restarted, const std::string& models) {
  stop(engine, owner + ": the restart file has contacts of `" + restarted +
                   "`, but the line has `" + models +
                   "`. Use the line of the earlier run. To discard the histories, do `run 0` with "
                   "that line first, then give the new line");
}

std::string constants_report(const ContactLines& lines) {
  std::vector<std::pair<std::string, std::string>> entries;  // {constants, owners of the lines}
  for (const auto& [owner, line] : lines)
    for (const std::string& constants : lines_of(line.report)) {
      const auto entry = std::find_if(entries.begin(), entries.end(),
                                      [&](const auto& pair) { return pair.first == constants; });
      if (entry == entries.end())
        entries.emplace_back(constants, owner);
      else
        entry->second += ", " + owner;
    }
  std::string text;
  for (std::size_t k = 0; k < entries.size(); ++k) {
    const auto& [constants, owners] = entries[k];
    text += constants + '\n';
    if (k + 1 == entries.size() || entries[k + 1].second != owners)
      text += "these constants hold for " + owners + '\n';
  }
  return text;
}

std::string first_change(const std::string& before, const std::string& now) {
  const std::vector<std::string> new_lines = lines_of(now);
  for (const std::string& line : lines_of(before)) {
    const std::string types = line.substr(0, line.find(": ") + 1);
    const auto other = std::find_if(new_lines.begin(), new_lines.end(), [&](const auto& new_line) {
      return new_line.compare(0, types.size(), types) == 0;
    });
    if (other != new_lines.end() && *other != line) return '`' + line + "` is now `" + *other + '`';
  }
  return {};
}

}  // namespace plastigran
