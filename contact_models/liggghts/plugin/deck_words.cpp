// SPDX-License-Identifier: GPL-2.0-or-later
#include "deck_words.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>
#include <sstream>

namespace plastigran {

namespace {

bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) || c == '_'; }

// A line without its comment. A # between quotes begins none.
std::string without_comment(const std::string& line) {
  char quote = 0;
  for (std::size_t at = 0; at < line.size(); ++at) {
    const char c = line[at];
    if (quote ? c == quote : c == '"' || c == '\'')
      quote = quote ? 0 : c;
    else if (c == '#' && !quote)
      return line.substr(0, at);
  }
  return line;
}

// White space and quotes part words: a command may be a quoted word of another one.
std::vector<std::string> words_of(std::string line) {
  for (char& c : line)
    if (c == '"' || c == '\'') c = ' ';
  std::istringstream words(line);
  return {std::istream_iterator<std::string>(words), {}};
}

}  // namespace

DeckWords::DeckWords(const std::string& path, const std::map<std::string, std::string>& given)
    : values_(given) {
  read(path);
}

bool DeckWords::may_use(const std::string& variable) const {
  return !complete_ || declared_.count(variable) || used_.count(variable) || mentions(variable);
}

// Whether the text has ${name}, $n or v_name.
bool DeckWords::mentions(const std::string& variable) const {
  const std::size_t size = variable.size();
  for (std::size_t at = text_.find(variable); at != std::string::npos;
       at = text_.find(variable, at + 1)) {
    const bool ends = at + size == text_.size() || !is_word(text_[at + size]);
    const std::string before = text_.substr(at < 2 ? 0 : at - 2, at < 2 ? at : 2);
    if (ends && (before == "${" || before == "v_" || (size == 1 && before.back() == '$')))
      return true;
  }
  return false;
}

void DeckWords::read(const std::string& path) {
  std::ifstream file(path);
  complete_ = complete_ && file && depth_ < 50;
  if (!complete_) return;
  ++depth_;
  std::string whole;
  for (std::string line; std::getline(file, line);) {
    whole += substitute(without_comment(line));
    const std::size_t last = whole.find_last_not_of(" \t\r");
    if (last != std::string::npos && whole[last] == '&') {  // goes on in the next line
      whole.resize(last);
      continue;
    }
    take(whole);
    whole.clear();
  }
  take(whole);
  --depth_;
}

// A whole command.
void DeckWords::take(const std::string& line) {
  text_ += line + '\n';
  std::vector<std::string> words = words_of(line);
  if (words.empty()) return;
  const std::string command = words[0];
  words.resize(std::max<std::size_t>(words.size(), 4));
  const auto has = [&](const char* word) {
    return std::find(words.begin() + 1, words.end(), word) != words.end();
  };
  for (std::size_t k = 0; k + 1 < words.size(); ++k)  // also as words of an `if`
    if (words[k] == "variable" || words[k] == "next") declared_.insert(words[k + 1]);
  if (command == "variable" && words[2] == "index") {
    settings_.push_back(words[1]);
    values_.emplace(words[1], words[3]);  // one given on the command line stays
  } else if (command == "include") {
    read(words[1]);
  } else if ((command == "jump" && words[1] != "SELF") || has("include") || has("jump")) {
    complete_ = false;  // `if ... then "include FILE"`, `run ... every`
  } else if ((command == "pair_style" && has("gran")) || (command == "fix" && has("wall/gran"))) {
    const auto model = std::find(words.begin(), words.end(), "model");
    if (model != words.end() && model + 1 != words.end()) models_.insert(*(model + 1));
  }
}

// The line with its known ${name} replaced; the rest is the engine's business.
std::string DeckWords::substitute(std::string line) {
  for (const auto& [name, value] : values_) {
    const std::string reference = "${" + name + "}";
    if (value.find(reference) != std::string::npos) continue;
    for (std::size_t at; (at = line.find(reference)) != std::string::npos;) {
      used_.insert(name);
      line.replace(at, reference.size(), value);
    }
  }
  return line;
}

}  // namespace plastigran
