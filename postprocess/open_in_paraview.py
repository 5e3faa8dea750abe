# SPDX-License-Identifier: GPL-2.0-or-later
"""Show the VTK frames of a bulk run in ParaView: grains colored by plastic work, contacts, meshes.

    paraview --script=postprocess/open_in_paraview.py    # from the run's folder
    pvpython postprocess/open_in_paraview.py RESULTS [picture.png]

In ParaView, choose Tools, Python Shell, Run Script, with the run's folder as working directory.
"""

import glob
import os
import re
import sys

from paraview import simple


def series(folder, kind):
    """Return the files of a kind as one source, in the order of their steps; None if none exist."""
    numbered = {}
    for path in glob.glob(os.path.join(folder, "frames", kind + "_*.vtk")):
        step = re.fullmatch(kind + r"_(\d+)\.vtk", os.path.basename(path))
        if step:
            numbered[int(step[1])] = path
    if not numbered:
        return None
    return simple.LegacyVTKReader(
        registrationName=kind, FileNames=[numbered[step] for step in sorted(numbered)]
    )


def show(source, field, association, title):
    """Show a source colored by a field, with a color bar."""
    display = simple.Show(source)
    simple.ColorBy(display, (association, *field))
    display.RescaleTransferFunctionToDataRange(True)
    display.SetScalarBarVisibility(simple.GetActiveView(), True)
    bar = simple.GetScalarBar(simple.GetColorTransferFunction(field[0]))
    bar.Title, bar.ComponentTitle = title, ""
    return display


def main(folder, picture=None):
    grains, contacts, mesh = (series(folder, kind) for kind in ("grains", "contacts", "mesh"))
    if grains is None:
        raise SystemExit(f"{folder} contains no frames. Run the deck with -v frames=10")
    view = simple.GetActiveViewOrCreate("RenderView")
    simple.GetAnimationScene().UpdateAnimationUsingDataTimeSteps()
    simple.GetAnimationScene().GoToLast()

    # The sphere glyph has a diameter of 1, so scale it by twice the radius.
    balls = simple.Glyph(registrationName="balls", Input=grains, GlyphType="Sphere")
    balls.GlyphType.ThetaResolution = balls.GlyphType.PhiResolution = 16
    balls.GlyphMode, balls.OrientationArray = "All Points", ["POINTS", "No orientation array"]
    balls.ScaleArray, balls.ScaleFactor = ["POINTS", "radius"], 2.0
    fields = [array.Name for array in grains.PointData]
    colour = "f_plastic_work" if "f_plastic_work" in fields else "radius"
    show(balls, (colour,), "POINTS", "plastic work (J)" if colour != "radius" else "radius (m)")
    if contacts is not None:
        chains = show(contacts, ("force", "Magnitude"), "CELLS", "contact force (N)")
        chains.LineWidth = 4.0
        simple.Hide(contacts)  # contact lines are inside the balls, so only one of the two is shown
    if mesh is not None:
        wall = simple.Show(mesh)
        wall.Opacity = 0.3
        wall.ColorArrayName = ["POINTS", ""]  # use one color for the whole mesh
    view.CameraPosition, view.CameraFocalPoint = [0.5, -1.0, 0.45], [0.0, 0.0, 0.0]
    view.CameraViewUp = [0.0, 0.0, 1.0]
    view.ResetCamera()
    simple.Render()
    if picture:
        simple.SaveScreenshot(picture, view, ImageResolution=[1200, 900])


arguments = [word for word in sys.argv[1:] if not word.startswith("-")]
main(arguments[0] if arguments else os.getcwd(), *arguments[1:2])
