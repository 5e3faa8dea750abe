#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-2.0-or-later
"""Random calls of every law: what must hold whatever it is asked.

    .venv/bin/python benchmarks/random_calls.py --calls 10000000

Contacts of random bodies and sizes are led along random paths of overlaps, from far apart to deeper
than the bodies, some as small as numbers get. Every answer must be a number; no force, energy or
contact radius may be negative. While the energy guard is on, the plastic work of a contact may
neither fall nor be negative. No force may exceed the largest the contact has borne but on the
virgin curve; asked the same again a contact answers the same. What does not hold is printed with
all that makes it again. Pairs of bodies that a law refuses are not counted among its calls; a law
without a call is a failure, too.
"""

from __future__ import annotations

import argparse
from collections.abc import Iterator

import numpy as np
from tqdm import tqdm

from plastigran import laws
from plastigran.usable_laws import laws_for

CONTACTS, STEPS = 200, 100  # of one random pair of bodies
#: Of a contact's energies, in which differences of sums are rounded.
ROUNDING = 1e-11


def random_law(random: np.random.Generator, kind: type[laws.Law]) -> laws.Law:
    """A law between two random bodies, with random options; constants where they must be given."""
    options: dict[str, object] = {
        o["name"]: str(random.choice(o["choices"])) for o in kind.options()
    }
    for parameter in kind.parameters():
        if parameter["default"] is None:
            lower, upper = max(parameter["lower"], 1e-6), min(parameter["upper"], 1e3)
            options[parameter["name"]] = float(np.exp(random.uniform(*np.log([lower, upper]))))
    return kind(laws.combine(random_body(random), random_body(random)), **options)


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
    """Overlaps of shape (CONTACTS, STEPS) [m]: steps of all sizes about a depth of each contact."""
    depth = 10 ** random.uniform(-14, 0.5, (CONTACTS, 1))
    walk = np.cumsum(random.standard_normal((CONTACTS, STEPS)), axis=1) / 5
    jumps = random.choice([-1.0, 0.0, 1e-300, 1e-8, 1.0], (CONTACTS, STEPS))
    path = np.where(random.random((CONTACTS, STEPS)) < 0.1, jumps, walk)
    return path * depth * radius[:, None]


def broken(law: laws.Law, radius: np.ndarray, paths: np.ndarray, rate: np.ndarray) -> Iterator[str]:
    """What does not hold along the paths, as sentences."""
    states = np.array([law.State() for _ in radius], dtype=object)
    answer = law.follow(radius, paths, states, rate)
    for name, values in answer.items():
        if not np.isfinite(values).all():
            yield f"{name} is not finite"
    scale = np.maximum.accumulate(answer["elastic_energy"] + np.abs(answer["plastic_work"]), axis=1)
    for name in ("force", "contact_radius", "elastic_energy"):
        if (answer[name] < 0).any():
            yield f"{name} is negative"
    guarded = "energy_guard='off'" not in repr(law)
    if guarded and (np.diff(answer["plastic_work"]) < -ROUNDING * scale[:, 1:]).any():
        yield "plastic work falls"
    if guarded and (answer["plastic_work"] < -ROUNDING * scale).any():
        yield "plastic work is negative"
    if (answer["force"][paths <= 0] > 0).any():
        yield "a force without overlap"
    deepest = np.maximum.accumulate(paths, axis=1)
    inside = paths < deepest
    largest = np.maximum.accumulate(answer["force"] - answer["viscous_force"], axis=1)
    if (inside & (answer["force"] - answer["viscous_force"] > largest * (1 + 1e-12))).any():
        yield "an inner force beyond the largest"
    before = [repr(state) for state in states]
    again = law.respond(radius, paths[:, -1], states, rate[:, -1])
    if [repr(state) for state in states] != before:
        yield "asked again, a history changes"
    if (again.force != answer["force"][:, -1]).any():
        yield "asked again, a force changes"


def main() -> None:
    parser = argparse.ArgumentParser(description=(__doc__ or "").splitlines()[0])
    parser.add_argument(
        "--calls", type=int, default=10_000_000, help="at most (default: %(default)s)"
    )
    parser.add_argument(
        "--seed", type=int, default=1, help="of the first pair (default: %(default)s)"
    )
    options = parser.parse_args()
    pairs = -(-options.calls // (CONTACTS * STEPS))
    names = [*laws_for("sphere"), *laws_for("cylinder")]
    kinds, failures = [laws.LAWS[name] for name in names], 0
    calls = dict.fromkeys(names, 0)
    for seed in tqdm(range(options.seed, options.seed + pairs), unit="pair"):
        random, kind = np.random.default_rng(seed), kinds[seed % len(kinds)]
        try:
            law = random_law(random, kind)
        except ValueError:  # bodies that the law refuses
            continue
        radius = 10 ** random.uniform(-7, 1, CONTACTS)
        rate = random.standard_normal((CONTACTS, STEPS))
        calls[kind.name] += CONTACTS * STEPS
        for sentence in broken(law, radius, random_paths(random, radius), rate):
            failures += 1
            tqdm.write(f"seed {seed}: {sentence}: {law!r}")
    for name, count in calls.items():
        print(f"{name}: {count} calls")
    print(f"{sum(calls.values())} calls of {len(kinds)} laws: {failures} sentences broken")
    raise SystemExit(bool(failures) or not all(calls.values()))


if __name__ == "__main__":
    main()
