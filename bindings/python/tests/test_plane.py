# SPDX-License-Identifier: MIT OR Apache-2.0
"""Figures, sites, axes by the gradient of the distance, balls, and files."""

import json
import math
import pathlib

import numpy as np
import pytest

import medax
from medax import NONE, Piece

SQUARE = [(0, 0), (4, 0), (4, 4), (0, 4)]
HOLE = [(1, 1), (1, 2), (2, 2), (2, 1), (1, 1)]


def test_figure():
    figure = medax.Figure([[SQUARE, HOLE]], [[(5, 0), (6, 1), (7, 0)]], [(8, 8)], [(10, 0, 1)])
    assert figure.part_count == 4 and figure.circles.tolist() == [[10, 0, 1]]
    assert [len(chain) for chain in figure.chains] == [4, 4, 3, 1]
    kinds = medax.ChainKind
    assert figure.kinds.tolist() == [kinds.OUTER, kinds.HOLE, kinds.POLYLINE, kinds.POINT]
    assert figure.parts_of_chains.tolist() == [0, 0, 1, 2] and figure.vertices.shape == (12, 2)
    assert np.allclose(figure.bounds, [[0, -1], [11, 8]])
    assert figure.normalised.closing_vertices == 1
    assert figure.validate().is_valid
    bow = [(0, 0), (1, 1), (1, 0), (0, 1)]
    with pytest.raises(medax.MedaxError):
        medax.Figure([[bow]])
    assert medax.Figure([[bow]], crossings="accept").normalised.crossings == 1
    for wrong in ([SQUARE], [[[(0, 0, 0)] * 3]]):
        with pytest.raises(medax.ArgumentError):
            medax.Figure(wrong)


def test_figures_of_generators_and_of_nothing():
    square = [(0, 0), (2, 0), (2, 2), (0, 2)]
    figure = medax.Figure(([ring] for ring in [square]), (line for line in [[(5, 5), (6, 6)]]))
    assert len(figure.vertices) == 6
    for wrong in ([[]], [square], [3]):
        with pytest.raises((medax.ArgumentError, TypeError), match="polygons|iterable"):
            medax.Figure(wrong)


def test_a_clip_that_is_no_box():
    sites = medax.Sites.of(medax.Figure([[[(0, 0), (2, 0), (2, 2)]]]))
    for wrong in (5, [1, 2, 3], "ab", [[0, 0], [1, 1]], [[0, 0, 0], None]):
        with pytest.raises(medax.ArgumentError, match="clip"):
            medax.MedialGraph.of(sites, clip=wrong)


def test_figure_of_a_file(tmp_path):
    feature = {
        "type": "Feature",
        "properties": {"name": "quay"},
        "geometry": {"type": "Polygon", "coordinates": [SQUARE]},
    }
    other = {"type": "Feature", "properties": {"name": "pond"}, "geometry": {"type": "Polygon", "coordinates": [HOLE]}}
    path = tmp_path / "figure.geojson"
    path.write_text(json.dumps({"type": "FeatureCollection", "features": [feature, other]}))
    assert medax.Figure.read(path, feature_name="quay").bounds.tolist() == [[0, 0], [4, 4]]
    assert medax.Figure.read(str(path), feature_number=1).bounds.tolist() == [[1, 1], [2, 2]]
    with pytest.raises(medax.MedaxError):
        medax.Figure.read(path)


def test_sites_of_pieces():
    pieces = [
        Piece.point((0, 0)),
        Piece.segment((1, 0), (1, 1), 1),
        Piece.ray((5, 5), (1, 0), 2),
        Piece.line((0, -9), (1, 0), 3),
        Piece.sphere((0, 20), 2, 4),
    ]
    sites = medax.Sites(2, pieces)
    assert (sites.dimension, sites.piece_count, sites.site_count) == (2, 5, 5)
    assert sites.site_of_piece.tolist() == [0, 1, 2, 3, 4]
    nearest = sites.nearest([[0.9, 0.5, 0], [0, 19, 0]])
    assert nearest.piece.tolist() == [1, 4] and np.allclose(nearest.distance, [0.1, 1])
    assert np.allclose(nearest.direction[0], [1, 0, 0]) and np.allclose(nearest.point[1], [0, 18, 0])
    again = medax.Sites(2, sites.pieces())
    assert np.array_equal(again.pieces(), sites.pieces())
    assert sites.size > 0 and sites.bounds.shape == (2, 3)
    assert medax.Sites(3, [Piece.triangle((0, 0, 0), (1, 0, 0), (0, 1, 0))]).dimension == 3
    for wrong in (lambda: medax.Sites(2, np.eye(3)), lambda: medax.Sites(4, pieces), lambda: Piece.point((1,))):
        with pytest.raises(medax.MedaxError):
            wrong()
    with pytest.raises(medax.ArgumentError):
        Piece.point((0, 0), -1)


def test_sites_of_figures_and_meshes(cube):
    square = medax.Sites.of(medax.Figure([[SQUARE]]))
    assert square.is_inside([[1, 1, 0], [9, 1, 0]]).tolist() == [True, False]
    closed = medax.Sites(2, square.pieces(), is_closed=[True] * 4)
    assert closed.is_inside([[1, 1, 0]]).tolist() == [True]
    all_nearest = square.all_nearest([[2, 2, 0], [1, 2, 0]], 1e-9)
    assert [len(row) for row in all_nearest.pieces] == [4, 1] and np.allclose(all_nearest.distances, [2, 2, 2, 2, 1])
    assert all_nearest.points.shape == all_nearest.directions.shape == (5, 3) and len(all_nearest.sites) == 5
    box = medax.Sites.of(cube)
    assert box.is_inside([[0.5, 0.5, 0.5], [2, 2, 2]]).tolist() == [True, False] and box.piece_count == 12
    two = medax.Complex(
        np.vstack([cube.vertices, cube.vertices + 5]),
        cube.faces.to_list() + [[i + 8 for i in row] for row in cube.faces.to_list()],
    )
    assert medax.Sites.of_components(two).site_count == 2
    with pytest.raises(TypeError):
        medax.Sites.of(box)


def test_decisions():
    square = medax.Sites.of(medax.Figure([[SQUARE]]))
    directions = square.even_directions(20)
    found = square.decide((2, 2, 0), 0.5, directions)
    assert found.has_point and found.test != medax.DecideTest.NONE and found.feet.shape == (2, 3)
    assert found.object_angle > 1 and len(found.theta) >= 2
    nothing = square.decide((2, 0.5, 0), 0.2, directions, tolerance=1e-9, epsilon=1e-6)
    assert not nothing.has_point and nothing.pieces == (NONE, NONE) and nothing.gap > 0
    assert medax.largest_missed_angle(nothing.gap, 0.2, 0.3) < math.pi
    assert medax.largest_missed_angle(1, 0.2, 0.3) == math.pi


def test_field_axis(cube):
    square = medax.Sites.of(medax.Figure([[SQUARE]]))
    axis = medax.FieldAxis.of(square, density=0.2, object_angle=0.1, min_distance=0.1)
    # The axis of a square are its diagonals.
    x, y, _ = axis.points.T
    assert np.minimum(np.abs(x - y), np.abs(x + y - 4)).max() < 1e-4
    assert np.allclose(axis.radii, np.minimum.reduce([x, y, 4 - x, 4 - y]), atol=1e-4)
    assert np.allclose(axis.object_angles[axis.radii < 1.8], math.pi / 2, atol=1e-3)
    assert axis.feet.shape == (len(x), 6) and axis.pieces.shape == axis.sites_of_points.shape == (len(x), 2)
    covers = axis.covers()
    assert covers.center.shape == (len(covers), 3) and axis.cover_of_point.max() < len(covers)
    assert axis.claim().angle < math.pi and axis.unconfirmed >= 0 and axis.sites.piece_count == 4
    assert (axis.resolved["density"], axis.resolved["side"]) == (0.2, medax.Side.INNER)
    assert len(axis.complex().vertices) == len(x) and axis.validate().is_valid
    assert len(medax.FieldAxis.between(square, np.empty((0, 2), int)).points) == 0
    surface = medax.FieldAxis.of(medax.Sites.of(cube), density=0.2).surface()
    assert len(surface.faces) > 0
    with pytest.raises(TypeError, match="densty"):
        medax.FieldAxis.of(square, densty=1)


def test_medial_graph():
    square = medax.Sites.of(medax.Figure([[SQUARE]]))
    graph = medax.MedialGraph.of(square, spacing=0.5)
    assert (graph.node_count, len(graph.arcs), graph.torn) == (5, 4, 0)
    assert np.allclose(graph.points[np.argmax(graph.radii)], [2, 2, 0])
    assert graph.complex().topology().betti == (1, 0, 0) and graph.validate().is_valid
    assert graph.feet.shape[1] == 6 and graph.pieces.shape == graph.sites_of_points.shape
    assert len(graph.object_angles) == len(graph.radii) and graph.sites.site_count == 1
    assert len(medax.MedialGraph.of(square, side="outer", clip=([-9, -9, 0], [9, 9, 0])).arcs) == 0
    assert len(medax.MedialGraph.between(square, [[0, 0]], spacing=0.5).arcs) == 4
    two = medax.Sites.of(medax.Figure([], [], [(0, 0), (2, 0)]))
    between = medax.MedialGraph.between(two, [(1, 0)], side="outer")
    assert np.allclose(between.points[:, 0], 1)


def test_balls(torus):
    balls = medax.Balls([[0, 0, 0], [3, 0, 0]], [1, 1])
    assert balls.count == len(balls) == 2 and balls.radii.tolist() == [1, 1] and balls.centers.shape == (2, 3)
    assert balls.bounds.tolist() == [[-1, -1, -1], [4, 1, 1]]
    assert np.allclose(balls.distances([[0, 0, 0], [1.5, 0, 0]]), [-1, 0.5])
    assert balls.boundary(spacing=0.2).topology().components == 2
    union = medax.Balls.of(torus.medial.axis())
    assert np.abs(union.distances(torus.points.coords)).max() < 0.05


@pytest.mark.parametrize("ending", ["ply", "off", "obj", "stl"])
def test_meshes_of_files(cube, tmp_path, ending):
    path = tmp_path / f"würfel 1.{ending}"
    warnings = cube.write(path)
    assert len(warnings) == warnings.count == len(list(warnings))
    read = medax.Complex.read(path)
    assert read.measure().volume == pytest.approx(1)
    file = medax.File.read(str(path))
    assert file.is_mesh and len(file.vertices) == len(read.vertices) and len(file.faces) == len(read.faces)
    assert file.complex().measure().volume == pytest.approx(1) and file.points().count == 8
    assert len(file.warnings) >= 0 and file.edges.shape == (0, 2)


def test_points_of_files(tmp_path, random_points):
    points, path = medax.Points(random_points), tmp_path / "points.ply"
    points.write(path, text=True)
    assert path.read_bytes().startswith(b"ply\nformat ascii")
    assert np.array_equal(medax.Points.read(path).coords, points.coords)
    (tmp_path / "nan.xyz").write_text("0 0 0\nnan 0 0\n")
    with pytest.raises(medax.MedaxError) as caught:
        medax.Points.read(tmp_path / "nan.xyz")
    assert caught.value.status == medax.Status.NON_FINITE
    assert medax.Points.read(tmp_path / "nan.xyz", skip_non_finite=True).count == 1


def test_what_formats_cannot_hold(torus, tmp_path):
    warnings = torus.medial.axis().write(tmp_path / "axis.off")
    assert len(warnings) > 0 and isinstance(warnings[0], str) and warnings[-1] == list(warnings)[-1]
    with pytest.raises(IndexError):
        warnings[len(warnings)]
    file = medax.File.read(tmp_path / "axis.off")
    torus.medial.axis().write(tmp_path / "axis.ply")
    file = medax.File.read(tmp_path / "axis.ply")
    assert file.attribute("vertex", "radius").values.tolist() == file.values("radius").tolist()
    assert file.attribute_count == len(file.attributes)


def test_paths(tmp_path):
    for path, status in (
        (tmp_path / "nowhere.ply", medax.Status.IO),
        (tmp_path / "x.unknown", medax.Status.UNSUPPORTED),
        (pathlib.Path("/nowhere") / "x.ply", medax.Status.IO),
    ):
        with pytest.raises(medax.MedaxError) as caught:
            medax.Complex.read(path)
        assert caught.value.status == status
    (tmp_path / "bad.off").write_text("OFF\n1 0 0\n0 0 zero\n")
    with pytest.raises(medax.MedaxError) as caught:
        medax.Complex.read(tmp_path / "bad.off")
    error = caught.value
    assert (error.status, error.kind, error.index) == (medax.Status.FORMAT, medax.ErrorKind.LINE, 3)
    with pytest.raises(medax.ArgumentError, match="NUL"):
        medax.Complex.read("a\0b.ply")
    with pytest.raises(TypeError):
        medax.Complex.read(3)
