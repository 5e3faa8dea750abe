# SPDX-License-Identifier: GPL-2.0-or-later
"""Impacts of a rod run in the engine, measured, and held against its equations of motion."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass, replace
from itertools import product
from pathlib import Path

import numpy as np
import pandas as pd

from plastigran import laws
from plastigran.engine.dumps import read_dump
from plastigran.engine.process import run_deck
from plastigran.experiments.central import OVERLAP_LIMIT
from plastigran.experiments.collision import CollisionError, measure_loop
from plastigran.experiments.rod.body import Rod, RodImpact
from plastigran.physics.rod import simulate

#: The deck's spheres.
TIP, CENTRE, FAR_END = 1, 2, 3

#: The engine's friction models: `history` holds the tip by a spring until it pulls with mu F,
#: `no_history` is mu F as soon as the tip slides, as in the paper.
TANGENTIAL = ("history", "no_history", "off")

#: Speeds of the paper's drops [m/s]; 2.487 is that of the run it prints.
PAPER_SPEEDS = (0.5, 1.0, 1.75, 2.487, 3.25, 4.0)


@dataclass(frozen=True)
class RodRun:
    """One impact of a rod to run.

    Attributes:
        law: Name of the law, with its options at their defaults.
        speed: Straight down [m/s].
        rod: The rod and the flat.
        tangential: The engine's friction, one of `TANGENTIAL`.

    Raises:
        ValueError: One of them is out of range, or the engine cannot do it.
    """

    law: str
    speed: float
    rod: Rod
    tangential: str = "history"

    def __post_init__(self) -> None:
        if not 0 < self.speed < float("inf"):
            raise ValueError(f"speed is {self.speed}; it must be positive and finite")
        if self.tangential not in TANGENTIAL:
            raise ValueError(
                f"tangential is {self.tangential!r}; it must be one of {', '.join(TANGENTIAL)}"
            )
        if self.law == "hertz" and self.tangential == "no_history":
            raise ValueError(
                "the engine's own hertz, undamped, has no friction with tangential no_history"
            )
        reach = self.frozen().overlap_max / self.rod.tip_radius
        if reach > OVERLAP_LIMIT:
            raise ValueError(
                f"{self.law} at {self.speed:g} m/s would overlap by {reach:.2g} tip radii; "
                f"no contact law is good beyond {OVERLAP_LIMIT:g}"
            )

    def frozen(self) -> laws.Impact:
        """The impact as a central one of the mass the tip feels, `Rod.mass_eff`."""
        rod = self.rod
        return rod.law(self.law).central_impact(rod.tip_radius, rod.mass_eff, self.speed)

    def predicted(self) -> RodImpact:
        """The impact by the equations of motion with the same friction, without the engine."""
        rod = replace(self.rod, friction=0.0) if self.tangential == "off" else self.rod
        spring = self.tangential == "history"
        return simulate(rod, rod.law(self.law), self.speed, spring)

    def time_step(self) -> float:
        """Half the step recommended for the tip's sphere alone [s], a sixth of the rod's mass: the
        engine's check of the time step knows no more of the rod than that."""
        rod = self.rod
        law = rod.law(self.law)
        return 0.5 * law.recommended_time_step(rod.tip_radius, rod.tip_mass, self.speed)

    @property
    def label(self) -> str:
        """What tells its folder from others."""
        return f"rod_{self.rod.angle:g}_{self.law}_{self.speed:.3g}"

    def run(self, folder: str | Path) -> RodImpact:
        """Run the deck in the engine and measure.

        Raises:
            EngineError: The engine stopped with an error.
            CollisionError: The trajectory holds no whole impact.
        """
        rod = self.rod
        names = ("angle", "friction", "length", "mass", "tip_radius", "gravity")
        variables = {name: float(getattr(rod, name)) for name in names}
        flat = {f"flat_{name}": value for name, value in rod.flat.variables().items()}
        del flat["flat_density"]  # it does not move
        variables |= {"indentation_pressure": rod.indentation_pressure, **flat}
        variables |= {"law": self.law, "speed": self.speed, "tangential": self.tangential}
        variables |= {"timestep": self.time_step(), **rod.material.variables()}
        run_deck("collision/rod.in", variables, folder)
        return measure_rod(Path(folder) / "trajectory.dump", rod.gravity)

    def row(self, measured: RodImpact) -> dict[str, object]:
        """One line of the results table; `*_predicted` is the equations of motion."""
        predicted = self.predicted()
        line = {
            "law": self.law,
            "angle": self.rod.angle,
            "friction": self.rod.friction,
            "speed": self.speed,
        }
        for name in (
            "coefficient_of_restitution",
            "angular_velocity",
            "force_max",
            "overlap_max",
            "overlap_res",
            "loading_time",
            "contact_time",
        ):
            line[name] = getattr(measured, name)
            line[f"{name}_predicted"] = getattr(predicted, name)
        return {**line, "in_range": self.frozen().in_range, "time_step": self.time_step()}


def measure_rod(trajectory: str | Path | pd.DataFrame, gravity: float) -> RodImpact:
    """Measure a rod's impact from the trajectory `rod.in` writes.

    Args:
        trajectory: The dump, or the table `read_dump` makes of it.
        gravity: The deck's [m/s^2]; the dumped forces hold each sphere's weight.

    Raises:
        CollisionError: The table is not a rod's, the tip never touches or has not let go.
    """
    if not isinstance(trajectory, pd.DataFrame):
        trajectory = read_dump(trajectory)
    parts = {number: part.reset_index(drop=True) for number, part in trajectory.groupby("id")}
    if set(parts) != {TIP, CENTRE, FAR_END}:
        raise CollisionError(f"{len(parts)} spheres; the rod of rod.in has three")
    tip, centre = parts[TIP], parts[CENTRE]
    force = tip["fy"] + tip["mass"] * gravity
    loop = pd.DataFrame(
        {
            "time": tip["time"],
            "overlap": tip["radius"] - tip["y"],
            "force": force.where(force > 1e-9 * force.max(), 0),  # no rounding of the weight
            "speed": -tip["vy"],
        }
    )
    collision = measure_loop(loop)
    loaded = np.flatnonzero(loop["force"])
    before = loop.iloc[loaded[0] - 1]
    touch = before["time"] - before["overlap"] / before["speed"]
    history = pd.DataFrame(
        {
            "time": loop["time"] - touch,
            "overlap": loop["overlap"],
            "force": loop["force"],
            "friction_force": tip["fx"],
            "displacement_x": centre["x"] - centre["x"][loaded[0] - 1],
            "displacement_y": centre["y"] - centre["y"][loaded[0] - 1],
            "velocity_x": centre["vx"],
            "velocity_y": centre["vy"],
            "angular_velocity": centre["omegaz"],
            "slip_velocity": tip["vx"] + tip["omegaz"] * tip["radius"],
        }
    ).iloc[loaded[0] - 1 : loaded[-1] + 2]
    return RodImpact(
        coefficient_of_restitution=collision.coefficient_of_restitution,
        angular_velocity=history["angular_velocity"].iloc[-1],
        force_max=collision.force_max,
        overlap_max=collision.overlap_max,
        overlap_res=collision.overlap_res,
        loading_time=collision.loading_time,
        contact_time=collision.contact_time,
        history=history,
    )


def plan(
    law_names: Iterable[str],
    speeds: Iterable[float],
    rods: Iterable[Rod],
    tangential: str = "history",
) -> list[RodRun]:
    """Every combination of laws, speeds [m/s] and rods, each once.

    Raises:
        ValueError: One of them cannot be run; the message says why.
    """
    combinations = product(rods, law_names, (float(speed) for speed in speeds))
    return list(
        dict.fromkeys(RodRun(law, speed, rod, tangential) for rod, law, speed in combinations)
    )
