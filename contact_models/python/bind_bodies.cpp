// SPDX-License-Identifier: GPL-2.0-or-later
//
// What two bodies bring to a contact, in Python.
#include "bind.h"
#include "plastigran/impact/validate.h"
#include "plastigran/shared/rate_factor.h"
#include "values.h"

namespace plastigran {

namespace {

constexpr std::array<Field<Body>, 7> body_fields{{
    {"youngs_modulus", &Body::youngs_modulus, "Young's modulus E [Pa]."},
    {"poissons_ratio", &Body::poissons_ratio, "Poisson's ratio nu [-]."},
    {"yield_strength", &Body::yield_strength,
     "Uniaxial yield strength sigma_Y [Pa]; inf: it never yields."},
    {"yield_pressure_factor", &Body::yield_pressure_factor,
     "Contact yield pressure over yield strength [-]; 0: the Hertz-von Mises value."},
    {"tangent_modulus", &Body::tangent_modulus,
     "E_t: slope of stress over total strain beyond yield [Pa]; 0: perfectly plastic."},
    {"rate_coefficient", &Body::rate_coefficient,
     "C: share of sigma_Y that a factor e in rate of strain adds [-]."},
    {"reference_rate", &Body::reference_rate,
     "Rate of strain at which the yield strength is sigma_Y [1/s]."},
}};

constexpr std::array<Field<MaterialPair>, 9> pair_fields{{
    {"youngs_modulus_eff", &MaterialPair::youngs_modulus_eff,
     "E* [Pa]: 1/E* = (1-nu1^2)/E1 + (1-nu2^2)/E2."},
    {"shear_modulus_eff", &MaterialPair::shear_modulus_eff,
     "G* [Pa]: 1/G* = (2-nu1)/G1 + (2-nu2)/G2."},
    {"yield_pressure", &MaterialPair::yield_pressure,
     "Contact pressure p_y at which the weaker body yields [Pa]."},
    {"yield_strength", &MaterialPair::yield_strength, "sigma_Y of the weaker body [Pa]."},
    {"poissons_ratio", &MaterialPair::poissons_ratio, "nu of the weaker body [-]."},
    {"youngs_modulus", &MaterialPair::youngs_modulus, "E of the weaker body [Pa]."},
    {"tangent_modulus", &MaterialPair::tangent_modulus, "E_t of the weaker body [Pa]."},
    {"rate_coefficient", &MaterialPair::rate_coefficient,
     "C of the weaker body's yield strength [-]."},
    {"reference_rate", &MaterialPair::reference_rate,
     "Rate of strain at which the weaker body's yield strength holds [1/s]."},
}};

constexpr Allowed ratio_of_a_body{[](double value) { return value > -1 && value <= 0.5; },
                                  "above -1 and at most 0.5"};

}  // namespace

void bind_bodies(nb::module_& module) {
  nb::class_<Body> body(module, "Body", "One body's bulk constants. Immutable.");
  body.def(
      "__init__",
      [](Body* self, double youngs_modulus, double poissons_ratio, double yield_strength,
         double yield_pressure_factor, double tangent_modulus, double rate_coefficient,
         double reference_rate) {
        const Body made{youngs_modulus,  poissons_ratio,   yield_strength, yield_pressure_factor,
                        tangent_modulus, rate_coefficient, reference_rate};
        raise_if(validate(made));
        new (self) Body(made);
      },
      "youngs_modulus"_a, "poissons_ratio"_a, "yield_strength"_a = unlimited,
      "yield_pressure_factor"_a = 0.0, "tangent_modulus"_a = 0.0, "rate_coefficient"_a = 0.0,
      "reference_rate"_a = 1.0,
      nb::sig("def __init__(self, youngs_modulus: float, poissons_ratio: float, "
              "yield_strength: float = float('inf'), yield_pressure_factor: float = 0.0, "
              "tangent_modulus: float = 0.0, rate_coefficient: float = 0.0, "
              "reference_rate: float = 1.0) -> None"),
      R"(A body.

Args:
    youngs_modulus: E [Pa], positive.
    poissons_ratio: nu [-], above -1 and at most 0.5.
    yield_strength: Uniaxial sigma_Y [Pa], positive; inf: it never yields.
    yield_pressure_factor: Contact yield pressure over yield strength [-], 0.5 to 10; 0 stands for
        the Hertz-von Mises value (`hertz_yield_pressure_factor`).
    tangent_modulus: E_t beyond yield, the slope of stress over total strain [Pa], from 0, which
        is perfectly plastic, to less than E. Laws with `hardens` use it.
    rate_coefficient: C of Johnson and Cook [-], 0 to 1: the yield strength is
        sigma_Y (1 + C ln(rate/reference_rate)). 0: the rate does not matter.
    reference_rate: Rate of strain at which the yield strength is sigma_Y [1/s], positive.

Raises:
    ValueError: A constant is out of range; the message names it, its value and the range.)");
  bind_fields(body, body_fields);

  nb::class_<MaterialPair> pair(module, "MaterialPair",
                                "What two bodies bring to a contact: see `combine`. Immutable.");
  bind_fields(pair, pair_fields);

  module.def("combine", &combine, "a"_a, "b"_a,
             R"(The pair two bodies form, the same in either order.

Args:
    a: One body.
    b: The other. The one that yields at the lower contact pressure sets the pair's yield.

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
      R"(Peak Hertz pressure over yield strength [-] at which a contact first yields (von Mises).

Args:
    poissons_ratio: nu [-], a number or an array of any shape, above -1 and at most
        0.5.

Returns:
    A number, or an array of that shape.

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
      R"(What an impact multiplies the yield strength of its weaker body by [-], in steps of 1e-4:
1 + C ln(rate/reference_rate) above the reference rate, 1 up to it. The rate is v/R of the weaker
body's sphere on a rigid plane: speed/R* (E*/E')^2.

Args:
    pair: The two bodies.
    radius_eff: R* [m], positive. Numbers or arrays whose shapes broadcast together, as all below.
    speed: At which the bodies close in at first touch [m/s].

Returns:
    A number, or an array of the shape all have together.

Raises:
    ValueError: A value is out of range, or the shapes do not fit together.

Source: Johnson & Cook 1983, 7th Int. Symp. Ballistics: 541.)");
  module.def("yield_radius_ratio", &yield_radius_ratio, "pair"_a,
             R"(Contact radius over effective radius at first yield [-]: pi p_y/(2 E*).

Args:
    pair: The two bodies.

Source: Johnson, Contact Mechanics (1985), sec. 6.1.)");
}

}  // namespace plastigran
