# SPDX-License-Identifier: GPL-2.0-or-later
"""The oblique rod of Ghaednia, Cermik & Marghitu 2015: experiments and nine contact laws."""

from __future__ import annotations

from tempfile import TemporaryDirectory

import pandas as pd

from plastigran.experiments.rod import RodImpact
from plastigran.experiments.rod.figures import (
    closest_to_measured,
    deformation_figure,
    motion_figure,
    outcome_figure,
)
from plastigran.experiments.rod.paper import (
    PAPER_RESTITUTION,
    PAPER_SPEEDS,
    MeasuredRun,
    paper_rods,
)
from plastigran.experiments.runs import Runs
from plastigran.papers.base import Paper
from plastigran.physics.rod_motion import simulate
from plastigran.report.base import Findings, add_difference

#: The paper's nine laws; `ghaednia` is its modified Jackson and Green.
LAWS = (
    "ghaednia",
    "jackson_green",
    "kogut_etsion",
    "kogut_komvopoulos",
    "ye_komvopoulos",
    "brake_2012",
    "brake_2015",
    "stronge",
    "thornton",
)
MEASURED = MeasuredRun()
#: Quantities in which LIGGGHTS is compared with the equations of motion, by column name.
COMPARED = {
    "coefficient_of_restitution": "restitution",
    "angular_velocity": "angular velocity",
    "force_max": "largest force",
    "overlap_res": "permanent deformation",
    "contact_time": "time of contact",
}
#: Stronge's law with unloading at the original radius, a possible interpretation of the paper.
OTHER_STRONGE = "stronge, original radius"


def compute(progress: bool, coarse: bool) -> Findings:
    """Compute every law at both angles, in LIGGGHTS and by the equations of motion.

    Friction is as in the paper: mu F as soon as the tip slides.
    """
    speeds = (-MEASURED.velocity_before,) if coarse else PAPER_SPEEDS
    with TemporaryDirectory() as folder:
        runs = RodImpact.study(
            folder, progress=progress, law=LAWS, speed=speeds, tangential="no_history"
        )
    closest = closest_to_measured(runs.outcomes)
    return Findings(
        tables={
            "restitution": restitution(runs.table),
            "measured_run": measured_run(runs),
            "deformation": deformation(runs.table),
            "engine": engine(runs.table),
        },
        figures={
            "outcome": outcome_figure(runs.table),
            "deformation": deformation_figure(runs.table),
            "motion": motion_figure(closest, runs.outcomes[closest]),
        },
    )


def restitution(table: pd.DataFrame) -> pd.DataFrame:
    """Return the restitution of the tip's normal velocity, computed and from the experiments.

    Args:
        table: Columns of `RodImpact.row`.
    """
    found = _by_law(table, "coefficient_of_restitution_predicted")
    for rod in paper_rods():
        law = RodImpact("stronge", 1.0, rod=rod).contact_law(unloading="original_radius")
        for row in found.index[found["angle (°)"] == rod.angle]:
            outcome = simulate(rod, law, found.loc[row, "speed (m/s)"])
            found.loc[row, OTHER_STRONGE] = outcome.coefficient_of_restitution
    found.insert(2, "paper, about", found["angle (°)"].map(PAPER_RESTITUTION))
    return found


def measured_run(runs: Runs) -> pd.DataFrame:
    """Return the run whose velocities the paper prints, by law and by its measured impulse."""
    rod = next(rod for rod in paper_rods() if rod.angle == MEASURED.angle)
    implied = MEASURED.coefficient_of_restitution(rod)
    table = runs.table
    rows = table[(table["angle"] == MEASURED.angle) & (table["speed"] == -MEASURED.velocity_before)]
    found = [
        {
            "from": "the measured impulse on a rigid rod",
            "quantity": "angular velocity",
            "unit": "rad/s",
            "equations of motion": rod.angular_velocity(MEASURED.impulse(rod)),
        }
    ]
    said = {
        "angular_velocity": ("angular velocity", "rad/s", MEASURED.angular_velocity),
        "coefficient_of_restitution": ("restitution", "-", implied),
    }
    for name, (quantity, unit, _) in said.items():
        found += [
            {
                "from": row["law"],
                "quantity": quantity,
                "unit": unit,
                "equations of motion": row[f"{name}_predicted"],
                "LIGGGHTS": row[name],
            }
            for _, row in rows.iterrows()
        ]
    result = pd.DataFrame(found)
    result.insert(3, "paper", result["quantity"].map({q: value for q, _, value in said.values()}))
    return add_difference(result, "equations of motion", "paper")


def deformation(table: pd.DataFrame) -> pd.DataFrame:
    """Return the permanent deformation [µm] by the equations of motion."""
    found = _by_law(table, "overlap_res_predicted")
    return found.assign(**{law: 1e6 * found[law] for law in LAWS})


def engine(table: pd.DataFrame) -> pd.DataFrame:
    """Return the largest difference between LIGGGHTS and the equations of motion for each law."""
    found = {
        f"{said} (%)": 100 * (table[name] / table[f"{name}_predicted"] - 1).abs()
        for name, said in COMPARED.items()
    }
    return pd.DataFrame(found).groupby(table["law"]).max().loc[list(LAWS)].reset_index()


def _by_law(table: pd.DataFrame, column: str) -> pd.DataFrame:
    """Return one row per angle and speed, one column per law."""
    wide = table.pivot(index=["angle", "speed"], columns="law", values=column)
    wide = wide[list(LAWS)].sort_index(level=0, ascending=False, sort_remaining=False)
    named = {"angle": "angle (°)", "speed": "speed (m/s)"}
    return wide.reset_index().rename(columns=named).rename_axis(columns=None)


PAPER = Paper(
    name="gcm15",
    title="An oblique steel rod on an iron flat",
    citation="H. Ghaednia, O. Cermik & D. B. Marghitu, Int. J. Impact Eng. 86 (2015) 307",
    tables=("restitution", "measured_run", "engine"),
    data=("deformation",),
    figures=("outcome", "deformation", "motion"),
    compute=compute,
)
