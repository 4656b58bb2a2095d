#!/usr/bin/env python3
"""A picture of the Voronoi diagram of three lines in a cube: docs/three_lines.png.

usage: three_lines.py FIRST SECOND THIRD FILE

The first three are what examples/three_lines.rs writes. Needs pyvista (pip install pyvista)."""

import sys

import pyvista

COLORS = ["steelblue", "goldenrod", "indianred"]
# Two ends each, in the cube.
LINES = [((-2, 0, -1), (2, 0, -1)), ((-1, -2, 0), (-1, 2, 0)), ((0, -1, -2), (0, -1, 2))]


def main():
    *pieces, file = sys.argv[1:]
    plotter = pyvista.Plotter(shape=(1, 2), off_screen=True, window_size=(1200, 600), border=False)
    for column, view in enumerate([(1, 0.55, 0.6), (-0.7, -1, 0.75)]):
        plotter.subplot(0, column)
        for piece, color in zip(pieces, COLORS):
            plotter.add_mesh(pyvista.read(piece), color=color, opacity=0.85)
        for a, b in LINES:
            plotter.add_mesh(pyvista.Tube(pointa=a, pointb=b, radius=0.03), color="black")
        plotter.add_mesh(pyvista.Cube(bounds=(-2, 2) * 3), style="wireframe", color="gray")
        plotter.view_vector(view, viewup=(0, 0, 1))
        plotter.camera.zoom(0.95)
    plotter.screenshot(file)


if __name__ == "__main__":
    main()
