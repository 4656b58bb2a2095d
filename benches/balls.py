#!/usr/bin/env python3
"""Models, points of their axes, and the unions of these points' balls, as in Figure 10 of Stolpner, Whitesides 2009: docs/field.png.

usage: balls.py MEDAX DATA FILE

Needs pyvista (pip install pyvista)."""

import pathlib
import subprocess
import sys
import tempfile

import numpy
import pyvista

MODELS = [
    ("fandisk.off", (-1, 0.6, 1), (0, 1, 0)),
    ("rocker-arm.obj", (1, 0.6, 0.2), (0, 1, 0)),
    ("foot.off", (1, 0.1, 0.2), (0, 0, 1)),
    ("abc_plate_00000329.obj", (1, 1, 1), (0, 0, 1)),
    ("refined_elephant.off", (1, 0.5, 0.4), (0, 1, 0)),
]


def main():
    medax, data, file = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
    plotter = pyvista.Plotter(shape=(len(MODELS), 3), off_screen=True, window_size=(1200, 400 * len(MODELS)), border=False)
    with tempfile.TemporaryDirectory() as folder:
        for row, (name, view, up) in enumerate(MODELS):
            axis, mesh, union = (f"{folder}/{part}" for part in ("axis.ma", "mesh.ply", "union.ply"))
            subprocess.run([medax, "decimate", data / name, "--ratio", "1", "-o", mesh, "--quiet"], check=True)
            subprocess.run([medax, "field", data / name, "--points", "-o", axis, "--quiet"], check=True)
            subprocess.run([medax, "union", axis, "-o", union, "--quiet"], check=True)
            solid = pyvista.read(mesh)
            # Lines "v x y z r".
            balls = numpy.array([line.split()[1:5] for line in open(axis) if line.startswith("v ")], dtype=float)
            for column in range(3):
                plotter.subplot(row, column)
                if column == 1:
                    plotter.add_mesh(solid, color="lightsteelblue", opacity=0.1)
                    plotter.add_points(balls[:, :3], scalars=balls[:, 3], cmap="viridis", point_size=4, show_scalar_bar=False)
                else:
                    plotter.add_mesh(solid if column == 0 else pyvista.read(union), color="lightsteelblue")
                plotter.view_vector(view, viewup=up)
                plotter.camera.zoom(1.2)
                plotter.add_text(pathlib.Path(name).stem if column == 0 else "", font_size=9, color="black")
    plotter.screenshot(file)


if __name__ == "__main__":
    main()
