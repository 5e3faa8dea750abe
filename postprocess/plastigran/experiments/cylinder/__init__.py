# SPDX-License-Identifier: GPL-2.0-or-later
"""Central impacts of a cylinder on a plane, and the study of Katta & Polycarpou (2010).

In this study (J. Tribol. 132:041402), a rigid cylinder under a slider of 1.59 mg hits glass.
"""

from __future__ import annotations

from collections.abc import Callable
from math import sqrt
from typing import TYPE_CHECKING, ClassVar

import attrs
import pandas as pd

from plastigran.declared import Declaration, number, word
from plastigran.experiments.central import CentralImpact
from plastigran.experiments.cylinder import study
from plastigran.experiments.fields import Flag
from plastigran.experiments.runs import Runs
from plastigran.physics import central
from plastigran.usable_laws import laws_for

if TYPE_CHECKING:
    from matplotlib.figure import Figure


@attrs.frozen
class CylinderImpact(CentralImpact):
    """One central impact of a cylinder, which is a disc in a two-dimensional deck.

    `material` is the material of the body that yields. The second body is rigid.

    Raises:
        ValueError: A field is out of range, `body_thickness` is too small for the formula of
            the elastic line contact up to yield, or the overlap is too large for any law.
    """

    geometry: str = word("deck", ("cylinder_wall",), default="cylinder_wall")
    mass: float = number("mass that moves with the cylinder", "kg", 0, default=1.59e-6)
    length_ratio: float = number("length / radius of the cylinder", "-", 0, default=10.0)
    body_thickness: float = number("thickness of the body that yields", "m", 0, default=1e-4)

    command = "cylinder"
    help = (
        "compute impacts of a cylinder on a plane: maps of results versus radius and speed, "
        "and one impact compared with Katta & Polycarpou (2010)"
    )
    example = "plastigran cylinder --points 10"
    shape = "cylinder"
    has_theory = False  # the study always compares LIGGGHTS with theory
    geometries: ClassVar = {"cylinder_wall": 1}
    # At overlaps above the radius, the center of the disc would cross the wall. The paper uses
    # overlaps up to this limit; the validity range of the laws is smaller.
    overlap_ratio_max = 1.0
    flags: ClassVar = {
        "points": Flag(
            30,
            declaration=Declaration(
                "number of radii, and number of speeds, in each map",
                lower=1,
                lower_allowed=True,
                value_type=int,
            ),
            many=False,
        )
    }

    def __attrs_post_init__(self) -> None:
        if self.wall is not None:
            raise ValueError(f"wall is {self.wall.name}, but a cylinder must hit a rigid wall")
        self.yield_speed()  # raises an error if `body_thickness` is too small
        super().__attrs_post_init__()

    @property
    def mass_eff(self) -> float:
        return self.mass / self.bodies

    @property
    def cylinder_length(self) -> float:
        """Length of the cylinder [m]."""
        return self.length_ratio * self.radius

    def contact_law(self, **others: float | str):
        return super().contact_law(
            cylinder_length=self.cylinder_length, body_thickness=self.body_thickness, **others
        )

    def variables(self) -> dict[str, object]:
        variables = super().variables() | {"cylinder_length": self.cylinder_length}
        del variables["length_ratio"]
        return variables

    def yield_speed(self) -> float:
        """Return the speed of the cylinder at which the mean pressure reaches 1.5 sigma_Y [m/s]."""
        *_, work = central.line_yield(
            self.pair, self.radius_eff, self.cylinder_length, self.body_thickness
        )
        return sqrt(2 * work / self.mass_eff) / self.bodies

    @classmethod
    def cases(cls, points: int = 30) -> list[CylinderImpact]:
        """Return the impact that Katta & Polycarpou computed by finite elements, for each law."""
        return cls.plan(law=laws_for("cylinder"), material=study.MATERIAL, **study.FINITE_ELEMENTS)

    @classmethod
    def tables(cls, runs: Runs) -> dict[str, pd.DataFrame]:
        """Return the maps of the study, and a comparison of laws, LIGGGHTS and finite elements.

        The comparison is for the impact that the paper computed by finite elements.
        """
        table = study.comparison()
        for case, outcome in runs.outcomes.items():
            for column in ("overlap_res", "contact_time", "coefficient_of_restitution"):
                table.loc[case.law, f"{column}_engine"] = getattr(outcome, column)
        return {"maps": study.maps(runs.settings.get("points", 30)), "comparison": table}

    @classmethod
    def figures(cls, runs: Runs) -> dict[str, Callable[[], Figure]]:
        # Imported here, because matplotlib is slow to load.
        from plastigran.experiments.cylinder import figures

        def maps(ratio: float) -> Callable[[], Figure]:
            return lambda: figures.maps_figure(
                runs.tables["maps"].query(f"length_ratio == {ratio}")
            )

        drawn = {f"maps_{ratio:g}": maps(ratio) for ratio in study.LENGTH_RATIOS}
        return drawn | {"comparison": figures.comparison_figure}

    @classmethod
    def summary(cls, runs: Runs) -> str:
        table = runs.tables["comparison"].T
        return (
            "Cylinder of radius 10 um, length 0.1 mm, 1 m/s: laws, LIGGGHTS and finite elements\n"
            + table.to_string(float_format="{:.4g}".format, na_rep="")
        )
