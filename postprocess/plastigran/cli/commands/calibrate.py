# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran calibrate`: constants of a metal for a deck, from a measurement."""

from __future__ import annotations

import argparse
from pathlib import Path

from plastigran.calibration import CalibratedMetal, DropTest, calibrate
from plastigran.calibration.calibrating import FEM_RADIUS
from plastigran.calibration.drop_test import BALL_RADIUS, read_drop_test
from plastigran.calibration.expected_errors import DEFAULT_LAW
from plastigran.calibration.finite_elements import USUAL_RANGE
from plastigran.calibration.strength import STEEL_RATE_COEFFICIENT
from plastigran.cli.arguments import positive, print_json, refuse_idle
from plastigran.cli.metal import add_elastic, add_strain
from plastigran.materials import (
    RIGID,
    check_material_file,
    material_lines,
    read_material,
    write_material,
)

HELP = "find the yield strength of a metal from hardness, rebound or drops, for use in a deck"
EXAMPLE = """
plastigran calibrate --young 206e9 --poisson 0.3 --density 7850 --hardness 45HRC --output spring.in
"""

#: Word for the calibrated metal itself, as ball or plate.
METAL = "metal"
#: Allowed suffixes of --figure.
FIGURES = (".png", ".svg", ".pdf")
#: Arguments that are passed on unchanged.
PASSED_ON = (
    *("density", "yield_strength", "hardness", "leeb", "plastic_modulus", "rate_coefficient"),
    *("scatter", "law", "speeds", "radius", "strain"),
)


def add_arguments(command: argparse.ArgumentParser) -> None:
    measured = command.add_mutually_exclusive_group(required=True)
    measured.add_argument(
        "--yield", type=positive, dest="yield_strength", help="yield strength, Pa"
    )
    measured.add_argument(
        "--hardness", help="hardness, HV or with its scale, for example 45HRC or 200HB"
    )
    measured.add_argument(
        "--leeb", help="rebound hardness, HLD or with its device, for example 750HLG"
    )
    measured.add_argument(
        "--drop", type=Path, metavar="FILE", help="table of drops, see docs/calibrate.md"
    )
    add_elastic(command, FEM_RADIUS, density=None)
    command.add_argument(
        "--hardening",
        type=float,
        default=0.0,
        dest="plastic_modulus",
        help="plastic modulus, Pa, default 0",
    )
    command.add_argument("--ball", help="material of the ball of --drop, default the metal itself")
    command.add_argument(
        "--plate",
        help=(
            "material of the plate of --drop: rigid (default for a ball of the "
            "metal), metal, or a material"
        ),
    )
    command.add_argument(
        "--ball-radius",
        type=positive,
        help=(
            f"radius of the ball of --drop, m, default {BALL_RADIUS:g}; it matters only with "
            "--rate-coefficient"
        ),
    )
    command.add_argument(
        "--rate-coefficient",
        type=float,
        help="relative increase of yield strength per e-fold increase of strain rate, with "
        f"the strength given at 1/s; default {STEEL_RATE_COEFFICIENT:g} for steel with "
        "--hardness or --leeb, else 0",
    )
    command.add_argument(
        "--scatter",
        type=positive,
        help="relative standard deviation of one measured restitution, default 0.02 for drops",
    )
    command.add_argument(
        "--law", default=DEFAULT_LAW, help=f"name of the law, default {DEFAULT_LAW}"
    )
    command.add_argument(
        "--speeds",
        nargs=2,
        type=positive,
        metavar=("SLOWEST", "FASTEST"),
        help=(
            "slowest and fastest impact speed of the intended simulation, m/s; the error of "
            "the law is reported for this range"
        ),
    )
    command.add_argument(
        "--fem", action="store_true", help="fit vu_quoc_zhang to finite elements of the metal"
    )
    command.add_argument(
        "--range",
        type=positive,
        dest="force_ratio",
        metavar="PMAX/PY",
        help=(
            "largest force of the finite-element fit as a multiple of the yield force, "
            f"default {USUAL_RANGE:g}; implies --fem"
        ),
    )
    add_strain(command)
    command.add_argument("--output", type=Path, metavar="FILE.in", help="material file to write")
    command.add_argument("--force", action="store_true", help="overwrite the material file")
    command.add_argument(
        "--figure",
        type=Path,
        metavar="FILE.png",
        help="figure of the law with drops or finite elements",
    )


def run(arguments: argparse.Namespace) -> None:
    output = arguments.output
    _refuse_idle(arguments)
    if output is not None:
        check_material_file(output, arguments.force)
    if arguments.figure is not None and arguments.figure.suffix not in FIGURES:
        raise ValueError(f"figure is {arguments.figure}; it must end in {' or '.join(FIGURES)}")
    calibrated = calibrate(
        youngs_modulus=arguments.young,
        poissons_ratio=arguments.poisson,
        drops=_drops(arguments),
        force_ratio=_finite_elements(arguments),
        name=output.stem if output else "metal",
        progress=True,
        **{name: getattr(arguments, name) for name in PASSED_ON},
    )
    if output is not None:
        write_material(calibrated.material, output, calibrated.remark, arguments.force)
    if arguments.figure is not None:
        _draw(calibrated, arguments.figure)
    if arguments.json:
        print_json(calibrated.to_dict())
    else:
        _print(calibrated, output)


def _refuse_idle(arguments: argparse.Namespace) -> None:
    """Refuse flags that have no effect.

    Raises:
        ValueError: A flag has no effect; the message names it.
    """
    finite_elements = _finite_elements(arguments)
    if arguments.output is None:
        refuse_idle(arguments, "--output", force=False)
    if arguments.drop is None:
        refuse_idle(arguments, "--drop", ball=None, plate=None, ball_radius=None)
        if arguments.leeb is None:
            refuse_idle(arguments, "--drop or --leeb", scatter=None)
        if not finite_elements:
            refuse_idle(arguments, "--drop or --fem", figure=None)
    if not finite_elements:
        refuse_idle(arguments, "--fem", radius=FEM_RADIUS)
        if arguments.strain == "finite":
            raise ValueError("--finite-strain needs --fem")


def _finite_elements(arguments: argparse.Namespace) -> float | None:
    """Return the largest force as a multiple of the yield force; None without finite elements."""
    usual = USUAL_RANGE if arguments.fem else None
    return usual if arguments.force_ratio is None else arguments.force_ratio


def _drops(arguments: argparse.Namespace) -> DropTest | None:
    if arguments.drop is None:
        return None
    ball = None if arguments.ball in (None, METAL) else read_material(arguments.ball)
    plate = arguments.plate or ("rigid" if ball is None else METAL)
    bodies = {"rigid": RIGID, METAL: None}
    plate = bodies[plate] if plate in bodies else read_material(plate)
    drops = read_drop_test(arguments.drop)
    return DropTest(**drops, ball=ball, plate=plate, radius=arguments.ball_radius or BALL_RADIUS)


def _draw(calibrated: CalibratedMetal, path: Path) -> None:
    from plastigran.calibration.figures import figure  # slow to load
    from plastigran.plot.style import save

    save(figure(calibrated, progress=True), path, (path.suffix,))


def _print(calibrated: CalibratedMetal, output: Path | None) -> None:
    print(calibrated)
    if calibrated.pressed is not None:
        print()
        for name, value in calibrated.pressed.fitted.to_dict().items():
            print(f"{name:28s} {value:.5g}")
    print("\nLines for a deck:")
    print("\n".join(calibrated.deck_lines()))
    if output is not None:
        print(f"\nwritten: {output}")
    print(f"\nMaterial file:\n# {calibrated.remark}\n{material_lines(calibrated.material)}")
