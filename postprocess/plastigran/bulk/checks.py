# SPDX-License-Identifier: GPL-2.0-or-later
"""Invariants of bulk decks, and those that several share."""

from __future__ import annotations

import attrs
import pandas as pd

#: Drift of the energy ledger over the energy that came in: what a run may be off by.
LEDGER = 1e-3

#: Largest overlap over that of a law's range from which a run counts as failed.
EXCESS = 10.0
#: Names of the ledger's checks.
LEDGER_CHECKS = (
    "drift of the energy ledger, over the energy that came in",
    "plastic work lost, over the energy that came in",
)
#: Spacing of rows up to which trapezia over them miss next to nothing, in times a grain needs to
#: move by its size under its weight, sqrt(d/g).
FINE_ROWS = 0.25

#: Where energy is or went, as inputs/energy_ledger.in names it: all but gravity's.
TAKEN = ["kinetic", "elastic", "plastic", "friction", "viscous"]
#: What contacts took that nothing gives back.
DISSIPATED = ["plastic", "friction", "viscous"]
#: Its entries that count what has passed.
FLOWS = [*DISSIPATED, "wallwork", "inserted", "drift"]


@attrs.frozen
class Check:
    """An invariant of a deck.

    Attributes:
        name: What must be small, in words.
        value: What was found.
        limit: What it may be at most.
        reason: Why that much.
    """

    name: str
    value: float
    limit: float
    reason: str

    @property
    def passed(self) -> bool:
        """Whether the value is within the limit; nan never is."""
        return bool(self.value <= self.limit)


def range_checks(excess: dict[str, float]) -> list[Check]:
    """Return a failed check for each law whose range contacts have left by more than `EXCESS`.

    Args:
        excess: For each law, its largest overlap divided by the largest of its range.
    """
    return [
        Check(
            f"largest overlap, divided by the largest of {law}'s range",
            furthest,
            EXCESS,
            "beyond the range the law's fit does not hold; check units, softness and time step",
        )
        for law, furthest in excess.items()
        if furthest > EXCESS
    ]


def energy_input(series: pd.DataFrame) -> float:
    """The energy that came in, by gravity, walls, inserted grains and motion at the start [J].

    It is now motion, stored in contacts, or dissipated: the most there was of them together.

    Args:
        series: The entries of inputs/energy_ledger.in [J], one row a line of the log.
    """
    return float(series[TAKEN].sum(axis="columns").max())


def last_simulation(series: pd.DataFrame) -> pd.DataFrame:
    """The rows since a deck's last `clear` command; all where there is none.

    Args:
        series: Of a run, with `simulation` where it has several.
    """
    if "simulation" not in series:
        return series
    return series[series["simulation"] == series["simulation"].iloc[-1]]


def dissipated(series: pd.DataFrame) -> pd.Series:
    """What contacts have taken so far, by yielding, friction and viscosity [J].

    Args:
        series: Those entries of inputs/energy_ledger.in [J].
    """
    return series[DISSIPATED].sum(axis="columns")


def since_first(series: pd.DataFrame) -> pd.DataFrame:
    """The same log with time [s] and what the ledger counts [J] from its first row on."""
    counted = [*FLOWS, "time"]
    return series.assign(**{name: series[name] - series[name].iloc[0] for name in counted})


def ledger_checks(series: pd.DataFrame) -> list[Check]:
    """The ledger closes, and plastic work only grows.

    Args:
        series: The entries of inputs/energy_ledger.in [J], one row a line of the log.
    """
    came_in = energy_input(series)
    plastic = series["plastic"]
    return [
        Check(
            LEDGER_CHECKS[0],
            series["drift"].abs().max() / came_in,
            LEDGER,
            "the integrator's error at a sound time step",
        ),
        Check(
            LEDGER_CHECKS[1],
            (plastic.cummax() - plastic).max() / came_in,
            1e-12,
            "plastic work only grows, to rounding of its sum over ranks",
        ),
    ]


def trapezia_factor(time: pd.Series, diameter: float, gravitational_acceleration: float) -> float:
    """How much more trapezia over rows of the log miss than over `FINE_ROWS` [-], 1 at least.

    It grows with the square of the spacing.

    Args:
        time: Evenly spaced [s].
        diameter: Of a grain [m].
        gravitational_acceleration: [m/s^2].
    """
    fine = FINE_ROWS * (diameter / gravitational_acceleration) ** 0.5
    return max(1.0, (time.iloc[1] - time.iloc[0]) / fine) ** 2


def count_check(series: pd.DataFrame, count: float) -> Check:
    """No grain is lost or gained.

    Args:
        series: Column `atoms`, one row a line of the log.
        count: Grains there must be.
    """
    lost = (series["atoms"] - count).abs().max()
    return Check("grains lost or gained", lost, 0, "walls and periodic sides keep them all")
