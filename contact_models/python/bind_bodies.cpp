// SPDX-License-Identifier: GPL-2.0-or-later
//
// Python bindings of the constants of bodies and pairs of bodies.
#include <cmath>
#include <sstream>
#include <string>

#include "bind.h"
#include "plastigran/impact/validate.h"
#include "plastigran/shared/rate_factor.h"
#include "values.h"

namespace plastigran {

namespace {

constexpr std::array<Field<MaterialPair>, 9> pair_fields{{
    {"youngs_modulus_eff", &MaterialPair::youngs_modulus_eff,
     "E* [Pa]: 1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2."},
    {"shear_modulus_eff", &MaterialPair::shear_modulus_eff,
     "G* [Pa]: 1/G* = (2-nu1)/G1 + (2-nu2)/G2."},
    {"yield_pressure", &MaterialPair::yield_pressure,
     "Contact pressure p_y at which the weaker body yields [Pa]."},
    {"yield_strength", &MaterialPair::yield_strength,
     "Yield strength sigma_Y of the weaker body [Pa]."},
    {"poissons_ratio", &MaterialPair::poissons_ratio, "Poisson's ratio nu of the weaker body [-]."},
    {"youngs_modulus", &MaterialPair::youngs_modulus, "Young's modulus E of the weaker body [Pa]."},
    {"tangent_modulus", &MaterialPair::tangent_modulus,
     "Tangent modulus E_t of the weaker body [Pa]."},
    {"rate_coefficient", &MaterialPair::rate_coefficient,
     "Rate coefficient C of the weaker body [-]."},
    {"reference_rate", &MaterialPair::reference_rate,
     "Strain rate to which the yield strength of the weaker body refers [1/s]."},
}};

constexpr Allowed ratio_of_a_body{[](double value) { return value > -1 && value <= 0.5; },
                                  "above -1 and at most 0.5"};

constexpr std::size_t body_constant_count = body_constants.size();

bool must_be_given(const BodyConstant& constant) { return std::isnan(constant.standard); }

std::array<Field<Body>, body_constant_count> body_fields() {
  static std::array<std::string, body_constant_count> meanings;
  std::array<Field<Body>, body_constant_count> fields;
  for (std::size_t k = 0; k < body_constant_count; ++k) {
    const BodyConstant& constant = body_constants[k];
    meanings[k] = std::string(constant.meaning) + " [" + constant.unit + "].";
    fields[k] = {constant.name, constant.value, meanings[k].c_str()};
  }
  return fields;
}

std::string body_signature() {
  std::ostringstream text;
  text << "def __init__(self";
  for (const BodyConstant& constant : body_constants) {
    text << ", " << constant.name << ": float";
    if (std::isinf(constant.standard))
      text << " = float('inf')";
    else if (!must_be_given(constant))
      text << " = " << constant.standard;
  }
  text << ") -> None";
  return text.str();
}

std::string body_doc() {
  std::ostringstream text;
  text << "Create a body from its material constants.\n\nArgs:\n";
  for (const BodyConstant& constant : body_constants)
    text << "    " << constant.name << ": " << constant.symbol << ", " << constant.meaning
         << ". Range: " << allowed_values(constant) << ".\n";
  text << "\nRaises:\n    ValueError: A constant is out of range; the message names it, its value "
          "and the range.";
  return text.str();
}

// Returns the body defined by positional and keyword arguments of Python.
Body read_body(const nb::args& values, const nb::kwargs& named) {
  nb::dict given;
  for (auto [name, value] : named) given[name] = value;
  for (std::size_t k = 0; k < values.size(); ++k) {
    if (k >= body_constant_count)
      throw nb::type_error("Body is given more constants than it has; see body_constants()");
    const char* const name = body_constants[k].name;
    if (given.contains(name)) throw nb::type_error((std::string(name) + " is given twice").c_str());
    given[name] = values[k];
  }
  Body body;
  for (const BodyConstant& constant : body_constants) {
    const std::string name = constant.name;
    if (given.contains(constant.name)) {
      if (!nb::try_cast<double>(given[constant.name], body.*constant.value))
        throw nb::type_error((name + " must be a number").c_str());
      nb::del(given[constant.name]);
    } else if (must_be_given(constant)) {
      throw nb::type_error((name + " is missing").c_str());
    }
  }
  for (auto [name, value] : given)
    throw nb::type_error(("Body has no constant " + nb::cast<std::string>(name)).c_str());
  raise_if(validate(body));
  return body;
}

nb::list constant_table() {
  nb::list table;
  for (const BodyConstant& constant : body_constants) {
    nb::dict row;
    row["name"] = constant.name;
    row["symbol"] = constant.symbol;
    row["unit"] = constant.unit;
    row["lower"] = constant.lower;
    row["upper"] = constant.upper;
    row["above"] = constant.above;
    row["default"] = must_be_given(constant) ? nb::object(nb::none())
                                             : nb::object(nb::float_(constant.standard));
    row["meaning"] = constant.meaning;
    table.append(row);
  }
  return table;
}

}  // namespace

void bind_bodies(nb::module_& module) {
  nb::class_<Body> body(module, "Body", "Material constants of one body. Immutable.");
  static const std::string signature = body_signature(), doc = body_doc();
  body.def(
      "__init__",
      [](Body* self, const nb::args& values, const nb::kwargs& named) {
        new (self) Body(read_body(values, named));
      },
      nb::sig(signature.c_str()), doc.c_str());
  bind_fields(body, body_fields());
  module.def(
      "body_constants", &constant_table, nb::sig("def body_constants() -> list[dict[str, Any]]"),
      R"(Return one dict per constant of a body: name, symbol, unit, lower and upper (bounds), above
(True if the lower bound is excluded), default (None if the constant is required; the bounds do not
apply to the default), and meaning.)");

  nb::class_<MaterialPair> pair(
      module, "MaterialPair",
      "Combined constants of two bodies in contact: see `combine`. Immutable.");
  bind_fields(pair, pair_fields);

  module.def("combine", &combine, "a"_a, "b"_a,
             R"(Combine the constants of two bodies into a pair; the order does not matter.

Args:
    a: One body.
    b: The other body. The body with the lower yield pressure determines the yield of the pair.

Source: effective moduli of Hertz 1881 and Mindlin 1949.)");
  module.def(
      "hertz_yield_pressure_factor",
      [](nb::object poissons_ratio) {
        const Broadcast given({{"poissons_ratio", poissons_ratio, ratio_of_a_body, "-"}});
        return column<double>(
            given, [&](std::size_t i) { return hertz_yield_pressure_factor(given(0, i)); });
      },
      "poissons_ratio"_a,
      nb::sig("def hertz_yield_pressure_factor(poissons_ratio: ArrayLike) -> Numbers"),
      R"(Return peak Hertz pressure / yield strength at first yield (von Mises) [-].

Args:
    poissons_ratio: Poisson's ratio nu [-], a number or an array; above -1 and at most 0.5.

Returns:
    A number, or an array with the shape of `poissons_ratio`.

Raises:
    ValueError: A value is out of range.

Source: Johnson, Contact Mechanics (1985), sec. 3.4 and 4.1.)");
  module.def(
      "rate_factor",
      [](const MaterialPair& pair, const nb::object& radius_eff, const nb::object& speed) {
        const Broadcast given(
            {{"radius_eff", radius_eff, positive, "m"}, {"speed", speed, not_negative, "m/s"}});
        return column<double>(
            given, [&](std::size_t i) { return rate_factor(pair, given(0, i), given(1, i)); });
      },
      "pair"_a, "radius_eff"_a, "speed"_a,
      nb::sig("def rate_factor(pair: MaterialPair, radius_eff: ArrayLike, speed: ArrayLike) -> "
              "Numbers"),
      R"(Return the factor by which the strain rate of an impact increases the yield strength [-].

The factor is 1 + C ln(rate/reference_rate) above the reference rate and 1 below, rounded to
multiples of 1e-4. The strain rate is (speed/R*) times (E*/E')^2, with E' = E/(1-nu^2). C, E and nu
belong to the weaker body.

Args:
    pair: The two bodies.
    radius_eff: R* [m], positive. `radius_eff` and `speed` are numbers or arrays; arrays broadcast
        together.
    speed: Closing speed at first touch [m/s], not negative.

Returns:
    A number, or an array of the broadcast shape.

Raises:
    ValueError: A value is out of range, or the shapes cannot be broadcast.

Source: Johnson & Cook 1983, 7th Int. Symp. Ballistics: 541.)");
  module.def("yield_radius_ratio", &yield_radius_ratio, "pair"_a,
             R"(Return contact radius / effective radius at first yield [-]: pi p_y/(2 E*).

Args:
    pair: The two bodies.

Source: Johnson, Contact Mechanics (1985), sec. 6.1.)");
}

}  // namespace plastigran
