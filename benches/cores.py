#!/usr/bin/env python3
"""Cores, axes of MEDIAL, and cores extended by these, side by side as in Figure 13 of Giesen, Ramos, Sadri 2010: docs/cores.png. Loose edges are red.

usage: cores.py MEDAX DATA FILE

Needs pyvista (pip install pyvista)."""

import pathlib
import subprocess
import sys
import tempfile

import pyvista

MODELS = [("3holes.off", (1, 1.5, 1)), ("refined_elephant.off", (1, 0.5, 0.4)), ("rocker-arm.obj", (1, 0.6, 0.2))]
COLUMNS = [("core", ["flow"]), ("MEDIAL", ["medial"]), ("extended core", ["flow", "--extend", "medial"])]


def main():
    medax, data, file = sys.argv[1], pathlib.Path(sys.argv[2]), sys.argv[3]
    plotter = pyvista.Plotter(shape=(3, 3), off_screen=True, window_size=(1200, 1100), border=False)
    with tempfile.TemporaryDirectory() as folder:
        for row, (name, view) in enumerate(MODELS):
            axis, mesh = f"{folder}/axis.vtu", f"{folder}/mesh.ply"
            subprocess.run([medax, "decimate", data / name, "--ratio", "1", "-o", mesh, "--quiet"], check=True)
            solid = pyvista.read(mesh)
            for column, (title, command) in enumerate(COLUMNS):
                subprocess.run([medax, command[0], data / name, *command[1:], "-o", axis, "--quiet"], check=True)
                cells = pyvista.read(axis)
                is_line = cells.celltypes == pyvista.CellType.LINE
                plotter.subplot(row, column)
                plotter.add_mesh(solid, color="lightsteelblue", opacity=0.12)
                if (~is_line).any():
                    plotter.add_mesh(cells.extract_cells(~is_line), color="steelblue")
                if is_line.any():
                    plotter.add_mesh(cells.extract_cells(is_line), color="firebrick", line_width=3)
                plotter.view_vector(view, viewup=(0, 1, 0))
                plotter.camera.zoom(1.2)
                plotter.add_text(title if row == 0 else "", font_size=10, color="black")
    plotter.screenshot(file)


if __name__ == "__main__":
    main()
