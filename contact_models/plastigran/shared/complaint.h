// SPDX-License-Identifier: GPL-2.0-or-later
//
// Error message about a value, in which a host can replace field names by its own names.
#pragma once

#include <sstream>
#include <string>
#include <utility>

namespace plastigran {

// Sentence with field names in braces: "{yield_strength} is 0; it must be positive and finite
// [Pa]". Empty if there is no error.
class Complaint {
 public:
  Complaint() = default;
  explicit Complaint(std::string sentence) : sentence_(std::move(sentence)) {}

  // Returns the complaint "{field} is VALUE; it must be ALLOWED".
  static Complaint about(const std::string& field, double value, const std::string& allowed) {
    std::ostringstream text;
    text << '{' << field << "} is " << value << "; it must be " << allowed;
    return Complaint(text.str());
  }

  bool empty() const { return sentence_.empty(); }
  const std::string& sentence() const { return sentence_; }  // text with braces

  // Returns the sentence with each field in braces replaced by name_of(field).
  template <class NameOf>
  std::string worded(const NameOf& name_of) const {
    std::string text;
    std::size_t at = 0;
    for (std::size_t open; (open = sentence_.find('{', at)) != std::string::npos;) {
      const std::size_t close = sentence_.find('}', open);
      text += sentence_.substr(at, open - at);
      text += name_of(sentence_.substr(open + 1, close - open - 1));
      at = close + 1;
    }
    return text + sentence_.substr(at);
  }

  // Returns the sentence without the braces around field names.
  std::string text() const {
    return worded([](const std::string& field) { return field; });
  }

 private:
  std::string sentence_;
};

}  // namespace plastigran
