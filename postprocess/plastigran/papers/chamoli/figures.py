# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures: impact, energies, restitution over speed, and spectra of the remaining vibration."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

from plastigran.fem.sphere.vibration import Vibration
from plastigran.papers.chamoli.computations import (
    HARD,
    PAPER_MODES,
    RADIUS,
    SHOWN,
    Computed,
    Impact,
    oscillation,
    sphere,
)
from plastigran.physics.central import hertz_force, hertz_history
from plastigran.plot.style import COLOURS, styled, subplots

FLIGHT_SHOWN = 1.0  # time after the contact that is shown, in contact durations
TOROIDAL = PAPER_MODES["toroidal", 1, 0]


def figures(computed: Computed) -> dict[str, Figure]:
    """Return the figures by name."""
    return {
        "impact": impact_figure(computed),
        "energies": energies_figure(computed),
        "restitution": restitution_figure(computed),
        "spectrum": spectrum_figure(computed),
    }


@styled()
def impact_figure(computed: Computed) -> Figure:
    """Draw force, center of mass and oscillation of the force over time, in Hertz' units."""
    figure, panels = subplots(1, 3, figsize=(11, 3.6))
    for colour, impact in zip(COLOURS, SHOWN, strict=False):
        found, hertz = computed.vibrations[impact], sphere(impact[0])
        approach = hertz.approach_max(impact[1])
        force, duration = hertz.force(approach), hertz.duration(impact[1])
        history = found.history[found.history["time"] < 1.2 * found.contact_time]
        time = history["time"] / duration
        panels[0].plot(time, history["force"] / force, color=colour)
        panels[1].plot(time, history["approach"] / approach, color=colour, label=_label(impact))
        swing = oscillation(found)
        panels[2].plot(swing.time / duration, 100 * swing.share, color=colour)
    # One curve is enough: in these units all Hertz impacts are the same.
    speed = SHOWN[0][1]
    hertz = sphere(SHOWN[0][0])
    approach = hertz.approach_max(speed)
    force, duration = hertz.force(approach), hertz.duration(speed)
    time, overlap = hertz_history(RADIUS, hertz.mass, hertz.modulus, speed)
    curves = (hertz_force(RADIUS, hertz.modulus, overlap) / force, overlap / approach)
    for panel, curve in zip(panels, curves, strict=False):
        panel.plot(time / duration, curve, color="k", ls="--", lw=1, label="Hertz")
    panels[1].legend(loc="lower left", fontsize=8)
    titles = ("force over Hertz' largest", "approach over Hertz' largest", "oscillation (%)")
    for panel, title in zip(panels, titles, strict=True):
        panel.set_title(title, fontsize=10)
        panel.set_xlabel("time over Hertz' duration")
    return figure


@styled()
def energies_figure(computed: Computed) -> Figure:
    """Draw shares of the impact energy over time, and the remaining energy in flight."""
    figure, grid = subplots(2, len(SHOWN), figsize=(11, 5.2), sharex=True)
    parts = {
        "kinetic": "kinetic_energy",
        "of it, the centre's": "centre_kinetic_energy",
        "strain": "elastic_energy",
        "penalty": "penalty_energy",
    }
    for (above, below), impact in zip(grid.T, SHOWN, strict=True):
        found = computed.vibrations[impact]
        history, energy = found.history, found.history["kinetic_energy"].iloc[0]
        time = history["time"] / found.contact_time
        shown = time < 1 + FLIGHT_SHOWN
        for colour, (label, name) in zip(COLOURS, parts.items(), strict=False):
            line = "--" if "centre" in name else "-"
            above.plot(time[shown], history[name][shown] / energy, line, color=colour, label=label)
        inner = history["kinetic_energy"] - history["centre_kinetic_energy"]
        below.semilogy(time[shown], inner[shown] / energy, color=COLOURS[0], label="of vibration")
        strain = history["elastic_energy"][shown] / energy
        below.semilogy(time[shown], strain, color=COLOURS[2], label="strain")
        below.set_ylim(bottom=1e-3 * found.vibration_energy)
        above.set_title(_label(impact), fontsize=10)
        below.set_xlabel("time over duration of contact")
    for panel in grid[:, 0]:
        panel.set_ylabel("share of the energy")
        panel.legend(fontsize=8)
    return figure


@styled()
def restitution_figure(computed: Computed) -> Figure:
    """Draw 1 - e over speed, by momentum and by kinetic energy."""
    figure, axes = subplots(figsize=(5.6, 4))
    hard = {v: found for (modulus, v), found in computed.vibrations.items() if modulus == HARD}
    soft = computed.vibrations[SHOWN[-1]]
    # Speeds are divided by the wave speed, so that both spheres lie on one curve.
    speeds = np.array([*(_mach(found) for found in hard.values()), _mach(soft)])
    found = [*hard.values(), soft]
    by_momentum = [1 - each.coefficient_of_restitution for each in found]
    by_energy = [1 - each.kinetic_restitution for each in found]
    in_modes = [each.modes["energy"].sum() / each.history["kinetic_energy"][0] for each in found]
    axes.loglog(speeds, by_momentum, "o-", color=COLOURS[0], label="1 − e, momentum")
    axes.loglog(speeds, by_energy, "s-", color=COLOURS[1], label="1 − e, total kinetic energy")
    halves = np.array(in_modes) / 2
    axes.loglog(speeds, halves, "^:", color=COLOURS[2], label="half the energy in twelve modes")
    axes.set_xlabel("speed over $(E/\\rho)^{1/2}$")
    axes.legend()
    return figure


@styled()
def spectrum_figure(computed: Computed) -> Figure:
    """Draw spectra in flight after some impacts, with the exact modes."""
    figure, panels = subplots(len(SHOWN), 1, figsize=(7.5, 6), sharex=True)
    highest = 1.04e-3 * computed.vibrations[SHOWN[1]].modes["frequency"].max()
    signals = {"strain energy": "middle_elastic_energy", "top": "top_displacement"}
    signals["equator"] = "equator_displacement"
    for panel, impact in zip(panels, SHOWN, strict=True):
        found = computed.vibrations[impact]
        scale = 1e-3 * np.sqrt(HARD / impact[0])
        for colour, (label, name) in zip(COLOURS, signals.items(), strict=False):
            frequency, amplitude = found.spectrum(name)
            half = 2 if name.endswith("energy") else 1
            frequency = scale * frequency / half
            shown = (frequency > 40) & (frequency < highest)
            largest = amplitude[shown].max()
            panel.semilogy(frequency[shown], amplitude[shown] / largest, color=colour, label=label)
        for mode in computed.modes.itertuples():
            line = "-" if mode.kind == "radial" else ":"
            panel.axvline(mode.frequency / 1e3, color="0.5", ls=line, lw=0.8, zorder=0)
        panel.axvline(TOROIDAL, color=COLOURS[3], ls="--", lw=1, zorder=0)
        panel.set(ylim=(1e-4, 2), xlim=(60, highest), ylabel=_label(impact))
        panel.grid(False)
    top = computed.modes[computed.modes["frequency"] < 1e3 * highest]
    for mode in top[top["overtone"] == 0].itertuples():
        panels[0].text(mode.frequency / 1e3, 2.3, f"n = {mode.degree}", ha="center", fontsize=7)
    panels[0].text(TOROIDAL, 2.3, "twist", ha="center", fontsize=7, color=COLOURS[3])
    panels[-1].legend(loc="lower left", fontsize=7, handlelength=1)
    panels[-1].set_xlabel("frequency of vibration, of the sphere of 9.3 GPa (kHz)")
    return figure


def _mach(vibration: Vibration) -> float:
    material = vibration.material
    return vibration.speed / np.sqrt(material.youngs_modulus / material.density)


def _label(impact: Impact) -> str:
    modulus, speed = impact
    unit, factor = ("GPa", 1e-9) if modulus > 1e9 else ("MPa", 1e-6)
    return f"{speed:g} m/s, {factor * modulus:g} {unit}"
