# SPDX-License-Identifier: GPL-2.0-or-later
"""Figure of the cost of each law: time of the pair forces / their time with stock `hertz`."""

from __future__ import annotations

import pandas as pd
from matplotlib.figure import Figure

from plastigran.plot.style import COLOURS, MARKERS, styled, subplots, title

#: Phase that the figure shows: the sum of both phases in the table of pair_time.py.
BOTH = "both"


def cost_figure(table: pd.DataFrame, control: str) -> Figure:
    """Draw medians and quartiles by law in the plastic and the elastic bed, cheapest law first.

    Args:
        table: Table of pair_time.py: state, law, phase, ratio, ratio_q25, ratio_q75 and shape.
        control: Name of the second run of the reference; its quartiles are the gray band.
    """
    both = table[table["phase"] == BOTH]
    shapes = list(dict.fromkeys(both["shape"]))
    counts = [both.loc[both["shape"] == shape, "law"].nunique() for shape in shapes]
    with styled():
        figure, axes = subplots(
            len(shapes),
            1,
            figsize=(7.0, 0.9 * len(shapes) + 0.27 * sum(counts)),
            squeeze=False,
            gridspec_kw={"height_ratios": counts},
        )
        for ax, shape in zip(axes[:, 0], shapes, strict=True):
            _draw(ax, both[both["shape"] == shape], control)
            ax.set_title(f"a bed of {shape}s", loc="left")
        axes[-1, 0].set_xlabel("time of the pair forces / time of stock hertz")
        axes[0, 0].legend(loc="upper left")
    return figure


def _draw(ax, table: pd.DataFrame, control: str) -> None:
    plastic = table[(table["state"] == "plastic") & (table["law"] != control)]
    laws = list(plastic.sort_values("ratio", ascending=False)["law"])
    for number, state in enumerate(("plastic", "elastic")):
        noise = table[(table["state"] == state) & (table["law"] == control)]
        if number == 0 and len(noise):
            row = noise.iloc[0]
            ax.axvspan(row["ratio_q25"], row["ratio_q75"], color="0.9", label="hertz again")
        rows = table[table["state"] == state].set_index("law").loc[laws]
        spread = [rows["ratio"] - rows["ratio_q25"], rows["ratio_q75"] - rows["ratio"]]
        places = [k + 0.15 - 0.3 * number for k in range(len(laws))]
        style = {"ls": "", "marker": MARKERS[number], "color": COLOURS[number], "capsize": 2}
        ax.errorbar(rows["ratio"], places, xerr=spread, **style, label=f"{state} bed")
    ax.axvline(1, color="0.4", linewidth=0.8)
    ax.set_yticks(range(len(laws)), [title(law) for law in laws])
    ax.set_xlim(left=0)
    ax.set_ylim(-0.6, len(laws) - 0.4)
