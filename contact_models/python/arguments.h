// SPDX-License-Identifier: GPL-2.0-or-later
//
// Arguments and results of Python functions: numbers or arrays of numbers. Arguments are checked
// and broadcast together as in numpy; results have the broadcast shape.
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

// Throws an exception that Python receives as ValueError, unless the complaint is empty. `about`
// precedes the message.
void raise_if(const Complaint& complaint, const std::string& about = "");

// Allowed values of an argument, and their description for messages.
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
  bool one_per_path = false;  // true if an array has one value per path of overlaps
};

class Broadcast {
 public:
  // Checks and broadcasts the arguments. Raises ValueError for a value out of range (the message
  // names argument, index, value and range), or for shapes that cannot be broadcast.
  explicit Broadcast(std::initializer_list<Argument> arguments);

  // Returns the value of one argument for one element. `argument` is the number of the argument,
  // from 0. `element` is the index in the flattened broadcast shape, in C order.
  double operator()(std::size_t argument, std::size_t element) const {
    const Column& column = columns_[argument];
    return column.array.is_valid() ? column.array.data()[element] : column.number;
  }
  // Returns the common shape of the arrays; empty if all arguments are numbers.
  const std::vector<std::size_t>& shape() const { return shape_; }
  std::size_t size() const { return size_; }

 private:
  typedef nb::ndarray<const double, nb::c_contig, nb::device::cpu> Array;
  struct Column {
    double number;
    Array array;  // invalid (no data) if all arguments are numbers
  };
  std::vector<Column> columns_;
  std::vector<std::size_t> shape_;
  std::size_t size_ = 1;
};

// Returns value(element) of every element as an array of the broadcast shape, or one number if all
// arguments are numbers.
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
