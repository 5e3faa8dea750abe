# SPDX-License-Identifier: GPL-2.0-or-later
"""Write the frames of a run as XML files of VTK, and a file that lists these files by time.

A frame is the output of the run at one time step. ParaView opens the list (.pvd). OVITO and
ParaView open the files (.vtp). This module needs pyvista.
"""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from xml.etree import ElementTree

import numpy as np

from plastigran.plot.frame_files import Frame, read_frame_file

#: Columns that are renamed: names in the files of LIGGGHTS, and names in the written files.
GRAINS = {"v": "velocity", "f_plastic_work": "plastic_work"}
CONTACTS = {"delta": "overlap"}


def contact_table(frame: Frame) -> dict[str, np.ndarray]:
    """Return the data of the N contacts of a frame as columns, each (N,) or (N, 3).

    The columns are id1, id2 (IDs of the grains), overlap [m], effective radius radius_eff [m] and
    the further columns of the VTK file.
    """
    contacts, grains = read_frame_file(frame.contacts), read_frame_file(frame.grains)
    if not contacts.n_cells:
        return {name: np.zeros(0) for name in ("id1", "id2", *CONTACTS.values(), "radius_eff")}
    table = {CONTACTS.get(name, name): np.asarray(contacts[name]) for name in contacts.cell_data}
    order = np.argsort(grains["id"])
    radius = np.asarray(grains["radius"], dtype=float)[order]
    pairs = np.stack([table["id1"], table["id2"]]).astype(int)
    ends = radius[np.searchsorted(np.asarray(grains["id"])[order], pairs)]
    return table | {"radius_eff": 1 / (1 / ends).sum(axis=0)}


def write_grains(frame: Frame, path: Path) -> None:
    """Write the grains of a frame as points with id, type, radius [m] and velocity [m/s].

    For a run with energy balance, the points also have plastic_work [J].
    """
    grains = read_frame_file(frame.grains)
    for old, new in GRAINS.items():
        if old in grains.point_data:
            grains.rename_array(old, new, preference="point")
    grains.save(path, compression=None)


def write_contacts(frame: Frame, path: Path, more: Mapping[str, np.ndarray]) -> None:
    """Write the contacts of a frame to a VTK file, as lines between the grain centers.

    The columns are id1, id2, overlap [m], force, force_normal, force_tangential [N] and the columns
    `more`, each (N,) for N contacts.
    """
    contacts = read_frame_file(frame.contacts)
    for old, new in CONTACTS.items():
        if old in contacts.cell_data:
            contacts.rename_array(old, new, preference="cell")
    for name, values in more.items():
        contacts.cell_data[name] = values
    contacts.save(path, compression=None)


def write_mesh(frame: Frame, path: Path) -> None:
    """Write the walls of a frame to a VTK file, as triangles with IDs."""
    surface = read_frame_file(frame.mesh).extract_surface(algorithm="dataset_surface")
    surface.save(path, compression=None)


def write_series(path: Path, files: Mapping[float, Path]) -> None:
    """Write a ParaView data file that lists files in its folder by time [s]."""
    root = ElementTree.Element("VTKFile", type="Collection", version="1.0")
    collection = ElementTree.SubElement(root, "Collection")
    for time, file in sorted(files.items()):
        ElementTree.SubElement(collection, "DataSet", timestep=f"{time:.9g}", file=file.name)
    ElementTree.indent(root)
    ElementTree.ElementTree(root).write(path, encoding="utf-8", xml_declaration=True)
