# SPDX-License-Identifier: GPL-2.0-or-later
"""Pictures of the VTK frames of a run: grains, force chains and meshes, drawn without a screen.

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

#: Quantities that can color grains, with name and unit for the scale.
COLOURS = {
    "plastic_work": ("plastic work", "J"),
    "speed": ("speed", "m/s"),
    "height": ("height", "m"),
    "radius": ("radius", "m"),
}
#: Quantities whose scale starts at zero.
FROM_ZERO = ("plastic_work", "speed")
#: Views: the side of the camera and the upward direction.
VIEWS = {
    "front": ((0, -1, 0), (0, 0, 1)),
    "side": ((1, 0, 0), (0, 0, 1)),
    "top": ((0, 0, 1), (0, 1, 0)),
    "corner": ((0.5, -1, 0.45), (0, 0, 1)),
}
#: Values at the ends of a color scale.
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
        frame: Frame to draw.
        path: Name of the file.
        colour: Quantity that colors the grains, a key of `COLOURS`.
        contacts: Whether to draw force chains instead: tubes whose thickness and color show the
            force.
        view: Direction of view, a key of `VIEWS`.
        size: Pixels along x and y.

    Raises:
        SnapshotError: The color or view is unknown, data are missing, or pyvista is not installed.
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
    """Draw a frame and return the picture. Other arguments and errors are as for `draw`.

    Args:
        path: Name of the file; None for no file.
        span: Values at the ends of the color scale; by default those of the frame.
        bounds: Bounds of the view along x, y and z [m]; by default those of the frame.

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
    plotter.camera.SetWindowCenter(0.15, 0)  # leave room for the scale
    plotter.enable_anti_aliasing("ssaa")
    picture = plotter.screenshot(path and str(path), return_img=True)
    plotter.close()
    return picture


def grain_values(frame: Frame, colour: str) -> np.ndarray:
    """Return the values of a quantity of `COLOURS` for each grain (N,); (0,) without grains.

    Raises:
        SnapshotError: The frame has no such values.
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
        raise SnapshotError(f"{frame.grains} has no {colour}. Choose another color") from None


def contact_forces(frame: Frame) -> np.ndarray:
    """Return the force of each contact (N,), N.

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
        if span:  # the first frames of a movie may have no grains
            return
        raise SnapshotError(f"{frame.grains} contains no grains")
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
        raise SnapshotError(f"{frame.grains} contains no grains")
    # The line of a contact through a periodic side would cross the whole box.
    ends = lines.points.reshape(-1, 2, 3)
    lengths = np.linalg.norm(ends[:, 1] - ends[:, 0], axis=1)
    radius = float(grains["radius"].max()) if grains.n_points else 0.0
    shown = np.flatnonzero((force > 0) & (lengths < 2 * radius))
    if not len(shown):
        if span:  # the first frames of a movie may have no contacts
            return
        raise SnapshotError(f"{frame.contacts} contains no contacts")
    largest = span[1] if span else force.max()
    scale = colour_scale("contact force", "N", [0, largest], from_zero=True)
    chains = pyvista.PolyData(
        ends[shown].reshape(-1, 3), lines=np.insert(np.arange(2 * len(shown)), slice(0, None, 2), 2)
    )
    chains[scale.title] = scale.factor * np.repeat(force[shown], 2)
    # The cross section is proportional to the force; the thickest tube is a third of a grain.
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
