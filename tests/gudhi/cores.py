"""Betti numbers of cores and extended cores: those that `medax flow` reports against those that GUDHI finds in the complex that it writes, and both against the solid's.

usage: cores.py MEDAX DATA

MEDAX is the program, DATA the folder with real models, which are left out where it is not there. What the hairs are for: some solid's Betti numbers must be wrong without them."""

import json
import pathlib
import subprocess
import sys
import tempfile

import gudhi

SHAPES = [("ellipsoid", [1, 0, 0]), ("capsule", [1, 0, 0]), ("torus", [1, 1, 0]), ("genus3", [1, 3, 0]), ("trefoil", [1, 1, 0])]
# The solid's Betti numbers, and whether its extended core, which has millions of faces otherwise, is small enough for a test.
MODELS = [
    ("3holes.off", [1, 3, 0], True),
    ("rocker-arm.obj", [1, 1, 0], False),
    ("refined_elephant.off", [1, 3, 0], False),
    ("cavity_and_ring.off", [2, 1, 1], False),
    ("kitten.xyz", [1, 1, 0], True),
    ("hotdogs.pts", [2, 0, 0], True),
    ("mannequin.off", [1, 0, 0], False),
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
    """The first coordinates of the vertices of an OBJ file, its faces, and its loose edges."""
    vertices, faces, edges = [], [], []
    for line in path.read_text().splitlines():
        words = line.split()
        if words[:1] == ["v"]:
            vertices.append(float(words[1]))
        elif words[:1] == ["f"]:
            faces.append([int(word.split("/")[0]) - 1 for word in words[1:]])
        elif words[:1] == ["l"]:
            chain = [int(word) - 1 for word in words[1:]]
            edges.extend(zip(chain, chain[1:]))
    return vertices, faces, edges


def betti(vertices, faces, edges):
    """By persistent homology over Z/2, where every face is a fan from a vertex of its own. The complex grows along the first axis: what GUDHI has to reduce then stays small."""
    tree = gudhi.SimplexTree()
    for vertex, at in enumerate(vertices):
        tree.insert([vertex], at)
    for p, q in edges:
        tree.insert([p, q], max(vertices[p], vertices[q]))
    for apex, face in enumerate(faces, len(vertices)):
        at = max(vertices[v] for v in face)
        for p, q in zip(face, face[1:] + face[:1]):
            tree.insert([p, q], max(vertices[p], vertices[q]))
            tree.insert([p, q, apex], at)
    tree.compute_persistence(homology_coeff_field=2, persistence_dim_max=True)
    return (tree.betti_numbers() + [0, 0, 0])[:3]


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
            vertices, faces, _ = cells
            used = sorted({v for face in faces for v in face})
            number = {v: i for i, v in enumerate(used)}
            places = [cells[0][v] for v in used]
            bare = betti(places, [[number[v] for v in face] for face in faces], [])
            broken = bare != solid
            print(f"{name} core without hairs: {bare}", flush=True)
    return failures, broken


def main():
    program, data = sys.argv[1], pathlib.Path(sys.argv[2])
    failures, broken = 0, []
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        cases = []
        for shape, solid in SHAPES:
            path = folder / f"{shape}.ply"
            medax(program, "sample", shape, "-o", path)
            cases.append((shape, path, solid, True))
        if data.is_dir():
            cases += [(name, data / name, solid, extended) for name, solid, extended in MODELS]
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
