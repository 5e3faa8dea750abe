# SPDX-License-Identifier: GPL-2.0-or-later
"""Settings that bulk decks share, beside those of the grains: looked at before anything runs."""

from __future__ import annotations

from math import inf

from plastigran.engine.deck import Settings

#: Rows of the log a steady part has at least: a line goes through them.
STEADY_ROWS = 10


def check_course(settings: Settings) -> None:
    """Time step, seed, what is written on the way, and the ledger.

    A checkpoint is made at steps that have a line of the log: `checkpoints` divides `rows`.

    Raises:
        ValueError: One is out of range, or the ledger is asked of the engine's own hertz.
    """
    settings.number("timestep", 0, unit="s")
    settings.number("seed", -inf)
    settings.whole("frames", 0)
    rows, checkpoints = settings.whole("rows", 1), settings.whole("checkpoints", 1)
    if rows % checkpoints:
        raise ValueError(f"checkpoints is {checkpoints}; it must divide rows, {rows}")
    _check_word(settings, "ledger", ("on", "off"))
    if settings["law"] == "hertz" and settings["ledger"] == "on":
        raise ValueError("ledger is on; the engine's own hertz keeps none: set ledger=off")


def check_contact(settings: Settings) -> None:
    """The settings of inputs/bulk/parts/friction.in, but for the ledger.

    Raises:
        ValueError: One is out of range; the message names it.
    """
    _check_word(settings, "tangential", ("off", "no_history", "history"))
    _check_word(settings, "rolling_friction", ("off", "cdt", "epsd2"))
    for name in ("coefficient_of_friction", "coefficient_of_rolling_friction"):
        settings.number(name, 0, closed=True)
    settings.number("coefficient_of_restitution", 0.05, 1, closed=True)


def read_settling(settings: Settings, unit: str) -> float:
    """The setting `settling`, after which `duration` goes on for ten rows of the log or more.

    Args:
        settings: Of the deck, with `duration`, `settling` and `rows`.
        unit: Of `duration` and `settling`.

    Raises:
        ValueError: One is out of range, or fewer rows are left.
    """
    duration = settings.number("duration", 0, unit=unit)
    settling = settings.number("settling", 0, duration, unit=unit, closed=True)
    rows = settings.whole("rows", STEADY_ROWS)
    latest = duration * (1 - STEADY_ROWS / rows)
    if settling > latest * (1 + 1e-12):
        raise ValueError(
            f"settling is {settings['settling']}; it must be {latest:g} [{unit}] or less, so that "
            f"{STEADY_ROWS} of {rows} rows are left"
        )
    return settling


def _check_word(settings: Settings, name: str, choices: tuple[str, ...]) -> None:
    if settings[name] not in choices:
        raise ValueError(f"{name} is {settings[name]!r}; it must be {', '.join(choices)}")
