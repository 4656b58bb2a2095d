"""Axes in VTU, PLY and .ma, read by VTK and by readers written from the formats' descriptions: attributes are there, and radii are the distances to the nearest samples.

usage: attributes.py MEDAX"""

import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import pyvista
import vtk

# Point and cell arrays, as docs/hosts/paraview.md names them; then files that the command reads.
TABLE = [
    (["medial", "points.ply", "-o"], {"radius", "cell"}, {"facet", "samples", "condition", "object_angle", "lambda", "side"}),
    (["crust", "points.ply", "--shape"], {"radius", "pole", "label", "object_angle"}, {"flatness"}),
    (["crust", "points.ply", "--poles"], {"radius", "object_angle", "label"}, set()),
    (["crust", "points.ply", "--sizes", "-o"], {"cell", "sample", "feature_size", "thickness"}, {"inner_pole", "outer_pole"}),
    (["flow", "points.ply", "-o"], {"radius", "cell", "critical"}, {"samples", "samples_", "facet", "lambda"}),
    (["field", "mesh.ply", "--object-degrees", 40, "--density", 0.2, "-o"], {"radius", "object_angle", "feet", "pieces", "sites"}, {"radius", "object_angle", "feet", "pieces", "sites"}),
    (["pair", "points.ply", "-o"], {"t", "sample"}, {"kind", "volume"}),
    (["cocone", "points.ply", "-o"], {"sample"}, {"inner_cell", "outer_cell"}),
]
PLY_TYPES = {"double": "<f8", "float": "<f4", "uint": "<u4", "int": "<i4", "uchar": "u1", "char": "i1", "ushort": "<u2", "short": "<i2"}

failures = 0


def demand(holds, text):
    global failures
    if not holds:
        failures += 1
        print(f"WRONG: {text}")


def ply_vertices(path):
    """The vertices of a PLY, which come first: a table of all their properties."""
    content = path.read_bytes()
    end = content.index(b"end_header\n") + len(b"end_header\n")
    lines = content[:end].decode("ascii").splitlines()
    demand(lines[0] == "ply", f"{path.name} begins with {lines[0]}")
    element = next(i for i, line in enumerate(lines) if line.startswith("element "))
    _, name, count = lines[element].split()
    demand(name == "vertex", f"{path.name}: vertices are not first")
    fields = []
    for line in lines[element + 1 :]:
        if not line.startswith("property "):
            break
        _, kind, name = line.split()
        fields.append((name, PLY_TYPES[kind]))
    kind = lines[1].split()[1]
    if kind == "binary_little_endian":
        return np.frombuffer(content, dtype=fields, count=int(count), offset=end)
    demand(kind == "ascii", f"{path.name} is {kind}")
    rows = content[end:].decode("ascii").splitlines()[: int(count)]
    return np.array([tuple(row.split()) for row in rows], dtype=fields)


def medial_mesh(path):
    """A .ma as docs/formats.md describes it: the counts, then `v x y z radius`, `e i j`, `f i j k`, from 0."""
    words = [line.split() for line in path.read_text().splitlines() if line.strip()]
    vertices, edges, faces = map(int, words[0])
    rest = words[1:]
    demand(len(rest) == vertices + edges + faces, f"{path.name}: {len(rest)} lines for {words[0]}")
    demand([row[0] for row in rest] == ["v"] * vertices + ["e"] * edges + ["f"] * faces, f"{path.name}: the order of lines")
    table = np.array([row[1:5] for row in rest[:vertices]], dtype=float)
    sides = np.array([row[1:3] for row in rest[vertices : vertices + edges]], dtype=int).reshape(-1, 2)
    triangles = np.array([row[1:4] for row in rest[vertices + edges :]], dtype=int).reshape(-1, 3)
    for name, indices in [("edges", sides), ("faces", triangles)]:
        demand(indices.size == 0 or (indices.min() >= 0 and indices.max() < vertices), f"{path.name}: {name} of no vertex")
    return table, sides, triangles


def radii_right(name, places, radii, samples):
    """Whether the radii are the distances to the nearest samples."""
    distances = np.concatenate([np.sqrt(((part[:, None] - samples[None]) ** 2).sum(axis=2).min(axis=1)) for part in np.array_split(places, len(places) // 500 + 1)])
    off = np.abs(radii - distances) / distances
    demand(len(radii) > 0 and off.max() <= 1e-6, f"{name}: radii are off by {off.max():.2g}")
    print(f"{name}: {len(radii)} radii, at most {off.max():.1e} off")


def main():
    program = pathlib.Path(sys.argv[1]).resolve()
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)

        def medax(*arguments):
            done = subprocess.run([program, *map(str, arguments), "--json", "--quiet"], capture_output=True, text=True, cwd=folder)
            report = json.loads(done.stdout)
            if done.returncode != 0:
                sys.exit(f"{' '.join(map(str, arguments))}: {report['error']['message']}")
            return report

        medax("sample", "genus3", "--spacing", 0.15, "-o", "points.ply")
        medax("cocone", "points.ply", "-o", "mesh.ply")
        table = ply_vertices(folder / "points.ply")
        samples = np.column_stack([table["x"], table["y"], table["z"]])

        for command, of_points, of_cells in TABLE:
            medax(*command, "result.vtu")
            grid = pyvista.read(folder / "result.vtu")
            found = set(grid.point_data), set(grid.cell_data)
            demand(found == (of_points, of_cells), f"{' '.join(map(str, command))}: arrays {found}")
            shown = next((name for name in ("radius", "thickness", "t") if name in of_points), None)
            reader = vtk.vtkXMLUnstructuredGridReader()
            reader.SetFileName(str(folder / "result.vtu"))
            reader.Update()
            scalars = reader.GetOutput().GetPointData().GetScalars()
            demand((scalars.GetName() if scalars else None) == shown, f"{' '.join(map(str, command))}: not coloured by {shown}")

        axes = {"medial": ["medial"], "core": ["flow"], "extended core": ["flow", "--extend", "medial"]}
        for name, command in axes.items():
            for file in ("axis.vtu", "axis.ply", "axis.ma"):
                report = medax(command[0], "points.ply", *command[1:], "-o", file)
            medax(command[0], "points.ply", *command[1:], "-o", "text.ply", "--text")
            output = next(its for its in report["outputs"] if its["path"] is not None)
            grid = pyvista.read(folder / "axis.vtu")
            places, radii = np.asarray(grid.points), np.asarray(grid.point_data["radius"])
            demand(grid.n_points == output["vertices"], f"{name}: {grid.n_points} points in VTU")
            demand(grid.n_cells == output["faces"] + output["edges"], f"{name}: {grid.n_cells} cells in VTU")
            radii_right(f"{name}, VTU", places, radii, samples)

            for file in ("axis.ply", "text.ply"):
                vertices = ply_vertices(folder / file)
                demand("radius" in vertices.dtype.names and "quality" in vertices.dtype.names, f"{name}, {file}: properties {vertices.dtype.names}")
                demand(np.array_equal(vertices["radius"], vertices["quality"]), f"{name}, {file}: radius is not quality")
                demand(np.array_equal(vertices["radius"], radii), f"{name}, {file}: radii are not those of VTU")
                demand(np.array_equal(np.column_stack([vertices[axis] for axis in "xyz"]), places), f"{name}, {file}: places are not those of VTU")
                radii_right(f"{name}, {file}", places, vertices["radius"], samples)
                surface = pyvista.read(folder / file)
                demand((surface.n_points, surface.GetNumberOfPolys()) == (output["vertices"], output["faces"]), f"{name}, {file}: {surface.n_points} points, {surface.GetNumberOfPolys()} faces")

            balls, edges, triangles = medial_mesh(folder / "axis.ma")
            demand(np.array_equal(balls[:, :3], places) and np.array_equal(balls[:, 3], radii), f"{name}, .ma: balls are not those of VTU")
            radii_right(f"{name}, .ma", balls[:, :3], balls[:, 3], samples)
            pairs = {tuple(sorted(edge)) for edge in edges.tolist()}
            demand(len(pairs) == len(edges), f"{name}, .ma: an edge is there twice")
            sides = {tuple(sorted((row[i], row[(i + 1) % 3]))) for row in triangles.tolist() for i in range(3)}
            demand(sides <= pairs, f"{name}, .ma: sides of triangles that are no edges")
            loose = edges[: output["edges"]].tolist()
            demand(not {tuple(sorted(edge)) for edge in loose} & sides, f"{name}, .ma: loose edges are not first")
            demand(len(pairs) == len(sides) + output["edges"], f"{name}, .ma: {len(pairs)} edges, {len(sides)} sides, {output['edges']} loose")
    sys.exit(1 if failures else 0)


main()
