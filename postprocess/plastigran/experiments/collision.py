# SPDX-License-Identifier: GPL-2.0-or-later
"""Measure a single collision from the trajectory that a collision deck writes."""

from __future__ import annotations

from collections.abc import Callable
from math import nan
from pathlib import Path

import attrs
import numpy as np
import pandas as pd

from plastigran.engine.dumps import read_dump


class CollisionError(ValueError):
    """A trajectory contains no complete collision."""


@attrs.frozen(eq=False)
class CollisionOutcome:
    """Measured or predicted outcome of one collision.

    Attributes:
        closing_speed: Closing speed before the contact [m/s].
        coefficient_of_restitution: Normal separation speed / closing speed [-]; 0 if the bodies
            stick.
        force_max: Largest force [N]. A measured value is the largest force in all frames.
        overlap_max: Largest overlap [m].
        overlap_res: Overlap at zero force during unloading [m].
        loading_time: Time from first touch to largest overlap [s]; None if not predicted.
        contact_time: Time from first touch to the end of contact [s]; NaN if the bodies stick,
            None if not predicted.
        in_range: Whether the overlap stays within the validity range of the law; None if measured.
        loop: Collision over time, one row per frame. Columns are time [s], overlap [m], force [N]
            and speed [m/s] (rate of the overlap). None if predicted.
    """

    closing_speed: float
    coefficient_of_restitution: float
    force_max: float
    overlap_max: float
    overlap_res: float
    loading_time: float | None = None
    contact_time: float | None = None
    in_range: bool | None = None
    loop: pd.DataFrame | None = None


def force_overlap_loop(trajectory: pd.DataFrame) -> pd.DataFrame:
    """Return overlap and force over time for two spheres, or one sphere at the wall x = 0.

    Args:
        trajectory: Frames of a `dump custom` file with the columns id, radius, x, y, z, vx, vy, vz,
            fx, fy, fz and time.

    Returns:
        One row per frame: time, overlap, force and speed; see `CollisionOutcome.loop`.

    Raises:
        CollisionError: Columns are missing, or there are more than two spheres.
    """
    xyz, vel, frc = ["x", "y", "z"], ["vx", "vy", "vz"], ["fx", "fy", "fz"]
    missing = {"id", "radius", "time", *xyz, *vel, *frc} - set(trajectory.columns)
    if missing:
        raise CollisionError(f"the trajectory has no column {', '.join(sorted(missing))}")
    bodies = [part.reset_index(drop=True) for _, part in trajectory.groupby("id")]
    first = bodies[0]
    if len(bodies) == 1:
        normal = np.tile([1.0, 0.0, 0.0], (len(first), 1))
        distance = first["x"].to_numpy()
        reach = first["radius"].to_numpy()
        approach = first[vel].to_numpy()
    elif len(bodies) == 2:
        second = bodies[1]
        separation = first[xyz].to_numpy() - second[xyz].to_numpy()
        distance = np.linalg.norm(separation, axis=1)
        normal = separation / distance[:, None]
        reach = (first["radius"] + second["radius"]).to_numpy()
        approach = first[vel].to_numpy() - second[vel].to_numpy()
    else:
        raise CollisionError(f"the trajectory has {len(bodies)} spheres; it must have one or two")
    along = np.einsum("ij,ij->i", normal, first[frc].to_numpy())
    return pd.DataFrame(
        {
            "time": first["time"].to_numpy(),
            "overlap": reach - distance,
            "force": along,
            "speed": -np.einsum("ij,ij->i", normal, approach),
        }
    )


def measure(trajectory: str | Path | pd.DataFrame) -> CollisionOutcome:
    """Measure the collision in a trajectory.

    The function interpolates between frames. The largest overlap is the maximum of the cubic
    through the overlaps and speeds of two frames. The residual overlap is the overlap of zero force
    on the unloading curve through the last loaded frames.

    Args:
        trajectory: Path of a `dump custom` file written every step, or its table from `read_dump`.

    Raises:
        CollisionError: The bodies never touch, or are still in contact at the end.
    """
    if not isinstance(trajectory, pd.DataFrame):
        trajectory = read_dump(trajectory)
    return measure_loop(force_overlap_loop(trajectory))


def measure_loop(loop: pd.DataFrame) -> CollisionOutcome:
    """Measure a collision from a table as in `CollisionOutcome.loop`; see `measure`.

    The separation speed is the speed in the first frame after the contact, because the speed may
    change later for other reasons.

    Raises:
        CollisionError: The bodies never touch, or are still in contact at the end.
    """
    time, overlap, force, speed = (
        loop[c].to_numpy() for c in ("time", "overlap", "force", "speed")
    )
    touching = np.flatnonzero(force)
    if touching.size == 0:
        raise CollisionError("the bodies never touch")
    start, last = touching[0], touching[-1]
    if start == 0:
        raise CollisionError("the bodies are already in contact in the first frame")
    opening = np.flatnonzero(speed[start:] < 0) + start
    turn = int(opening[0]) if opening.size else len(loop)  # first frame of unloading
    stuck = last == len(loop) - 1 and bool((speed[turn:] > 0).any())
    if not stuck and (last == len(loop) - 1 or speed[-1] >= 0):
        raise CollisionError(
            f"the bodies are still in contact in the last frame (t = {time[-1]:g} s). "
            "Increase the duration of the run"
        )
    before = start - 1
    touch = time[before] - overlap[before] / speed[before]
    turning_time, overlap_max = _turning_point(time, overlap, speed, turn - 1)

    pressed = turn + int(np.argmin(np.append(force[turn:], 0) > 0)) - 1  # last repulsive frame
    rebound = slice(max(pressed - 3, turn), pressed + 1)
    attracted = force[pressed + 1] < 0
    if attracted:
        share = force[pressed] / (force[pressed] - force[pressed + 1])
        overlap_res = overlap[pressed] + share * (overlap[pressed + 1] - overlap[pressed])
        release = time[last]
    else:
        overlap_res = _residual(overlap[rebound], force[rebound])
        release = time[last] + (overlap[last] - overlap_res) / -speed[last]
    return CollisionOutcome(
        closing_speed=speed[start - 1],
        coefficient_of_restitution=0.0 if stuck else -speed[last + 1] / speed[start - 1],
        force_max=force.max(),
        overlap_max=overlap_max,
        overlap_res=0.0 if abs(overlap_res) < 1e-6 * overlap_max else overlap_res,
        loading_time=turning_time - touch,
        contact_time=nan if stuck else release - touch,
        loop=loop,
    )


def _residual(overlap, force) -> float:
    """Return the overlap at zero force from the last frames of a rebound, in order of time.

    In most laws, the force during unloading is proportional to (overlap - overlap_res)^n with n
    near 3/2. In `universal`, it is proportional to (overlap - overlap_res)^(3/2) divided by a
    linear function of (overlap - overlap_res)^(1/2). Three frames determine the constants of either
    form. A fourth frame, if there is one, selects the form.
    """
    last = overlap[-3:], force[-3:]
    residual, power = _end_of_power(*last)
    if len(overlap) < 4:
        return residual
    bent_residual, bent_power = _end_of_bent_power(*last)
    power_error = abs(power(overlap[-4]) - force[-4])
    bent_error = abs(bent_power(overlap[-4]) - force[-4])
    return bent_residual if bent_error < power_error else residual


def _end_of_power(overlap, force) -> tuple[float, Callable]:
    """Fit force = c (overlap - overlap_res)^n to three frames; with fewer frames, n is 3/2.

    With the right n, force^(1/n) is a linear function of the overlap.

    Returns:
        The residual overlap, and the fitted force as a function of the overlap.
    """
    from scipy.optimize import brentq  # imported here: scipy.optimize is slow

    def slopes(n: float):
        return np.diff(force ** (1 / n)) / np.diff(overlap)

    n = 1.5
    if len(overlap) == 3:

        def bend(n: float) -> float:
            return np.subtract(*slopes(n))

        # Start the search below n = 1, which is the exponent of linear unloading.
        if bend(0.9) * bend(3.0) < 0:
            n = brentq(bend, 0.9, 3.0, xtol=1e-9)
    residual = overlap[-1] - force[-1] ** (1 / n) / slopes(n)[-1]
    left = overlap[-1] - residual
    return residual, lambda at: force[-1] * ((at - residual) / left) ** n


def _end_of_bent_power(overlap, force) -> tuple[float, Callable]:
    """Fit force = c z^3/(1 + g z) with z = (overlap - overlap_res)^(1/2) to three frames.

    c and g are constants. With the right overlap_res, z^3/force is a linear function of z. Without
    a solution, the results are NaN.

    Returns:
        As for `_end_of_power`.
    """
    from scipy.optimize import brentq  # imported here: scipy.optimize is slow

    def line(residual: float):
        z = np.sqrt(overlap - residual)
        return z, z**3 / force

    def bend(residual: float) -> float:
        z, over = line(residual)
        return np.subtract(*(np.diff(over) / np.diff(z)))

    # Begin the search far from the last frame, because a second root lies close to this frame.
    reach = overlap[-1] - (overlap[0] - overlap[-1]) * np.geomspace(3, 1e-6, 40)
    bends = np.array([bend(residual) for residual in reach])
    signs = np.flatnonzero(bends[1:] * bends[:-1] < 0)
    if signs.size == 0:
        return np.nan, lambda at: np.nan
    residual = brentq(bend, reach[signs[0]], reach[signs[0] + 1], xtol=1e-9 * overlap[-1])
    z, over = line(residual)
    slope, level = np.polyfit(z, over, 1)

    def bent(at: float) -> float:
        root = np.sqrt(at - residual)
        return root**3 / (level + slope * root)

    return residual, bent


def _turning_point(time, value, rate, k: int) -> tuple[float, float]:
    """Return time and value of the maximum of the cubic between frames k and k+1."""
    step = time[k + 1] - time[k]
    fraction = rate[k] / (rate[k] - rate[k + 1])  # the linearly interpolated rate is zero here
    h = np.polynomial.Polynomial
    t = h([0, 1])
    cubic = (
        value[k] * (1 - 3 * t**2 + 2 * t**3)
        + value[k + 1] * (3 * t**2 - 2 * t**3)
        + step * rate[k] * (t - 2 * t**2 + t**3)
        + step * rate[k + 1] * (t**3 - t**2)
    )
    return time[k] + fraction * step, float(cubic(fraction))
