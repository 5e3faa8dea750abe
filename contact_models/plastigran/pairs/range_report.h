// SPDX-License-Identifier: GPL-2.0-or-later
//
// Messages about contacts beyond the validity range of their law, for all hosts.
#pragma once

#include <sstream>
#include <string>

namespace plastigran {

// Returns the warning at the end of a run. `range` is the validity range in words. `furthest` is
// the largest ratio of overlap to limit.
inline std::string range_warning(const std::string& range, double contacts, double furthest) {
  std::ostringstream text;
  // The count lacks elastic contacts, because their state does not record whether they were counted
  // before. In LIGGGHTS, it also lacks contacts counted before a restart.
  if (contacts > 0) text << contacts << ' ';
  text << "contacts have exceeded the validity range of the law (" << range
       << "). The largest overlap was " << furthest
       << " times the limit. Use a law with a larger range, or lower the load";
  return text.str();
}

// Returns the warning before a run. `speed` is the largest speed of the impacts, with its unit.
inline std::string range_forecast(const std::string& range, double speed, const std::string& unit) {
  std::ostringstream text;
  text << "impacts at the current speeds (up to " << speed << ' ' << unit
       << ") will exceed the validity range of the law (" << range
       << "). Use a law with a larger range, or lower the load";
  return text.str();
}

// Returns the log line from which the Python package reads the number of contacts beyond the
// validity range.
inline std::string range_line(const std::string& law, double contacts, double furthest) {
  std::ostringstream line;
  line << "plastigran range " << law << " contacts=" << contacts << " furthest=" << furthest
       << '\n';
  return line.str();
}

}  // namespace plastigran
