# SPDX-License-Identifier: GPL-2.0-or-later
"""Figures of a vibrating sphere's impacts: force, energies, restitution and spectra."""

from __future__ import annotations

import numpy as np
from matplotlib.figure import Figure

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

FLIGHT_SHOWN = 1.0  # shown time of flight / duration of contact
TOROIDAL = PAPER_MODES["toroidal", 1, 0]


@styled()
def impact_figure(computed: Computed) -> Figure:
    """Draw force, approach and oscillation of the force versus time, relative to Hertz' values."""
    figure, panels = subplots(1, 3, figsize=(11, 3.6))
    for colour, impact in zip(COLOURS, SHOWN, strict=False):
        vibration = computed.vibrations[impact]
        force, approach, duration = _hertz_units(impact)
        history = vibration.history[vibration.history["time"] < 1.2 * vibration.contact_time]
        time = history["time"] / duration
        panels[0].plot(time, history["force"] / force, color=colour)
        panels[1].plot(time, history["approach"] / approach, color=colour, label=_label(impact))
        swing = oscillation(vibration)
        panels[2].plot(swing["time"] / duration, 100 * swing["relative_force"], color=colour)
    # Draw one Hertz impact, because all Hertz impacts coincide in these units.
    force, approach, duration = _hertz_units(SHOWN[0])
    hertz = sphere(SHOWN[0][0])
    time, overlap = hertz_history(RADIUS, hertz.mass, hertz.modulus, SHOWN[0][1])
    curves = (hertz_force(RADIUS, hertz.modulus, overlap) / force, overlap / approach)
    for panel, curve in zip(panels, curves, strict=False):
        panel.plot(time / duration, curve, color="k", ls="--", lw=1, label="Hertz")
    panels[1].legend(loc="lower left", fontsize=8)
    titles = ("force / largest Hertz force", "approach / largest Hertz approach")
    for panel, title in zip(panels, (*titles, "oscillation (%)"), strict=True):
        panel.set_title(title, fontsize=10)
        panel.set_xlabel("time / duration of a Hertz impact")
    return figure


def _hertz_units(impact: Impact) -> tuple[float, float, float]:
    """Return largest force [N], largest approach [m] and duration [s] of a Hertz impact."""
    modulus, speed = impact
    hertz = sphere(modulus)
    approach = hertz.approach_max(speed)
    return hertz.force(approach), approach, hertz.duration(speed)


@styled()
def energies_figure(computed: Computed) -> Figure:
    """Draw kinetic, strain and penalty energy / impact energy versus time, and vibration energy.

    Penalty energy is the energy of the stiff springs that represent the rigid plane.
    """
    figure, grid = subplots(2, len(SHOWN), figsize=(11, 5.2), sharex=True)
    parts = (
        ("kinetic energy", "kinetic_energy", "-"),
        ("kinetic energy of the center of mass", "centre_kinetic_energy", "--"),
        ("strain energy", "elastic_energy", "-"),
        ("penalty energy", "penalty_energy", "-"),
    )
    for (above, below), impact in zip(grid.T, SHOWN, strict=True):
        vibration = computed.vibrations[impact]
        shares = vibration.history / vibration.history["kinetic_energy"].iloc[0]
        time = vibration.history["time"] / vibration.contact_time
        shown = time < 1 + FLIGHT_SHOWN
        for colour, (label, name, line) in zip(COLOURS, parts, strict=False):
            above.plot(time[shown], shares[name][shown], line, color=colour, label=label)
        inner = shares["kinetic_energy"] - shares["centre_kinetic_energy"]
        below.semilogy(
            time[shown], inner[shown], color=COLOURS[0], label="kinetic energy of the vibration"
        )
        strain = shares["elastic_energy"][shown]
        below.semilogy(time[shown], strain, color=COLOURS[2], label="strain energy")
        below.set_ylim(bottom=1e-3 * vibration.vibration_energy)
        above.set_title(_label(impact), fontsize=10)
        below.set_xlabel("time / duration of contact")
    for panel in grid[:, 0]:
        panel.set_ylabel("fraction of the energy")
        panel.legend(fontsize=8)
    return figure


@styled()
def restitution_figure(computed: Computed) -> Figure:
    """Draw 1 - e versus speed, where the restitution e follows from momentum or kinetic energy."""
    figure, axes = subplots(figsize=(5.6, 4))
    vibrations = [v for (modulus, _), v in computed.vibrations.items() if modulus == HARD]
    vibrations.append(computed.vibrations[SHOWN[-1]])
    # Divide speeds by the wave speed, so that the points of both spheres lie on one curve.
    wave_speeds = [np.sqrt(v.material.youngs_modulus / v.material.density) for v in vibrations]
    speeds = np.array([v.speed for v in vibrations]) / wave_speeds
    in_modes = [v.modes["energy"].sum() / v.history["kinetic_energy"][0] for v in vibrations]
    for line, label, values in (
        ("o-", "1 − e, momentum", [1 - v.coefficient_of_restitution for v in vibrations]),
        ("s-", "1 − e, total kinetic energy", [1 - v.kinetic_restitution for v in vibrations]),
        ("^:", "half of the vibration energy in twelve modes", np.array(in_modes) / 2),
    ):
        axes.loglog(speeds, values, line, color=COLOURS[len(axes.lines)], label=label)
    axes.set_xlabel("speed / $(E/\\rho)^{1/2}$")
    axes.legend()
    return figure


@styled()
def spectrum_figure(computed: Computed) -> Figure:
    """Draw the spectra of the flight after some impacts, and the frequencies of the exact modes."""
    figure, panels = subplots(len(SHOWN), 1, figsize=(7.5, 6), sharex=True)
    highest = 1.04e-3 * computed.vibrations[SHOWN[1]].modes["frequency"].max()
    # The last number of each signal is signal frequency / mode frequency. It is 2 for the strain
    # energy, which oscillates twice per period of a mode.
    signals = (
        ("strain energy", "middle_elastic_energy", 2),
        ("top", "top_displacement", 1),
        ("equator", "equator_displacement", 1),
    )
    for panel, impact in zip(panels, SHOWN, strict=True):
        scale = 1e-3 * np.sqrt(HARD / impact[0])
        for colour, (label, name, oscillations) in zip(COLOURS, signals, strict=False):
            frequency, amplitude = computed.vibrations[impact].spectrum(name)
            frequency = scale * frequency / oscillations
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
    panels[0].text(TOROIDAL, 2.3, "toroidal", ha="center", fontsize=7, color=COLOURS[3])
    panels[-1].legend(loc="lower left", fontsize=7, handlelength=1)
    panels[-1].set_xlabel("frequency, scaled to a Young's modulus of 9.3 GPa (kHz)")
    return figure


def _label(impact: Impact) -> str:
    modulus, speed = impact
    unit, factor = ("GPa", 1e-9) if modulus > 1e9 else ("MPa", 1e-6)
    return f"{speed:g} m/s, {factor * modulus:g} {unit}"
