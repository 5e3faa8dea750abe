# SPDX-License-Identifier: GPL-2.0-or-later
"""Settings of bulk runs that several tests share."""

from __future__ import annotations

from plastigran.bulk.decks import deck_class

#: Settings of the deck `cooling_gas` for a run of about one second with many checkpoints.
SHORT_GAS = {"side": 5, "duration": 24, "rows": 24, "checkpoints": 12, "mixing": 1}
#: Settings for which the flows of chute, drum and hopper become steady.
#:
#: Chute: Bagnold's profile holds for a flow much deeper than a layer of grains. With a depth of
#: nine lattice cells, the relative deviation from the profile was 0.009 to 0.026 for six random
#: seeds, and the relative error of the power balance was 0.012 to 0.032.
#:
#: Drum: It is ten grains wide, holds about 100 grains, and turns fast, so the grains flow evenly.
#:
#: Hopper: It holds 2080 grains; half of them flow out in half a second.
STEADY_FLOWS = {
    "chute": {"length": 5, "width": 4, "depth": 9, "start_speed": 1.0, "angle": 25, "rows": 360}
    | {"duration": 1.8, "settling": 0.8, "checkpoints": 4},
    "drum": {"drum_radius": 0.05, "length": 0.03, "froude": 0.05, "duration": 0.9}
    | {"settling": 0.3, "checkpoints": 2},
    "hopper": {"orifice": 8, "layers": 10, "timestep": 3e-5, "duration": 0.7, "rows": 150}
    | {"filling": 0.2, "checkpoints": 1},
}


def short_settings(deck: str, label: str = "") -> dict[str, object]:
    """Return the settings of a deck in `STEADY_FLOWS`, or else those of its short run `label`."""
    return STEADY_FLOWS.get(deck) or dict(deck_class(deck).briefs[label].settings)
