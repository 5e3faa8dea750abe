# SPDX-License-Identifier: GPL-2.0-or-later
"""Spectra of evenly sampled signals, and frequencies of their peaks."""

from __future__ import annotations

import numpy as np

PADDING = 8  # zero-padding factor, which interpolates peaks without improving the resolution


def spectrum(values: np.ndarray, timestep: float) -> tuple[np.ndarray, np.ndarray]:
    """Return the amplitude spectrum of a signal after its mean is subtracted.

    With the Blackman-Harris window, the spectrum of a sinusoid is below 3e-5 of its amplitude at
    frequency distances above 4/duration (Harris 1978, Proc. IEEE 66:51).

    Args:
        values: Values at equal time steps (n,).
        timestep: Time step, s.

    Returns:
        Frequencies, Hz, and amplitudes in the unit of the values; each (4 n + 1,).
    """
    from scipy.signal.windows import blackmanharris  # imported here: scipy.signal is slow

    window = blackmanharris(len(values), sym=False)
    weighted = window * (values - np.average(values, weights=window))
    size = PADDING * len(values)
    amplitudes = 2 / window.sum() * np.abs(np.fft.rfft(weighted, size))
    return np.fft.rfftfreq(size, timestep), amplitudes


def peaks(
    frequencies: np.ndarray, amplitudes: np.ndarray, least: float = 0.01
) -> tuple[np.ndarray, np.ndarray]:
    """Return the peaks of a spectrum.

    A parabola through the logarithms of three amplitudes gives each peak.

    Args:
        frequencies: Evenly spaced frequencies (n,), Hz, starting at 0.
        amplitudes: Amplitudes (n,).
        least: Smallest amplitude of a peak / largest amplitude of the spectrum.

    Returns:
        Increasing frequencies, Hz, and amplitudes; each (n_peaks,).
    """
    from scipy.signal import find_peaks  # imported here: scipy.signal is slow

    least = least * amplitudes.max()
    indices, _ = find_peaks(amplitudes, height=least, prominence=least)
    below, here, above = (np.log(amplitudes[indices + shift]) for shift in (-1, 0, 1))
    shift = (below - above) / (2 * (below - 2 * here + above))
    tops = np.exp(here - (below - above) * shift / 4)
    return frequencies[indices] + shift * frequencies[1], tops
