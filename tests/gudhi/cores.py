"""Betti numbers of cores and extended cores: those that `medax flow` reports against those that GUDHI finds in the complex that it writes, and both against the solid's.

usage: cores.py MEDAX DATA [--all]

MEDAX is the program, DATA the folder with real models, which are left out where it is not there. What the hairs are for: some solid's Betti numbers must be wrong without them."""

import json
import pathlib
import subprocess
import sys
import tempfile

import gudhi
import numpy as np

SHAPES = [("ellipsoid", [1, 0, 0]), ("capsule", [1, 0, 0]), ("torus", [1, 1, 0]), ("genus3", [1, 3, 0]), ("trefoil", [1, 1, 0])]
# The solid's Betti numbers, and whether its extended core, which has millions of faces otherwise, is small enough for a test that is run often; `--all` takes them all.
MODELS = [
    ("3holes.off", [1, 3, 0], True),
    ("rocker-arm.obj", [1, 1, 0], True),
    ("refined_elephant.off", [1, 3, 0], False),
    ("cavity_and_ring.off", [2, 1, 1], False),
    ("kitten.xyz", [1, 1, 0], True),
    ("hotdogs.pts", [2, 0, 0], True),
    ("mannequin.off", [1, 0, 0], True),
    ("foot.off", [1, 0, 0], True),
    ("igea.ply", [1, 0, 0], False),
]


def medax(program, *arguments):
    done = subprocess.run([program, *map(str, arguments), "--json", "--quiet"], capture_output=True, text=True)
    report = json.loads(done.stdout)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, arguments))}: {report['error']['message']}")
    return report


def read(path):
    """The first coordinates of the vertices of an OBJ file, its faces as the vertices of all in turn and the number of each, and its loose edges."""
    vertices, corners, sizes, edges = [], [], [], []
    with open(path) as lines:
        for line in lines:
            if line.startswith("v "):
                vertices.append(float(line.split(None, 2)[1]))
            elif line.startswith("f "):
                face = [int(word) - 1 for word in line.split()[1:]]
                corners += face
                sizes.append(len(face))
            elif line.startswith("l "):
                chain = [int(word) - 1 for word in line.split()[1:]]
                edges.extend(zip(chain, chain[1:]))
    return np.array(vertices), np.array(corners, np.int32), np.array(sizes, np.int32), np.array(edges, np.int32).reshape(-1, 2)


def betti(vertices, corners, sizes, edges):
    """By persistent homology over Z/2, where every face is a fan from a vertex of its own. The complex grows along the first axis: what GUDHI has to reduce then stays small."""
    tree = gudhi.SimplexTree()
    tree.insert_batch(np.arange(len(vertices), dtype=np.int32)[None, :], vertices)
    if len(edges):
        tree.insert_batch(edges.T.copy(), vertices[edges].max(axis=1))
    if len(sizes):
        begins = np.cumsum(sizes) - sizes
        apexes = np.repeat(np.arange(len(vertices), len(vertices) + len(sizes), dtype=np.int32), sizes)
        following = np.arange(1, len(corners) + 1)
        following[begins + sizes - 1] = begins
        triangles = np.stack([corners, corners[following], apexes])
        face_at = np.maximum.reduceat(vertices[corners], begins)
        sides = triangles[:2]
        tree.insert_batch(sides, vertices[sides].max(axis=0))
        tree.insert_batch(triangles, np.repeat(face_at, sizes))
    tree.compute_persistence(homology_coeff_field=2, persistence_dim_max=True)
    return (tree.betti_numbers() + [0, 0, 0])[:3]


def without_hairs(vertices, corners, sizes, _):
    """The faces alone."""
    used, corners = np.unique(corners, return_inverse=True)
    return vertices[used], corners.astype(np.int32), sizes, np.zeros((0, 2), np.int32)


def check(program, name, path, solid, extended, folder):
    """The number of failures, and whether the plain core without its hairs has the wrong Betti numbers."""
    failures, broken = 0, False
    for kind, options in [("core", []), ("plain core", ["--plain"]), ("extended core", ["--extend", "medial"])]:
        if kind == "extended core" and not extended:
            continue
        out = folder / "core.obj"
        report = medax(program, "flow", path, *options, "-o", out)
        ours = report["outputs"][0]["topology"]["betti"]
        cells = read(out)
        theirs = betti(*cells)
        demanded = kind != "plain core"
        right = ours == theirs and (ours == solid or not demanded)
        failures += not right
        print(f"{name} {kind}: solid {solid}, medax {ours}, gudhi {theirs}{'' if right else '   WRONG'}", flush=True)
        if kind == "core" and theirs == solid:
            bare = betti(*without_hairs(*cells))
            broken = bare != solid
            print(f"{name} core without hairs: {bare}", flush=True)
    return failures, broken


def main():
    program, data, is_all = sys.argv[1], pathlib.Path(sys.argv[2]), "--all" in sys.argv[3:]
    failures, broken = 0, []
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        cases = []
        for shape, solid in SHAPES:
            path = folder / f"{shape}.ply"
            medax(program, "sample", shape, "-o", path)
            cases.append((shape, path, solid, True))
        if data.is_dir():
            cases += [(name, data / name, solid, extended or is_all) for name, solid, extended in MODELS]
        else:
            print(f"skipped: real models, since {data} is not there")
        for name, path, solid, extended in cases:
            wrong, bare = check(program, name, path, solid, extended, folder)
            failures += wrong
            broken += [name] if bare else []
    print(f"without hairs wrong: {', '.join(broken)}")
    if not broken:
        sys.exit("no core is wrong without its hairs")
    sys.exit(1 if failures else 0)


main()
