#!/usr/bin/env python3
"""Axes of meshes and figures by sampling the distance's gradient, and the unions of their balls: docs/field.md. Stolpner, Whitesides 2009, *Medial axis approximation with bounded error*.

usage: field.py MEDAX DATA FOLDER

MEDAX is the program, DATA the folder with the models, FOLDER where field.md goes. Seconds are those of the processor, of one run."""

import datetime
import json
import pathlib
import platform
import subprocess
import sys
import tempfile

MODELS = ["fandisk.off", "rocker-arm.obj", "foot.off", "abc_plate_00000329.obj", "refined_elephant.off"]
# Least object angle of the axes that are compared with others, in degrees.
ANGLE = 60
FIGURES = [("letters.geojson", name) for name in ("B", "g", "i", "S", "O", "&", "8", "Y")] + [("countries.geojson", name) for name in ("Norway", "South Africa", "Italy", "Croatia")]


def run(medax, command, *arguments):
    done = subprocess.run([medax, command, *map(str, arguments), "--json", "--quiet"], capture_output=True, text=True)
    if done.returncode != 0:
        sys.exit(f"medax {command} {' '.join(map(str, arguments))}: {done.stderr}")
    return json.loads(done.stdout)


def seconds(report):
    return sum(stage["cpu_seconds"] for stage in report["stages"])


def betti(report):
    return ", ".join(map(str, report["outputs"][-1]["topology"]["betti"]))


def shares(report):
    """Distances from A to B and from B to A, in hundredths of the diagonal."""
    found = report["distances"]
    share = lambda way, name: f"{100 * found[way][name] / found['diagonal']:.2g}"
    return [share(way, name) for way in ("a_to_b", "b_to_a") for name in ("max", "mean")]


def unions(medax, data, folder, add):
    add("## Unions of balls\n")
    add("Points of the inner axis a hundredth of the model's diagonal apart, without thresholds, and the boundary of the union of their balls (`medax field --points`, `medax union`), compared with the mesh. Distances in hundredths of the diagonal.\n")
    add("| model | balls | triangles | union to mesh, max | mean | mesh to union, max | mean | axis, s | union, s |")
    add("| --- | --: | --: | --: | --: | --: | --: | --: | --: |")
    for name in MODELS:
        path, axis, union = data / name, folder / "axis.ply", folder / "union.ply"
        field = run(medax, "field", path, "--points", "-o", axis)
        made = run(medax, "union", axis, "-o", union)
        cells = [path.stem, f"{field['counts']['vertices']:,}", f"{made['counts']['faces']:,}", *shares(run(medax, "compare", union, path)), f"{seconds(field):.1f}", f"{seconds(made):.1f}"]
        add("| " + " | ".join(cells) + " |")
    add("")


def axes(medax, data, folder, add):
    add("## Beside other axes\n")
    add(f"The axis as a surface (`medax field`, object angles of {ANGLE} degrees and more, a hundredth of the diagonal dense), beside those of the mesh's vertices by MEDIAL and by the power crust. Betti numbers, and distances in hundredths of the diagonal. MEDIAL and the power crust")
    add("see vertices alone, field the faces; where the axis has small object angles, at convex edges above all, each cuts it off elsewhere.\n")
    add("| model | field: faces, edges | Betti | MEDIAL: Betti | field to MEDIAL, max | mean | MEDIAL to field, max | mean | crust: Betti | field to crust, max | mean | crust to field, max | mean |")
    add("| --- | --: | --- | --- | --: | --: | --: | --: | --- | --: | --: | --: | --: |")
    for name in MODELS:
        path, axis, other = data / name, folder / "axis.ply", folder / "other.ply"
        field = run(medax, "field", path, "--object-degrees", ANGLE, "-o", axis)
        cells = [path.stem, f"{field['counts']['faces']:,}, {field['counts']['edges']:,}", betti(field)]
        for options in (["medial", path, "-o", other], ["crust", path, "--shape", other]):
            report = run(medax, *options)
            cells += [betti(report), *shares(run(medax, "compare", axis, other))]
        add("| " + " | ".join(cells) + " |")
    add("")


def halving(medax, data, folder, add):
    add("## The cost of halving the density\n")
    add("Points, and seconds: in space points are as many as the density's inverse square, in the plane as its inverse; circles grow faster than that, since they go nearer to the boundary, up to a quarter of the density. *Kept* are the circles or spheres that the result knows of: in the plane all, in space those with a point.\n")
    add("| input | density, of the diagonal | points | kept | seconds | times the one before |")
    add("| --- | --: | --: | --: | --: | --: |")
    for name, options, shares in [("fandisk.off", [], [0.04, 0.02, 0.01, 0.005]), ("letters.geojson", ["--feature", "B"], [0.02, 0.01, 0.005, 0.0025])]:
        last = None
        for share in shares:
            size = run(medax, "field", data / name, *options, "--points")["parameters"]["density"] * 100 if last is None else size
            report = run(medax, "field", data / name, *options, "--points", "--density", share * size)
            now = seconds(report)
            ratio = "" if last is None else f"{now / last:.1f}"
            add(f"| {pathlib.Path(name).stem} {' '.join(options[1:])} | {share} | {report['counts']['vertices']:,} | {report['field']['covers']:,} | {now:.2f} | {ratio} |")
            last = now
    add("")


def figures(medax, data, add):
    add("## Plane figures\n")
    add("The graph of the inner axis, and its points with what theorem 10 claims of them: what may be missed has no larger object angle, but in the circles without a claim.\n")
    add("| figure | Betti numbers | edges | graph, s | points | missed, degrees | circles | without a claim | points, s |")
    add("| --- | --- | --: | --: | --: | --: | --: | --: | --: |")
    for file, name in FIGURES:
        graph = run(medax, "field", data / file, "--feature", name)
        points = run(medax, "field", data / file, "--feature", name, "--points")
        claim = points["claim"]
        cells = [name, betti(graph), f"{graph['counts']['edges']:,}", f"{seconds(graph):.2f}", f"{points['counts']['vertices']:,}", f"{claim['missed_degrees']:.2f}", f"{claim['circles']:,}", f"{claim['circles_without_claim']}", f"{seconds(points):.2f}"]
        add("| " + " | ".join(cells) + " |")
    add("")


def main():
    medax, data, target = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    page = []
    add = page.append
    add("# Axes by the gradient of the distance\n")
    add("Axes of meshes and plane figures (Stolpner, Whitesides 2009; [docs/algorithms/distance.md](algorithms/distance.md)). `make field` makes this page;")
    add(f"this one was made on {datetime.date.today()}, {platform.machine()}, {platform.system()}.\n")
    add("![Models, their axes, and the unions of the axes' balls](field.png)\n")
    add("Models; points of their axes, the darker the smaller their balls; the boundary of the union of these balls.\n")
    with tempfile.TemporaryDirectory() as folder:
        unions(medax, data, pathlib.Path(folder), add)
        axes(medax, data, pathlib.Path(folder), add)
        halving(medax, data, pathlib.Path(folder), add)
    figures(medax, data, add)
    (target / "field.md").write_text("\n".join(page).rstrip() + "\n")


main()
