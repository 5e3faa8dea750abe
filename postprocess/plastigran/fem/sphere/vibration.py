# SPDX-License-Identifier: GPL-2.0-or-later
"""Results of the impact of an elastic sphere and of its vibration in flight.

The strain energy of a free body is a sum over its vibration modes, because the modes are orthogonal
with respect to the stiffness matrix. In the spectrum of the energy, each mode therefore has only
one peak, at twice its frequency.
"""

from __future__ import annotations

from math import pi

import attrs
import numpy as np
import pandas as pd

from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.result_file import numbers
from plastigran.fem.sphere.spectrum import peaks, spectrum

LEAST_PEAK = 0.01  # smallest amplitude of a peak / largest amplitude of the spectrum
SIGNALS = ("middle_elastic_energy", "top_displacement", "equator_displacement")


@attrs.frozen
class Vibration:
    """Results of the impact of an elastic sphere on a plane, and of its vibration afterwards.

    Attributes:
        material: Material of the sphere.
        radius: Radius of the sphere, m.
        speed: Impact speed, m/s.
        timestep: Time step, s.
        history: Table with one row per time step. Columns are time s, force N (mean over the step
            that ends at this time) and contact_radius m. Columns of the center of mass are approach
            m, velocity m/s (upward) and centre_kinetic_energy J. Columns of the whole body are
            kinetic_energy, elastic_energy, penalty_energy and middle_elastic_energy J, which is the
            elastic energy at the mean displacement of the step. This mean filters vibrations that
            the steps do not resolve. Displacements relative to the center of mass are
            top_displacement m (upward, of the pole far from the plane) and equator_displacement m
            (outward).
        modes: Table with one row for each of the lowest vibration modes of the mesh. Columns are
            frequency Hz, energy J at the end, and contact_displacement kg^-1/2: the normal
            displacement at the contact point for unit modal mass.
        coefficient_of_restitution: Momentum after the impact / momentum before the impact.
        kinetic_restitution: Square root of the mean kinetic energy in flight / kinetic energy
            before the impact. It counts half of the vibration energy as rebound.
        force_max: Largest force, N.
        overlap_max: Largest approach, m.
        contact_time: Duration of the contact, s.
        vibration_energy: Vibration energy / impact energy.
        stopped: Reason for an early end of the computation; otherwise empty.
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
        """Part of the history after the end of contact."""
        last = np.flatnonzero(self.history["force"])[-1]
        return self.history.iloc[last + 1 :]

    def spectrum(self, signal: str) -> tuple[np.ndarray, np.ndarray]:
        """Return the amplitude spectrum of a column of the history, in flight.

        Args:
            signal: Name of the column.

        Returns:
            Frequencies, Hz, and amplitudes in the unit of the column.
        """
        return spectrum(self.flight[signal].to_numpy(), self.timestep)

    def peaks(self, signal: str, least: float = LEAST_PEAK) -> pd.DataFrame:
        """Return the frequencies of the vibrations that a column of the history shows in flight.

        The midpoint rule with the time step dt changes a frequency f to f', where
        tan(pi f' dt) = pi f dt. This function returns f. Energies have twice the frequency of their
        vibration; this function returns the frequency of the vibration. Frequencies above those of
        the computed vibration modes are omitted.

        Args:
            signal: Name of the column.
            least: Smallest amplitude of a peak / largest amplitude of the spectrum.

        Returns:
            Table of frequency, Hz, and amplitude in the unit of the column.
        """
        frequencies, amplitudes = peaks(*self.spectrum(signal), least)
        if signal.endswith("energy"):
            frequencies = frequencies / 2
        frequencies = np.tan(pi * frequencies * self.timestep) / (pi * self.timestep)
        table = pd.DataFrame({"frequency": frequencies, "amplitude": amplitudes})
        return table[table["frequency"] < 1.01 * self.modes["frequency"].max()]

    def to_dict(self) -> dict:
        """Return the results that are numbers, for a JSON file."""
        result = numbers(self)
        if not self.stopped:
            result |= {f"{name}_peaks": self.peaks(name).to_dict("list") for name in SIGNALS}
        tables = {"modes": self.modes, "history": self.history}
        return result | {name: table.to_dict("list") for name, table in tables.items()}
