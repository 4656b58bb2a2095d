"""What `medax pair` writes, as VTK reads it: the cells of the solid, and the surfaces between its inner structure and its boundary.

usage: pair.py MEDAX DATA

MEDAX is the program, DATA the folder with real models, which are left out where it is not there."""

import json
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import pyvista
import vtk
from vtk.util.numpy_support import vtk_to_numpy

# The genus of the boundary.
SHAPES = [("ellipsoid", 0), ("torus", 1)]
# vtkCellValidator's FacesAreOrientedIncorrectly, which its Python side does not name.
ORIENTED_INCORRECTLY = 0x20
MODELS = [("3holes.off", 3)]


def medax(program, *arguments):
    done = subprocess.run([program, *map(str, arguments), "--json", "--quiet"], capture_output=True, text=True)
    report = json.loads(done.stdout)
    if done.returncode != 0:
        sys.exit(f"{' '.join(map(str, arguments))}: {report['error']['message']}")
    return report


def determinants(a, b, c):
    """Of rows."""
    return np.einsum("ij,ij->i", a, np.cross(b, c))


def enclosed(points, triangles):
    """The volume that triangles enclose."""
    corners = points[triangles] - points[triangles[0, 0]]
    return determinants(*corners.transpose(1, 0, 2)).sum() / 6


def volumes(solid):
    """Of tetrahedra and pyramids by their corners, of polyhedra by their faces, each a fan of triangles that point out. VTK's own volumes of thin polyhedra are wrong."""
    points = np.asarray(solid.points)
    cells, offsets, kinds = solid.cell_connectivity, vtk_to_numpy(solid.GetCells().GetOffsetsArray()), solid.celltypes
    found = np.full(solid.n_cells, np.nan)
    for kind, tetrahedra in [(vtk.VTK_TETRA, [(0, 1, 2, 3)]), (vtk.VTK_PYRAMID, [(0, 1, 2, 4), (0, 2, 3, 4)])]:
        which = np.flatnonzero(kinds == kind)
        found[which] = 0
        for corners in tetrahedra:
            a, b, c, d = (points[cells[offsets[which] + k]] for k in corners)
            found[which] += determinants(b - a, c - a, d - a) / 6
    stream = vtk.vtkIdList()
    for cell in np.flatnonzero(kinds == vtk.VTK_POLYHEDRON):
        solid.GetFaceStream(int(cell), stream)
        numbers = [stream.GetId(i) for i in range(stream.GetNumberOfIds())]
        count, numbers, triangles = numbers[0], numbers[1:], []
        for _ in range(count):
            face, numbers = numbers[1 : numbers[0] + 1], numbers[numbers[0] + 1 :]
            triangles += [(face[0], p, q) for p, q in zip(face[1:], face[2:])]
        found[cell] = enclosed(points, np.array(triangles))
    return found


def turned(solid):
    """The number of cells of which VTK says that faces point the wrong way."""
    validator = vtk.vtkCellValidator()
    validator.SetInputData(solid)
    validator.Update()
    states = vtk_to_numpy(validator.GetOutput().GetCellData().GetArray("ValidityState"))
    return np.count_nonzero(states & ORIENTED_INCORRECTLY)


def topology(surface):
    """The numbers of open and of non-manifold edges, the genus, and the number of pieces."""

    def edges(**kinds):
        return surface.extract_feature_edges(**{"boundary_edges": False, "non_manifold_edges": False, "feature_edges": False, "manifold_edges": False, **kinds}).n_cells

    euler = surface.n_points - surface.extract_all_edges().n_lines + surface.n_cells
    pieces = len(np.unique(surface.connectivity()["RegionId"]))
    return edges(boundary_edges=True), edges(non_manifold_edges=True), 1 - euler / 2, pieces


def check(program, name, path, genus, folder, inner):
    """What is wrong with the pair-mesh of an inner structure."""
    wrong = []

    def demand(holds, text):
        if not holds:
            wrong.append(text)

    report = medax(program, "pair", path, "--inner", inner, "-o", folder / "solid.vtu", "--iso", "1", "--iso-out", folder / "boundary.vtu")
    solid, boundary = pyvista.read(folder / "solid.vtu"), pyvista.read(folder / "boundary.vtu")
    counts, pair = report["counts"], report["pair"]
    demand((solid.n_cells, solid.n_points) == (counts["cells"], counts["vertices"]), "the counts of the solid")
    demand(solid.n_points == pair["boundary_vertices"] + pair["inner_vertices"], "the vertices of the solid")
    wrongly = turned(solid)
    demand(wrongly == 0, f"{wrongly} cells have faces that point the wrong way")
    kinds = solid.cell_data["kind"]
    demand([np.count_nonzero(kinds == kind) for kind in (1, 2, 3)] == [pair["face_vertex"], pair["edge_edge"], pair["vertex_face"]], "the kinds of cells")
    t = solid.point_data["t"]
    demand(np.count_nonzero(t == 1) == pair["boundary_vertices"] and np.count_nonzero(t == 0) == pair["inner_vertices"], "t is not 0 or 1")
    inside, all_cells = enclosed(boundary.points, boundary.cell_connectivity.reshape(-1, 3)), volumes(solid)
    demand(abs(all_cells.sum() - inside) <= 1e-9 * inside and abs(pair["volume"] - inside) <= 1e-9 * inside, f"volumes {all_cells.sum()} {pair['volume']} {inside}")
    demand(all_cells.min() >= -1e-12 * inside, f"a cell is turned inside out: {all_cells.min()}")
    demand(np.abs(all_cells - solid.cell_data["volume"]).max() <= 1e-12 * inside, "the attribute volume")
    contour = solid.contour([0.5], scalars="t")
    found = topology(contour)
    demand(found == (0, 0, genus, 1), f"the contour: {found}")

    report = medax(program, "pair", path, "--inner", inner, "--iso", "0.001,0.5", "--iso-out", folder / "iso.ply")
    for out in [folder / "iso-0.001.ply", folder / "iso-0.5.ply"]:
        its = next(its for its in report["outputs"] if its["path"] == str(out))
        surface = pyvista.read(out)
        demand((surface.n_cells, surface.n_points) == (its["faces"], its["vertices"]), f"the counts of {out.name}")
        demand(topology(surface) == (0, 0, genus, 1), f"{out.name}: {topology(surface)}")
    report = medax(program, "pair", path, "--inner", inner, "--iso", "0.5", "--iso-out", folder / "iso.obj")
    again = pyvista.read(folder / "iso.obj")
    demand((again.n_cells, again.n_points) == (surface.n_cells, surface.n_points), "the counts of iso.obj")
    demand(topology(again) == (0, 0, genus, 1), f"iso.obj: {topology(again)}")
    demand(np.abs(again.points - surface.points).max() <= 1e-6 * surface.length, "the points of iso.obj")
    print(f"{name}, {inner}: {solid.n_cells} cells, {solid.n_points} points, volume {inside}; contour of {contour.n_cells} faces, genus {found[2]:g}{''.join('   WRONG: ' + text for text in wrong)}", flush=True)
    return wrong


def main():
    program, data = sys.argv[1], pathlib.Path(sys.argv[2])
    failures = 0
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        cases = []
        for shape, genus in SHAPES:
            path = folder / f"{shape}.ply"
            medax(program, "sample", shape, "-o", path)
            cases.append((shape, path, genus))
        if data.is_dir():
            cases += [(name, data / name, genus) for name, genus in MODELS]
        else:
            print(f"skipped: real models, since {data} is not there")
        for name, path, genus in cases:
            for inner in ["voronoi", "medial"]:
                failures += len(check(program, name, path, genus, folder, inner))
    sys.exit(1 if failures else 0)


main()
