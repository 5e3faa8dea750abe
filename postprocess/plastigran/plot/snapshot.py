# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of a run's VTK frames: grains, force chains and meshes, drawn without a screen.

Needs pyvista, an optional dependency: `pip install pyvista`.
"""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path
from typing import TYPE_CHECKING

import numpy as np

from plastigran.plot.colour_scale import colour_scale
from plastigran.plot.frame_files import Frame, SnapshotError, load_pyvista, read_vtk

if TYPE_CHECKING:
    import pyvista

#: What grains can be coloured by, with the words and unit beside the scale.
COLOURS = {
    "plastic_work": ("plastic work", "J"),
    "speed": ("speed", "m/s"),
    "height": ("height", "m"),
    "radius": ("radius", "m"),
}
#: Colours whose scale begins at nothing.
FROM_ZERO = ("plastic_work", "speed")
#: Directions to look from: the camera's side and what is up.
VIEWS = {
    "front": ((0, -1, 0), (0, 0, 1)),
    "side": ((1, 0, 0), (0, 0, 1)),
    "top": ((0, 0, 1), (0, 1, 0)),
    "corner": ((0.5, -1, 0.45), (0, 0, 1)),
}
#: Values at the ends of a scale of colours.
Span = tuple[float, float] | None


def draw(
    frame: Frame,
    path: str | Path,
    colour: str = "plastic_work",
    contacts: bool = False,
    view: str = "corner",
    size: tuple[int, int] = (1200, 900),
) -> None:
    """Draw a frame into a PNG file.

    Args:
        frame: What to draw.
        path: The file.
        colour: What colours grains, of `COLOURS`.
        contacts: Draw force chains instead, tubes whose thickness and colour are the force.
        view: Where from, of `VIEWS`.
        size: Pixels along x and y.

    Raises:
        SnapshotError: An unknown colour or view, no such data, or pyvista is not installed.
    """
    render(frame, path, colour, contacts, view, size)


def render(
    frame: Frame,
    path: str | Path | None,
    colour: str,
    contacts: bool,
    view: str,
    size: tuple[int, int],
    span: Span = None,
    bounds: Sequence[float] | None = None,
) -> np.ndarray:
    """A picture of a frame; arguments and errors as for `draw`, and those that pictures share.

    Args:
        path: Of the file; None for none.
        span: Values at the ends of the scale, of forces from 0; the frame's own by default.
        bounds: What to look at, two ends along x, y and z [m]; the frame's own by default.

    Returns:
        (height, width, 3) bytes.
    """
    if colour not in COLOURS:
        raise SnapshotError(f"colour is {colour!r}; it must be one of {', '.join(COLOURS)}")
    if view not in VIEWS:
        raise SnapshotError(f"view is {view!r}; it must be one of {', '.join(VIEWS)}")
    plotter = load_pyvista().Plotter(off_screen=True, window_size=size)
    bar = {
        "vertical": True,
        "position_x": 0.85,
        "position_y": 0.25,
        "height": 0.5,
        "fmt": "%.4g",
        "color": "black",
        "title_font_size": 22,
        "label_font_size": 20,
    }
    if contacts:
        _add_contacts(plotter, frame, bar, span)
    else:
        _add_grains(plotter, frame, colour, bar, span)
    if frame.mesh:
        plotter.add_mesh(read_vtk(frame.mesh), color="grey", opacity=0.25, show_edges=False)
    side, up = VIEWS[view]
    plotter.set_background("white")
    plotter.view_vector(side, viewup=up, bounds=bounds)
    plotter.enable_parallel_projection()
    plotter.camera.SetWindowCenter(0.15, 0)  # room for the scale
    plotter.enable_anti_aliasing("ssaa")
    picture = plotter.screenshot(path and str(path), return_img=True)
    plotter.close()
    return picture


def grain_values(frame: Frame, colour: str) -> np.ndarray:
    """What a colour of `COLOURS` shows of each grain, (N,); a frame without grains has no columns.

    Raises:
        SnapshotError: The frame does not have it.
    """
    grains = read_vtk(frame.grains)
    if not grains.n_points:
        return np.zeros(0)
    columns = {
        "plastic_work": lambda: grains["f_plastic_work"],
        "speed": lambda: np.linalg.norm(grains["v"], axis=1),
        "height": lambda: grains.points[:, 2],
        "radius": lambda: grains["radius"],
    }
    try:
        return np.asarray(columns[colour]())
    except KeyError:
        raise SnapshotError(f"{frame.grains} has no {colour}; choose another colour") from None


def contact_forces(frame: Frame) -> np.ndarray:
    """Force of each contact [N], (N,).

    Raises:
        SnapshotError: The frame has no contacts.
    """
    if frame.contacts is None:
        raise SnapshotError(f"{frame.grains.parent} has no contacts_{frame.step}.vtk")
    lines = read_vtk(frame.contacts)
    return np.linalg.norm(lines["force"], axis=1) if lines.n_cells else np.zeros(0)


def _add_grains(plotter: pyvista.Plotter, frame: Frame, colour: str, bar: dict, span: Span) -> None:
    grains = read_vtk(frame.grains)
    values = grain_values(frame, colour)
    if not len(values):
        if span:  # a movie may begin before there are any
            return
        raise SnapshotError(f"{frame.grains} holds no grains")
    scale = colour_scale(*COLOURS[colour], span or values, colour in FROM_ZERO)
    grains[scale.title] = scale.factor * values
    facets = 24 if grains.n_points < 10_000 else 10
    sphere = load_pyvista().Sphere(radius=1, theta_resolution=facets, phi_resolution=facets)
    balls = grains.glyph(geom=sphere, scale="radius", orient=False)
    plotter.add_mesh(
        balls,
        scalars=scale.title,
        clim=scale.ends,
        cmap="viridis",
        smooth_shading=True,
        scalar_bar_args=bar | {"title": f"{scale.title}\n", "n_labels": scale.labels},
    )


def _add_contacts(plotter: pyvista.Plotter, frame: Frame, bar: dict, span: Span) -> None:
    pyvista, force = load_pyvista(), contact_forces(frame)
    lines, grains = read_vtk(frame.contacts), read_vtk(frame.grains)
    if not span and not grains.n_points:
        raise SnapshotError(f"{frame.grains} holds no grains")
    # A contact through a periodic side would cross the whole box.
    ends = lines.points.reshape(-1, 2, 3)
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    radius = float(grains["radius"].max()) if grains.n_points else 0.0
    shown = np.flatnonzero((force > 0) & (lengths < 2 * radius))
    if not len(shown):
        if span:  # a movie may begin before anything touches
            return
        raise SnapshotError(f"nothing touches in {frame.contacts}")
    largest = span[1] if span else force.max()
    scale = colour_scale("contact force", "N", [0, largest], from_zero=True)
    chains = pyvista.PolyData(
        ends[shown].reshape(-1, 3), lines=np.insert(np.arange(2 * len(shown)), slice(0, None, 2), 2)
    )
    chains[scale.title] = scale.factor * np.repeat(force[shown], 2)
    # Sections as the forces: the thickest tube is a third as wide as a grain.
    chains["thickness"] = radius / 3 * np.sqrt(np.repeat(force[shown], 2) / largest)
    tubes = chains.tube(scalars="thickness", absolute=True, n_sides=8, capping=True)
    plotter.add_mesh(
        tubes,
        scalars=scale.title,
        clim=scale.ends,
        cmap="inferno_r",
        smooth_shading=True,
        scalar_bar_args=bar | {"title": f"{scale.title}\n", "n_labels": scale.labels},
    )
