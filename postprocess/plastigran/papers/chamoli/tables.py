# SPDX-License-Identifier: GPL-2.0-or-later
"""Tables: impacts compared with Hertz, energies, restitution, oscillations and modes."""

from __future__ import annotations

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
NEAR = 0.01  # relative distance within which a peak belongs to a mode


def tables(computed: Computed) -> dict[str, pd.DataFrame]:
    """Return the tables by name."""
    kinds = (impacts, energies, restitution, oscillations, modes, viscoelastic)
    found = {table.__name__: table(computed) for table in kinds}
    return found | {"deviations": deviations(found["impacts"])}


def impacts(computed: Computed) -> pd.DataFrame:
    """Return largest force, largest approach and duration, by Hertz' closed forms and LIGGGHTS."""
    quantities = {
        "force_max": ("largest force", "N", 1.0),
        "overlap_max": ("largest approach", "µm", MICRO),
        "contact_time": ("duration", "µs", MICRO),
    }
    rows = []
    for impact, found in computed.vibrations.items():
        engine, hertz = computed.engine.loc[impact], sphere(impact[0])
        approach = hertz.approach_max(impact[1])
        closed = {
            "force_max": hertz.force(approach),
            "overlap_max": approach,
            "contact_time": hertz.duration(impact[1]),
        }
        widest = found.history["contact_radius"].max() / RADIUS
        for name, (quantity, unit, factor) in quantities.items():
            rows.append(
                {
                    **_named(impact),
                    "a/R": widest,
                    "quantity": quantity,
                    "unit": unit,
                    "Hertz": factor * closed[name],
                    "finite elements": factor * getattr(found, name),
                    "LIGGGHTS": factor * engine[name],
                }
            )
    table = add_difference(pd.DataFrame(rows), "finite elements", "Hertz")
    return add_difference(table, "LIGGGHTS", "Hertz")


def deviations(impacts: pd.DataFrame) -> pd.DataFrame:
    """Return one row per impact: how the finite elements differ from Hertz, in per cent."""
    difference = "finite elements vs Hertz (%)"
    rows = []
    for named, group in impacts.groupby(["E (GPa)", "speed (m/s)", "a/R"], sort=False):
        by_quantity = group.set_index("quantity")[difference]
        row = dict(zip(("E (GPa)", "speed (m/s)", "a/R"), named, strict=True))
        rows.append(row | {f"{name} (%)": value for name, value in by_quantity.items()})
    return pd.DataFrame(rows)


def energies(computed: Computed) -> pd.DataFrame:
    """Return shares of the impact energy, and the error of the total."""
    rows = []
    for impact, found in computed.vibrations.items():
        history = found.history
        parts = history[["kinetic_energy", "elastic_energy", "penalty_energy"]]
        total = parts.sum(axis=1)
        share = parts / total.iloc[0]
        flight = share.loc[found.flight.index]
        rows.append(
            {
                **_named(impact),
                "energy (µJ)": MICRO * total.iloc[0],
                "strain, largest in contact": share["elastic_energy"].max(),
                "kinetic, smallest in contact": share["kinetic_energy"].min(),
                "penalty, largest": share["penalty_energy"].max(),
                "strain, mean in flight": flight["elastic_energy"].mean(),
                "strain, largest in flight": flight["elastic_energy"].max(),
                "energy error": (total / total.iloc[0] - 1).abs().max(),
            }
        )
    return pd.DataFrame(rows)


def restitution(computed: Computed) -> pd.DataFrame:
    """Return 1 - e by momentum and by kinetic energy, because all e are close to one."""
    gravest = computed.modes["frequency"].min()
    rows = []
    for impact, found in computed.vibrations.items():
        kinetic = np.sqrt(
            found.flight["kinetic_energy"] / found.history["kinetic_energy"].iloc[0]
        ).to_numpy()
        rows.append(
            {
                **_named(impact),
                "periods in contact": found.contact_time * gravest * np.sqrt(impact[0] / HARD),
                "1 − e, momentum": 1 - found.coefficient_of_restitution,
                "1 − e, kinetic energy": 1 - found.kinetic_restitution,
                "least": 1 - kinetic.max(),
                "most": 1 - kinetic.min(),
                "vibration energy": found.vibration_energy,
                "in twelve modes": _shares(found).sum(),
                "1 − e, LIGGGHTS": 1 - computed.engine.loc[impact]["coefficient_of_restitution"],
            }
        )
    return pd.DataFrame(rows)


def oscillations(computed: Computed) -> pd.DataFrame:
    """Return the oscillation of the force about a smooth curve during contact."""
    rows = []
    for impact, found in computed.vibrations.items():
        force = oscillation(found)
        frequencies, amplitudes = peaks(*spectrum(force.share, found.timestep), least=0.5)
        gravest = computed.modes["frequency"].min() * np.sqrt(impact[0] / HARD)
        rows.append(
            {
                **_named(impact),
                "rms/largest force": np.sqrt(np.mean(force.share**2)),
                "peak/largest force": np.abs(force.share).max(),
                "fundamental mode (kHz)": KHZ * gravest,
                "strongest (kHz)": KHZ * frequencies[np.argmax(amplitudes)],
            }
        )
    return add_difference(pd.DataFrame(rows), "strongest (kHz)", "fundamental mode (kHz)")


def modes(computed: Computed) -> pd.DataFrame:
    """Return free vibrations: exact, of the mesh, and peaks of the spectra.

    The spectra are those after the fastest impact. Further columns are the energies of the modes
    after some impacts.

    Further columns are the energies of the modes after some impacts.
    """
    found = computed.vibrations[HARD, 5.0]
    table = nearest_modes(found.modes["frequency"], computed.modes)
    table = table.rename(columns={"found": "mesh"})
    seen = np.concatenate([found.peaks(signal)["frequency"] for signal in SIGNALS])
    difference = np.abs(seen[:, None] / table["frequency"].to_numpy() - 1)
    peak = seen[np.argmin(difference, axis=0)]
    table["peak"] = np.where(difference.min(axis=0) < NEAR, peak, np.nan)
    for impact in SHOWN:
        modulus, speed = _named(impact).values()
        table[f"energy at {speed:g} m/s, {modulus:g} GPa"] = _shares(computed.vibrations[impact])
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
    number = viscoelastic_number(
        ice.dissipative_constant,
        impact.radius_eff,
        impact.mass_eff,
        impact.pair.youngs_modulus_eff,
        speeds,
    )
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


def _named(impact: Impact) -> dict[str, float]:
    modulus, speed = impact
    return {"E (GPa)": modulus / 1e9, "speed (m/s)": speed}


def _shares(vibration: Vibration) -> np.ndarray:
    """Return the energy of each mode divided by that of the impact."""
    energy = vibration.history["kinetic_energy"].iloc[0]
    return (vibration.modes["energy"] / energy).to_numpy()
