# SPDX-License-Identifier: GPL-2.0-or-later
"""`plastigran calibrate`: find constants of a material for decks from a measurement."""

from __future__ import annotations

import argparse
from pathlib import Path

from plastigran import laws
from plastigran.calibration import (
    CalibratedAdhesion,
    CalibratedMetal,
    DropTest,
    calibrate,
    calibrate_adhesion,
)
from plastigran.calibration.calibrating import FEM_RADIUS
from plastigran.calibration.drop_test import BALL_RADIUS, read_drop_test
from plastigran.calibration.expected_errors import DEFAULT_LAW
from plastigran.calibration.finite_elements import USUAL_RANGE
from plastigran.calibration.strength import STEEL_RATE_COEFFICIENT
from plastigran.calibration.surface_energy import DEFAULT_LAW as ADHESIVE_LAW
from plastigran.cli.arguments import positive, print_json, refuse_idle
from plastigran.cli.metal import add_elastic, add_strain
from plastigran.materials import (
    RIGID,
    RIGID_WALL,
    Material,
    can_adhere,
    check_material_file,
    law_class,
    material_lines,
    read_material,
    write_material,
)

HELP = (
    "find the yield strength of a metal from hardness, rebound hardness or drop tests, or the "
    "surface energy of grains from a pull-off force or sticking speed"
)
EXAMPLE = """
plastigran calibrate --young 206e9 --poisson 0.3 --density 7850 --hardness 45HRC --output spring.in
plastigran calibrate --young 1.2e9 --poisson 0.3 --density 1350 --pull-off 2.4e-6 --radius 2.5e-6
"""

#: Value of --ball and --plate for the metal that is calibrated.
METAL = "metal"
#: Allowed suffixes of the file for --figure.
FIGURES = (".png", ".svg", ".pdf")
#: Yield strength of a material that does not yield [Pa].
NO_YIELD = 1e30
#: Flags that give or measure the yield strength, each with the name of its parsed argument.
MEASURED = {
    "--yield": "yield_strength",
    "--hardness": "hardness",
    "--leeb": "leeb",
    "--drop": "drop",
}
#: Further flags that have no effect if the surface energy is calibrated, as names of their parsed
#: arguments.
OF_STRENGTH = ("ball", "ball_radius", "rate_coefficient", "scatter", "speeds", "force_ratio")
#: Names of the parsed arguments that are passed to `calibrate` unchanged.
PASSED_ON = (
    *("density", "yield_strength", "hardness", "leeb", "plastic_modulus", "rate_coefficient"),
    *("scatter", "speeds", "strain"),
)


def add_arguments(command: argparse.ArgumentParser) -> None:
    command.add_argument(
        "--yield",
        type=positive,
        dest="yield_strength",
        help="yield strength, Pa: instead of a measurement, or together with --pull-off or "
        "--sticking-speed for a law that yields",
    )
    measured = command.add_mutually_exclusive_group()
    measured.add_argument(
        "--hardness", help="hardness: a number in HV, or with its scale, for example 45HRC or 200HB"
    )
    measured.add_argument(
        "--leeb",
        help="Leeb (rebound) hardness: a number in HLD, or with another scale, such as 750HLG",
    )
    measured.add_argument(
        "--drop", type=Path, metavar="FILE", help="table of drop tests, see docs/calibrate.md"
    )
    measured.add_argument(
        "--pull-off", type=positive, dest="pull_off_force", help="pull-off force of two bodies, N"
    )
    measured.add_argument(
        "--sticking-speed", type=positive, help="largest closing speed at which bodies stick, m/s"
    )
    command.add_argument(
        "--load",
        type=positive,
        help="largest compressive force before --pull-off, N, default 0; for laws that yield",
    )
    command.add_argument(
        "--radius-other",
        type=positive,
        help="radius of the second sphere of --pull-off or --sticking-speed, m; default: a plate",
    )
    add_elastic(command, FEM_RADIUS, density=None)
    command.set_defaults(radius=None)  # --pull-off and --sticking-speed need a radius
    command.add_argument(
        "--hardening",
        type=float,
        default=0.0,
        dest="plastic_modulus",
        help="plastic modulus, which is the slope of stress versus plastic strain, Pa, default 0",
    )
    command.add_argument(
        "--ball", help="material of the ball of --drop, default: the calibrated metal"
    )
    command.add_argument(
        "--plate",
        help=(
            "material of the plate of --drop, or of the second body of --pull-off or "
            "--sticking-speed: `rigid`, `metal` for the calibrated metal, or a material. Default: "
            "metal with --radius-other or another --ball, else rigid"
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
        "--law",
        help=f"name of the law, default {DEFAULT_LAW}, and {ADHESIVE_LAW} for --pull-off and "
        "--sticking-speed",
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
        "--fem",
        action="store_true",
        help="fit the law vu_quoc_zhang to finite-element computations of the metal",
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
        help="file for a figure of the calibrated law with the drop tests or finite elements",
    )


def run(arguments: argparse.Namespace) -> None:
    output = arguments.output
    _refuse_idle(arguments)
    if output is not None:
        check_material_file(output, arguments.force)
    if arguments.figure is not None and arguments.figure.suffix not in FIGURES:
        raise ValueError(f"--figure is {arguments.figure}; it must end in {' or '.join(FIGURES)}")
    calibrated = _adhesion(arguments) if _is_of_adhesion(arguments) else _metal(arguments)
    if output is not None:
        write_material(calibrated.material, output, calibrated.remark, arguments.force)
    if arguments.figure is not None:
        _draw(calibrated, arguments.figure)
    if arguments.json:
        print_json(calibrated.to_dict())
    else:
        _print(calibrated, output)


def _is_of_adhesion(arguments: argparse.Namespace) -> bool:
    return arguments.pull_off_force is not None or arguments.sticking_speed is not None


def _metal(arguments: argparse.Namespace) -> CalibratedMetal:
    """Calibrate the yield strength of the metal.

    Raises:
        ValueError: No measurement or more than one is given; or as for `calibrate`.
    """
    measured = [name for name in MEASURED if getattr(arguments, MEASURED[name]) is not None]
    if len(measured) != 1:
        raise ValueError(
            f"{' and '.join(measured) or 'no measurement'} given; exactly one of "
            f"{', '.join(MEASURED)}, --pull-off and --sticking-speed is needed"
        )
    output = arguments.output
    return calibrate(
        youngs_modulus=arguments.young,
        poissons_ratio=arguments.poisson,
        drops=_drops(arguments),
        force_ratio=_finite_elements(arguments),
        name=output.stem if output else "metal",
        progress=True,
        law=arguments.law or DEFAULT_LAW,
        radius=arguments.radius or FEM_RADIUS,
        **{name: getattr(arguments, name) for name in PASSED_ON},
    )


def _adhesion(arguments: argparse.Namespace) -> CalibratedAdhesion:
    """Calibrate the surface energy of the bodies.

    Raises:
        ValueError: The radius or a yield strength is missing; or as for `calibrate_adhesion`.
    """
    law = arguments.law or ADHESIVE_LAW
    if arguments.radius is None:
        raise ValueError(
            "--pull-off and --sticking-speed need --radius, the radius of the sphere in m. Add it"
        )
    if law_class(law).yields and can_adhere(law) and arguments.yield_strength is None:
        raise ValueError(f"law {law} yields, so it needs --yield, the yield strength in Pa. Add it")
    material = Material(
        arguments.output.stem if arguments.output else "grain",
        arguments.young,
        arguments.poisson,
        arguments.density,
        yield_strength=arguments.yield_strength or NO_YIELD,
    )
    return calibrate_adhesion(
        material,
        _plate(arguments, METAL if arguments.radius_other else RIGID_WALL) or material,
        radius=arguments.radius,
        radius_other=arguments.radius_other,
        pull_off_force=arguments.pull_off_force,
        sticking_speed=arguments.sticking_speed,
        load=arguments.load or 0.0,
        law=law,
    )


def _refuse_idle(arguments: argparse.Namespace) -> None:
    """Reject flags that have no effect with the given measurement.

    Raises:
        ValueError: A flag has no effect; the message names it.
    """
    finite_elements = _finite_elements(arguments)
    adhesion = _is_of_adhesion(arguments)
    if adhesion:
        needed = "a measurement of the yield strength"
        refuse_idle(arguments, needed, **dict.fromkeys(OF_STRENGTH), plastic_modulus=0.0, fem=False)
    else:
        refuse_idle(arguments, "--pull-off or --sticking-speed", radius_other=None)
    if arguments.pull_off_force is None:
        refuse_idle(arguments, "--pull-off", load=None)
    if arguments.output is None:
        refuse_idle(arguments, "--output", force=False)
    if arguments.drop is None:
        plate = {} if adhesion else {"plate": None}
        refuse_idle(arguments, "--drop", ball=None, **plate, ball_radius=None)
        if arguments.leeb is None:
            refuse_idle(arguments, "--drop or --leeb", scatter=None)
        if not finite_elements:
            refuse_idle(arguments, "--drop or --fem", figure=None)
    if not finite_elements:
        if not adhesion:
            refuse_idle(arguments, "--fem", radius=None)
        if arguments.strain == "finite":
            raise ValueError(
                "--finite-strain has no effect without --fem. Add --fem, or remove the flag"
            )


def _finite_elements(arguments: argparse.Namespace) -> float | None:
    """Return largest force / yield force of the finite-element fit; None without a fit."""
    usual = USUAL_RANGE if arguments.fem else None
    return usual if arguments.force_ratio is None else arguments.force_ratio


def _drops(arguments: argparse.Namespace) -> DropTest | None:
    if arguments.drop is None:
        return None
    ball = None if arguments.ball in (None, METAL) else read_material(arguments.ball)
    plate = _plate(arguments, RIGID_WALL if ball is None else METAL)
    drops = read_drop_test(arguments.drop)
    return DropTest(**drops, ball=ball, plate=plate, radius=arguments.ball_radius or BALL_RADIUS)


def _plate(arguments: argparse.Namespace, default: str) -> Material | laws.Body | None:
    """Return the plate of --plate or the default plate; None stands for the calibrated metal."""
    plate = arguments.plate or default
    bodies = {RIGID_WALL: RIGID, METAL: None}
    return bodies[plate] if plate in bodies else read_material(plate)


def _draw(calibrated: CalibratedMetal, path: Path) -> None:
    # Import here, because matplotlib is slow to load.
    from plastigran.calibration.figures import figure
    from plastigran.plot.style import save

    save(figure(calibrated, progress=True), path, (path.suffix,))


def _print(calibrated: CalibratedMetal | CalibratedAdhesion, output: Path | None) -> None:
    print(calibrated)
    if getattr(calibrated, "pressed", None) is not None:
        print()
        for name, value in calibrated.pressed.fitted.to_dict().items():
            print(f"{name:28s} {value:.5g}")
    print("\nLines for a deck:")
    print("\n".join(calibrated.deck_lines()))
    if output is not None:
        print(f"\nwritten: {output}")
    print(f"\nMaterial file:\n# {calibrated.remark}\n{material_lines(calibrated.material)}")
