# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables of a vibrating sphere's impacts: Hertz, energies, restitution, oscillations, modes."""

from __future__ import annotations

from collections.abc import Callable

import numpy as np
import pandas as pd

from plastigran.experiments.central import CentralImpact
from plastigran.fem.sphere.spectrum import peaks, spectrum
from plastigran.fem.sphere.vibration import SIGNALS, Vibration
from plastigran.materials import read_material
from plastigran.papers.chamoli.computations import (
    HARD,
    ICE_RADIUS,
    ICE_RESTITUTION,
    PAPER_MODES,
    RADIUS,
    SHOWN,
    Computed,
    Impact,
    material,
    oscillation,
    sphere,
)
from plastigran.physics.central import viscoelastic_number, viscoelastic_restitution
from plastigran.physics.impact_modes import nearest_modes
from plastigran.physics.modes import sphere_modes
from plastigran.report.base import add_difference

KHZ, MICRO = 1e-3, 1e6
NEAR = 0.01  # largest relative difference between the frequencies of a mode and of its peak


def impacts(computed: Computed) -> pd.DataFrame:
    """Return largest force, largest approach and duration: Hertz, finite elements and LIGGGHTS."""
    rows = []
    for impact, vibration in computed.vibrations.items():
        hertz, speed = sphere(impact[0]), impact[1]
        approach = hertz.approach_max(speed)
        for name, quantity, unit, factor, closed_form in (
            ("force_max", "largest force", "N", 1.0, hertz.force(approach)),
            ("overlap_max", "largest approach", "µm", MICRO, approach),
            ("contact_time", "duration", "µs", MICRO, hertz.duration(speed)),
        ):
            rows.append(
                {
                    **_impact_columns(impact),
                    "a/R": vibration.history["contact_radius"].max() / RADIUS,
                    "quantity": quantity,
                    "unit": unit,
                    "Hertz": factor * closed_form,
                    "finite elements": factor * getattr(vibration, name),
                    "LIGGGHTS": factor * computed.engine.loc[impact][name],
                }
            )
    table = add_difference(pd.DataFrame(rows), "finite elements", "Hertz")
    return add_difference(table, "LIGGGHTS", "Hertz")


def deviations(computed: Computed) -> pd.DataFrame:
    """Return the differences between finite elements and Hertz [%], one row per impact."""
    difference = "finite elements vs Hertz (%)"
    keys = ["E (GPa)", "speed (m/s)", "a/R"]
    rows = [
        dict(zip(keys, values, strict=True))
        | dict(zip(rows["quantity"] + " (%)", rows[difference], strict=True))
        for values, rows in impacts(computed).groupby(keys, sort=False)
    ]
    return pd.DataFrame(rows)


def _by_impact(
    computed: Computed, row: Callable[[Impact, Vibration], dict[str, float]]
) -> pd.DataFrame:
    """Return a table with one row per impact; `row` returns the further columns of an impact."""
    return pd.DataFrame(
        [_impact_columns(impact) | row(impact, v) for impact, v in computed.vibrations.items()]
    )


def energies(computed: Computed) -> pd.DataFrame:
    """Return strain, kinetic and penalty energy / impact energy, and the energy error."""

    def row(_: Impact, vibration: Vibration) -> dict[str, float]:
        parts = vibration.history[["kinetic_energy", "elastic_energy", "penalty_energy"]]
        total = parts.sum(axis=1)
        share = parts / total.iloc[0]
        strain_in_flight = share.loc[vibration.flight.index, "elastic_energy"]
        return {
            "energy (µJ)": MICRO * total.iloc[0],
            "strain, largest in contact": share["elastic_energy"].max(),
            "kinetic, smallest in contact": share["kinetic_energy"].min(),
            "penalty, largest": share["penalty_energy"].max(),
            "strain, mean in flight": strain_in_flight.mean(),
            "strain, largest in flight": strain_in_flight.max(),
            "energy error": (total / total.iloc[0] - 1).abs().max(),
        }

    return _by_impact(computed, row)


def restitution(computed: Computed) -> pd.DataFrame:
    """Return 1 - e, with the restitution e computed from momentum and from kinetic energy.

    The table shows 1 - e, because e is close to one.
    """

    def row(impact: Impact, vibration: Vibration) -> dict[str, float]:
        initial = vibration.history["kinetic_energy"].iloc[0]
        kinetic = np.sqrt(vibration.flight["kinetic_energy"] / initial).to_numpy()
        engine = computed.engine.loc[impact]
        return {
            "periods in contact": vibration.contact_time * computed.fundamental_frequency(impact),
            "1 − e, momentum": 1 - vibration.coefficient_of_restitution,
            "1 − e, kinetic energy": 1 - vibration.kinetic_restitution,
            "least": 1 - kinetic.max(),
            "most": 1 - kinetic.min(),
            "vibration energy": vibration.vibration_energy,
            "in twelve modes": _mode_energies(vibration).sum(),
            "1 − e, LIGGGHTS": 1 - engine["coefficient_of_restitution"],
        }

    return _by_impact(computed, row)


def oscillations(computed: Computed) -> pd.DataFrame:
    """Return the oscillation of the force about a smooth curve during contact."""

    def row(impact: Impact, vibration: Vibration) -> dict[str, float]:
        force = oscillation(vibration)["relative_force"].to_numpy()
        frequencies, amplitudes = peaks(*spectrum(force, vibration.timestep), least=0.5)
        return {
            "rms/largest force": np.sqrt(np.mean(force**2)),
            "peak/largest force": np.abs(force).max(),
            "fundamental mode (kHz)": KHZ * computed.fundamental_frequency(impact),
            "strongest (kHz)": KHZ * frequencies[np.argmax(amplitudes)],
        }

    return add_difference(_by_impact(computed, row), "strongest (kHz)", "fundamental mode (kHz)")


def modes(computed: Computed) -> pd.DataFrame:
    """Return frequencies of free vibrations: exact, of the mesh, and peaks of the spectra.

    The spectra are from the flight after the fastest impact. Further columns are the energies of
    the modes after some impacts.
    """
    fastest = computed.vibrations[HARD, 5.0]
    table = nearest_modes(fastest.modes["frequency"], computed.modes)
    table = table.rename(columns={"measured": "mesh"})
    measured = np.concatenate([fastest.peaks(signal)["frequency"] for signal in SIGNALS])
    difference = np.abs(measured[:, None] / table["frequency"].to_numpy() - 1)
    nearest = measured[np.argmin(difference, axis=0)]
    table["peak"] = np.where(difference.min(axis=0) < NEAR, nearest, np.nan)
    for impact in SHOWN:
        modulus, speed = _impact_columns(impact).values()
        energies = _mode_energies(computed.vibrations[impact])
        table[f"energy at {speed:g} m/s, {modulus:g} GPa"] = energies
    ice = material(HARD)
    twisting = sphere_modes(HARD, ice.poissons_ratio, ice.density, RADIUS, [1], 1)
    table = pd.concat([table, twisting[twisting["kind"] == "toroidal"]])
    table = table.sort_values("frequency", ignore_index=True)
    names = table[["kind", "degree", "overtone"]].itertuples(index=False, name=None)
    table.insert(3, "thesis (kHz)", [PAPER_MODES.get(name, np.nan) for name in names])
    for old, new in {"frequency": "exact", "mesh": "mesh", "peak": "peak"}.items():
        table[old] *= KHZ
        table = table.rename(columns={old: f"{new} (kHz)"})
    table = table.drop(columns=["ka", "ha", "difference"])
    table = add_difference(table, "mesh (kHz)", "exact (kHz)")
    return add_difference(table, "peak (kHz)", "exact (kHz)")


def viscoelastic(computed: Computed) -> pd.DataFrame:
    """Return the restitution of a viscoelastic ice sphere: measured, closed form, law, LIGGGHTS."""
    ice, runs = read_material("ice"), computed.viscoelastic
    speeds = runs["speed"].to_numpy()
    factor, power = ICE_RESTITUTION
    impact = CentralImpact("viscoelastic_hertz", speeds[0], ice, ICE_RADIUS)
    bodies = impact.radius_eff, impact.mass_eff, impact.pair.youngs_modulus_eff
    number = viscoelastic_number(ice.dissipative_constant, *bodies, speeds)
    table = pd.DataFrame(
        {
            "speed (cm/s)": 100 * speeds,
            "measured": factor * (100 * speeds) ** power,
            "closed form": viscoelastic_restitution(number),
            "viscoelastic_hertz": runs["coefficient_of_restitution_predicted"].to_numpy(),
            "LIGGGHTS": runs["coefficient_of_restitution"].to_numpy(),
        }
    )
    table = add_difference(table, "viscoelastic_hertz", "closed form")
    return add_difference(table, "LIGGGHTS", "closed form")


def _impact_columns(impact: Impact) -> dict[str, float]:
    modulus, speed = impact
    return {"E (GPa)": modulus / 1e9, "speed (m/s)": speed}


def _mode_energies(vibration: Vibration) -> np.ndarray:
    """Return the energy of each mode / impact energy."""
    energy = vibration.history["kinetic_energy"].iloc[0]
    return (vibration.modes["energy"] / energy).to_numpy()
