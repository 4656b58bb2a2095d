#!/usr/bin/env python3
"""Power crusts of real models against what is known of them: the tables of docs/results.md.

usage: results.py MEDAX FOLDER > docs/results.md

MEDAX is the program, FOLDER has the models that `make results` names. Only vertices are taken. Seconds are of the processor."""

import json
import math
import pathlib
import platform
import random
import subprocess
import sys
import tempfile

sys.dont_write_bytecode = True
import smooth

# File, components and genus of the closed surface; None where that is not what its sample can tell, with the reason.
MODELS = [
    ("3holes.off", (1, 3), ""),
    ("rocker-arm.obj", (1, 1), ""),
    ("mannequin.off", (1, 0), ""),
    ("foot.off", (1, 0), ""),
    ("igea.ply", (1, 0), ""),
    ("refined_elephant.off", (1, 3), ""),
    ("ant.off", (1, 0), ""),
    ("fandisk.off", (1, 0), ""),
    ("fandisk.off --sharp-corners", (1, 0), ""),
    ("abc_plate_00000329.obj", (1, 3), ""),
    ("abc_plate_00000329.obj --sharp-corners", (1, 3), ""),
    ("cavity_and_ring.off", (3, 1), ""),
    ("octopus.off", (4, 0), "four shells that cut into each other"),
    ("dragon.ply", (1, 55), "the genus is dirt of the scan"),
]
POINTS = [("kitten.xyz", (1, 1)), ("hotdogs.pts", (2, 0)), ("knot.pts", (1, 1))]
# Scans, and whether the scanner was at the origin.
SCANS = [
    ("stanford-bunny.obj", False),
    ("foot_hole.off", False),
    ("range_scan_rops.ply", True),
    ("street_lidar.xyz", True),
    ("kinect_office_nan.ply", True),
]
NOISY = [("mannequin.off", (1, 0)), ("foot.off", (1, 0)), ("rocker-arm.obj", (1, 1))]


def run(medax, *arguments):
    """The program's report, and what it took."""
    done = subprocess.run([medax, *arguments, "--json", "--quiet"], capture_output=True, text=True)
    report = json.loads(done.stdout)
    if done.returncode != 0:
        raise SystemExit(f"{' '.join(arguments)}: {report['error']['message']}")
    return report


def reconstruct(medax, source, output, options):
    report = run(medax, "crust", str(source), "-o", str(output), *options)
    topology = report["outputs"][0]["topology"]
    seconds = sum(stage["cpu_seconds"] for stage in report["stages"])
    return report, topology, seconds


def form(topology):
    return f"{topology['components']}, {'-' if topology['genus'] is None else topology['genus']}"


def distances(medax, surface, mesh):
    """Maximum and mean, both ways, as shares of the diagonal in percent."""
    found = run(medax, "compare", str(surface), str(mesh))["distances"]
    percent = 100 / found["diagonal"]
    return [f"{found[way][what] * percent:.3f}" for way in ("a_to_b", "b_to_a") for what in ("max", "mean")]


def row(*cells):
    print("| " + " | ".join(str(cell) for cell in cells) + " |")


def points_of(medax, mesh, folder):
    """The distinct points of a model, and the median distance to the nearest other one."""
    run(medax, "triangulate", str(mesh), "-o", str(folder / "cells.vtu"))
    run(medax, "poles", str(mesh), "--normals", str(folder / "samples.xyz"))
    lines = (folder / "samples.xyz").read_text().split("\n")
    points = [tuple(map(float, line.split()[:3])) for line in lines if line and line[0] not in "#"]
    cells = {}
    box = [max(p[k] for p in points) - min(p[k] for p in points) for k in range(3)]
    step = max(box) / 60
    for p in points:
        cells.setdefault(tuple(int(x // step) for x in p), []).append(p)
    def nearest(p):
        at = [int(x // step) for x in p]
        around = [(at[0] + i, at[1] + j, at[2] + k) for i in (-1, 0, 1) for j in (-1, 0, 1) for k in (-1, 0, 1)]
        return min((math.dist(p, q) for key in around for q in cells.get(key, []) if q != p), default=step)
    near = sorted(nearest(p) for p in points)
    return points, near[len(near) // 2]


def chord_errors(medax, folder, place):
    """Crusts and meshes against a smooth surface through the same vertices."""
    print("\nA mesh is no nearer to the surface than its chords. Crust and mesh against a smooth surface through all the samples: a torus, known")
    print("exactly (here in 1.3 million triangles), with samples as far apart for its tube as those of 3holes, stirred by half a step;")
    print("and what interpolating subdivision makes of a mesh (the modified butterfly of Zorin, Schröder, Sweldens 1996, three steps). Both ways are")
    print("alike; this is the first:\n")
    row("samples of", "number", "crust to mesh, max", "mean", "crust to smooth, max", "mean", "mesh to smooth, max", "mean")
    row("---", *["--:"] * 7)
    cases = [("torus", smooth.torus(76, 34, 0.5), smooth.torus(1216, 544, 0))]
    for name, before in [("3holes.off", 0), ("3holes.off", 1), ("rocker-arm.obj", 0)]:
        mesh = smooth.read_mesh(folder / name)
        for _ in range(before):
            mesh = smooth.butterfly(*mesh)
        limit = mesh
        for _ in range(3):
            limit = smooth.butterfly(*limit)
        cases.append((name + ", quartered" * before, mesh, limit))
    for name, mesh, limit in cases:
        smooth.write_mesh(place / "mesh.off", *mesh)
        smooth.write_mesh(place / "limit.off", *limit)
        run(medax, "crust", str(place / "mesh.off"), "-o", str(place / "crust.ply"))
        pairs = [("crust.ply", "mesh.off"), ("crust.ply", "limit.off"), ("mesh.off", "limit.off")]
        row(name, len(mesh[0]), *(cell for a, b in pairs for cell in distances(medax, place / a, place / b)[:2]))
    print("\nIn the mean the crusts of the torus and of 3holes are nearer to the smooth surface than the meshes are, so that their distance to the mesh is mostly")
    print("the mesh's own; it falls by four where triangles are quartered. The triangles of rocker-arm are uneven, and its mesh is the nearer one. In the maximum")
    print("only the crust of 3holes is nearer. The polygons of crusts are planar but for rounding: how they are cut into triangles changes nothing.")


def scans(medax, folder, place):
    """Labels of scans by the paper's rule, by the default, and with the scanner's place."""
    print("\nScans, which are no samples of a closed surface. Conflict: how much the labels of poles contradict each other (algorithms/crust.md), by")
    print("the paper's rule (`--labels spread`), by default, and with the scanner's place (`--viewpoint 0 0 0`). All surfaces are closed.\n")
    row("scan", "samples", "skipped", "conflict, spread", "form", "conflict", "form", "conflict, viewpoint", "form", "s")
    row("---", *["--:"] * 9)
    for name, at_origin in SCANS:
        cells = []
        for options in (["--labels", "spread"], [], ["--viewpoint", "0", "0", "0"] if at_origin else None):
            if options is None:
                cells += ["", ""]
                continue
            report, topology, seconds = reconstruct(medax, folder / name, place / "crust.ply", ["--skip-invalid", *options])
            cells += [f"{report['labels']['conflict']:.4f}", form(topology)]
            last = f"{seconds:.2f}"
        row(name, report["input"]["points"], report["input"]["skipped"], *cells, last)


def main():
    medax, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    version = subprocess.run([medax, "--version"], capture_output=True, text=True).stdout.strip()
    print("# Results\n")
    print(f"Power crusts of the vertices of models, with the defaults but for what is named. `make results` makes this page; {version}, {platform.machine()}.")
    print("Form: components, genus. Distances: from the crust to the mesh and back, in percent of the diagonal. Seconds are of the")
    print("processor; memory is the peak of the whole program. How both grow with the number of samples: [scaling.md](scaling.md).\n")
    row("model", "samples", "form", "known", "closed", "faces", "max", "mean", "max back", "mean back", "s", "MB", "why")
    row(*["---"] + ["--:"] * 3 + ["---"] + ["--:"] * 7 + ["---"])
    with tempfile.TemporaryDirectory() as temporary:
        place = pathlib.Path(temporary)
        for name, known, why in MODELS:
            file, *options = name.split(" ")
            report, topology, seconds = reconstruct(medax, folder / file, place / "crust.ply", options)
            cells = distances(medax, place / "crust.ply", folder / file)
            row(name, report["input"]["points"], form(topology), f"{known[0]}, {known[1]}", topology["closed"],
                report["counts"]["faces"], *cells, f"{seconds:.2f}", round(report["peak_memory_bytes"] / 1e6), why)
        for name, known in POINTS:
            report, topology, seconds = reconstruct(medax, folder / name, place / "crust.ply", [])
            row(name, report["input"]["points"], form(topology), f"{known[0]}, {known[1]}", topology["closed"], report["counts"]["faces"],
                "", "", "", "", f"{seconds:.2f}", round(report["peak_memory_bytes"] / 1e6),
                "a stray point; samples 0.69 apart on a tube of radius 1" if name == "knot.pts" else "")
        scans(medax, folder, place)
        chord_errors(medax, folder, place)
        print("\nWith shards (`--keep-shards`) and without:\n")
        row("model", "faces with", "without", "vertices with", "without")
        row("---", "--:", "--:", "--:", "--:")
        for name, _, _ in MODELS[:6]:
            counts = [reconstruct(medax, folder / name, place / "crust.ply", options)[0]["counts"] for options in (["--keep-shards"], [])]
            row(name, counts[0]["faces"], counts[1]["faces"], counts[0]["vertices"], counts[1]["vertices"])
        print("\nWith Gaussian noise, its standard deviation given in median distances to the nearest sample, and `--noise`:\n")
        row("model", "noise", "form", "form without `--noise`", "known", "lambda", "max", "mean", "max back", "mean back")
        row("---", *["--:"] * 9)
        for name, known in NOISY:
            points, spacing = points_of(medax, folder / name, place)
            for level in (0.25, 0.5, 1):
                numbers = random.Random(1)
                moved = [[x + level * spacing * numbers.gauss(0, 1) for x in p] for p in points]
                noisy = place / "noisy.xyz"
                noisy.write_text("".join(f"{x!r} {y!r} {z!r}\n" for x, y, z in moved))
                _, without, _ = reconstruct(medax, noisy, place / "crust.ply", [])
                report, topology, _ = reconstruct(medax, noisy, place / "crust.ply", ["--noise"])
                row(name, level, form(topology), form(without), f"{known[0]}, {known[1]}", report["parameters"]["lambda"],
                    *distances(medax, place / "crust.ply", folder / name))


main()
