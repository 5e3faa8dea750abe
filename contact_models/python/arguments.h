// SPDX-License-Identifier: GPL-2.0-or-later
//
// What Python gives and gets: numbers or arrays of numbers, checked, broadcast against each other
// as numpy does, and answered by numbers or arrays of the shape they have together.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/ndarray.h>

#include <algorithm>
#include <initializer_list>
#include <string>
#include <vector>

#include "plastigran/shared/complaint.h"

namespace plastigran {

namespace nb = nanobind;
using namespace nb::literals;

// Throw what Python sees as ValueError, unless there is nothing to complain of.
void raise_if(const Complaint& complaint, const std::string& about = "");

// Values an argument may have, and the words for them.
struct Allowed {
  bool (*holds)(double value);
  const char* words;
};
extern const Allowed positive, finite, not_negative;

struct Argument {
  const char* name;
  nb::object given;
  Allowed allowed;
  const char* unit;
  bool one_per_path = false;  // an array of it has no axis along the path
};

class Broadcast {
 public:
  // Raises ValueError naming the argument, its index and value, and what is allowed; or the shapes
  // when they do not fit together.
  explicit Broadcast(std::initializer_list<Argument> arguments);

  // The value of an argument, counted as given, for an element, counted in C order.
  double operator()(std::size_t argument, std::size_t element) const {
    const Column& column = columns_[argument];
    return column.array.is_valid() ? column.array.data()[element] : column.number;
  }
  const std::vector<std::size_t>& shape() const { return shape_; }  // empty for a number
  std::size_t size() const { return size_; }

 private:
  typedef nb::ndarray<const double, nb::c_contig, nb::device::cpu> Array;
  struct Column {
    double number;
    Array array;  // not valid when all arguments are numbers
  };
  std::vector<Column> columns_;
  std::vector<std::size_t> shape_;
  std::size_t size_ = 1;
};

// One number for numbers, else an array: value(element) of every element.
template <class Value, class ValueOf>
nb::object column(const Broadcast& given, const ValueOf& value) {
  if (given.shape().empty()) return nb::cast(static_cast<Value>(value(0)));
  Value* const data = new Value[given.size()];
  nb::capsule owner(data, [](void* memory) noexcept { delete[] static_cast<Value*>(memory); });
  for (std::size_t i = 0; i < given.size(); ++i) data[i] = value(i);
  return nb::cast(
      nb::ndarray<nb::numpy, Value>(data, given.shape().size(), given.shape().data(), owner));
}

}  // namespace plastigran
