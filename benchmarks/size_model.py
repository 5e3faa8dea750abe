#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""What a step of a dense bed takes on a cluster, from what it took here.

    .venv/bin/python benchmarks/size_model.py    # after ./run bench size --part cost

A rank owns a cube of n grains. It computes its contacts, those across its faces too (with `newton
off` both sides do), sends the grains near its faces to six neighbours, and takes part in one
reduction, by which all ranks learn whether neighbours must be listed anew. Times of contacts and of
copies are fitted to the runs of size.py; faces and copies follow from geometry and agree with those
counted on four ranks; bytes and calls were counted by size/mpi_calls.c. What was not measured here
is an assumption and a field of `Cluster`.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from math import log2
from pathlib import Path

import pandas as pd

from plastigran.engine.process import PROJECT

RESULTS = PROJECT / "results" / "bench"
#: Range at which neighbours are listed over the mean distance of grains: diameter of the largest
#: and skin over (volume of box/grains)^(1/3), of bed.in.
REACH = 1.29
#: Position, velocity and spin of a copy, eight bytes each number.
COPY_BYTES = 72
#: From memory, a grain and step, of a bed that no cache holds: cachegrind's misses of a last level
#: of 1 MiB, in lines of 64 bytes; `hertz`, `thornton` and `universal` alike within 1 %.
TRAFFIC_BYTES = 970
#: Of `atom_modify map array`, for each grain of the whole bed on every rank; of a checkpoint.
MAP_BYTES, CHECKPOINT_BYTES = 4, 415


@dataclass(frozen=True)
class Costs:
    """Of one rank, measured.

    Attributes:
        grain: Time a grain and step, its share of contacts included [s].
        copy: Time a copy and step, to pack, hand over and unpack it in memory [s].
        bytes: Memory a grain.
    """

    grain: float
    copy: float
    bytes: float


@dataclass(frozen=True)
class Cluster:
    """What is assumed of the machine.

    Attributes:
        ranks: A node has.
        message: Latency of a message [s].
        hop: Of a reduction, for each doubling of the ranks [s].
        network: Of a node [bytes/s].
        memory: Of a node [bytes/s].
        imbalance: Grains of the fullest rank over the mean.
        disk: Of a checkpoint through one rank [bytes/s].
    """

    ranks: int = 64
    message: float = 2e-6
    hop: float = 2e-6
    network: float = 12.5e9
    memory: float = 200e9
    imbalance: float = 1.1
    disk: float = 1e9


def copies(grains: float) -> float:
    """Of other ranks' grains around a cube of so many."""
    return (grains ** (1 / 3) + 2 * REACH) ** 3 - grains


def contacts_factor(grains: float) -> float:
    """Return the contacts that a cube of grains computes, divided by their number.

    At a face, each grain has a quarter of its contacts across it, which are computed twice.
    """
    return 1 + 1.5 * grains ** (-1 / 3)


def step_time(grains: float, ranks: int, costs: Costs, cluster: Cluster) -> dict[str, float]:
    """Parts of a step's time [s]: contacts, copies, network, reduction."""
    each = cluster.imbalance * grains / ranks
    sent = copies(each) if ranks > 1 else 0.0
    on_node = min(ranks, cluster.ranks)
    grain = max(costs.grain, TRAFFIC_BYTES * on_node / cluster.memory)
    return {
        "contacts": grain * each * contacts_factor(each),
        "copies": costs.copy * sent,
        "network": (6 * cluster.message if ranks > 1 else 0)
        + COPY_BYTES * sent * on_node / cluster.network,
        "reduction": cluster.hop * log2(ranks),
    }


def fit(table: pd.DataFrame, law: str = "thornton") -> Costs:
    """Fit the costs to the rounds of `size.py --part cost`, by medians.

    The time of copies is that of its row in LIGGGHTS' table, scaled from clock to processor time.
    """
    rows = table[table["law"] == law]
    steps = rows["processor"] / rows["steps"]
    comm = rows["Comm"] / rows["clock"]
    return Costs(
        grain=float((steps * (1 - comm) / rows["grains"]).median()),
        copy=float((steps * comm / rows["ghosts"]).median()),
        bytes=float((rows["later"] / rows["grains"]).median()),
    )


def predict(costs: Costs, cluster: Cluster) -> pd.DataFrame:
    """Grains, ranks and what they take, from a million grains to a thousand million."""
    rows = []
    for grains in (1e6, 1e7, 1e8, 1e9):
        for each in (100_000, 10_000, 1000):
            ranks = round(grains / each)
            parts = step_time(grains, ranks, costs, cluster)
            total = sum(parts.values())
            ideal = costs.grain * grains / ranks
            rows.append(
                {
                    "grains": grains,
                    "ranks": ranks,
                    "milliseconds a step": 1e3 * total,
                    **{name: f"{time / total:.0%}" for name, time in parts.items()},
                    "efficiency": f"{ideal / total:.0%}",
                    "hours for 1e6 steps": total * 1e6 / 3600,
                    "map array, GB a node": MAP_BYTES * grains * min(ranks, cluster.ranks) / 1e9,
                    "grains, GB a node": costs.bytes * each * min(ranks, cluster.ranks) / 1e9,
                    "checkpoint, s": CHECKPOINT_BYTES * grains / cluster.disk,
                }
            )
    return pd.DataFrame(rows)


def main() -> None:
    files = {
        int(re.findall(r"\d+", file.stem)[0]): file for file in RESULTS.glob("size_cost_*.csv")
    }
    if not files:
        raise SystemExit("ERROR: no results/bench/size_cost_*.csv; run ./run bench size first")
    largest = Path(files[max(files)])
    costs, cluster = fit(pd.read_csv(largest)), Cluster()
    print(f"from {largest.name}: {costs}\nassumed: {cluster}\n")
    print(predict(costs, cluster).to_markdown(index=False, floatfmt=".3g"))


if __name__ == "__main__":
    main()
