# SPDX-License-Identifier: GPL-2.0-or-later
"""What comes of throwing an elastic sphere: the impact and the vibration it leaves.

The strain energy of a free body is a sum over its vibrations, each of which adds twice its own
frequency and no other: cross terms vanish, for vibrations are orthogonal in the stiffness.
"""

from __future__ import annotations

from math import pi

import attrs
import numpy as np
import pandas as pd

from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.sphere.spectrum import peaks, spectrum

LEAST_PEAK = 0.01  # over the largest
SIGNALS = ("middle_elastic_energy", "top_displacement", "equator_displacement")


@attrs.frozen
class Vibration:
    """An elastic sphere thrown at a plane, and its vibration afterwards.

    Attributes:
        material: The metal.
        radius: m.
        speed: m/s.
        timestep: s.
        history: One row for each step: time s, force N (mean over the step that ends there),
            approach m and velocity m/s (of the centre of mass, upward), contact_radius m,
            kinetic_energy, centre_kinetic_energy, elastic_energy, penalty_energy J,
            middle_elastic_energy J (of the mean displacement of the step, where vibrations that
            the steps do not resolve are filtered out),
            top_displacement and equator_displacement m (of the pole far from the plane, upward,
            and of the equator, outward, in the frame of the centre of mass).
        modes: One row for each of the gravest free vibrations of the mesh: frequency Hz, energy J
            in it at the end, and contact_displacement kg^-1/2, its shape of unit modal mass at the
            point of contact, along the normal.
        coefficient_of_restitution: Momentum after over before.
        kinetic_restitution: Square root of total kinetic energy after, the mean over the flight,
            over that before. It counts half the vibration's energy as rebound.
        force_max: N.
        overlap_max: Largest approach, m.
        contact_time: s.
        vibration_energy: Left in the sphere over the energy of the impact.
        stopped: Why it ended before its end; empty if it did not.
    """

    material: ElasticPlastic
    radius: float
    speed: float
    timestep: float
    history: pd.DataFrame
    modes: pd.DataFrame
    coefficient_of_restitution: float
    kinetic_restitution: float
    force_max: float
    overlap_max: float
    contact_time: float
    vibration_energy: float
    stopped: str = ""

    @property
    def flight(self) -> pd.DataFrame:
        """The rows of the history after the last one with a force."""
        last = np.flatnonzero(self.history["force"])[-1]
        return self.history.iloc[last + 1 :]

    def spectrum(self, signal: str) -> tuple[np.ndarray, np.ndarray]:
        """Frequencies, Hz, and amplitudes of a column of the history in flight."""
        return spectrum(self.flight[signal].to_numpy(), self.timestep)

    def peaks(self, signal: str, least: float = LEAST_PEAK) -> pd.DataFrame:
        """Frequencies of vibration that a column of the history shows in flight, up to the highest
        of `modes`.

        The midpoint rule makes of a frequency f the lower one f' with tan(pi f' dt) = pi f dt; f is
        what is given.

        Args:
            signal: The column. Energies show twice a vibration's frequency; what is given here is
                the vibration's own.
            least: Smallest amplitude over the largest.

        Returns:
            frequency, Hz, and amplitude in the column's unit.
        """
        found, amplitudes = peaks(*self.spectrum(signal), least)
        if signal.endswith("energy"):
            found = found / 2
        found = np.tan(pi * found * self.timestep) / (pi * self.timestep)
        table = pd.DataFrame({"frequency": found, "amplitude": amplitudes})
        return table[table["frequency"] < 1.01 * self.modes["frequency"].max()]

    def to_dict(self) -> dict:
        """Numbers only, for a file."""
        names = (
            "radius",
            "speed",
            "timestep",
            "stopped",
            "coefficient_of_restitution",
            "kinetic_restitution",
            "force_max",
            "overlap_max",
            "contact_time",
            "vibration_energy",
        )
        numbers = {name: getattr(self, name) for name in names}
        if not self.stopped:
            numbers |= {f"{name}_peaks": self.peaks(name).to_dict("list") for name in SIGNALS}
        tables = {"modes": self.modes, "history": self.history}
        return numbers | {name: table.to_dict("list") for name, table in tables.items()}
