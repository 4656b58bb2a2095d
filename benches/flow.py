#!/usr/bin/env python3
"""Cores of real models and of smooth shapes: docs/flow.md. The structure of Giesen, Ramos, Sadri 2010, *Medial axis approximation and unstable flow complex*.

usage: flow.py MEDAX DATA FOLDER

MEDAX is the program, DATA the folder with the models, FOLDER where flow.md goes. Seconds are those of the processor, medians of up to three runs with one thread; peaks are of the library's own arrays."""

import datetime
import json
import pathlib
import platform
import statistics
import subprocess
import sys
import tempfile

# The Betti numbers of the solids.
MODELS = [
    ("3holes.off", [1, 3, 0]),
    ("rocker-arm.obj", [1, 1, 0]),
    ("refined_elephant.off", [1, 3, 0]),
    ("cavity_and_ring.off", [2, 1, 1]),
    ("kitten.xyz", [1, 1, 0]),
    ("hotdogs.pts", [2, 0, 0]),
    ("mannequin.off", [1, 0, 0]),
    ("foot.off", [1, 0, 0]),
    ("igea.ply", [1, 0, 0]),
    ("ant.off", [1, 0, 0]),
    ("fandisk.off", [1, 0, 0]),
    ("abc_plate_00000329.obj", [1, 3, 0]),
]
SHAPES = [("ellipsoid", [1, 0, 0]), ("capsule", [1, 0, 0]), ("torus", [1, 1, 0]), ("genus3", [1, 3, 0]), ("trefoil", [1, 1, 0])]
GROWTH = [10_000, 30_000, 100_000, 300_000, 1_000_000]
GROWING = ["ellipsoid", "trefoil"]
# The whole complex of a tube has 100 faces and more for each sample.
MOST = {"core": 1_000_000, "extended": 1_000_000, "whole": 30_000}


def run(medax, command, path, *options):
    done = subprocess.run([medax, command, path, "--json", "--quiet", *map(str, options)], capture_output=True, text=True)
    report = json.loads(done.stdout)
    return report if done.returncode == 0 else None


def betti(report):
    return None if report is None else report["outputs"][0]["topology"]["betti"]


def show(found, solid):
    if found is None:
        return "-"
    text = ", ".join(map(str, found))
    return text if found == solid else f"**{text}**"


def seconds(report, name):
    return sum(stage["cpu_seconds"] for stage in report["stages"] if stage["name"] == name)


def models(medax, data, add):
    add("## Betti numbers\n")
    add("Labels are those of Tight Cocone; numbers over Z/2, those that are wrong in bold. *MEDIAL* is the axis that `medax medial` writes; *plain core* the union of the unstable manifolds of the inner critical")
    add("points (`--plain`), *core* the repaired one; *extended* the core with the flow of MEDIAL's facets. *Taken*, and left out: facets that the theorem cannot take, since their flow comes to a critical point of the surface or of")
    add("the other side (*leaving*), or since they cross the surface (*crossing*). *Gap* is between the slopes of the critical points of the surface and those of the medial axis: there is one if the")
    add("sample is dense enough (theorem 2.1). The five models whose plain core is wrong are those with the narrowest gaps, none wider than 0.0011.\n")
    add("| model | solid | MEDIAL | plain core | core | extended, plain | extended | faces and hairs of the core | taken | leaving | crossing | gap |")
    add("| --- | --- | --- | --- | --- | --- | --- | --: | --: | --: | --: | --: |")
    for name, solid in MODELS:
        path = data / name
        axis = betti(run(medax, "medial", path))
        plain, core, wide = (betti(run(medax, "flow", path, *options)) for options in (["--plain"], [], ["--plain", "--extend", "medial"]))
        report = run(medax, "flow", path)
        counts = report["counts"]
        extended = run(medax, "flow", path, "--extend", "medial")
        found = extended["flow"]["core"]
        out, gap = found["excluded"], extended["flow"]["gap"]
        add(f"| {path.stem} | {show(solid, solid)} | {show(axis, solid)} | {show(plain, solid)} | {show(core, solid)} | {show(wide, solid)} | {show(betti(extended), solid)} | {counts['faces']:,}, {counts['edges']:,} | "
            f"{found['taken']:,} | {out['leaving']:,} | {out['of_surface']:,} | {gap[0]:.4f} to {gap[1]:.4f} |")
    add("")


def coarsest(medax, folder, add):
    add("## The coarsest samples\n")
    add("Smooth shapes, sampled evenly and at random, the largest spacing, in units of the shape's least feature size, at which what is written has the right Betti numbers, as it has at every finer one that was tried (each 0.9 times the")
    add("one before, three samples of each, from a tenth of the feature size on; 1.39 is the coarsest tried). Labels are those of Tight Cocone.\n")
    kinds = [("MEDIAL", "medial", []), ("plain core", "flow", ["--plain"]), ("core", "flow", []), ("extended, plain", "flow", ["--plain", "--extend", "medial"]), ("extended", "flow", ["--extend", "medial"])]
    add("| shape | " + " | ".join(kind for kind, _, _ in kinds) + " |")
    add("| --- |" + " --: |" * len(kinds))
    for shape, solid in SHAPES:
        # By default the spacing is a quarter of the least feature size.
        size = 4 * run(medax, "sample", shape)["parameters"]["spacing"]
        right = {kind: None for kind, _, _ in kinds}
        wrong = set()
        share = 0.1
        while share < 1.5 and len(wrong) < len(kinds):
            paths = []
            for seed in range(3):
                path = folder / f"{shape}{seed}.ply"
                run(medax, "sample", shape, "--spacing", share * size, "--seed", seed, "-o", path)
                paths.append(path)
            for kind, command, options in kinds:
                if kind not in wrong:
                    if all(betti(run(medax, command, path, *options)) == solid for path in paths):
                        right[kind] = share
                    else:
                        wrong.add(kind)
            share /= 0.9
        add(f"| {shape} | " + " | ".join("-" if right[kind] is None else f"{right[kind]:.2f}" for kind, _, _ in kinds) + " |")
    add("")


def cell(x, form):
    return "-" if x is None else form.format(x)


def growth(medax, folder, add):
    add("## Cost\n")
    add("Samples of two shapes, one thread. Processor seconds of the triangulation with its dual; of the flow (drivers, critical points) with the core, with the core extended by MEDIAL's facets, and with the whole flow complex; and")
    add("the largest amount of memory that the library's own arrays took at once.\n")
    add("| shape | samples | triangulation, dual | flow and core | flow, extended core | flow, whole complex | core by triangulation | core, bytes a sample | extended, bytes a sample | whole, bytes a sample | whole, faces a sample |")
    add("| --- | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: |")
    ends = {shape: [] for shape in GROWING}
    for shape in GROWING:
        for count in GROWTH:
            path = folder / "growth.ply"
            spacing = run(medax, "sample", shape, "-o", path)["parameters"]["spacing"]
            points = run(medax, "info", path)["counts"]["vertices"]
            run(medax, "sample", shape, "--spacing", spacing * (points / count) ** 0.5, "-o", path)
            rounds = {"core": [], "extended": [], "whole": []}
            for _ in range(3 if count < 100_000 else 1):
                for kind, options in [("core", []), ("extended", ["--extend", "medial"]), ("whole", ["--complex"])]:
                    if count <= MOST[kind]:
                        rounds[kind].append(run(medax, "flow", path, "--threads", 1, *options))
            reports = {kind: list(filter(None, reports)) for kind, reports in rounds.items()}
            middle = lambda kind, name: statistics.median(seconds(report, name) for report in reports[kind]) if reports[kind] else None
            base = middle("core", "triangulate") + middle("core", "dual")
            core, extended, whole = middle("core", "flow"), middle("extended", "flow"), middle("whole", "flow")
            samples = reports["core"][0]["input"]["points"]
            peaks = [reports[kind][0]["peak_memory_bytes"] / samples if reports[kind] else None for kind in ("core", "extended", "whole")]
            faces = reports["whole"][0]["counts"]["faces"] / samples if reports["whole"] else None
            cells = [shape, f"{samples:,}", *(cell(x, "{:.2f}") for x in (base, core, extended, whole)), f"{core / base:.2f}", *(cell(x, "{:,.0f}") for x in (*peaks, faces))]
            add("| " + " | ".join(cells) + " |")
            ends[shape].append((samples, base, core, extended))
    add("\nFrom the first row of a shape to its last:\n")
    for shape, rows in ends.items():
        times = [last / first for first, last in zip(rows[0], rows[-1])]
        add(f"- {shape}: the samples grow {times[0]:.0f} times, the seconds of triangulation and dual {times[1]:.0f} times, those of flow and core {times[2]:.0f} times, those of flow and extended core {times[3]:.0f} times.")
    add("\nThe tube's triangulation grows faster than its samples: the denser they are, the more of them are cospherical but for rounding, and the more is decided exactly. The")
    add("whole complex grows faster on both: on a smooth sheet the orbit of every Voronoi vertex crosses as many facets as lie between it and a critical point, about the root of their number. Cores need none of these cuts.\n")


def main():
    medax, data, target = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    page = []
    add = page.append
    add("# Cores\n")
    add("Axes with the topology of the solid, from the flow of the distance to the samples (Giesen, Ramos, Sadri 2010; [docs/algorithms/flow.md](algorithms/flow.md)), beside those of MEDIAL. `make flow` makes this page;")
    add(f"this one was made on {datetime.date.today()}, {platform.machine()}, {platform.system()}.\n")
    add("![Cores, axes of MEDIAL, and cores extended by these](cores.png)\n")
    add("Cores of 3holes, refined_elephant and rocker-arm, loose edges in red; the axes of MEDIAL; the cores extended by these.\n")
    models(medax, data, add)
    with tempfile.TemporaryDirectory() as folder:
        coarsest(medax, pathlib.Path(folder), add)
        growth(medax, pathlib.Path(folder), add)
    (target / "flow.md").write_text("\n".join(page).rstrip() + "\n")


main()
