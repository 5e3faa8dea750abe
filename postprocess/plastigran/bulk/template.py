# SPDX-License-Identifier: GPL-2.0-or-later
"""Write a new deck for the user from the template in `inputs/template`."""

from __future__ import annotations

import shutil
from math import floor, log10
from pathlib import Path

from plastigran import laws
from plastigran.contact import Contact
from plastigran.declared import Declaration, read_number
from plastigran.engine.process import inputs_folder, misread
from plastigran.materials import (
    Material,
    has_constants,
    has_surface_energy,
    read_material,
    write_material,
)
from plastigran.usable_laws import laws_for

#: Impact speed for which the time step of a new deck is computed [m/s]. It exceeds all impact
#: speeds in the deck.
SPEED = 2.0
#: Impact speed after a fall from 0.09 m, the largest initial height in a new deck [m/s].
FALL_SPEED = 1.33
#: Allowed grain radii, for which the box of the template is large enough [m].
NEW_DECK_RADIUS = Declaration("radius", "m", 0.0005, 0.006, True, True)
#: Further files that are copied to the folder of the new deck.
PARTS = ("energy_ledger.in", "meshes/plate.stl", "template/fresh.in", "template/checkpoint.in")
#: Names of the files in `PARTS` without suffix. Deck and material must not have these names.
USED_NAMES = [Path(file).stem for file in PARTS]


def write_deck(
    folder: Path, law: str, material: Material | str | Path, radius: float = 0.003
) -> Path:
    """Write a folder with a deck and the files that it reads, such as its material and its mesh.

    Args:
        folder: Folder to create; the deck has its name.
        law: Law between grains, and between grains and walls.
        material: Material of grains and walls.
        radius: Radius of the grains [m], from 0.0005 to 0.006.

    Returns:
        Path of the deck.

    Raises:
        ValueError: The law or the material does not exist, the law is not for spheres, the name of
            the folder is not allowed, or the radius is out of range.
        FileExistsError: The folder exists.
    """
    material, radius = read_material(material), read_number("radius", radius, NEW_DECK_RADIUS)
    for name in (folder.name, material.name):
        if misread(name):
            raise ValueError(
                f"{name!r} contains white space, % or *, which LIGGGHTS misreads. Choose another "
                "name"
            )
        if name in USED_NAMES:
            raise ValueError(
                f"{name!r} is the name of another file in the folder of the deck. "
                "Choose another name"
            )
    if folder.name == material.name:
        raise ValueError(f"deck and material are both called {folder.name!r}. Choose another name")
    choices = _choices(material)
    if law not in choices:
        problem = f"{law!r} is not a law for spheres of {material.name}"
        if law in laws.LAWS and (has_surface_energy(law) or not has_constants(law)):
            problem = (
                f"law {law!r} needs constants of the pair of bodies, which the deck does not define"
            )
        if law == "hertz":
            problem = (
                "hertz is LIGGGHTS' own model and has no energy balance, but the deck needs it"
            )
        raise ValueError(f"{problem}. Choose one of {', '.join(choices)}")
    source = inputs_folder() / "template"
    text = (source / "deck.in").read_text()
    contact = Contact(law, material, material, radius=radius, radius_other=radius)
    values = {
        "LAW": law,
        "RADIUS": f"{radius:g}",
        "MATERIAL": material.name,
        "TIMESTEP": _rounded_down(float(contact.timestep(SPEED))),
        "DECK": folder.name,
    }
    for word, value in values.items():
        text = text.replace(word, value)
    if folder.exists():
        raise FileExistsError(f"{folder} already exists. Choose another name")
    folder.mkdir(parents=True)
    deck = folder / f"{folder.name}.in"
    deck.write_text(text)
    remark = f"Material of {deck.name}, made from {material.name}."
    write_material(material, folder / f"{material.name}.in", remark)
    for file in PARTS:
        shutil.copyfile(inputs_folder() / file, folder / Path(file).name)
    return deck


def _choices(material: Material) -> list[str]:
    """Return the names of the laws that the new deck can use."""
    names = laws_for("sphere", [material])
    return [name for name in names if name != "hertz" and not has_surface_energy(name)]


def range_note(law: str, material: Material | str | Path, radius: float) -> str:
    """Return a warning if impacts in the deck exceed the valid overlap of the law; otherwise "".

    Args:
        law, material, radius: As for `write_deck`.
    """
    material = read_material(material)

    def excess(name: str) -> float:
        contact = Contact(name, material, material, radius=radius, radius_other=radius)
        return contact.impact(FALL_SPEED).overlap_max / contact.overlap_range

    if excess(law) <= 1:
        return ""
    covering = [name for name in _choices(material) if excess(name) <= 1]
    remedy = f"one of {', '.join(covering)}, or " if covering else ""
    return (
        f"grains of this deck fall at up to {FALL_SPEED:g} m/s. With {material.name}, their "
        f"overlap then is {excess(law):.2g} times the largest valid overlap of {law}. "
        f"Use {remedy}a stiffer and stronger material"
    )


def _rounded_down(step: float) -> str:
    """Return a time step rounded down to one digit, as text."""
    power = floor(log10(step))
    return f"{floor(step / 10.0**power)}.0e{power}"
