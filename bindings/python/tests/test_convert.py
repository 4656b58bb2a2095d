# SPDX-License-Identifier: MIT OR Apache-2.0
"""There and back with trimesh, meshio and PyVista."""

import math

import numpy as np
import pytest

import medax

pyvista = pytest.importorskip("pyvista")
meshio = pytest.importorskip("meshio")
trimesh = pytest.importorskip("trimesh")


@pytest.fixture(scope="module")
def complexes(torus):
    core = torus.flow.core(torus.medial.selected(theta=1.3, rho=100)).complex
    return {
        "surface": torus.cocone.surface,
        "crust": torus.crust.with_sizes(torus.crust.surface),
        "axis": torus.medial.axis(),
        "core": core,
        "shape": torus.crust.shape(),
        "solid": torus.pair.solid(),
        "poles": torus.crust.poles_complex(),
    }


NAMES = ["surface", "crust", "axis", "core", "shape", "solid", "poles"]


def assert_same(found, expected):
    assert np.array_equal(found.vertices, expected.vertices)
    assert found.faces.to_list() == expected.faces.to_list()
    assert np.array_equal(found.edges, expected.edges)
    assert found.cells.to_list() == expected.cells.to_list()
    assert np.array_equal(found.cell_types, expected.cell_types)
    assert_same_attributes(found, expected)


def assert_same_attributes(found, expected, elements=tuple(medax.Element)):
    wanted = {(a.element, a.name): a.values for a in expected.attributes if a.element in elements}
    for key, values in wanted.items():
        other = found.attribute(*key).values
        if not np.array_equal(other, values, equal_nan=values.dtype.kind == "f"):
            # A last column that is missing throughout is dropped.
            assert (values[:, other.shape[1] :] == medax.NONE).all() and np.array_equal(
                other, values[:, : other.shape[1]]
            )
    assert found.attribute_count == len(wanted)


@pytest.mark.parametrize("name", NAMES)
def test_pyvista_there_and_back(complexes, name):
    given = complexes[name]
    dataset = given.to_pyvista()
    assert dataset.n_points == len(given.vertices)
    if name in ("shape", "solid"):
        assert isinstance(dataset, pyvista.UnstructuredGrid)
        assert dataset.n_cells == len(given.edges) + len(given.faces) + len(given.cells)
    else:
        assert isinstance(dataset, pyvista.PolyData)
    assert_same(medax.Complex.from_pyvista(dataset), given)


def test_pyvista_knows_the_same_measures(complexes):
    surface = complexes["surface"]
    dataset = surface.to_pyvista()
    measure = surface.measure()
    assert dataset.area == pytest.approx(measure.area) and dataset.volume == pytest.approx(measure.volume)
    assert dataset.is_manifold and dataset.n_open_edges == 0
    solid = complexes["solid"]
    volumes = solid.to_pyvista().compute_cell_sizes()["Volume"]
    assert volumes.sum() == pytest.approx(measure.volume, rel=1e-4)
    assert complexes["axis"].to_pyvista()["radius"].max() == complexes["axis"].values("radius").max()


def test_pyvista_draws(complexes, tmp_path):
    """`axis.to_pyvista().plot()`, off screen."""
    picture = tmp_path / "axis.png"
    try:
        complexes["axis"].to_pyvista().plot(scalars="radius", off_screen=True, screenshot=picture, show_edges=True)
    except RuntimeError as error:
        pytest.skip(f"VTK cannot draw here: {error}")
    assert picture.stat().st_size > 2000
    drawn = pyvista.read(picture)
    assert np.ptp(np.asarray(drawn.point_data.active_scalars), axis=0).max() > 50


def test_what_else_pyvista_has():
    line = pyvista.PolyData(np.eye(3), lines=[3, 0, 1, 2])
    line.cell_data["length"] = [2.5]
    made = medax.Complex.from_pyvista(line)
    assert made.edges.tolist() == [[0, 1], [1, 2]] and made.values("length", "edge").tolist() == [2.5, 2.5]
    strip = pyvista.PolyData(np.random.default_rng(0).random((4, 3)), strips=[4, 0, 1, 2, 3])
    assert medax.Complex.from_pyvista(strip).faces.to_list() == [[0, 1, 2], [2, 1, 3]]
    assert len(medax.Complex.from_pyvista(pyvista.PolyData(np.eye(3))).vertices) == 3
    sphere = medax.Complex.from_pyvista(pyvista.Sphere())
    assert sphere.topology().genus == 0 and sphere.vertices.dtype == float
    assert sphere.values("Normals").shape == (len(sphere.vertices), 3)
    wild = pyvista.PolyData(np.eye(3))
    wild["words"] = ["a", "b", "c"]
    with pytest.warns(UserWarning, match="'words' is left out"):
        assert medax.Complex.from_pyvista(wild).attribute_count == 0
    grid = pyvista.ImageData(dimensions=(2, 2, 2))
    with pytest.raises(medax.ArgumentError, match="extract_surface"):
        medax.Complex.from_pyvista(grid)
    with pytest.raises(medax.ArgumentError, match="triangulate"):
        medax.Complex.from_pyvista(grid.cast_to_unstructured_grid())
    made = medax.Complex.from_pyvista(grid.cast_to_unstructured_grid().triangulate())
    assert (made.cell_types == medax.CellType.TETRAHEDRON).all() and made.topology().betti == (1, 0, 0)
    plane = medax.Complex.from_pyvista(pyvista.ImageData(dimensions=(2, 2, 1)).cast_to_unstructured_grid(), dimension=2)
    assert (plane.measure().area, plane.dimension) == (1, 2)


def test_vtu_reads_back(complexes, tmp_path):
    """What medax writes itself, PyVista has as `to_pyvista` makes it."""
    for name in NAMES:
        path = tmp_path / f"{name}.vtu"
        complexes[name].write(path)
        read = pyvista.read(path)
        assert read.n_points == len(complexes[name].vertices)
        made = medax.Complex.from_pyvista(read)
        assert made.faces.to_list() == complexes[name].faces.to_list() and len(made.cells) == len(complexes[name].cells)


@pytest.mark.parametrize("name", NAMES)
def test_meshio_there_and_back(complexes, name):
    given = complexes[name]
    mesh = given.to_meshio()
    found = medax.Complex.from_meshio(mesh)
    assert np.array_equal(found.vertices, given.vertices) and np.array_equal(found.edges, given.edges)
    assert sorted(found.faces.to_list()) == sorted(given.faces.to_list())
    assert sorted(found.cells.to_list()) == sorted(given.cells.to_list())
    assert found.attribute_count == given.attribute_count
    # Faces stand by their number of corners: what they carry goes along.
    for attribute in given.attributes:
        rows = {medax.Element.FACE: "faces", medax.Element.CELL: "cells"}.get(attribute.element)
        if rows and attribute.values.ndim == 1:
            before, after = getattr(given, rows), getattr(found, rows)
            told = dict(zip(map(tuple, before.to_list()), attribute.values.tolist()))
            other = found.attribute(attribute.element, attribute.name).values
            assert all(told[tuple(row)] == value for row, value in zip(after.to_list(), other.tolist()))


def test_meshio_writes_and_reads(complexes, tmp_path):
    path = tmp_path / "surface.vtu"
    complexes["surface"].to_meshio().write(path)
    assert_same(medax.Complex.from_meshio(meshio.read(path)), complexes["surface"])
    # And what medax wrote is read by meshio.
    complexes["surface"].write(path)
    assert_same(medax.Complex.from_meshio(meshio.read(path)), complexes["surface"])


def test_what_else_meshio_has():
    flat = meshio.Mesh([[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]], [("triangle", [[0, 1, 2]])], cell_data={"a": [[5]]})
    made = medax.Complex.from_meshio(flat)
    assert made.dimension == 2 and made.values("a", "face").tolist() == [5]
    with pytest.raises(medax.ArgumentError, match="'hexahedron'"):
        medax.Complex.from_meshio(meshio.Mesh(np.eye(8)[:, :3], [("hexahedron", [list(range(8))])]))


@pytest.mark.parametrize("name", ["surface", "crust", "axis", "core"])
def test_trimesh_there_and_back(complexes, name):
    given = complexes[name]
    mesh = given.to_trimesh()
    assert isinstance(mesh, trimesh.Trimesh) and np.array_equal(mesh.faces, given.triangles)
    made = medax.Complex.from_trimesh(mesh)
    assert np.array_equal(made.vertices, given.vertices) and np.array_equal(made.triangles, given.triangles)
    for attribute in given.attributes:
        if attribute.element == medax.Element.VERTEX:
            assert np.array_equal(made.values(attribute.name), attribute.values)
        elif attribute.element == medax.Element.FACE:
            found = made.values(attribute.name, "face")
            assert np.array_equal(found, attribute.values[given.face_of_triangle])


def test_trimesh_knows_the_same_measures(complexes, cube):
    mesh, measure = complexes["surface"].to_trimesh(), complexes["surface"].measure()
    assert (
        mesh.is_watertight and mesh.volume == pytest.approx(measure.volume) and mesh.area == pytest.approx(measure.area)
    )
    assert mesh.euler_number == 0
    made = medax.Complex.from_trimesh(trimesh.creation.icosphere(3, 2.0))
    assert made.measure().volume == pytest.approx(4 / 3 * math.pi * 8, rel=0.02)
    scene = trimesh.Scene([trimesh.creation.box(), trimesh.creation.icosphere().apply_translation([5, 0, 0])])
    assert medax.Complex.from_trimesh(scene).topology().components == 2


def test_paths_and_clouds_of_trimesh(complexes):
    cloud = complexes["poles"].to_trimesh()
    assert isinstance(cloud, trimesh.PointCloud)
    assert_same(medax.Complex.from_trimesh(cloud), complexes["poles"])
    graph = medax.MedialGraph.of(medax.Sites.of(medax.Figure([[[(0, 0), (2, 0), (2, 1), (0, 1)]]]))).complex()
    path = graph.to_trimesh()
    made = medax.Complex.from_trimesh(path)
    assert np.array_equal(made.edges, graph.edges) and np.array_equal(made.vertices, graph.vertices)
    with pytest.raises(medax.ArgumentError, match="no mesh"):
        medax.Complex.from_trimesh("mesh")


def test_a_scan_from_trimesh_to_pyvista():
    """From one package to the other."""
    mesh = trimesh.creation.torus(1.0, 0.4, major_sections=48, minor_sections=24)
    points = medax.Points(mesh.vertices)
    crust = medax.PowerCrust.of(points)
    assert crust.surface.to_pyvista().volume == pytest.approx(mesh.volume, rel=0.05)


def test_a_package_that_is_not_there(monkeypatch, cube):
    monkeypatch.setitem(__import__("sys").modules, "pyvista", None)
    with pytest.raises(ImportError, match=r"pip install 'medax\[pyvista\]'"):
        cube.to_pyvista()
