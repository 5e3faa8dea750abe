// SPDX-License-Identifier: GPL-2.0-or-later
//
// Conversion of the results of a law (Response, ImpactOutcome) to Python objects. Their fields are
// numbers, or arrays with one element per contact.
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
  bool Record::*truth;  // pointer to a bool member; used if `number` is null
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

// TangentialResponse, with the components of the force along x and y in the plane of the contact.
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

// Calls compute(element) for every element and returns the fields of the records as numbers or
// arrays.
template <class Record, class Compute>
Answer<Record> answer(const Broadcast& given, const Compute& compute) {
  std::vector<Record> records(given.size());
  for (std::size_t i = 0; i < records.size(); ++i) records[i] = compute(i);
  Answer<Record> answer;
  for (const auto& field : AnswerFields<Record>::all)
    answer.values.push_back(
        field.number
            ? column<double>(given, [&](std::size_t i) { return records[i].*field.number; })
            : column<bool>(given, [&](std::size_t i) { return records[i].*field.truth; }));
  return answer;
}

}  // namespace plastigran
