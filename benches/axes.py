#!/usr/bin/env python3
"""Pictures of inner axes within their models: docs/axes.png.

usage: axes.py MEDAX DATA FILE

Needs pyvista (pip install pyvista)."""

import pathlib
import subprocess
import sys
import tempfile

import pyvista

MODELS = [
    ("3holes.off", (1, 1.5, 1)),
    ("fandisk.off", (-1, 0.6, 1)),
    ("foot.off", (1, 0.1, 0.2)),
    ("mannequin.off", (0.6, -1, 0.3)),
    ("refined_elephant.off", (1, 0.5, 0.4)),
    ("rocker-arm.obj", (1, 0.6, 0.2)),
]


def main():
    medax, data, file = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
    plotter = pyvista.Plotter(shape=(2, 3), off_screen=True, window_size=(1200, 800), border=False)
    with tempfile.TemporaryDirectory() as folder:
        for i, (name, view) in enumerate(MODELS):
            axis, mesh = f"{folder}/axis.ply", f"{folder}/mesh.ply"
            subprocess.run([medax, "medial", data / name, "-o", axis, "--quiet"], check=True)
            subprocess.run([medax, "decimate", data / name, "--ratio", "1", "-o", mesh, "--quiet"], check=True)
            solid = pyvista.read(mesh)
            plotter.subplot(*divmod(i, 3))
            plotter.add_mesh(solid, color="lightsteelblue", opacity=0.15)
            plotter.add_mesh(pyvista.read(axis), color="firebrick")
            plotter.view_vector(view, viewup=(0, 0, 1) if name in ("foot.off", "mannequin.off") else (0, 1, 0))
            plotter.camera.zoom(1.2)
            plotter.add_text(pathlib.Path(name).stem, font_size=9, color="black")
    plotter.screenshot(file)


if __name__ == "__main__":
    main()
