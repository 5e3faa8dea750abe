# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of the frames of a run: grains, force chains and meshes, drawn without a screen.

A frame is the output of the run at one time step.

This module needs pyvista, an optional dependency: `pip install pyvista`.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from plastigran.plot.colour_scale import ColourScale, colour_scale
from plastigran.plot.frame_files import Frame, SnapshotError, load_pyvista, read_frame_file
from plastigran.plot.frames import GRAIN_QUANTITIES, contact_forces, grain_values

if TYPE_CHECKING:
    import pyvista

#: For each view, the direction from the grains to the camera, and the upward direction.
VIEWS = {
    "front": ((0, -1, 0), (0, 0, 1)),
    "side": ((1, 0, 0), (0, 0, 1)),
    "top": ((0, 0, 1), (0, 1, 0)),
    "corner": ((0.5, -1, 0.45), (0, 0, 1)),
}
#: Layout of the color scale.
SCALE_BAR = {
    "vertical": True,
    "position_x": 0.85,
    "position_y": 0.25,
    "height": 0.5,
    "fmt": "%.4g",
    "color": "black",
    "title_font_size": 22,
    "label_font_size": 20,
}
#: Values at the ends of a color scale; None to take the range of the values in the frame.
Span = tuple[float, float] | None


def draw(
    frame: Frame,
    path: str | Path | None,
    colour: str = "plastic_work",
    contacts: bool = False,
    view: str = "corner",
    size: tuple[int, int] = (1200, 900),
    span: Span = None,
    bounds: Sequence[float] | None = None,
) -> np.ndarray:
    """Draw a frame into a PNG file and return the picture, (height, width, 3) bytes.

    Args:
        frame: Frame to draw.
        path: Name of the PNG file; None to write no file.
        colour: Quantity that colors the grains, a key of `GRAIN_QUANTITIES`.
        contacts: Whether to draw contacts instead of grains, as tubes whose thickness and color
            show the force.
        view: Direction of view, a key of `VIEWS`.
        size: Width and height in pixels.
        span: Values at the ends of the color scale. The default is the range of values in the
            frame. If `span` is given, a frame without grains or contacts is allowed.
        bounds: Smallest and largest visible x, y and z [m] (6 numbers). The default is the extent
            of the frame.

    Raises:
        SnapshotError: The color or view is unknown, data are missing, or pyvista is not installed.
    """
    for name, value, choices in (("colour", colour, GRAIN_QUANTITIES), ("view", view, VIEWS)):
        if value not in choices:
            raise SnapshotError(f"{name} is {value!r}; it must be one of {', '.join(choices)}")
    plotter = load_pyvista().Plotter(off_screen=True, window_size=size)
    if contacts:
        _add_contacts(plotter, frame, span)
    else:
        _add_grains(plotter, frame, colour, span)
    if frame.mesh:
        plotter.add_mesh(read_frame_file(frame.mesh), color="grey", opacity=0.25, show_edges=False)
    side, up = VIEWS[view]
    plotter.set_background("white")
    plotter.view_vector(side, viewup=up, bounds=bounds)
    plotter.enable_parallel_projection()
    plotter.camera.SetWindowCenter(0.15, 0)  # shift the picture to leave space for the color scale
    plotter.enable_anti_aliasing("ssaa")
    picture = plotter.screenshot(path and str(path), return_img=True)
    plotter.close()
    return picture


def _add_grains(plotter: pyvista.Plotter, frame: Frame, colour: str, span: Span) -> None:
    grains, values = read_frame_file(frame.grains), grain_values(frame, colour)
    if not len(values):
        if span:
            return
        raise SnapshotError(f"{frame.grains} contains no grains. Choose another frame")
    quantity = GRAIN_QUANTITIES[colour]
    scale = colour_scale(quantity.title, quantity.unit, span or values, quantity.from_zero)
    grains[scale.axis] = scale.factor * values
    facets = 24 if grains.n_points < 10_000 else 10
    sphere = load_pyvista().Sphere(radius=1, theta_resolution=facets, phi_resolution=facets)
    _add_coloured(
        plotter, grains.glyph(geom=sphere, scale="radius", orient=False), scale, "viridis"
    )


def _add_contacts(plotter: pyvista.Plotter, frame: Frame, span: Span) -> None:
    pyvista, force = load_pyvista(), contact_forces(frame)
    lines, grains = read_frame_file(frame.contacts), read_frame_file(frame.grains)
    if not span and not grains.n_points:
        raise SnapshotError(f"{frame.grains} contains no grains. Choose another frame")
    # Omit contacts across a periodic boundary, because their lines would cross the whole box.
    ends = lines.points.reshape(-1, 2, 3)
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    radius = float(grains["radius"].max()) if grains.n_points else 0.0
    shown = np.flatnonzero((force > 0) & (lengths < 2 * radius))
    if not len(shown):
        if span:
            return
        raise SnapshotError(f"{frame.contacts} contains no contacts. Choose another frame")
    largest = span[1] if span else force.max()
    scale = colour_scale("contact force", "N", [0, largest], from_zero=True)
    chains = pyvista.PolyData(
        ends[shown].reshape(-1, 3), lines=np.insert(np.arange(2 * len(shown)), slice(0, None, 2), 2)
    )
    chains[scale.axis] = scale.factor * np.repeat(force[shown], 2)
    # The cross-sectional area of a tube is proportional to the force. The radius of the thickest
    # tube is a third of the largest grain radius.
    chains["thickness"] = radius / 3 * np.sqrt(np.repeat(force[shown], 2) / largest)
    tubes = chains.tube(scalars="thickness", absolute=True, n_sides=8, capping=True)
    _add_coloured(plotter, tubes, scale, "inferno_r")


def _add_coloured(
    plotter: pyvista.Plotter, mesh: pyvista.DataSet, scale: ColourScale, colour_map: str
) -> None:
    """Add a mesh to the picture, colored by its column `scale.axis`, and the color scale."""
    plotter.add_mesh(
        mesh,
        scalars=scale.axis,
        clim=scale.ends,
        cmap=colour_map,
        smooth_shading=True,
        scalar_bar_args=SCALE_BAR | {"title": f"{scale.axis}\n", "n_labels": scale.labels},
    )
