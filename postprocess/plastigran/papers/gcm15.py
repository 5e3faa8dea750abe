# SPDX-License-Identifier: GPL-2.0-or-later
"""Oblique impacts of a rod (Ghaednia, Cermik & Marghitu 2015): experiments and nine laws."""

from __future__ import annotations

from tempfile import TemporaryDirectory

import pandas as pd
from matplotlib.figure import Figure

from plastigran.experiments.rod import RodImpact
from plastigran.experiments.rod import figures as rod_figures
from plastigran.experiments.rod.paper import (
    PAPER_RESTITUTION,
    PAPER_SPEEDS,
    MeasuredRun,
    paper_rods,
)
from plastigran.experiments.runs import Runs
from plastigran.papers.base import declare
from plastigran.physics.rod_motion import simulate
from plastigran.report.base import add_difference

#: The nine laws of the paper; `ghaednia` is its modified law of Jackson and Green.
LAWS = [
    "ghaednia",
    "jackson_green",
    "kogut_etsion",
    "kogut_komvopoulos",
    "ye_komvopoulos",
    "brake_2012",
    "brake_2015",
    "stronge",
    "thornton",
]
MEASURED = MeasuredRun()
#: Columns that are compared between LIGGGHTS and the equations of motion, with their names in
#: words.
COMPARED = {
    "coefficient_of_restitution": "restitution",
    "angular_velocity": "angular velocity",
    "force_max": "largest force",
    "overlap_res": "permanent deformation",
    "contact_time": "time of contact",
}
#: Column of Stronge's law with unloading at the original radius. The paper may have used this
#: variant of the law.
OTHER_STRONGE = "stronge, original radius"


def compute(progress: bool, coarse: bool) -> Runs:
    """Compute impacts of the rod with every law at both angles.

    Each impact is computed in LIGGGHTS and by integrating the equations of motion of the rod.

    As in the paper, friction has no tangential spring: the friction force is mu times the normal
    force as soon as the tip slides.
    """
    speeds = (-MEASURED.velocity_before,) if coarse else PAPER_SPEEDS
    with TemporaryDirectory() as folder:
        return RodImpact.study(
            folder, progress=progress, law=LAWS, speed=speeds, tangential="no_history"
        )


def restitution(runs: Runs) -> pd.DataFrame:
    """Return the restitution of the normal velocity of the rod's tip: experiments and laws."""
    table = _by_law(runs, "coefficient_of_restitution_predicted")
    for rod in paper_rods():
        law = RodImpact("stronge", 1.0, rod=rod).contact_law(unloading="original_radius")
        for row in table.index[table["angle (°)"] == rod.angle]:
            outcome = simulate(rod, law, table.loc[row, "speed (m/s)"])
            table.loc[row, OTHER_STRONGE] = outcome.coefficient_of_restitution
    table.insert(2, "paper, about", table["angle (°)"].map(PAPER_RESTITUTION))
    return table


def measured_run(runs: Runs) -> pd.DataFrame:
    """Return results for the experiment whose velocities before and after impact the paper prints.

    The results are those of the laws, and the angular velocity computed from the measured impulse.
    """
    rod = next(rod for rod in paper_rods() if rod.angle == MEASURED.angle)
    impacts = runs.table
    impacts = impacts[
        (impacts["angle"] == MEASURED.angle) & (impacts["speed"] == -MEASURED.velocity_before)
    ]
    rows = [
        {
            "from": "the measured impulse on a rigid rod",
            "quantity": "angular velocity",
            "unit": "rad/s",
            "paper": MEASURED.angular_velocity,
            "equations of motion": rod.angular_velocity(MEASURED.impulse(rod)),
        }
    ]
    for name, unit, measured in (
        ("angular_velocity", "rad/s", MEASURED.angular_velocity),
        ("coefficient_of_restitution", "-", MEASURED.coefficient_of_restitution(rod)),
    ):
        rows += [
            {
                "from": impact["law"],
                "quantity": COMPARED[name],
                "unit": unit,
                "paper": measured,
                "equations of motion": impact[f"{name}_predicted"],
                "LIGGGHTS": impact[name],
            }
            for _, impact in impacts.iterrows()
        ]
    return add_difference(pd.DataFrame(rows), "equations of motion", "paper")


def deformation(runs: Runs) -> pd.DataFrame:
    """Return the permanent deformation that the equations of motion predict [µm]."""
    table = _by_law(runs, "overlap_res_predicted")
    return table.assign(**{law: 1e6 * table[law] for law in LAWS})


def engine(runs: Runs) -> pd.DataFrame:
    """Return the largest difference between LIGGGHTS and the equations of motion for each law."""
    table = runs.table
    differences = {
        f"{quantity} (%)": 100 * (table[name] / table[f"{name}_predicted"] - 1).abs()
        for name, quantity in COMPARED.items()
    }
    return pd.DataFrame(differences).groupby(table["law"]).max().loc[LAWS].reset_index()


def _by_law(runs: Runs, column: str) -> pd.DataFrame:
    """Return the values of `column` as a table: one row per angle and speed, one column per law."""
    wide = runs.table.pivot(index=["angle", "speed"], columns="law", values=column)
    wide = wide[LAWS].sort_index(level=0, ascending=False, sort_remaining=False)
    names = {"angle": "angle (°)", "speed": "speed (m/s)"}
    return wide.reset_index().rename(columns=names).rename_axis(columns=None)


def outcome_figure(runs: Runs) -> Figure:
    """Draw the results of the rod's impacts versus impact speed."""
    return rod_figures.outcome_figure(runs.table)


def deformation_figure(runs: Runs) -> Figure:
    """Draw the permanent deformation versus impact speed."""
    return rod_figures.deformation_figure(runs.table)


def motion_figure(runs: Runs) -> Figure:
    """Draw the motion of the rod in the computed run that is closest to the measured run."""
    law = rod_figures.closest_to_measured(runs.outcomes)
    return rod_figures.motion_figure(law, runs.outcomes[law])


PAPER = declare(
    name="gcm15",
    title="An oblique steel rod on an iron flat",
    citation="H. Ghaednia, O. Cermik & D. B. Marghitu, Int. J. Impact Eng. 86 (2015) 307",
    compute=compute,
    tables=(restitution, measured_run, engine),
    data=(deformation,),
    figures=(outcome_figure, deformation_figure, motion_figure),
)
