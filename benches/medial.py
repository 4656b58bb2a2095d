#!/usr/bin/env python3
"""Axes by MEDIAL of real models: docs/medial.md. Table 1 and Figures 5 and 7 of Dey, Zhao 2004, *Approximating the medial axis from the
Voronoi diagram with a convergence guarantee*.

usage: medial.py MEDAX DATA FOLDER

MEDAX is the program, DATA the folder with the models, FOLDER where medial.md goes. Seconds are of the processor, with one thread, medians of five runs, each stage
with its own triangulation in the same run."""

import datetime
import json
import pathlib
import platform
import statistics
import subprocess
import sys

# The model, its file, and the paper's points, Delaunay seconds and filter seconds (Table 1).
TABLE = [
    ("3HOLE", "3holes.off", 4000, 2.37, 0.82),
    ("KNOT", "knot.pts", 10001, 8.36, 2.66),
    ("MANNEQUIN", "mannequin.off", 12773, 7.79, 2.28),
    ("FANDISK", "fandisk.off", 16475, 13.4, 3.0),
    ("FOOT", "foot.off", 20021, 13.24, 3.71),
    ("ROCKER", "rocker-arm.obj", 40177, 74.54, 8.25),
]
SWEPT = ["3holes.off", "foot.off", "knot.pts", "rocker-arm.obj"]
THETAS = [10, 15, 22.5, 30, 45]
RHOS = [4, 6, 8, 12, 16]


def run(medax, path, *options):
    done = subprocess.run([medax, "medial", path, "--json", "--quiet", *options], capture_output=True, text=True)
    report = json.loads(done.stdout)
    if done.returncode != 0:
        raise SystemExit(f"{path}: {report['error']['message']}")
    return report


def seconds(report, stages):
    return sum(stage["cpu_seconds"] for stage in report["stages"] if stage["name"] in stages)


def table1(medax, data):
    for name, file, points, delaunay, filtering in TABLE:
        reports = [run(medax, data / file, "--side", "both", "--threads", "1") for _ in range(5)]
        ours = statistics.median(seconds(r, {"order", "triangulate"}) for r in reports)
        dual = statistics.median(seconds(r, {"dual"}) for r in reports)
        medial = statistics.median(seconds(r, {"medial"}) for r in reports)
        first = reports[0]
        yield [
            name, points, f"{delaunay:.2f}", f"{filtering:.2f}", f"{filtering / delaunay:.2f}",
            first["input"]["points"], f"{1e3 * ours:.1f}", f"{1e3 * dual:.1f}", f"{1e3 * medial:.1f}",
            f"{medial / ours:.2f}", f"{medial / (ours + dual):.2f}",
        ]


def form(report):
    topology = report["outputs"][0]["topology"]
    return f"{report['medial']['selected']} ({', '.join(map(str, topology['betti']))})"


def sweep(medax, data):
    for file in SWEPT:
        angles = [form(run(medax, data / file, "--rule", "angle", "--theta-degrees", str(theta))) for theta in THETAS]
        ratios = [form(run(medax, data / file, "--rule", "ratio", "--rho", str(rho))) for rho in RHOS]
        yield file, angles, ratios, form(run(medax, data / file))


def rows(head, body, align):
    lines = [head, align, *body]
    return "\n".join("| " + " | ".join(map(str, line)) + " |" for line in lines) + "\n"


def main():
    medax, data, folder = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    version = run(medax, data / SWEPT[0])["medax"]
    day = f"{datetime.date.today():%-d %B %Y}"
    head = ["", "points", "Delaunay, s", "filter, s", "ratio", "points", "Delaunay, ms", "dual, ms", "filter, ms", "to Delaunay", "to both"]
    text = f"""# MEDIAL on real models

`make medial` makes this page; medax {version}, one thread, {platform.machine()}, {platform.system()}, {day}. How it works: `algorithms/medial.md`.

![Inner axes of 3holes, fandisk, foot, mannequin, refined_elephant and rocker-arm](axes.png)

Inner axes with the default thresholds, theta = 22.5 degrees and rho = 8, as `medax medial` writes them.

## Seconds (Table 1)

The paper's numbers (933 MHz, CGAL 2.3), then ours, of the models that we have; the samplings differ. Delaunay is with putting the points in order; the dual is the
Voronoi diagram with all its facets; the filter is umbrellas and both conditions for every facet.

"""
    text += rows(head, table1(medax, data), ["---"] + ["--:"] * 10)
    swept = list(sweep(medax, data))
    text += """
The ratio to our triangulation is larger than the paper's to theirs because the triangulation is the faster by more.

## One condition alone (Figures 5 and 7)

Facets of the inner axis, and their Betti numbers: components, holes, voids. Small thresholds give spikes, large ones holes, and none does for all models; both
conditions together have one pair of thresholds for all.

"""
    text += rows(["theta alone"] + [f"{theta} degrees" for theta in THETAS] + ["both conditions"],
                 [[file, *angles, both] for file, angles, _, both in swept], ["---"] + ["--:"] * 6)
    text += "\n"
    text += rows(["rho alone"] + [str(rho) for rho in RHOS] + ["both conditions"],
                 [[file, *ratios, both] for file, _, ratios, both in swept], ["---"] + ["--:"] * 6)
    (folder / "medial.md").write_text(text)


if __name__ == "__main__":
    main()
