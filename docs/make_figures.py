# SPDX-License-Identifier: GPL-2.0-or-later
"""Draw the figures of the docs: one per law, found and never listed, the README's and the rod's.

Run it with `./run figures`; the files in docs/figures are its output.
"""

from __future__ import annotations

import tempfile
from itertools import pairwise
from pathlib import Path

import numpy as np

from plastigran import figures, laws, rod_figures, rod_runs, theory
from plastigran.figures import STYLE, plt, save, title
from plastigran.impact import PAPER_SPEEDS, plan, sweep
from plastigran.materials import RIGID, read_material
from plastigran.rod import PAPER_RODS

FOLDER = Path(__file__).parent / "figures"
RADIUS = 0.01  # the figures are dimensionless; any size gives the same


def law_figure(name: str) -> plt.Figure:
    """A load, partial unload, reload, unload path, and restitution over impact speed."""
    pair = laws.combine(read_material("aluminium_zv02").body(), RIGID)
    law = laws.LAWS[name](pair)
    overlap_y = RADIUS * laws.yield_radius_ratio(pair) ** 2
    force_y = 4 / 3 * pair.youngs_modulus_eff * np.sqrt(RADIUS) * overlap_y**1.5
    with plt.rc_context(STYLE):
        figure, (left, right) = plt.subplots(1, 2, figsize=(8.2, 3.4), layout="constrained")
        turns = [0, 12, 9, 20, 0]
        path = np.concatenate([np.linspace(a, b, 400) for a, b in pairwise(turns)])
        state = law.State()
        force = law.follow(RADIUS, path * overlap_y, state)["force"] / force_y
        hertz = np.linspace(0, 8, 100)
        if name != "hertz":
            left.plot(hertz, hertz**1.5, ":", color="0.5", label="Hertz")
        left.plot(path, force, color=figures.COLOURS[0], label=title(name))
        left.set_xlabel("overlap / overlap at yield")
        left.set_ylabel("force / force at yield")
        left.legend(loc="upper left")
        mass = 1.0
        scale = theory.yield_speed(pair, mass, RADIUS)
        ratio = np.geomspace(0.3, 120, 120)
        restitution = [
            law.central_impact(RADIUS, mass, q * scale).coefficient_of_restitution for q in ratio
        ]
        right.semilogx(ratio, restitution, color=figures.COLOURS[0])
        right.set_ylim(0, 1.05)
        right.set_xlabel("impact speed / yield speed")
        right.set_ylabel("coefficient of restitution")
    return figure


def main() -> None:
    for name in sorted(laws.LAWS):
        save(law_figure(name), FOLDER / name, (".svg",))
    impacts = plan(sorted(laws.LAWS), PAPER_SPEEDS, ["aluminium_zv02"], 0.1)
    rods = rod_runs.plan(sorted(laws.LAWS), rod_runs.PAPER_SPEEDS, PAPER_RODS)
    with tempfile.TemporaryDirectory() as folder:
        table, _ = sweep(impacts, folder)
        rod_table, _ = sweep(rods, folder)
    save(figures.restitution_figure(table, impacts), FOLDER / "restitution", (".png",))
    save(rod_figures.outcome_figure(rod_table), FOLDER / "rod", (".png",))


if __name__ == "__main__":
    main()
