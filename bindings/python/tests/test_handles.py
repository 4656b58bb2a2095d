# SPDX-License-Identifier: MIT OR Apache-2.0
"""Every class, and what it answers, against what is known of tori, boxes and balls."""

import math

import numpy as np
import pytest

import medax
from medax import NONE


def sums_to(array, value, tolerance):
    assert abs(float(np.sum(array)) - value) < tolerance, (float(np.sum(array)), value)


def test_points():
    xyz = np.array([[0, 0, 0], [1, 2, 3], [0, 0, 0], [4, 5, 6]], float)
    points = medax.Points(xyz)
    assert (points.count, len(points), points.row_count, points.duplicate_count, points.skipped_count) == (
        3,
        3,
        4,
        1,
        0,
    )
    assert points.duplicate_of.tolist() == [NONE, NONE, 0, NONE]
    assert np.array_equal(points.coords[points.vertex_of_row], xyz)
    assert np.array_equal(xyz[points.row_of_vertex], points.coords)
    assert points.bounds.tolist() == [[0, 0, 0], [4, 5, 6]]
    with pytest.raises(ValueError, match="read-only"):
        points.bounds[0] = 7
    assert repr(points) == "<medax.Points: 3 points, 1 duplicates>"


def test_samples(torus, cube):
    samples = torus.samples
    assert samples.area == pytest.approx(4 * math.pi**2 * 0.4, rel=0.02) and samples.spacing == 0.2
    ring = np.hypot(*samples.coords.T[:2]) - 1
    assert np.allclose(np.hypot(ring, samples.coords[:, 2]), 0.4)
    assert np.allclose(np.linalg.norm(samples.normals, axis=1), 1) and len(samples) == len(samples.coords)
    assert np.array_equal(samples.complex().values("normal"), samples.normals)
    facts = medax.describe("torus")
    assert (facts.genus, facts.components, facts.smooth) == (1, 1, True) and facts.max[2] == pytest.approx(0.4)
    of_mesh = medax.Samples.of(cube, density=100, seed=3)
    assert of_mesh.area == pytest.approx(6) and 300 < len(of_mesh) < 900
    noisy = medax.Samples.of(medax.Shape.SPHERE, spacing=0.3, noise=0.01).coords
    assert 0 < np.abs(np.linalg.norm(noisy, axis=1) - 1).max() < 0.1
    with pytest.raises(medax.ArgumentError, match="'klein' is no Shape: there are 'torus'"):
        medax.Samples.of("klein")


def test_triangulation(torus):
    triangulation, cells = torus.triangulation, torus.triangulation.cells
    a, b, c, d = (torus.points.coords[cells[:, i]] for i in range(4))
    volumes = np.einsum("ij,ij->i", np.cross(b - a, c - a), d - a)
    assert (volumes > 0).all()
    assert np.array_equal(triangulation.coords, triangulation.points.coords)
    assert np.array_equal(triangulation.row_of_vertex, torus.points.row_of_vertex)
    for cell in range(0, len(cells), 97):
        for neighbor in triangulation.neighbors[cell]:
            assert neighbor == NONE or cell in triangulation.neighbors[neighbor]
    middle = torus.points.coords[cells[5]].mean(axis=0)
    assert triangulation.locate(middle) == triangulation.locate(middle, 40) == 5
    assert triangulation.locate([9, 9, 9]) == NONE
    drawn = triangulation.complex()
    assert len(drawn.cells) == len(cells) and (drawn.cell_types == medax.CellType.TETRAHEDRON).all()
    with pytest.raises(medax.ArgumentError):
        triangulation.locate([1, 2])
    with pytest.raises(medax.ArgumentError):
        triangulation.locate([1, 2, 3], -1)


def test_regular_triangulation():
    points = medax.Points([[0, 0, 0], [4, 0, 0], [0, 4, 0], [0, 0, 4], [0.5, 0.5, 0.5]])
    weights = [0, 0, 0, 0, -100]
    triangulation = medax.Triangulation.regular(points, weights)
    assert len(triangulation.cells) == 1
    assert triangulation.row_of_vertex[triangulation.hidden].tolist() == [4]
    assert triangulation.weights[triangulation.row_of_vertex == 4].tolist() == [-100]
    assert triangulation.complex().values("weight").min() == -100


def test_incidence(torus):
    incidence = medax.Incidence.of(torus.triangulation)
    cells = torus.triangulation.cells
    row = incidence.cells_of_vertex[7].tolist()
    assert row == np.flatnonzero((cells == 7).any(axis=1)).tolist()
    a, b = incidence.edges[11].tolist()
    ring = torus.triangulation.ring(incidence.cell_of_edge[11], a, b)
    expected = np.flatnonzero((cells == a).any(axis=1) & (cells == b).any(axis=1))
    assert sorted(ring.cells.tolist()) == expected.tolist() and isinstance(ring.closed, bool)


def test_long_rings():
    """More cells round one edge than the first buffer holds."""
    turns = np.arange(100) * 2 * math.pi / 100
    rim = np.column_stack([np.cos(turns), np.sin(turns), 0.01 * np.sin(7 * turns)])
    triangulation = medax.Triangulation.delaunay(medax.Points(np.vstack([rim, [[0, 0, -0.5], [0, 0, 0.5]]])))
    incidence = medax.Incidence.of(triangulation)
    longest = 0
    for cell, (a, b) in zip(incidence.cell_of_edge, incidence.edges):
        longest = max(longest, len(triangulation.ring(cell, a, b).cells))
    assert longest > 32


def test_dual(torus):
    dual, xyz = torus.dual, torus.points.coords
    corners = xyz[torus.triangulation.cells]
    distances = np.linalg.norm(corners - dual.centers[:, None], axis=2)
    assert np.allclose(distances**2, dual.radii_squared[:, None], rtol=1e-6)
    assert np.allclose(np.linalg.norm(dual.ray_directions, axis=1), 1)
    hull = np.argwhere(torus.triangulation.neighbors == NONE)
    assert np.array_equal(dual.ray_facets, hull)
    assert len(dual.facets) == len(dual.facet_edges) == len(dual.facet_rays)
    ring = dual.facets[3]
    assert all(set(dual.facet_edges[3]) <= set(cell) for cell in torus.triangulation.cells[ring].tolist())
    assert len(medax.Dual.of(torus.triangulation).facets) == 0
    assert np.array_equal(dual.triangulation.cells, torus.triangulation.cells)


def test_poles(torus):
    poles = torus.crust.poles
    assert poles.has_far_box and not medax.Poles.of(torus.dual).has_far_box
    assert np.allclose(poles.balls[:, 3] ** 2, poles.radii_squared)
    inner = poles.balls[torus.crust.labels == medax.Label.INNER]
    assert np.allclose(np.hypot(*inner.T[:2]), 1, atol=0.1) and np.allclose(inner[:, 3], 0.4, atol=0.05)
    assert len(poles.samples_on_balls) == len(poles.balls) == len(poles.cell_of_pole) == len(poles.object_angles)
    assert np.allclose(np.linalg.norm(poles.normals, axis=1), 1)
    assert poles.pole_of_sample.shape == (torus.points.count, 2)
    assert poles.touches_far_box.any() and len(poles.triangulation.coords) == torus.points.count + 8
    assert poles.feature_size([[1, 0, 0]])[0] < 0.1
    assert np.array_equal(poles.complex().values("radius"), poles.balls[:, 3])
    assert np.array_equal(poles.samples_complex().values("normal"), poles.normals)
    with pytest.raises(medax.ArgumentError, match="Omit"):
        medax.Poles.with_far_box(torus.points, omit=medax.Side.OUTER)
    few = medax.Poles.with_far_box(torus.points, omit="both", lambda_=0.4)
    assert len(few.balls) < len(poles.balls) and few.lambda_ == 0.4
    assert few.validate().is_valid


def test_power_crust(torus):
    crust = torus.crust
    topology = crust.surface.topology()
    assert (topology.genus, topology.closed, topology.oriented, topology.betti) == (1, True, True, (1, 2, 1))
    volume = 2 * math.pi**2 * 0.4**2
    assert crust.surface.measure().volume == pytest.approx(volume, rel=0.05)
    shape = crust.shape()
    assert np.array_equal(shape.vertices, crust.shape("inner").vertices) and (shape.values("label") == 1).all()
    assert len(crust.both_shapes().vertices) == len(shape.vertices) + len(crust.shape(medax.Label.OUTER).vertices)
    assert len(crust.regular.coords) == len(crust.poles.balls) and crust.is_visible(0) and not crust.is_visible(10**9)
    assert (crust.unreached_count, crust.is_settled) == (0, False) and crust.forced_count >= 0
    assert 0 <= crust.conflict < 0.01
    assert np.array_equal(crust.poles_complex().values("label"), crust.labels)
    again = medax.PowerCrust.of(crust.poles)
    assert np.array_equal(again.labels, crust.labels)
    for options in (
        {"deep": 0.3, "round_poles": True, "keep_shards": True, "label_rule": "least-conflict"},
        {"viewpoint": (9, 0, 0)},
    ):
        assert medax.PowerCrust.of(torus.points, **options).surface.topology().closed
    with pytest.raises(TypeError, match="sample must be"):
        medax.PowerCrust.of(torus.dual)


def test_variants_of_power_crusts(torus):
    crust, surface = torus.crust, torus.cocone.surface
    assert np.array_equal(crust.with_labels(crust.labels).labels, crust.labels)
    assert len(crust.with_labels(np.zeros(len(crust.labels), int)).surface.faces) == 0
    assert (crust.labelled_by_mesh(surface).labels != crust.labels).mean() < 0.02
    grown = crust.offset(0.1).surface.measure().volume
    assert grown == pytest.approx(2 * math.pi**2 * 0.5**2, rel=0.1)
    axis = crust.scale_axis("inner", 1.2)
    assert axis.topology().betti == (1, 1, 0)
    simplified = crust.simplify(epsilon=0.7, delta=0.01)
    assert (simplified.epsilon, simplified.delta) == (0.7, 0.01)
    assert len(simplified.unstable) > 0 and simplified.redundant.shape[1] == 2
    assert simplified.crust.surface.topology().closed
    kept, left_out = crust.open(depth=0.9)
    assert len(kept.faces) + len(left_out.faces) == len(crust.surface.faces)


def test_sizes(torus):
    feature_size, thickness = torus.crust.sizes_at(torus.points.coords)
    assert np.allclose(feature_size, 0.4, atol=0.05) and np.allclose(thickness, 0.8, atol=0.1)
    samples = torus.crust.samples_complex()
    assert np.array_equal(samples.values("thickness"), thickness)
    sized = torus.crust.with_sizes(torus.cocone.surface)
    assert np.allclose(sized.values("thickness"), 0.8, atol=0.1)


def test_cocone(torus):
    cocone = torus.cocone
    assert cocone.surface.topology().genus == 1 and cocone.used_count == torus.points.count
    assert cocone.open_surface.topology().euler_characteristic == 0
    assert cocone.is_well_sampled.all() and cocone.is_undersampled.mean() < 0.2 and cocone.marked_count > 0
    assert np.array_equal(cocone.is_inner, torus.labels.is_inner)
    assert len(medax.Cocone.of(torus.dual, angle=0.3, ratio=1.1, normal_angle=0.4).surface.faces) > 0


def test_labels(torus):
    labels = torus.labels
    assert labels.inner_count == labels.is_inner.sum()
    assert len(labels.triangulation.cells) == len(labels.is_inner)
    by_crust, by_mesh = medax.Labels.of(torus.dual, torus.crust), medax.Labels.of(torus.dual, torus.cocone.surface)
    for other in (by_crust, by_mesh):
        assert labels.disagreement(other) == (labels.is_inner != other.is_inner).sum()
    assert by_crust.disagreement(by_mesh) < len(labels.is_inner) / 100
    for wrong in ((torus.dual,), (torus.cocone, torus.crust), (torus.points,)):
        with pytest.raises(TypeError, match="labels are of"):
            medax.Labels.of(*wrong)


def test_medial(torus):
    medial = torus.medial
    axis = medial.axis()
    inside = np.hypot(*axis.vertices.T[:2])
    assert np.median(np.abs(inside - 1)) < 0.01 and np.median(axis.values("radius")) == pytest.approx(0.4, abs=0.01)
    facets = medial.selected()
    assert len(axis.faces) <= len(facets) and set(axis.values("facet", "face")) <= set(facets.tolist())
    few = medial.axis(theta=1.2, rho=30, side="inner", rule="angle", object_angle=2.8, lambda_=0.3)
    assert 0 < len(few.faces) < len(axis.faces)
    assert len(medial.axis(side=medax.Side.OUTER, clip=([-2, -2, -2], [2, 2, 2])).faces) > 0
    assert len(medial.selected(rule="every", side="both")) == len(torus.dual.facets)
    assert medial.sines.shape == medial.ratios.shape == medial.reaches.shape == (len(torus.dual.facets), 2)
    assert len(medial.least_cell) == len(torus.triangulation.cells) and len(medial.scales) == 0
    assert medial.umbrella_offsets[-1] == len(medial.umbrella_rims) and medial.umbrella_is_disk.all()
    assert medial.torn_count == 0 and medial.labels.disagreement(torus.labels) == 0
    assert np.array_equal(medial.dual.centers, torus.dual.centers)
    scaled = medax.Medial.of(torus.dual, torus.labels, normals=torus.crust.poles.normals, scales=True)
    assert len(scaled.axis(scale=1.5).faces) <= len(axis.faces) and (scaled.scales >= 1).all()
    bare = medax.Medial.of(torus.dual)
    assert bare.labels is None and len(bare.axis().faces) > len(axis.faces)
    with pytest.raises(medax.MedaxError):
        bare.axis(side="inner")
    with pytest.raises(TypeError, match="thetta"):
        medial.axis(thetta=1)
    with pytest.raises(medax.ArgumentError, match="two corners"):
        medial.axis(clip=[1, 2, 3])
    with pytest.raises(medax.ArgumentError, match="theta must be a number"):
        medial.axis(theta="wide")


def test_flow(torus):
    flow = torus.flow
    simplices = flow.critical_simplices
    indices = np.bincount(simplices[:, 0], minlength=4)
    assert indices[0] - indices[1] + indices[2] - indices[3] == 1 and indices[0] == torus.points.count
    assert flow.critical_count == len(simplices) == len(flow.critical_points) == len(flow.critical_corners)
    assert np.array_equal(flow.critical_slopes[: indices[0]], np.zeros(indices[0]))
    assert len(flow.critical_shares) == len(flow.critical_distances) == flow.critical_count
    assert set(flow.critical_classes) == set(medax.CriticalClass)
    row = flow.critical_row(simplices[-1])
    assert row == flow.critical_count - 1 and flow.critical_row((3, 10**9)) == NONE
    least, greatest = flow.gap()
    assert least < 0.5 < greatest
    assert len(flow.critical_complex().vertices) == flow.critical_count - indices[0]
    assert flow.driver_of_triangle(0).dimension in (1, 2) and flow.driver_of_cell(0).dimension in (1, 2, 3)
    assert flow.triangles.shape[1] == 2 and np.array_equal(flow.dual.centers, torus.dual.centers)
    assert flow.labels.disagreement(torus.labels) == 0
    at = flow.at([[1.2, 0, 0], [1, 0, 0]])
    assert at.dtype.names == ("simplex", "driver", "vector", "distance", "angle")
    assert at.vector[0, 0] < 0 and at.distance[0] == pytest.approx(0.2, abs=0.1)
    orbits = flow.orbits([[1.2, 0, 0], [9, 9, 9]])
    assert flow.critical_classes[orbits.ends[0]] == medax.CriticalClass.INNER and orbits.ends[1] == NONE
    assert set(orbits.complex.values("orbit", "edge")) == {0, 1}
    core = flow.core()
    assert core.complex.topology().betti == (1, 1, 0) and core.report.taken == 0
    extended = flow.core(torus.medial.selected(), side="inner", repair=True)
    assert extended.report.taken > 0 and extended.complex.topology().betti == (1, 1, 0)
    assert len(flow.closure(simplices[-1:]).vertices) > 0


def test_flow_complex():
    points = medax.Samples.of("sphere", spacing=0.5).points()
    dual = medax.Dual.of(medax.Triangulation.delaunay(points), facets=True)
    flow = medax.Flow.of(dual, medax.Labels.of(medax.Cocone.of(dual)), least_slope=0.4)
    made = medax.FlowComplex.of(flow)
    assert made.vertex_count == len(dual.centers) + len(made.points) == len(made.edge_of_vertex)
    assert len(made.triangle_of_point) == len(made.points) and len(made.triangle_of_edge) <= len(made.edges)
    assert len(made.faces) == len(made.face_edges) and len(made.face_of_edge) == len(made.edges)
    assert made.faces_of_facet[-1] == len(made.faces) and len(made.faces_of_facet) == len(dual.facets) + 1
    assert made.flow.critical_count == flow.critical_count
    elements = made.elements_of((1, 0))
    assert (elements[:, 0] == medax.Element.FACE).all()
    assert len(elements) == made.faces_of_facet[1] - made.faces_of_facet[0]
    # A Voronoi facet of many faces fills more than the first buffer.
    counts = np.diff(made.faces_of_facet.astype(int))
    assert len(made.elements_of((1, int(counts.argmax())))) == counts.max()
    closure, upstream = made.closure(elements), made.upstream(elements)
    assert {tuple(row) for row in elements.tolist()} <= {tuple(row) for row in closure.tolist()}
    assert len(upstream) >= len(elements)
    sets = made.critical_sets(closure)
    assert len(sets) == len(closure) and all(len(row) for row in made.critical_sets([[0, 0]]))
    everything = np.column_stack([np.full(made.vertex_count, 0), np.arange(made.vertex_count)])
    assert len(made.critical_sets(everything)) == made.vertex_count
    assert made.validate().is_valid and len(made.complex().faces) > 0


def test_pair(torus):
    pair = torus.pair
    kinds = [pair.element_count(kind) for kind in medax.PairElement]
    assert sum(kinds) == pair.element_count() == len(pair.rings) and kinds[0] == 2 * len(pair.inner_faces)
    assert pair.element_count("face_vertex") == kinds[0]
    volumes = pair.volumes()
    sums_to(volumes, pair.enclosed_volume, 1e-9)
    assert pair.centroids().shape == (pair.element_count(), 3)
    assert set(pair.shells()) == {0} and len(pair.folded()) == 0 and len(pair.removed) == 0
    assert np.array_equal(torus.points.coords[pair.boundary_samples], pair.boundary_vertices)
    assert len(pair.inner_vertices) == len(pair.inner_cells) == len(pair.voronoi_vertices)
    assert pair.nodes.max(axis=0).tolist() == [len(pair.boundary_vertices) - 1, len(pair.inner_vertices) - 1]
    assert pair.iso_surface(0.5).topology().genus == 1
    assert pair.boundary().measure().volume == pytest.approx(pair.enclosed_volume)
    assert len(pair.solid().cells) == pair.element_count() and len(pair.inner().faces) == len(pair.inner_faces)
    queries = pair.centroids()[:50]
    places = pair.locate(queries)
    assert np.allclose(pair.positions(places), queries) and np.allclose(places.weights.sum(axis=1), 1)
    assert ((places.t >= 0) & (places.t <= 1)).all() and pair.locate([[9, 9, 9]]).element[0] == NONE
    corners = pair.piece(places.element[0], places.piece[0])
    assert np.allclose(
        places.weights[0] @ np.vstack([pair.boundary_vertices, pair.inner_vertices])[corners], queries[0]
    )
    moved = pair.with_inner(pair.inner_vertices + [1, 0, 0])
    assert np.allclose(moved.boundary_vertices, pair.boundary_vertices + [1, 0, 0])
    assert np.allclose(pair.with_boundary(pair.boundary_vertices * 2).boundary_vertices, pair.boundary_vertices * 2)
    core = torus.flow.core().complex
    onto = pair.onto(core, subdivide=True)
    assert len(onto.reasons()) == len(onto.inner_faces) and onto.validate().is_valid
    assert pair.missing == 0 and onto.missing >= 0
    assert len(onto.inner_faces) < len(pair.inner_faces) and set(pair.reasons()) == {medax.PairReason.ASKED}
    with pytest.raises(medax.ArgumentError, match="places must be rows"):
        pair.positions(queries)


def test_half_faces(torus):
    halves = medax.HalfFaces.of(torus.pair)
    assert len(halves.of_element) == torus.pair.element_count() + 1 and halves.of_element[-1] == len(halves.duals)
    there = np.flatnonzero(halves.duals != NONE)
    assert np.array_equal(halves.duals[halves.duals[there]], there)
    edges = np.arange(len(halves.origins))
    assert np.array_equal(halves.opposites[halves.opposites], edges) and halves.offsets[-1] == len(edges)
    partnered = np.flatnonzero(halves.partners != NONE)
    assert np.array_equal(halves.partners[halves.partners[partnered]], partnered)


def test_complex(cube):
    assert (cube.dimension, len(cube.triangles), cube.face_of_triangle.tolist()) == (3, 12, sorted([*range(6)] * 2))
    assert cube.bounds.tolist() == [[0, 0, 0], [1, 1, 1]]
    measure = cube.measure()
    assert (measure.area, measure.volume) == (6, 1)
    topology = cube.topology()
    assert (topology.vertices, topology.edges, topology.faces, topology.genus) == (8, 12, 6, 0)
    assert len(cube.self_intersections().pairs) == len(cube.self_intersections()) == 0
    assert np.allclose(cube.winding_numbers([[0.5, 0.5, 0.5], [2, 2, 2]]), [1, 0])
    normals = cube.vertex_normals()
    assert np.allclose(normals, (cube.vertices - 0.5) / math.sqrt(0.75))
    turned = medax.Complex(cube.vertices, [row[::-1] for row in cube.faces])
    assert turned.measure().volume == -1 and turned.oriented().measure().volume == 1
    assert cube.validate().is_valid
    shifted = medax.Complex(cube.vertices + [0.1, 0, 0], cube.faces)
    compared = cube.compare(shifted, samples=1000, seed=1)
    assert compared.a_to_b_max == pytest.approx(0.1) and compared.diagonal == pytest.approx(math.sqrt(1.1**2 + 2))
    flat = medax.Complex([[0, 0, 0], [1, 0, 0], [0, 1, 0]], [[0, 1, 2]], dimension=2)
    assert flat.dimension == 2 and flat.topology().genus == 0 and not flat.topology().closed
    moebius = medax.Complex(
        np.eye(6)[:, :3] + np.arange(6)[:, None], [[0, 1, 2], [1, 2, 3], [2, 3, 4], [3, 4, 0], [4, 0, 1]]
    )
    assert moebius.topology().genus is None
    for wrong in ({"dimension": 4}, {"dimension": -1}):
        with pytest.raises(medax.MedaxError):
            medax.Complex(cube.vertices, **wrong)
    with pytest.raises(medax.ArgumentError, match="cell_types"):
        medax.Complex(cube.vertices, cells=[[0, 1, 3, 2, 4]])
    pyramid = medax.Complex(cube.vertices, cells=[[0, 2, 3, 1, 4]], cell_types=[medax.CellType.PYRAMID])
    assert pyramid.cells.to_list() == [[0, 2, 3, 1, 4]] and pyramid.topology().cells == 1


def test_intersecting_triangles():
    xyz = [[0, 0, 0], [2, 0, 0], [0, 2, 0], [0.5, 0.5, -1], [0.5, 0.5, 1], [3, 3, 0]]
    assert medax.Complex(xyz, [[0, 1, 2], [3, 4, 5]]).self_intersections().pairs.tolist() == [[0, 1]]


def test_decimate_and_flatten(torus):
    surface = torus.cocone.surface
    few = surface.decimate(triangles=200)
    assert len(few.faces) <= 200 and few.topology().genus == 1
    assert len(surface.decimate(max_error=1e-9).faces) > 200
    shape = torus.crust.shape()
    flat = shape.flatten(flatness=math.inf)
    assert len(flat.complex().cells) + len(flat.collapses) == len(shape.cells) and flat.left_count >= 0
    assert flat.complex().topology().betti == shape.topology().betti


def test_jupyter(torus, cube):
    shown = torus.medial.axis()._repr_html_()
    for part in ("vertices", "faces", "object_angle <small>(face)</small>", "float64 × 2", "…"):
        assert part in shown
    assert "&lt;b&gt;" in medax.Complex(cube.vertices, attributes={"vertex": {"<b>": range(8)}})._repr_html_()
    empty = medax.Complex(np.empty((0, 3)))
    assert repr(empty) == "<medax.Complex: 0 vertices>" and "<table>" in empty._repr_html_()
    assert np.isnan(empty.bounds).all()
    empty.close()
    assert "closed" in empty._repr_html_()
    for handle in vars(torus).values():
        assert repr(handle).startswith(f"<medax.{type(handle).__name__}: ")


def test_every_handle_clones(torus, tmp_path):
    sites = medax.Sites.of(torus.cocone.surface)
    path = tmp_path / "torus.ply"
    warnings = torus.cocone.surface.write(path)
    flat = medax.Figure([[[(0, 0), (1, 0), (0, 1)]]])
    handles = [
        *vars(torus).values(),
        sites,
        warnings,
        flat,
        torus.crust.poles,
        torus.cocone.surface,
        torus.crust.simplify(),
        medax.Incidence.of(torus.triangulation),
        torus.cocone.surface.self_intersections(),
        torus.crust.shape().flatten(),
        medax.HalfFaces.of(torus.pair),
        medax.FlowComplex.of(torus.flow),
        sites.all_nearest([[0, 0, 0]], 0.0),
        medax.FieldAxis.of(medax.Sites.of(flat)),
        medax.MedialGraph.of(medax.Sites.of(flat)),
        medax.Balls([[0, 0, 0]], [1]),
        medax.File.read(path),
        medax.Job(),
    ]
    kinds = {type(handle) for handle in handles}
    assert kinds == {kind for kind in vars(medax).values() if isinstance(kind, type) and hasattr(kind, "_stem")}
    for handle in handles:
        with handle.clone() as clone:
            assert repr(clone) == repr(handle) and not clone.closed
        assert not handle.closed
