#!/usr/bin/env python3
"""Pair-meshes of models and built-in shapes: docs/pair.md, and their surfaces from the inner structure to the boundary, as in Figures 13 to 15 of Shaham, Shamir, Cohen-Or 2004: docs/pair.png.

usage: pair.py MEDAX DATA FOLDER

MEDAX is the program, DATA the folder with the models, FOLDER where pair.md and pair.png go. Seconds are those of the processor. Needs pyvista (pip install pyvista)."""

import datetime
import json
import pathlib
import platform
import subprocess
import sys
import tempfile

import numpy
import pyvista

MODELS = ["3holes.off", "rocker-arm.obj", "mannequin.off", "foot.off", "kitten.xyz", "igea.ply", "refined_elephant.off", "fandisk.off", "abc_plate_00000329.obj", "ant.off", "cavity_and_ring.off", "hotdogs.pts", "knot.pts", "octopus.off", "stanford-bunny.obj"]
SHAPES = ["ellipsoid", "torus", "genus3", "trefoil", "sphere", "capsule", "box", "bracket"]
# What is drawn: the shapes of the paper's figures, as far as there are such.
DRAWN = [("ball", (1, 0.6, 0.4), (0, 1, 0)), ("cylinder", (1, 0.4, 0.4), (0, 1, 0)), ("wheel", (0.5, -0.5, 1), (0, 1, 0)), ("cube", (1, 0.7, 0.5), (0, 1, 0)), ("mannequin", (1, -1, 0.2), (0, 0, 1))]
TIMES = [0.001, 0.1, 0.3, 0.5, 0.75, 1]


def run(medax, *arguments):
    done = subprocess.run([medax, *map(str, arguments), "--json", "--quiet"], capture_output=True, text=True)
    return json.loads(done.stdout)


def table(medax, data, folder, add):
    add("| sample | samples | pyramids | between edges | over triangles | moved, of inner vertices | removed | Betti numbers of S, of the surface at 0.5, of the inner structure | problems | s |")
    add("| --- | --: | --: | --: | --: | --: | --: | --- | --: | --: |")
    paths = [data / name for name in MODELS]
    for shape in SHAPES:
        path = folder / f"{shape}.ply"
        run(medax, "sample", shape, "-o", path)
        paths.append(path)
    for path in paths:
        options = ["--validate", "--iso", "0.5,1", "--iso-out", folder / "iso.ply"]
        report = run(medax, "pair", path, *options)
        if "error" in report:
            add(f"| {path.stem} | " + " | " * 7 + f"{report['error']['message']} | |")
            continue
        pair = report["pair"]
        betti = lambda i: ", ".join(map(str, report["outputs"][i]["topology"]["betti"]))
        seconds = sum(stage["cpu_seconds"] for stage in report["stages"] if stage["name"] == "pair")
        cells = [path.stem, f"{report['input']['points']:,}", f"{pair['face_vertex']:,}", f"{pair['edge_edge']:,}", f"{pair['vertex_face']:,}", f"{pair['moved']:,} of {pair['inner_vertices']:,}", str(pair["removed"]), f"{betti(3)}; {betti(2)}; {betti(1)}", str(report["validation"]["problems"]), f"{seconds:.2f}"]
        add("| " + " | ".join(cells) + " |")
        print(path.stem, file=sys.stderr)
    add("")


def mesh_of(name):
    """A mesh of a shape of the paper, from which samples are taken."""
    if name == "ball":
        return pyvista.Sphere(radius=1, theta_resolution=60, phi_resolution=60)
    if name == "cylinder":
        return pyvista.Cylinder(radius=0.5, height=2, resolution=60).triangulate()
    if name == "cube":
        return pyvista.Cube().triangulate()
    if name == "wheel":
        x, y, z = numpy.meshgrid(*(numpy.linspace(-1.3, 1.3, 131),) * 2, numpy.linspace(-0.25, 0.25, 31), indexing="ij")
        value = 0.15 - numpy.hypot(numpy.hypot(x, y) - 1, z)
        value = numpy.maximum(value, numpy.minimum(0.25 - numpy.hypot(x, y), 0.15 - abs(z)))
        for k in range(6):
            a = numpy.pi * k / 3
            along, across = x * numpy.cos(a) + y * numpy.sin(a), y * numpy.cos(a) - x * numpy.sin(a)
            value = numpy.maximum(value, numpy.minimum(0.08 - numpy.hypot(across, z), numpy.minimum(along, 1 - along)))
        grid = pyvista.ImageData(dimensions=x.shape, spacing=(2.6 / 130, 2.6 / 130, 0.5 / 30), origin=(-1.3, -1.3, -0.25))
        grid["value"] = value.ravel(order="F")
        return grid.contour([0], scalars="value").triangulate().clean()
    return None


def picture(medax, data, folder, file):
    plotter = pyvista.Plotter(shape=(len(DRAWN), len(TIMES)), off_screen=True, window_size=(220 * len(TIMES), 220 * len(DRAWN)), border=False)
    for row, (name, view, up) in enumerate(DRAWN):
        mesh = mesh_of(name)
        source = data / "mannequin.off"
        if mesh is not None:
            source = folder / "samples.ply"
            mesh.save(folder / "mesh.ply")
            run(medax, "sample", folder / "mesh.ply", "-o", source, "--spacing", 0.02 * mesh.length)
        times = ",".join(map(str, TIMES))
        report = run(medax, "pair", source, "--iso", times, "--iso-out", folder / "iso.ply")
        if "error" in report:
            sys.exit(f"{name}: {report['error']['message']}")
        for column, t in enumerate(TIMES):
            surface = pyvista.read(folder / f"iso-{t}.ply")
            plotter.subplot(row, column)
            plotter.add_mesh(surface, color="lightsteelblue", show_edges=True, edge_opacity=0.2, line_width=0.5)
            plotter.view_vector(view, viewup=up)
            plotter.add_text(f"t = {t}" if row == 0 else "", font_size=9, color="black")
    plotter.screenshot(file)


def main():
    medax, data, docs = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    lines = ["# Pair-meshes\n"]
    add = lines.append
    machine = f"{platform.machine()}, {platform.system()}"
    add("Solids between their inner Voronoi diagram and their surface (Shaham, Shamir, Cohen-Or 2004; [docs/algorithms/pair.md](algorithms/pair.md)). `make pair` makes this page;")
    add(f"this one was made on {datetime.date.today()}, {machine}.\n")
    add("![Shapes, and their surfaces from the inner structure to the boundary](pair.png)\n")
    add("Labels are those of Tight Cocone. *Problems* are the checks of `validate` that fail.\n")
    with tempfile.TemporaryDirectory() as folder:
        picture(medax, data, pathlib.Path(folder), docs / "pair.png")
        table(medax, data, pathlib.Path(folder), add)
    (docs / "pair.md").write_text("\n".join(lines))


if __name__ == "__main__":
    main()
