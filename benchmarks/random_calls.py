#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Test rules that every law must satisfy, with random calls.

    .venv/bin/python benchmarks/random_calls.py --calls 10000000

Contacts of random bodies and sizes follow random paths of overlaps. The bodies may be far apart.
Overlaps may exceed the size of the bodies, or be almost as small as the smallest floating-point
numbers. All results must be finite, and no force, energy or contact radius may be negative. With
the energy guard, the plastic work of a contact may neither decrease nor be negative. Below the
largest overlap, no force may exceed the largest earlier force. A repeated call must return the same
result. The script prints each violation with its seed and law. Pairs of bodies that a law rejects
do not count as calls, and a law without a call counts as a failure.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator

import numpy as np
from tqdm import tqdm

from plastigran import laws
from plastigran.usable_laws import laws_for

# Number of contacts of one random pair of bodies, and number of steps of each contact.
CONTACTS, STEPS = 200, 100
#: Allowed round-off of energy differences, relative to the energies of a contact.
ROUND_OFF = 1e-11


def random_law(random: np.random.Generator, law: type[laws.Law]) -> laws.Law:
    """Return a law between two random bodies, with random options and required constants."""
    options: dict[str, object] = {
        o["name"]: str(random.choice(o["choices"])) for o in law.options()
    }
    for parameter in law.parameters():
        if parameter["default"] is None:
            lower, upper = max(parameter["lower"], 1e-6), min(parameter["upper"], 1e3)
            options[parameter["name"]] = float(np.exp(random.uniform(*np.log([lower, upper]))))
    return law(laws.combine(random_body(random), random_body(random)), **options)


def random_body(random: np.random.Generator) -> laws.Body:
    modulus = 10 ** random.uniform(3, 13)
    return laws.Body(
        modulus,
        random.uniform(-0.9, 0.499),
        modulus * 10 ** random.uniform(-6, -0.5),
        yield_pressure_factor=float(random.choice([0, 0.5, 1.6, 10])),
        tangent_modulus=modulus * float(random.choice([0, 1e-3, 0.3, 0.99])),
    )


def random_paths(random: np.random.Generator, radius: np.ndarray) -> np.ndarray:
    """Return a random path of overlaps for each contact, (CONTACTS, STEPS) [m]."""
    depth = 10 ** random.uniform(-14, 0.5, (CONTACTS, 1))
    walk = np.cumsum(random.standard_normal((CONTACTS, STEPS)), axis=1) / 5
    jumps = random.choice([-1.0, 0.0, 1e-300, 1e-8, 1.0], (CONTACTS, STEPS))
    path = np.where(random.random((CONTACTS, STEPS)) < 0.1, jumps, walk)
    return path * depth * radius[:, None]


def violations(
    law: laws.Law, radius: np.ndarray, paths: np.ndarray, rate: np.ndarray
) -> Iterator[str]:
    """Yield the rules that a law violates along the paths."""
    states = np.array([law.State() for _ in radius], dtype=object)
    response = law.follow(radius, paths, states, rate)
    for name, values in response.items():
        if not np.isfinite(values).all():
            yield f"{name} is not finite"
    scale = np.maximum.accumulate(
        response["elastic_energy"] + np.abs(response["plastic_work"]), axis=1
    )
    for name in ("force", "contact_radius", "elastic_energy"):
        if (response[name] < 0).any():
            yield f"{name} is negative"
    guarded = "energy_guard='off'" not in repr(law)
    if guarded and (np.diff(response["plastic_work"]) < -ROUND_OFF * scale[:, 1:]).any():
        yield "plastic work decreases"
    if guarded and (response["plastic_work"] < -ROUND_OFF * scale).any():
        yield "plastic work is negative"
    if (response["force"][paths <= 0] > 0).any():
        yield "a contact without overlap has a force"
    deepest = np.maximum.accumulate(paths, axis=1)
    inside = paths < deepest
    largest = np.maximum.accumulate(response["force"] - response["viscous_force"], axis=1)
    if (inside & (response["force"] - response["viscous_force"] > largest * (1 + 1e-12))).any():
        yield "a force below the largest overlap exceeds the earlier forces"
    before = [repr(state) for state in states]
    again = law.respond(radius, paths[:, -1], states, rate[:, -1])
    if [repr(state) for state in states] != before:
        yield "a repeated call changes the history"
    if (again.force != response["force"][:, -1]).any():
        yield "a repeated call changes the force"


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument(
        "--calls",
        type=int,
        default=10_000_000,
        help="largest number of calls (default: %(default)s)",
    )
    parser.add_argument(
        "--seed",
        type=int,
        default=1,
        help="seed of the first pair of bodies (default: %(default)s)",
    )
    options = parser.parse_args()
    pairs = -(-options.calls // (CONTACTS * STEPS))
    names = [*laws_for("sphere"), *laws_for("cylinder")]
    all_laws, failures = [laws.LAWS[name] for name in names], 0
    calls = dict.fromkeys(names, 0)
    for seed in tqdm(range(options.seed, options.seed + pairs), unit="pair"):
        random, law_class = np.random.default_rng(seed), all_laws[seed % len(all_laws)]
        try:
            law = random_law(random, law_class)
        except ValueError:  # the law rejects these bodies
            continue
        radius = 10 ** random.uniform(-7, 1, CONTACTS)
        rate = random.standard_normal((CONTACTS, STEPS))
        calls[law_class.name] += CONTACTS * STEPS
        for violation in violations(law, radius, random_paths(random, radius), rate):
            failures += 1
            tqdm.write(f"seed {seed}: {violation}: {law!r}")
    for name, count in calls.items():
        print(f"{name}: {count} calls")
    print(f"{sum(calls.values())} calls of {len(all_laws)} laws: {failures} violations")
    raise SystemExit(bool(failures) or not all(calls.values()))


if __name__ == "__main__":
    main()
