// SPDX-License-Identifier: GPL-2.0-or-later
#include "liggghts/model/line_settings.h"

#include <cstdio>
#include <cstdlib>
#include <sstream>

#include "liggghts/fixes/engine_access.h"

namespace plastigran {

// Returns the settings with full precision; LIGGGHTS itself prints them only to a file, with few
// digits.
std::string settings_text(Settings& settings) {
  std::string text;
  for (const auto& [name, setting] : settings_by_name(settings)) {
    char* word = nullptr;
    std::size_t size = 0;
    FILE* const file = open_memstream(&word, &size);
    double number;
    if (is_number(*setting, number))
      fprintf(file, "%.17g", number);
    else
      setting->print_value(file);
    fclose(file);
    text += (text.empty() ? "" : " ") + name + ' ' + word;
    std::free(word);
  }
  return text;
}

void set_from_text(Settings& settings, const std::string& text) {
  std::istringstream words(text);
  for (std::string name, word; words >> name >> word;) {
    char* pair[] = {name.data(), word.data()};
    settings.parseArguments(2, pair);
  }
}

}  // namespace plastigran
