# SPDX-License-Identifier: MIT OR Apache-2.0
"""medax.meshlab with the real PyMeshLab."""

import importlib.util
import pathlib
import re
import threading
import time

import numpy as np
import pytest

import medax

if importlib.util.find_spec("pymeshlab") is None:
    pytest.skip("PyMeshLab is not installed", allow_module_level=True)

import pymeshlab  # noqa: E402

from medax import meshlab  # noqa: E402

TORUS = medax.describe("torus")
MANUAL = pathlib.Path(__file__).resolve().parents[3] / "docs" / "hosts" / "pymeshlab.md"


def set_of(vertices, faces=None, name="input"):
    meshes = pymeshlab.MeshSet()
    parts = () if faces is None else (np.asarray(faces, np.int32),)
    meshes.add_mesh(pymeshlab.Mesh(np.array(vertices, np.float64), *parts), name)
    return meshes


@pytest.fixture(scope="module")
def samples():
    return np.array(medax.Samples.of("torus", spacing=0.12).coords)


@pytest.fixture
def torus(samples):
    return set_of(samples)


@pytest.fixture(scope="module")
def box_mesh():
    """A box of 4 by 3 by 1, whose sides are divided into triangles."""
    meshes = pymeshlab.MeshSet()
    meshes.create_cube(size=1.0)
    meshes.meshing_surface_subdivision_midpoint(iterations=4, threshold=pymeshlab.PercentageValue(0))
    mesh = meshes.current_mesh()
    return mesh.vertex_matrix() * [4, 3, 1], mesh.face_matrix()


def measures(meshes, which):
    meshes.set_current_mesh(which)
    return meshes.get_topological_measures()


def nearest(points, samples):
    return np.array([np.sqrt(((samples - p) ** 2).sum(axis=1).min()) for p in points])


def is_closed(found, genus):
    return (
        found["is_mesh_two_manifold"]
        and found["boundary_edges"] == 0
        and found["connected_components_number"] == 1
        and found["genus"] == genus
        and found["unreferenced_vertices"] == 0
    )


def labels(meshes):
    return [mesh.label() for mesh in meshes]


# ---- What is made ----


def test_the_surface_of_a_torus_has_its_genus(torus, samples):
    ids = meshlab.surface(torus)
    assert ids == [1] and torus.current_mesh_id() == 1
    assert labels(torus) == ["input", "Power Crust"]
    assert is_closed(measures(torus, 1), TORUS.genus)
    volume = torus.get_geometric_measures()["mesh_volume"]
    assert volume == pytest.approx(2 * np.pi**2 * 0.4**2, rel=0.05)
    assert np.array_equal(torus.mesh(0).vertex_matrix(), samples)


def test_a_surface_with_its_shape(torus):
    ids = meshlab.surface(torus, shape=True, label_rule="spread")
    assert labels(torus)[1:3] == ["Power Crust", "Power Shape"]
    shape = torus.mesh(ids[1])
    radius = shape.vertex_scalar_array()
    assert len(radius) and radius.max() < 0.5
    assert np.array_equal(shape.vertex_custom_scalar_attribute_array("radius"), radius)


def test_a_surface_is_opened_where_it_closes_a_hole():
    torus = np.array(medax.Samples.of("torus").coords)
    meshes = set_of(torus[torus[:, 2] < 0.3 * torus[:, 2].max()])
    (closed,) = meshlab.surface(meshes)
    meshes.set_current_mesh(0)
    (open,) = meshlab.surface(meshes, open=True)
    assert is_closed(measures(meshes, closed), 1)
    assert measures(meshes, open)["boundary_edges"] > 0
    assert meshes.mesh(open).face_number() < meshes.mesh(closed).face_number()


def test_the_scalar_of_an_axis_is_the_distance_to_the_samples(torus, samples):
    (which,) = meshlab.axis(torus)
    axis = torus.mesh(which)
    assert axis.label() == "Medial Axis" and axis.face_number() > 0
    radius = axis.vertex_scalar_array()
    assert np.allclose(radius, nearest(axis.vertex_matrix(), samples), rtol=1e-9)
    assert np.array_equal(axis.vertex_custom_scalar_attribute_array("radius"), radius)
    angles = [axis.face_custom_scalar_attribute_array(f"object_angle_{k}") for k in (0, 1)]
    assert len(angles[0]) == axis.face_number()
    assert (angles[0] <= angles[1]).all() and angles[1].max() <= np.pi
    assert (axis.face_custom_scalar_attribute_array("side") == medax.Side.INNER).all()


def test_what_an_axis_has_is_what_the_package_gives(torus, samples):
    dual = medax.Dual.of(medax.Triangulation.delaunay(medax.Points(samples)), facets=True)
    medial = medax.Medial.of(dual, medax.Labels.of(medax.Cocone.of(dual)))
    for filter in ({}, {"theta": 0.8, "rho": 12}, {"object_angle": 2.0, "rule": "angle"}):
        torus.set_current_mesh(0)
        (which,) = meshlab.axis(torus, **filter)
        expected = medial.axis(**filter)
        assert torus.mesh(which).face_number() == len(expected.triangles)
        assert np.array_equal(torus.mesh(which).vertex_scalar_array(), expected.values("radius"))


def test_an_outer_axis_is_clipped_to_the_grown_box(torus, samples):
    (which,) = meshlab.axis(torus, side="outer", inside="crust")
    low, high = samples.min(axis=0), samples.max(axis=0)
    grown = 0.1 * np.linalg.norm(high - low) + 1e-12
    vertices = torus.mesh(which).vertex_matrix()
    assert (vertices >= low - grown).all() and (vertices <= high + grown).all()
    assert (vertices.max(axis=0) > high).any()
    torus.set_current_mesh(0)
    (which,) = meshlab.axis(torus, side="both", clip=(low, high))
    vertices = torus.mesh(which).vertex_matrix()
    assert (vertices >= low - 1e-9).all() and (vertices <= high + 1e-9).all()


def test_faces_tell_inside_from_outside(box_mesh):
    vertices, faces = box_mesh
    counts = []
    for turned in (faces, faces[:, ::-1]):
        meshes = set_of(vertices, turned)
        try:
            (which,) = meshlab.axis(meshes, inside="mesh")
            middle = meshes.mesh(which).vertex_matrix()
            assert (np.abs(middle) <= np.array([2, 1.5, 0.5]) + 1e-9).all()
            counts.append(meshes.mesh(which).face_number())
        except medax.MedaxError:
            counts.append(0)
    # Faces that point inward leave nothing inside.
    assert counts[0] > 0 and counts[1] == 0


def test_the_core_of_a_torus_is_a_ring(torus, samples):
    (which,) = meshlab.core(torus)
    ring = torus.mesh(which)
    assert ring.label() == "Core" and ring.face_number() == 0
    # As many edges as vertices in one piece: one ring, and trees on it.
    assert ring.edge_number() == ring.vertex_number()
    core = medax.Complex(ring.vertex_matrix(), edges=ring.edge_matrix())
    assert core.topology().betti == (1, 1, 0)
    assert np.allclose(ring.vertex_scalar_array(), nearest(ring.vertex_matrix(), samples), rtol=1e-9)


def test_a_core_is_extended_by_facets(torus):
    faces = []
    for extend in (None, False, {"theta": 0.8}, True):
        torus.set_current_mesh(0)
        faces.append(torus.mesh(meshlab.core(torus, extend=extend)[0]).face_number())
    assert faces[0] == faces[1] == 0 < faces[2] < faces[3]
    for wrong in (0.8, {"thetta": 0.8}):
        with pytest.raises(TypeError, match="thett?a"):
            meshlab.core(torus, extend=wrong)


def test_edges_and_points_beside_faces_are_layers_of_their_own():
    parts = medax.Complex(
        [[0, 0, 0], [1, 0, 0], [0, 1, 0], [5, 5, 5], [2, 0, 0]],
        [[0, 1, 2]],
        [[1, 4]],
        attributes={"vertex": {"radius": [1.0, 2, 3, 4, 5]}, "face": {"lambda": [7.0]}},
    )
    meshes = pymeshlab.MeshSet()
    ids = meshlab._add(meshes, [meshlab._Layers("Core", parts)])
    assert ids == [0, 1, 2] and meshes.current_mesh_id() == 0
    assert labels(meshes) == ["Core", "Core (edges)", "Core (points)"]
    faces, edges, points = meshes
    assert (faces.vertex_number(), faces.face_number(), faces.edge_number()) == (3, 1, 0)
    assert faces.face_custom_scalar_attribute_array("lambda").tolist() == [7]
    assert edges.vertex_scalar_array().tolist() == [2, 5] and edges.edge_matrix().tolist() == [[0, 1]]
    assert points.vertex_matrix().tolist() == [[5, 5, 5]] and points.vertex_scalar_array().tolist() == [4]
    assert points.vertex_custom_scalar_attribute_array("radius").tolist() == [4]


@pytest.mark.parametrize("by_faces", [True, False])
def test_the_thickness_of_a_box(box_mesh, by_faces):
    vertices, faces = box_mesh
    if not by_faces:
        vertices = np.array(medax.Samples.of(medax.Complex(vertices, faces), spacing=0.08).coords)
        faces = None
    meshes = set_of(vertices, faces)
    (which,) = meshlab.thickness(meshes)
    layer = meshes.mesh(which)
    assert labels(meshes) == ["input", "Thickness"] and meshes.current_mesh_id() == which
    assert np.array_equal(layer.vertex_matrix(), vertices)
    if by_faces:
        assert np.array_equal(layer.face_matrix(), faces)
    thickness = layer.vertex_scalar_array()
    # On the two large sides, away from edges, a ball reaches from one side to the other.
    x, y, z = np.abs(vertices).T
    middle = (np.abs(z - 0.5) < 1e-6) & (x < 1.3) & (y < 0.8)
    assert middle.sum() > 20
    assert np.allclose(thickness[middle], 1, atol=0.05)
    assert np.array_equal(layer.vertex_custom_scalar_attribute_array("thickness"), thickness)
    size = layer.vertex_custom_scalar_attribute_array("feature_size")
    assert np.allclose(size[middle], 0.5, atol=0.05)
    assert meshes.get_scalar_statistics_per_vertex()["max"] < 1.5


def test_the_feature_size_of_a_torus(torus):
    (which,) = meshlab.thickness(torus, size="feature_size", omit="side")
    assert torus.mesh(which).label() == "Feature Size"
    assert np.median(torus.mesh(which).vertex_scalar_array()) == pytest.approx(0.4, rel=0.02)


@pytest.mark.parametrize("onto", ["axis", "core", "voronoi"])
def test_iso_surfaces_are_closed_and_grow(torus, onto):
    ids = meshlab.iso_surface(torus, [0.25, 0.5, 1], onto=onto)
    assert labels(torus)[1:] == ["Iso-surface 25%", "Iso-surface 50%", "Iso-surface 100%"]
    volumes = []
    for which in ids:
        assert is_closed(measures(torus, which), TORUS.genus)
        volumes.append(torus.get_geometric_measures()["mesh_volume"])
    assert 0 < volumes[0] < volumes[1] < volumes[2] < 2 * np.pi**2 * 0.4**2


def test_one_iso_surface(torus):
    assert meshlab.iso_surface(torus, theta=0.6) == [1]
    assert torus.mesh(1).label() == "Iso-surface 50%"


# ---- What is taken ----


def test_the_matrix_of_a_layer_is_applied(torus, samples):
    torus.compute_matrix_from_translation(axisx=5.0, freeze=False)
    torus.compute_matrix_from_scaling_or_normalization(axisx=2.0, freeze=False)
    taken = torus.mesh(0)
    assert not np.array_equal(taken.transform_matrix(), np.eye(4))
    moved = taken.transformed_vertex_matrix()
    for make in (meshlab.surface, meshlab.axis, meshlab.thickness):
        torus.set_current_mesh(0)
        (which,) = make(torus)
        assert np.array_equal(torus.mesh(which).transform_matrix(), np.eye(4))
        if make is meshlab.axis:
            vertices = torus.mesh(which).vertex_matrix()
            assert np.allclose(torus.mesh(which).vertex_scalar_array(), nearest(vertices, moved), rtol=1e-9)
        else:
            box = torus.mesh(which).bounding_box()
            assert np.allclose(box.center(), (moved.min(axis=0) + moved.max(axis=0)) / 2, atol=0.1)
    assert np.array_equal(taken.vertex_matrix(), samples)
    assert not np.array_equal(taken.transform_matrix(), np.eye(4))


def test_faces_of_a_mirrored_layer_still_point_outward(box_mesh):
    meshes = set_of(*box_mesh)
    mirror = np.diag([-1.0, 1, 1, 1])
    meshes.set_matrix(transformmatrix=mirror, freeze=False)
    (which,) = meshlab.thickness(meshes)
    values = meshes.mesh(which).vertex_scalar_array()
    assert np.nanmax(values) == pytest.approx(1, abs=0.05)
    assert meshes.get_geometric_measures()["mesh_volume"] == pytest.approx(12)


def test_the_current_mesh_is_taken_and_others_are_left(samples):
    meshes = set_of(samples, name="torus")
    meshes.add_mesh(pymeshlab.Mesh(np.array(medax.Samples.of("sphere").coords)), "sphere")
    meshes.set_current_mesh(0)
    assert is_closed(measures(meshes, meshlab.surface(meshes)[0]), 1)
    meshes.set_current_mesh(1)
    assert is_closed(measures(meshes, meshlab.surface(meshes)[0]), 0)
    # MeshLab gives no name twice.
    assert labels(meshes) == ["torus", "sphere", "Power Crust", "Power Crust(1)"]


# ---- What is wrong ----

FUNCTIONS = [meshlab.surface, meshlab.axis, meshlab.core, meshlab.thickness, meshlab.iso_surface]


@pytest.mark.parametrize("make", FUNCTIONS)
def test_nothing_comes_of_nothing(make):
    with pytest.raises(medax.MedaxError, match="no current mesh"):
        make(pymeshlab.MeshSet())
    meshes = set_of(np.eye(3))
    meshes.set_selection_all()
    meshes.meshing_remove_selected_vertices()
    assert meshes.current_mesh().vertex_number() == 0
    with pytest.raises(medax.MedaxError, match="'input', has no vertices") as caught:
        make(meshes)
    assert caught.value.status == medax.Status.TOO_FEW_POINTS
    assert meshes.mesh_number() == 1


@pytest.mark.parametrize("make", FUNCTIONS)
def test_what_is_no_sample_is_an_error(make, samples):
    flat = set_of(samples * [1, 1, 0])
    with pytest.raises(medax.MedaxError):
        make(flat)
    holed = samples.copy()
    holed[17, 1] = np.nan
    broken = set_of(holed)
    with pytest.raises(medax.MedaxError) as caught:
        make(broken)
    assert (caught.value.status, caught.value.index) == (medax.Status.NON_FINITE, 17)
    assert flat.mesh_number() == broken.mesh_number() == 1


@pytest.mark.parametrize("make", FUNCTIONS)
def test_what_is_no_option_is_an_error(make, torus):
    with pytest.raises(TypeError, match="thetta"):
        make(torus, thetta=1)
    with pytest.raises(TypeError, match="MeshSet"):
        make(torus.current_mesh())
    with pytest.raises(TypeError, match="progress"):
        make(torus, progress=print, job=medax.Job())
    assert torus.mesh_number() == 1


@pytest.mark.parametrize(
    ("make", "options"),
    [
        (meshlab.axis, {"inside": "nothing"}),
        (meshlab.axis, {"inside": "mesh"}),
        (meshlab.axis, {"theta": 2.0}),
        (meshlab.axis, {"side": "left"}),
        (meshlab.axis, {"theta": 1.57, "rho": 1e9}),
        (meshlab.core, {"inside": "mesh"}),
        (meshlab.thickness, {"size": "weight"}),
        (meshlab.thickness, {"faces": True}),
        (meshlab.thickness, {"spacing": 0.1}),
        (meshlab.iso_surface, {"t": 2.0}),
        (meshlab.iso_surface, {"onto": "moon"}),
        (meshlab.iso_surface, {"onto": "core", "theta": 0.4}),
        (meshlab.iso_surface, {"side": "outer"}),
        (meshlab.surface, {"omit": "noise"}),
    ],
)
def test_what_cannot_be_asked_for_is_an_error(make, options, torus):
    with pytest.raises(medax.MedaxError):
        make(torus, **options)
    assert torus.mesh_number() == 1


# ---- Progress and cancel ----


@pytest.mark.parametrize("make", FUNCTIONS)
def test_progress_rises_once_from_0_to_1(make, torus):
    told = []
    make(torus, progress=lambda fraction, stage: told.append((fraction, stage)))
    fractions = [fraction for fraction, _ in told]
    assert fractions == sorted(fractions) and fractions[0] < 0.2
    assert fractions[-1] == 1 and fractions.count(1) == 1
    assert len({stage for _, stage in told}) > 1


@pytest.mark.parametrize("make", FUNCTIONS)
def test_false_cancels_and_adds_nothing(make, torus):
    with pytest.raises(medax.MedaxError) as caught:
        make(torus, progress=lambda fraction, _: fraction < 0.3)
    assert caught.value.status == medax.Status.CANCELLED
    assert torus.mesh_number() == 1 and torus.current_mesh_id() == 0


def test_what_progress_raises_comes_out(torus):
    def progress(fraction, stage):
        raise LookupError(stage)

    with pytest.raises(LookupError):
        meshlab.core(torus, progress=progress)
    assert torus.mesh_number() == 1


def test_a_job_is_used_and_can_be_cancelled(torus):
    job = medax.Job(threads=1)
    meshlab.core(torus, job=job)
    assert {"triangulate", "flow"} <= {time.stage for time in job.times()}
    torus.set_current_mesh(0)
    job.cancel()
    with pytest.raises(medax.MedaxError) as caught:
        meshlab.axis(torus, job=job)
    assert caught.value.status == medax.Status.CANCELLED


def test_another_thread_cancels():
    meshes = set_of(np.random.default_rng(0).random((200_000, 3)))
    job = medax.Job()

    def cancel():
        while job.stage != "triangulate":
            time.sleep(0.001)
        job.cancel()

    thread = threading.Thread(target=cancel)
    thread.start()
    with pytest.raises(medax.MedaxError) as caught:
        meshlab.axis(meshes, job=job)
    thread.join()
    assert caught.value.status == medax.Status.CANCELLED and meshes.mesh_number() == 1


# ---- The manual ----


def test_the_manual_says_what_works(samples, box_mesh, tmp_path, monkeypatch, capsys):
    monkeypatch.chdir(tmp_path)
    medax.Points(samples).write("scan.ply")
    medax.Complex(*box_mesh).write("part.stl")
    blocks = re.findall(r"```python\n(.*?)```", MANUAL.read_text(), re.DOTALL)
    assert len(blocks) >= 8
    names = {}
    for block in blocks:
        exec(compile(block, str(MANUAL), "exec"), names)
    assert pathlib.Path("surface.ply").stat().st_size > 1000
    assert capsys.readouterr().out.split("\n")[0] == str(TORUS.genus)
    assert names["radius"].max() < 0.5
    assert names["thinnest"] > 0


@pytest.mark.parametrize("options", ({}, {"shape": True}, {"open": True}))
def test_a_surface_of_eight_corners_is_an_error(options):
    meshes = pymeshlab.MeshSet()
    meshes.create_cube()
    with pytest.raises(medax.ArgumentError, match="the surface is empty: the sample is too sparse"):
        meshlab.surface(meshes, **options)
    assert meshes.mesh_number() == 1


def test_the_thickness_of_faces_that_point_inward_is_an_error(box_mesh):
    vertices, faces = box_mesh
    meshes = set_of(vertices, faces[:, ::-1])
    with pytest.raises(medax.ArgumentError, match="every thickness is 0: do faces point inward?"):
        meshlab.thickness(meshes)
    assert meshes.mesh_number() == 1


def test_the_options_are_explained():
    for make in (meshlab.surface, meshlab.axis, meshlab.core, meshlab.thickness, meshlab.iso_surface):
        assert "- `threads`: " in make.__doc__
    assert "- `theta`: " in meshlab.axis.__doc__ and "- `deep`: " in meshlab.surface.__doc__
