# SPDX-License-Identifier: GPL-2.0-or-later
"""Command-line arguments of finite-element commands: metal, half space and kind of strain."""

from __future__ import annotations

import argparse
import sys
import warnings
from collections.abc import Callable

from plastigran.cli.arguments import add_json, positive
from plastigran.fem.cache import cached
from plastigran.fem.limits import SmallStrainWarning
from plastigran.fem.material.elastic_plastic import ElasticPlastic
from plastigran.fem.material.hardening import LinearHardening
from plastigran.fem.settings import Settings


def add_metal(command: argparse.ArgumentParser, radius: float | None = 0.1) -> None:
    """Add the flags of `add_elastic`, and flags for yield. --elastic or --yield is required."""
    add_elastic(command, radius)
    strength = command.add_mutually_exclusive_group(required=True)
    strength.add_argument(
        "--yield", type=positive, dest="yield_strength", help="yield strength, Pa"
    )
    strength.add_argument("--elastic", action="store_true", help="elastic material without yield")
    command.add_argument(
        "--hardening",
        type=float,
        help="plastic modulus, which is the slope of stress versus plastic strain, Pa, default 0",
    )


def add_elastic(
    command: argparse.ArgumentParser, radius: float | None = 0.1, density: float | None = 2700.0
) -> None:
    """Add the flags of an elastic material, --radius and --json.

    Args:
        command: Parser of the command.
        radius: Default radius [m]; None to require the flag.
        density: Default density [kg/m^3]; None to require the flag.
    """
    command.add_argument("--young", type=positive, required=True, help="Young's modulus, Pa")
    command.add_argument("--poisson", type=float, required=True, help="Poisson's ratio")
    for flag, default, meaning in (
        ("--density", density, "density, kg/m3"),
        ("--radius", radius, "radius of the sphere or cylinder, m"),
    ):
        shown = "" if default is None else f", default {default:g}"
        command.add_argument(
            flag,
            type=positive,
            default=default,
            required=default is None,
            help=meaning + shown,
        )
    add_json(command)


def add_strain(command: argparse.ArgumentParser) -> None:
    """Add the flag --finite-strain."""
    command.add_argument(
        "--finite-strain",
        action="store_const",
        const="finite",
        default="small",
        dest="strain",
        help="compute with finite strain, for contact radii above 0.1 times the radius of the "
        "body; takes longer",
    )


def add_plane(command: argparse.ArgumentParser) -> None:
    """Add the flags of a half space under the sphere. By default, the plane is rigid."""
    for name, value_type, meaning in (
        ("young", positive, "Young's modulus of a half space, Pa; default: rigid plane"),
        ("poisson", float, "Poisson's ratio of the half space; default: value of the sphere"),
        ("density", positive, "density of the half space, kg/m3; default: value of the sphere"),
        ("yield", positive, "yield strength of the half space, Pa; default: elastic"),
        ("hardening", float, "plastic modulus of the half space, Pa, default 0"),
    ):
        command.add_argument(f"--plane-{name}", type=value_type, help=meaning)


def metal(arguments: argparse.Namespace) -> ElasticPlastic:
    """Return the metal that the flags of `add_metal` or `add_elastic` describe.

    Raises:
        ValueError: A number is out of range, or a plastic modulus is given without a yield
            strength.
    """
    strength = getattr(arguments, "yield_strength", None)
    modulus = getattr(arguments, "hardening", None)
    return ElasticPlastic(
        youngs_modulus=arguments.young,
        poissons_ratio=arguments.poisson,
        density=arguments.density,
        hardening=_hardening(strength, modulus, "--"),
    )


def plane(arguments: argparse.Namespace) -> ElasticPlastic | None:
    """Return the metal of the half space; None for a rigid plane.

    Raises:
        ValueError: A number is out of range, or --plane-young is missing.
    """
    names = ("young", "poisson", "density", "yield", "hardening")
    given = {name: getattr(arguments, f"plane_{name}", None) for name in names}
    given = {name: value for name, value in given.items() if value is not None}
    if "young" not in given:
        for name, value in given.items():
            raise ValueError(f"--plane-{name} is {value:g}, but --plane-young is missing. Add it")
        return None
    return ElasticPlastic(
        youngs_modulus=given["young"],
        poissons_ratio=given.get("poisson", arguments.poisson),
        density=given.get("density", arguments.density),
        hardening=_hardening(given.get("yield"), given.get("hardening"), "--plane-"),
    )


def _hardening(
    strength: float | None, modulus: float | None, prefix: str
) -> LinearHardening | None:
    """Return the hardening law of a metal; None if the metal does not yield."""
    if strength is not None:
        return LinearHardening(strength, modulus or 0.0)
    if modulus is not None:
        raise ValueError(f"{prefix}hardening is {modulus:g}, but {prefix}yield is missing. Add it")
    return None


def computed(compute: Callable, *arguments: object, strain: str = "small", **named: object):
    """Return the result of a finite-element computation, from the cache if possible.

    The function prints warnings on stderr. If the computation stops early, it also prints the
    reason.

    Args:
        compute: Function with the keyword arguments `settings` and `progress`.
        arguments: Positional arguments of `compute`.
        strain: "small" or "finite".
        named: Further keyword arguments of `compute`.

    Raises:
        ValueError: The computation cannot start.
    """
    with warnings.catch_warnings(record=True) as recorded:
        warnings.simplefilter("always", SmallStrainWarning)
        try:
            result = cached(
                compute,
                *arguments,
                settings=Settings(strain=strain),
                progress=True,
                **named,
            )
        except ArithmeticError as error:
            raise ValueError(str(error)) from None
    for line in [*(str(warning.message) for warning in recorded), result.stopped]:
        if line:
            say(line)
    return result


def say(line: str) -> None:
    """Print a line on stderr, so that stdout contains only results."""
    print(f"plastigran: {line}", file=sys.stderr)
