// SPDX-License-Identifier: GPL-2.0-or-later
//
// A law's answers as Python has them: records whose fields are numbers, or arrays with one number
// an element.
#pragma once

#include <array>
#include <utility>
#include <vector>

#include "arguments.h"
#include "plastigran/impact/central_impact.h"
#include "plastigran/shared/contact.h"

namespace plastigran {

template <class Record>
struct AnswerField {
  const char* name;
  double Record::*number;
  bool Record::*truth;  // set where `number` is null
  const char* meaning;
};

template <class Record>
struct AnswerFields;
template <>
struct AnswerFields<Response> {
  static const std::array<AnswerField<Response>, 6> all;
};
template <>
struct AnswerFields<ImpactOutcome> {
  static const std::array<AnswerField<ImpactOutcome>, 7> all;
};

// TangentialResponse in the plane of the contact.
struct PlaneResponse {
  double force_x, force_y, stored_energy, friction_work;
};
template <>
struct AnswerFields<PlaneResponse> {
  static const std::array<AnswerField<PlaneResponse>, 4> all;
};

template <class Record>
struct Answer {
  std::vector<nb::object> values;
};

// Ask for every element, `ask(element)`, and turn the records into fields.
template <class Record, class Ask>
Answer<Record> answer(const Broadcast& given, const Ask& ask) {
  std::vector<Record> records(given.size());
  for (std::size_t i = 0; i < records.size(); ++i) records[i] = ask(i);
  Answer<Record> answer;
  for (const auto& field : AnswerFields<Record>::all)
    answer.values.push_back(
        field.number
            ? column<double>(given, [&](std::size_t i) { return records[i].*field.number; })
            : column<bool>(given, [&](std::size_t i) { return records[i].*field.truth; }));
  return answer;
}

}  // namespace plastigran
