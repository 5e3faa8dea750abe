# SPDX-License-Identifier: GPL-2.0-or-later
"""Checks of the results of bulk runs, used by several decks.

A `series` has one row per line of the log, and the energy terms of inputs/energy_ledger.in [J].
"""

from __future__ import annotations

import attrs
import pandas as pd

#: Largest relative error of restitution at the recommended time step (docs/timestep.md).
RESTITUTION_ERROR = 1e-3
#: Largest balance error / energy input at the recommended time step. The factor is 2, because
#: energy is proportional to the square of restitution.
LEDGER = 2 * RESTITUTION_ERROR

#: Largest allowed ratio of overlap to largest overlap for which the law is valid.
EXCESS = 10.0
#: Names of the checks of the energy balance.
LEDGER_CHECKS = (
    "balance error, divided by the energy input",
    "plastic work lost, divided by the energy input",
)
#: Largest spacing of rows for trapezoidal integration, in units of sqrt(d/g), the time in which a
#: grain moves by its diameter under its weight.
FINE_ROWS = 0.25

#: Energy terms of inputs/energy_ledger.in whose sum is the energy input. The input already contains
#: the work of gravity, so its potential energy is not a term.
ENERGIES = ["kinetic", "elastic", "plastic", "friction", "viscous"]
#: Energy terms that only contacts with adhesion have: the surface energy, which is negative, and
#: the loss when contacts form and break. They are part of the sum if the log has both.
ADHESION = ["surfaces", "adhesion"]
#: Dissipated energy terms.
DISSIPATED = ["plastic", "friction", "viscous"]
#: Energy terms that accumulate.
FLOWS = [*DISSIPATED, "wallwork", "inserted", "drift"]


@attrs.frozen
class Check:
    """Check of a run.

    Attributes:
        name: Quantity that must be small, in words.
        value: Value of the run.
        limit: Largest allowed value.
        reason: Reason of the limit.
    """

    name: str
    value: float
    limit: float
    reason: str

    @property
    def passed(self) -> bool:
        """Whether the value is within the limit; NaN is not."""
        return bool(self.value <= self.limit)


def range_checks(excess: dict[str, float]) -> list[Check]:
    """Return a failed check for each law whose validity range was exceeded by more than `EXCESS`.

    Args:
        excess: For each law, largest overlap / largest valid overlap [-].
    """
    reason = "the law is not valid there. Check the units, Young's modulus and the time step"
    name = "largest overlap, divided by the largest valid overlap of"
    return [
        Check(f"{name} {law}", ratio, EXCESS, reason)
        for law, ratio in excess.items()
        if ratio > EXCESS
    ]


def energy_input(series: pd.DataFrame) -> float:
    """Return the energy input by gravity, walls, inserted grains and initial motion [J].

    It is the largest sum of kinetic, stored and dissipated energy.
    """
    return float(series[energy_terms(series)].sum(axis="columns").max())


def energy_terms(series: pd.DataFrame) -> list[str]:
    """Return the names of the terms whose sum is the energy input, for the columns of a series."""
    return ENERGIES + (ADHESION if set(ADHESION) <= set(series) else [])


def last_simulation(series: pd.DataFrame) -> pd.DataFrame:
    """Return the rows after the last `clear` command; all rows without a column `simulation`."""
    if "simulation" not in series:
        return series
    return series[series["simulation"] == series["simulation"].iloc[-1]]


def dissipated(series: pd.DataFrame) -> pd.Series:
    """Return the energy dissipated by yielding, friction and viscosity [J]."""
    return series[DISSIPATED].sum(axis="columns")


def since_first(series: pd.DataFrame) -> pd.DataFrame:
    """Return the series with time [s] and accumulated terms [J] counted from its first row."""
    accumulated = [*FLOWS, "time"]
    return series.assign(**{name: series[name] - series[name].iloc[0] for name in accumulated})


def ledger_checks(series: pd.DataFrame, limit: float = LEDGER) -> list[Check]:
    """Check that the energy balance closes, and that plastic work never decreases.

    Args:
        series: Terms of the energy balance [J].
        limit: Largest allowed balance error as a fraction of the energy input.
    """
    total, plastic = energy_input(series), series["plastic"]
    return [
        Check(
            LEDGER_CHECKS[0],
            series["drift"].abs().max() / total,
            limit,
            "bound for impacts with the largest integration error at this time step",
        ),
        Check(
            LEDGER_CHECKS[1],
            (plastic.cummax() - plastic).max() / total,
            1e-12,
            "plastic work never decreases, to round-off of its sum over ranks",
        ),
    ]


def trapezia_factor(time: pd.Series, diameter: float, gravitational_acceleration: float) -> float:
    """Return the integration error divided by the error with the row spacing `FINE_ROWS` [-].

    The error of trapezoidal integration is proportional to the square of the row spacing. The
    result is at least 1.

    Args:
        time: Evenly spaced times [s].
        diameter: Grain diameter [m].
        gravitational_acceleration: Gravitational acceleration [m/s^2].
    """
    fine = FINE_ROWS * (diameter / gravitational_acceleration) ** 0.5
    return max(1.0, (time.iloc[1] - time.iloc[0]) / fine) ** 2


def count_check(series: pd.DataFrame, count: float) -> Check:
    """Check that the column `atoms` always has the expected number of grains."""
    difference = (series["atoms"] - count).abs().max()
    return Check("grains lost or gained", difference, 0, "walls and periodic sides keep all grains")
