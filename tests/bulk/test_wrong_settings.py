# SPDX-License-Identifier: GPL-2.0-or-later
"""Decks refuse wrong settings, and checks fail if the analysis has other settings than the run."""

from __future__ import annotations

import attrs
import pytest
from bulk_settings import STEADY_FLOWS, short_settings

from plastigran.bulk.decks import deck_class
from plastigran.bulk.series import read_series
from plastigran.engine.deck import read_deck


@pytest.mark.parametrize(
    ("deck", "change", "message"),
    [
        ("plate", {"fastest": 0.01}, r"fastest is 0.01; it must be above 0.1 and finite \[m/s\]"),
        ("plate", {"shot_layers": 2}, "shot_layers is 2; it must be 1 for target plate"),
        (
            "plate",
            {"gravitational_acceleration": 9.81},
            "gravitational_acceleration is 9.81; it must be 0 for target plate",
        ),
        ("plate", {"ledger": "off"}, "ledger is off"),
        ("plate", {"options": "viscous_damping on"}, "viscous_damping on changes the restitution"),
        ("bed", {"bed_layers": 0}, "bed_layers is 0; it must be 1 or more"),
        ("bed", {"filling": 0}, r"filling is 0; it must be positive and finite \[s\]"),
        ("chute", {"settling": 3}, r"settling is 3; it must lie from 0 to 1.8 \[s\]"),
        ("chute", {"settling": 1.76}, r"settling is 1.76; it must be at most 1.75 \[s\]"),
        ("chute", {"rows": 9, "checkpoints": 1}, "rows is 9; it must be 10 or more"),
        ("compaction", {"die_radius": 0.004}, r"die_radius is 0.004; it must be above 0.004 and"),
        ("ball_impact", {"grain_count": 60}, "grain_count is 60; it must be 61 or more"),
        ("drum", {"drum_radius": 0.02}, r"drum_radius is 0.02; it must be above 0.023 and finite"),
        ("drum", {"length": 0.01}, r"length is 0.01; it must be above 0.023 and below 0.05 \[m\]"),
        ("drum", {"settling": 0.89}, r"settling is 0.89; it must be at most 0.885 \[revolutions\]"),
        ("hopper", {"orifice": 9}, "orifice is 9; there are meshes for 5, 6, 7, 8"),
        ("hopper", {"layers": 21}, "layers is 21; at most 20 fit into the barrel"),
        (
            "cooling_gas",
            {"options": "viscous_damping on"},
            "viscous_damping on changes the restitution",
        ),
    ],
)
def test_impossible_settings_are_refused(deck, change, message):
    label, deck = (deck, "bed_impact") if deck in ("plate", "bed") else ("", deck)
    settings = read_deck(deck, {**short_settings(deck, label), **change}, ".").settings
    with pytest.raises(ValueError, match=message):
        deck_class(deck).read(settings).check_inputs()


@pytest.mark.parametrize(
    ("deck", "change", "check"),
    [
        ("cooling_gas", {"yield_strength": 2.85e9}, "temperature from mean-field theory"),
        (
            "bed_impact",
            {"yield_strength": 1.1e5},
            "difference between the restitution of a shot and that of the law",
        ),
        ("drum", {"froude": 0.051}, "relative difference between the wall work"),
        ("drum", {"gravitational_acceleration": 9.9}, "relative difference between the wall work"),
        ("chute", {"angle": 25.5}, "work of gravity and the work on the center"),
        ("chute", {"gravitational_acceleration": 9.9}, "work of gravity and the work"),
        # rates just outside the band of Beverloo's law
        ("hopper", {"orifice": "6"}, "discharge rate outside the band of Beverloo's law"),
        ("hopper", {"gravitational_acceleration": 3.5}, "discharge rate outside the band"),
        ("hopper", {"gravitational_acceleration": 16}, "discharge rate outside the band"),
    ],
)
def test_checks_fail_for_other_settings(deck, change, check, steady_flow, brief_run):
    """A check fails if the analysis uses another strength, gravity or geometry than the run."""
    label = "plate" if deck == "bed_impact" else ""
    run = steady_flow(deck) if deck in STEADY_FLOWS else brief_run(deck, label)
    failed = attrs.evolve(run.deck, **change).analyse(read_series(run.folder)).failed
    assert any(check in failed_check.name for failed_check in failed)
