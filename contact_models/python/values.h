// SPDX-License-Identifier: GPL-2.0-or-later
//
// Value semantics of the Python classes: repr, equality, hash, pickle and copy use the named values
// of an object.
#pragma once

#include <nanobind/nanobind.h>
#include <nanobind/stl/string.h>

#include <array>
#include <new>
#include <string>

namespace plastigran {

namespace nb = nanobind;

// Python attribute for a member of a plain struct.
template <class Struct, class Value = double>
struct Field {
  const char* name;
  Value Struct::*member;
  const char* meaning;
};

// Returns repr(self) built from the values, for example Thornton.State(overlap_max=1e-06).
std::string described(nb::handle self, const nb::dict& values);
// Returns whether all values are equal; arrays are compared element by element.
bool equal(const nb::dict& values, const nb::dict& others);
// Returns the Python hash of the values.
Py_hash_t hashed(const nb::dict& values);

// Binds repr, equality, hash, pickle and copy. `values(self)` returns a dict of names and values;
// `restore(memory, values)` constructs an object from them in `memory`.
template <class Class, class Values, class Restore>
void bind_values(Class& type, const Values& values, const Restore& restore, bool hashable) {
  typedef typename Class::Type Self;
  type.def("__repr__",
           [values](nb::handle self) { return described(self, values(nb::cast<Self&>(self))); });
  type.def(
      "__eq__",
      [values](nb::handle self, nb::handle other) -> nb::object {
        if (!self.type().is(other.type())) return nb::borrow(Py_NotImplemented);
        return nb::bool_(equal(values(nb::cast<Self&>(self)), values(nb::cast<Self&>(other))));
      },
      nb::is_operator(), nb::sig("def __eq__(self, other: object, /) -> bool"));
  if (hashable)
    type.def("__hash__", [values](const Self& self) { return hashed(values(self)); });
  else
    type.attr("__hash__") = nb::none();
  type.def("__getstate__", [values](const Self& self) { return nb::make_tuple(values(self)); });
  type.def("__setstate__", [restore](Self& self, const nb::tuple& state) {
    restore(&self, nb::cast<nb::dict>(state[0]));
  });
}

// Binds a struct of numbers. Its fields become read-only attributes of the Python object, and
// define repr, equality, hash and pickle.
template <class Class, std::size_t count>
void bind_fields(Class& type, const std::array<Field<typename Class::Type>, count>& fields) {
  typedef typename Class::Type Self;
  for (const auto& field : fields) type.def_ro(field.name, field.member, field.meaning);
  bind_values(
      type,
      [fields](const Self& self) {
        nb::dict values;
        for (const auto& field : fields) values[field.name] = self.*field.member;
        return values;
      },
      [fields](Self* memory, const nb::dict& values) {
        Self* const self = new (memory) Self();
        for (const auto& field : fields) self->*field.member = nb::cast<double>(values[field.name]);
      },
      true);
}

}  // namespace plastigran
