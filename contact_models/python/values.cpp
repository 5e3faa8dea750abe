// SPDX-License-Identifier: GPL-2.0-or-later
#include "values.h"

namespace plastigran {

std::string described(nb::handle self, const nb::dict& values) {
  std::string text;
  for (auto [name, value] : values)
    text += (text.empty() ? "" : ", ") + nb::cast<std::string>(name) + '=' +
            nb::cast<std::string>(nb::repr(value));
  return nb::cast<std::string>(self.type().attr("__qualname__")) + '(' + text + ')';
}

bool equal(const nb::dict& values, const nb::dict& others) {
  const nb::object array_equal = nb::module_::import_("numpy").attr("array_equal");
  for (auto [name, value] : values)
    if (!nb::cast<bool>(array_equal(value, others[name]))) return false;
  return true;
}

Py_hash_t hashed(const nb::dict& values) { return nb::hash(nb::tuple(values.values())); }

}  // namespace plastigran
