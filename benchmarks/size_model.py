#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Predict the time per step of a dense bed on a cluster, from runs on this machine.

    .venv/bin/python benchmarks/size_model.py    # after ./run bench size --part cost

In the model, each rank owns the grains in a cube. With `newton off`, both ranks compute a contact
across a face of the cube. A rank sends the grains near its faces to six ranks. One reduction
decides whether all ranks rebuild their neighbor lists. The times of contacts and of ghost atoms are
fitted to the runs of size.py. The numbers of contacts and ghost atoms follow from geometry and
agree with a count on four ranks. size/mpi_calls.c counts bytes and calls. The fields of `Cluster`
are assumptions, which were not measured.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from math import log2
from pathlib import Path

import pandas as pd

from plastigran.engine.process import PROJECT

RESULTS = PROJECT / "results" / "bench"
#: Range of the neighbor lists / mean distance of grains in bed.in: (largest diameter + skin) /
#: (volume of the box / grains)^(1/3).
REACH = 1.29
#: Bytes of a ghost atom in a message: position, velocity and spin, eight bytes per number.
COPY_BYTES = 72
#: Bytes read from memory per grain and step, for a bed that is larger than any cache: the misses of
#: a last-level cache of 1 MiB in cachegrind, times 64 bytes. The values of `hertz`, `thornton` and
#: `universal` agree within 1 %.
TRAFFIC_BYTES = 970
#: Bytes of the table `atom_modify map array` on every rank, per grain of the whole bed; and bytes
#: of a checkpoint per grain.
MAP_BYTES, CHECKPOINT_BYTES = 4, 415


@dataclass(frozen=True)
class Costs:
    """Measured costs of one rank.

    Attributes:
        grain: Time per grain and step, including the contacts of the grain [s].
        copy: Time per ghost atom and step, to pack, send and unpack it in memory [s].
        bytes: Memory per grain [bytes].
    """

    grain: float
    copy: float
    bytes: float


@dataclass(frozen=True)
class Cluster:
    """Assumed properties of the machine.

    Attributes:
        ranks: Number of ranks of a node.
        message: Latency of a message [s].
        hop: Time of a reduction per doubling of the number of ranks [s].
        network: Network bandwidth of a node [bytes/s].
        memory: Memory bandwidth of a node [bytes/s].
        imbalance: Largest number of grains of a rank / mean number.
        disk: Bandwidth of a checkpoint through one rank [bytes/s].
    """

    ranks: int = 64
    message: float = 2e-6
    hop: float = 2e-6
    network: float = 12.5e9
    memory: float = 200e9
    imbalance: float = 1.1
    disk: float = 1e9


def copies(grains: float) -> float:
    """Return the number of ghost atoms around a cube of grains."""
    return (grains ** (1 / 3) + 2 * REACH) ** 3 - grains


def contacts_factor(grains: float) -> float:
    """Return the factor by which double computation increases the contacts of a rank.

    Two ranks compute each contact across a face. A grain at a face has a quarter of its contacts
    across this face.
    """
    return 1 + 1.5 * grains ** (-1 / 3)


def step_time(grains: float, ranks: int, costs: Costs, cluster: Cluster) -> dict[str, float]:
    """Return the parts of the time of a step [s]: contacts, ghost atoms, network, reduction."""
    per_rank = cluster.imbalance * grains / ranks
    sent = copies(per_rank) if ranks > 1 else 0.0
    on_node = min(ranks, cluster.ranks)
    grain = max(costs.grain, TRAFFIC_BYTES * on_node / cluster.memory)
    return {
        "contacts": grain * per_rank * contacts_factor(per_rank),
        "copies": costs.copy * sent,
        "network": (6 * cluster.message if ranks > 1 else 0)
        + COPY_BYTES * sent * on_node / cluster.network,
        "reduction": cluster.hop * log2(ranks),
    }


def fit(table: pd.DataFrame, law: str = "thornton") -> Costs:
    """Fit the costs to the rounds of `size.py --part cost`, by medians.

    The time of ghost atoms is the row `Comm` in the table of times that LIGGGHTS prints, scaled
    from elapsed to processor time.
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
    """Return time and memory for 10^6 to 10^9 grains and several numbers of grains per rank."""
    rows = []
    for grains in (1e6, 1e7, 1e8, 1e9):
        for per_rank in (100_000, 10_000, 1000):
            ranks = round(grains / per_rank)
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
                    "grains, GB a node": costs.bytes * per_rank * min(ranks, cluster.ranks) / 1e9,
                    "checkpoint, s": CHECKPOINT_BYTES * grains / cluster.disk,
                }
            )
    return pd.DataFrame(rows)


def main() -> None:
    files = {
        int(re.findall(r"\d+", file.stem)[0]): file for file in RESULTS.glob("size_cost_*.csv")
    }
    if not files:
        raise SystemExit(
            "ERROR: results/bench/size_cost_*.csv is missing. Run `./run bench size` first"
        )
    largest = Path(files[max(files)])
    costs, cluster = fit(pd.read_csv(largest)), Cluster()
    print(f"from {largest.name}: {costs}\nassumed: {cluster}\n")
    print(predict(costs, cluster).to_markdown(index=False, floatfmt=".3g"))


if __name__ == "__main__":
    main()
