# SPDX-License-Identifier: GPL-2.0-or-later
"""The constants of two bodies combine to those of a pair; constants out of range are refused."""

from __future__ import annotations

import pytest

from plastigran import laws


def test_pair_is_the_same_in_either_order():
    soft, hard = laws.Body(7e10, 0.33, 1e8), laws.Body(2.1e11, 0.28, 9e8)
    one, other = laws.combine(soft, hard), laws.combine(hard, soft)
    for name in ("youngs_modulus_eff", "shear_modulus_eff", "yield_pressure", "yield_strength"):
        assert getattr(one, name) == getattr(other, name), name
    assert one.yield_pressure == 1e8 * laws.hertz_yield_pressure_factor(0.33)
    assert one.poissons_ratio == 0.33
    assert one.youngs_modulus == 7e10
    # The tangent modulus and the rate constants of a pair are those of the weaker body.
    rated = laws.Body(7e10, 0.33, 1e8, tangent_modulus=1e9, rate_coefficient=0.02, reference_rate=3)
    pair = laws.combine(hard, rated)
    assert pair == laws.combine(rated, hard)
    assert (pair.tangent_modulus, pair.rate_coefficient, pair.reference_rate) == (1e9, 0.02, 3)
    # Two bodies with the same yield pressure also give a pair that does not depend on their order.
    tied = laws.Body(7e10, 0.2, 8e7, 2.0), laws.Body(7e10, 0.3, 1e8, 1.6)
    assert laws.combine(*tied) == laws.combine(*tied[::-1])
    for other in (laws.Body(2e11, 0.33, 1e8), rated):  # same yield pressure as `soft`
        assert laws.combine(soft, other) == laws.combine(other, soft)


@pytest.mark.parametrize(
    ("poissons_ratio", "factor"),
    [(0.25, 1.554347), (0.30, 1.612797), (0.35, 1.674110), (0.40, 1.738481)],
)
def test_yield_pressure_factor(poissons_ratio, factor):
    """The default of yield pressure / yield strength depends on Poisson's ratio.

    The expected values follow from the largest von Mises stress on the axis of Hertz' contact,
    computed to seven digits.
    """
    assert laws.hertz_yield_pressure_factor(poissons_ratio) == pytest.approx(factor, rel=5e-7)


@pytest.mark.parametrize(
    ("given", "said"),
    [
        ({"yield_strength": 0}, r"yield_strength is 0; it must be positive and finite \[Pa\]"),
        ({"yield_strength": float("nan")}, r"yield_strength is nan"),
        ({"youngs_modulus": -1}, r"youngs_modulus is -1"),
        ({"poissons_ratio": 0.51}, r"poissons_ratio is 0.51; it must be above -1 and at most 0.5"),
        ({"poissons_ratio": -1}, r"poissons_ratio is -1"),
        ({"yield_pressure_factor": -2}, r"yield_pressure_factor is -2; it must be between 0.5 and"),
        ({"tangent_modulus": 7e10}, r"tangent_modulus is 7e\+10; it must be 0 or more and less"),
        ({"tangent_modulus": -1}, r"tangent_modulus is -1; .* youngs_modulus, 7e\+10 \[Pa\]"),
        ({"rate_coefficient": 1.1}, r"rate_coefficient is 1.1; it must be between 0 and 1 \[-\]"),
        ({"reference_rate": 0}, r"reference_rate is 0; it must be positive and finite \[1/s\]"),
    ],
)
def test_materials_out_of_range_are_refused(given, said):
    constants = {"youngs_modulus": 7e10, "poissons_ratio": 0.3, "yield_strength": 1e8} | given
    with pytest.raises(ValueError, match=said):
        laws.Body(**constants)
