// SPDX-License-Identifier: GPL-2.0-or-later
//
// What the launcher reads of a deck before the engine does: which variables it takes, and which
// contact models it asks for.
#pragma once

#include <map>
#include <set>
#include <string>
#include <vector>

namespace plastigran {

// A deck with the files it includes.
class DeckWords {
 public:
  // `given` holds the values of -var, by name: they resolve paths of includes.
  DeckWords(const std::string& path, const std::map<std::string, std::string>& given);

  // Whether the deck may use a variable. Yes, in doubt: where it runs commands this class cannot
  // follow, the engine is left to say what is missing.
  bool may_use(const std::string& variable) const;

  // What it lets one set: `variable NAME index ...`.
  const std::vector<std::string>& settings() const { return settings_; }

  // Words after `model` in lines of the styles `gran` and `wall/gran`, as written there.
  const std::set<std::string>& models() const { return models_; }

 private:
  void read(const std::string& path);
  void take(const std::string& line);
  std::string substitute(std::string line);
  bool mentions(const std::string& variable) const;

  std::string text_;
  std::vector<std::string> settings_;
  std::map<std::string, std::string> values_;  // of the settings so far
  std::set<std::string> used_, declared_, models_;
  int depth_ = 0;
  bool complete_ = true;  // false when it may read or run what could not be followed
};

}  // namespace plastigran
