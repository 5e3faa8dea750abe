# SPDX-License-Identifier: GPL-2.0-or-later
"""Checks of the results of bulk runs, used by several decks.

A `series` is a table with one row per `thermo` line of the log. Its columns include the energy
terms [J] that inputs/energy_ledger.in defines.
"""

from __future__ import annotations

import attrs
import pandas as pd

#: Largest relative error of the restitution coefficient at the recommended time step
#: (docs/timestep.md).
RESTITUTION_ERROR = 1e-3
#: Largest allowed balance error as a fraction of the energy input, at the recommended time step.
#: The rebound energy is proportional to the square of the restitution coefficient, so its relative
#: error is twice as large.
LEDGER = 2 * RESTITUTION_ERROR

#: Largest allowed overlap, as a multiple of the largest overlap for which the law is valid.
EXCESS = 10.0
#: Names of the two checks that `ledger_checks` returns.
LEDGER_CHECKS = (
    "balance error, divided by the energy input",
    "decrease of plastic work, divided by the energy input",
)
#: Reference time between log lines, in units of sqrt(d/g). In the time sqrt(d/g), a grain of
#: diameter d falls by d/2 from rest (g: gravitational acceleration). Decks that integrate log data
#: with the trapezoidal rule give their error limits for this reference time.
FINE_ROWS = 0.25

#: Energy terms of inputs/energy_ledger.in whose sum equals the energy input. The energy input
#: includes the work of gravity, so the potential energy is not one of the terms.
ENERGIES = ["kinetic", "elastic", "plastic", "friction", "viscous"]
#: Energy terms of contacts with adhesion: the surface energy, which is negative, and the energy
#: lost when contacts form and break. If the log has both columns, they belong to the energy input.
ADHESION = ["surfaces", "adhesion"]
#: Names of the energy terms that contacts dissipate.
DISSIPATED = ["plastic", "friction", "viscous"]
#: Energy terms that accumulate from the start of a run.
FLOWS = [*DISSIPATED, "wallwork", "inserted", "drift"]


@attrs.frozen
class Check:
    """Comparison of a quantity of a run with its largest allowed value.

    Attributes:
        name: Name of the quantity, in words.
        value: Value of the quantity in the run.
        limit: Largest allowed value.
        reason: Reason for the limit.
    """

    name: str
    value: float
    limit: float
    reason: str

    @property
    def passed(self) -> bool:
        """Whether the value is at most the limit; false if the value is NaN."""
        return bool(self.value <= self.limit)


def range_checks(excess: dict[str, float]) -> list[Check]:
    """Return failed checks of the validity range: one for each law with overlaps above `EXCESS`.

    Args:
        excess: Largest overlap / largest valid overlap [-], by name of the law.
    """
    reason = "at this overlap the law is not valid. Check units, Young's modulus and time step"
    name = "largest overlap, divided by the largest valid overlap of"
    return [
        Check(f"{name} {law}", ratio, EXCESS, reason)
        for law, ratio in excess.items()
        if ratio > EXCESS
    ]


def energy_input(series: pd.DataFrame) -> float:
    """Return the energy input by gravity, walls, inserted grains and initial motion [J].

    The input is the largest value that the sum of kinetic, stored and dissipated energy has in any
    row.
    """
    return float(series[energy_terms(series)].sum(axis="columns").max())


def energy_terms(series: pd.DataFrame) -> list[str]:
    """Return the names of the energy columns whose sum is the energy input of a run."""
    return ENERGIES + (ADHESION if set(ADHESION) <= set(series) else [])


def last_simulation(series: pd.DataFrame) -> pd.DataFrame:
    """Return the log rows after the last `clear` command of a deck.

    If the series has no column `simulation`, the deck has no `clear`. Then return all rows.
    """
    if "simulation" not in series:
        return series
    return series[series["simulation"] == series["simulation"].iloc[-1]]


def dissipated(series: pd.DataFrame) -> pd.Series:
    """Return the energy dissipated by yielding, friction and viscosity [J]."""
    return series[DISSIPATED].sum(axis="columns")


def since_first(series: pd.DataFrame) -> pd.DataFrame:
    """Shift the time [s] and accumulated energies [J] of a series to zero in the first row."""
    accumulated = [*FLOWS, "time"]
    return series.assign(**{name: series[name] - series[name].iloc[0] for name in accumulated})


def ledger_checks(series: pd.DataFrame, limit: float = LEDGER) -> list[Check]:
    """Return checks that the energy balance closes and that the plastic work never decreases.

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
            "largest integration error of impacts at this time step",
        ),
        Check(
            LEDGER_CHECKS[1],
            (plastic.cummax() - plastic).max() / total,
            1e-12,
            "plastic work never decreases, except by round-off of its sum over ranks",
        ),
    ]


def trapezia_factor(time: pd.Series, diameter: float, gravitational_acceleration: float) -> float:
    """Return the error of trapezoidal integration, as a multiple of the error at `FINE_ROWS` [-].

    The error is proportional to the square of the time between log lines. The result is 1 if this
    time is shorter than `FINE_ROWS` sqrt(d/g), where d is the grain diameter.

    Args:
        time: Times of the log lines, evenly spaced [s].
        diameter: Grain diameter [m].
        gravitational_acceleration: Gravitational acceleration [m/s^2].
    """
    fine = FINE_ROWS * (diameter / gravitational_acceleration) ** 0.5
    return max(1.0, (time.iloc[1] - time.iloc[0]) / fine) ** 2


def count_check(series: pd.DataFrame, count: float) -> Check:
    """Check that the column `atoms` always has the expected number of grains."""
    difference = (series["atoms"] - count).abs().max()
    return Check("grains lost or gained", difference, 0, "walls and periodic sides keep all grains")
