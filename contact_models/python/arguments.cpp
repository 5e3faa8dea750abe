// SPDX-License-Identifier: GPL-2.0-or-later
#include "arguments.h"

#include <cmath>
#include <stdexcept>

namespace plastigran {

void raise_if(const Complaint& complaint, const std::string& about) {
  if (!complaint.empty()) throw std::invalid_argument(about + complaint.text());
}

const Allowed positive{[](double value) { return value > 0 && std::isfinite(value); },
                       "positive and finite"};
const Allowed finite{[](double value) { return std::isfinite(value); }, "finite"};
const Allowed not_negative{[](double value) { return value >= 0 && std::isfinite(value); },
                           "zero or positive, and finite"};

namespace {

std::string text(nb::handle object) { return nb::cast<std::string>(nb::str(object)); }

void check(const Argument& argument, const std::string& index, double value) {
  if (!argument.allowed.holds(value))
    raise_if(Complaint::about(argument.name + index, value,
                              std::string(argument.allowed.words) + " [" + argument.unit + "]"));
}

bool is_number(nb::handle given) { return PyFloat_Check(given.ptr()) || PyLong_Check(given.ptr()); }

// Returns an array-like argument as an array of doubles. Raises ValueError if it cannot be
// converted to numbers, or if a value is out of range.
nb::object to_array(const nb::module_& numpy, const Argument& argument) {
  nb::object array;
  try {
    array = numpy.attr("asarray")(argument.given, "dtype"_a = "float64", "order"_a = "C");
  } catch (const nb::python_error&) {
    throw std::invalid_argument(
        std::string(argument.name) + " is " + nb::cast<std::string>(nb::repr(argument.given)) +
        "; it must be a number or an array of numbers [" + argument.unit + "]");
  }
  const auto values = nb::cast<nb::ndarray<const double, nb::c_contig, nb::device::cpu>>(array);
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (argument.allowed.holds(values.data()[i])) continue;
    std::string index;
    for (nb::handle along : numpy.attr("unravel_index")(i, array.attr("shape")))
      index += (index.empty() ? "[" : ", ") + text(nb::int_(along));
    check(argument, index.empty() ? index : index + ']', values.data()[i]);
  }
  if (argument.one_per_path && values.ndim() > 0) return numpy.attr("expand_dims")(array, -1);
  return array;
}

}  // namespace

Broadcast::Broadcast(std::initializer_list<Argument> arguments) {
  if (std::all_of(arguments.begin(), arguments.end(),
                  [](const Argument& argument) { return is_number(argument.given); })) {
    for (const Argument& argument : arguments) {
      columns_.push_back({nb::cast<double>(argument.given), {}});
      check(argument, "", columns_.back().number);
    }
    return;
  }
  const nb::module_ numpy = nb::module_::import_("numpy");
  std::vector<nb::object> arrays;
  nb::list shapes;
  std::string description;
  for (const Argument& argument : arguments) {
    arrays.push_back(to_array(numpy, argument));
    shapes.append(arrays.back().attr("shape"));
    description += (description.empty() ? "" : ", ") + std::string(argument.name) + ' ' +
                   text(numpy.attr("shape")(argument.given));
  }
  nb::object shape;
  try {
    shape = numpy.attr("broadcast_shapes")(*shapes);
  } catch (const nb::python_error&) {
    throw std::invalid_argument("the shapes of the arguments cannot be broadcast together: " +
                                description);
  }
  for (const nb::object& array : arrays) {
    const nb::object spread = numpy.attr("broadcast_to")(array, shape);
    columns_.push_back({0, nb::cast<Array>(numpy.attr("ascontiguousarray")(spread))});
  }
  for (nb::handle length : shape) shape_.push_back(nb::cast<std::size_t>(length));
  for (const std::size_t length : shape_) size_ *= length;
}

}  // namespace plastigran
