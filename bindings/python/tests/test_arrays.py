# SPDX-License-Identifier: MIT OR Apache-2.0
"""What arrays go in, how, and what comes out."""

import numpy as np
import pytest

import medax
from medax import view

XYZ = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0], [0, 0, 1], [2, 3, 4]], float)


def test_contiguous_arrays_are_passed_as_they_are():
    assert view.floats(XYZ, "xyz") is XYZ
    faces = np.array([[0, 1, 2]], np.uint32)
    assert view.indices(faces, "faces", 3) is faces
    assert np.shares_memory(view.rows(faces, "faces").indices, faces)
    flags = np.array([True, False])
    assert np.shares_memory(view.flags(flags, "flags"), flags)


@pytest.mark.parametrize(
    "given",
    [
        XYZ.tolist(),
        tuple(map(tuple, XYZ)),
        XYZ.astype(np.float32),
        XYZ.astype(np.float16),
        XYZ.astype(np.int8),
        XYZ.astype(np.int64),
        XYZ.astype(np.uint64),
        XYZ.astype(">f8"),
        np.asfortranarray(XYZ),
        np.repeat(XYZ, 2, axis=0)[::2],
        np.column_stack([XYZ, XYZ])[:, :3],
        np.column_stack([XYZ, XYZ]).astype(np.float32)[:, 3:],
        XYZ[::-1][::-1],
        np.ma.masked_array(XYZ),
    ],
    ids=lambda given: f"{type(given).__name__}-{getattr(given, 'dtype', '')}",
)
def test_what_points_convert(given):
    points = medax.Points(given)
    assert np.array_equal(points.coords[points.vertex_of_row], XYZ)


def test_rows_in_reverse():
    points = medax.Points(XYZ[::-1])
    assert np.array_equal(points.coords[points.vertex_of_row], XYZ[::-1])


def test_unaligned_rows():
    packed = np.zeros(5, np.dtype([("tag", "u1"), ("xyz", "f8", 3)]))
    packed["xyz"] = XYZ
    points = medax.Points(packed["xyz"])
    assert np.array_equal(points.coords[points.vertex_of_row], XYZ)
    numbers = medax.Complex(XYZ, [[0, 1, 2]]).winding_numbers(packed["xyz"][4:])
    assert np.array_equal(numbers, medax.Complex(XYZ, [[0, 1, 2]]).winding_numbers(XYZ[4:]))


@pytest.mark.parametrize(
    ("given", "says"),
    [
        (XYZ[:, :2], r"shape \(n, 3\), not \(5, 2\)"),
        (XYZ.ravel(), r"shape \(n, 3\), not \(15,\)"),
        (XYZ[None], r"shape \(n, 3\), not \(1, 5, 3\)"),
        (5.0, r"shape \(n, 3\), not \(\)"),
        ([[0, 0, 0], [1, 1]], "no array"),
        ([["a", "b", "c"]], "cannot be converted"),
        (XYZ.astype(complex), "complex128 cannot be converted"),
        (XYZ.astype(bool), "bool cannot be converted"),
        (XYZ.astype(object), "object cannot be converted"),
        (XYZ.astype("M8[s]"), "cannot be converted"),
        (np.array([[2**53 + 1, 0, 0]]), r"beyond 2\*\*53"),
        (np.ma.masked_array(XYZ, XYZ == 1), "masked"),
        (None, "cannot be converted|shape"),
    ],
)
def test_what_points_refuse(given, says):
    for error in (medax.MedaxError, ValueError):
        with pytest.raises(error, match=says) as caught:
            medax.Points(given)
    assert caught.value.status == medax.Status.INVALID_ARGUMENT


@pytest.mark.skipif(np.dtype(np.longdouble).itemsize == 8, reason="long double is double here")
def test_long_doubles_are_refused():
    with pytest.raises(medax.ArgumentError, match="without loss"):
        medax.Points(XYZ.astype(np.longdouble))


@pytest.mark.parametrize("wrong", [np.nan, np.inf, -np.inf])
def test_what_is_not_finite(wrong):
    xyz = XYZ.copy()
    xyz[3, 1] = wrong
    with pytest.raises(medax.MedaxError) as caught:
        medax.Points(xyz)
    error = caught.value
    assert (error.status, error.kind, error.index) == (medax.Status.NON_FINITE, medax.ErrorKind.ROW, 3)
    assert "row 3" in error.message and str(error) == error.message
    points = medax.Points(xyz, skip_non_finite=True)
    assert points.skipped_count == 1 and points.vertex_of_row[3] == medax.NONE


def test_no_points():
    for nothing in ([], np.empty((0, 3)), np.empty(0)):
        with pytest.raises(medax.MedaxError) as caught:
            medax.Points(nothing)
        assert caught.value.status == medax.Status.TOO_FEW_POINTS
        assert caught.value.index is None


@pytest.mark.parametrize("kind", [np.int8, np.int32, np.int64, np.uint8, np.uint16, np.uint64, ">u4"])
def test_indices_of_other_types(kind):
    made = medax.Complex(XYZ, np.array([[0, 1, 2], [0, 2, 3]]).astype(kind))
    assert made.faces.to_list() == [[0, 1, 2], [0, 2, 3]]


@pytest.mark.parametrize(
    ("faces", "says"),
    [
        ([[0, 1, -1]], "from 0 to"),
        (np.array([[0, 1, 2**32]]), "from 0 to"),
        ([[0.0, 1.0, 2.0]], "integers"),
        (np.array([[0.0, 1.0, 2.0]]), "integers, not float64"),
        (np.array([0, 1, 2]), r"shape \(n, k\)"),
        ([["a", "b", "c"]], "integers"),
        (7, "rows of indices"),
        ([0, 1, 2], "rows of indices"),
        ((np.array([0, 2]), np.array([0, 1, 2])), "offsets"),
        ((np.array([1, 3]), np.array([0, 1, 2])), "offsets"),
        ((np.array([0, 4, 3]), np.array([0, 1, 2])), "offsets"),
    ],
)
def test_faces_that_are_none(faces, says):
    with pytest.raises(medax.ArgumentError, match=says):
        medax.Complex(XYZ, faces)


def test_faces_in_every_form():
    rows = [[0, 1, 2], [0, 2, 3, 4]]
    first = medax.Complex(XYZ, rows)
    assert first.faces.to_list() == rows
    for form in (first.faces, (first.faces.offsets, first.faces.indices), tuple(map(tuple, rows))):
        assert medax.Complex(XYZ, form).faces.to_list() == rows
    assert medax.Complex(XYZ, np.array([rows[0]])).faces.to_list() == rows[:1]
    assert medax.Complex(XYZ).faces.to_list() == []
    with pytest.raises(medax.MedaxError) as caught:
        medax.Complex(XYZ, [[0, 1, 2], [0, 1, 9]])
    assert (caught.value.kind, caught.value.index) == (medax.ErrorKind.FACE, 1)


@pytest.mark.parametrize(
    "offsets, inside",
    [
        (np.array([0, 3, 200_000_000], np.uint32), np.array([0, 1, 2], np.uint32)),
        (np.array([0, 3, 4_000_000_000], np.uint32), np.array([0, 1, 2], np.uint32)),
        (np.array([1, 3], np.uint32), np.array([0, 1, 2], np.uint32)),
        (np.array([0, 3, 0, 3], np.uint32), np.array([0, 1, 2], np.uint32)),
        ([0, 3], [1 << 32, 2, 3]),
        ([0, 3], [0.0, 1.0, 2.0]),
        ([], [0, 1, 2]),
    ],
)
def test_rows_that_are_none(offsets, inside):
    with pytest.raises(medax.ArgumentError, match="faces"):
        medax.Complex(XYZ, medax.Rows(offsets, inside))


@pytest.mark.parametrize("kind", [list, np.int64, np.uint8, ">u4"])
def test_rows_of_a_caller_are_converted(kind):
    made = [[0, 3, 7], [0, 1, 2, 3, 2, 1, 0]]
    if kind is not list:
        made = [np.array(part, kind) for part in made]
        # Every second one of twice as many.
        made = [np.repeat(part, 2)[::2] for part in made]
    assert medax.Complex(XYZ, medax.Rows(*made)).faces.to_list() == [[0, 1, 2], [3, 2, 1, 0]]
    assert len(medax.Complex(XYZ, medax.Complex(XYZ).faces).faces) == 0


def test_rows_of_mixed_types_and_ragged_ones():
    faces = [np.array([0, 1, 2], np.uint64), np.array([2, 1, 3], np.int64)]
    assert medax.Complex(XYZ, faces).faces.to_list() == [[0, 1, 2], [2, 1, 3]]
    # What is wrong with an empty row is that it is no face.
    for wrong, says in (([[0, 1, 2], []], "vertices"), ([[0, 1, [2]]], "rows of indices"), ([[0, 1, -1]], "faces")):
        with pytest.raises(medax.MedaxError, match=says):
            medax.Complex(XYZ, wrong)


@pytest.mark.parametrize("wrong", ["radius\0more", 3, None, b"radius"])
def test_names_that_are_none(wrong):
    solid = medax.Complex(XYZ, attributes={"vertex": {"radius": [1.0] * 5}})
    with pytest.raises(medax.ArgumentError, match="name"):
        solid.values(wrong)
    with pytest.raises(medax.ArgumentError, match="name"):
        medax.Complex(XYZ, attributes={"vertex": {wrong: [1.0] * 5}})


def test_rows_are_a_sequence():
    rows = medax.Complex(XYZ, [[0, 1, 2], [0, 2, 3, 4]]).faces
    assert len(rows) == 2 and rows[-1].tolist() == [0, 2, 3, 4] and rows.lengths.tolist() == [3, 4]
    assert [row.tolist() for row in rows[:1]] == [[0, 1, 2]]
    assert [len(row) for row in rows] == [3, 4] and "2 rows" in repr(rows)
    for wrong in (2, -3):
        with pytest.raises(IndexError):
            rows[wrong]


def test_flags(torus):
    count = len(torus.triangulation.cells)
    for given in (torus.labels.is_inner, torus.labels.is_inner.astype(int), torus.labels.is_inner.tolist()):
        assert medax.Labels(torus.triangulation, given).disagreement(torus.labels) == 0
    for wrong, says in (
        (np.full(count, 2), "flags are 0 or 1"),
        (np.full(count, -1), "flags are 0 or 1"),
        (np.zeros(count), "booleans"),
        (np.zeros(count - 1, bool), f"{count} rows"),
    ):
        with pytest.raises(medax.ArgumentError, match=says):
            medax.Labels(torus.triangulation, wrong)


def test_what_comes_out_is_read_only_and_no_copy(torus):
    points = torus.points
    for array in (points.coords, points.row_of_vertex, torus.labels.is_inner, torus.dual.facets.indices):
        assert not array.flags.writeable and array.flags.c_contiguous and not array.flags.owndata
        with pytest.raises(ValueError):
            array.flags.writeable = True
        with pytest.raises(ValueError):
            array[0] = 0
    assert points.coords.ctypes.data == points.coords.ctypes.data
    assert torus.triangulation.coords.ctypes.data == points.coords.ctypes.data
    assert torus.labels.is_inner.dtype == bool and points.coords.dtype == float
    empty = torus.triangulation.weights
    assert empty.shape == (0,) and not empty.flags.writeable
    assert medax.Complex(XYZ).edges.shape == (0, 2)


def test_results_are_input(torus):
    """What came out goes in again, without a copy."""
    assert view.floats(torus.points.coords, "xyz").ctypes.data == torus.points.coords.ctypes.data
    again = medax.Points(torus.points.coords)
    assert np.array_equal(again.coords, torus.points.coords)


@pytest.mark.parametrize("wrong", [XYZ[:, :2], XYZ[0], "text", XYZ.astype(complex)])
def test_queries_of_every_kind(torus, wrong):
    sites = medax.Sites.of(torus.cocone.surface)
    balls = medax.Balls.of(torus.medial.axis())
    for call in (
        torus.crust.poles.feature_size,
        torus.crust.sizes_at,
        torus.flow.at,
        torus.flow.orbits,
        torus.pair.locate,
        torus.cocone.surface.winding_numbers,
        sites.nearest,
        sites.is_inside,
        balls.distances,
    ):
        with pytest.raises(medax.ArgumentError):
            call(wrong)
        assert len(np.asarray(call(np.empty((0, 3)))[0] if call == torus.flow.orbits else call([]))) in (0, 2)


def test_nan_in_queries(torus):
    nan = np.array([[0, 0, 0], [0, np.nan, 0]])
    for call in (torus.crust.sizes_at, torus.flow.at, torus.cocone.surface.winding_numbers, torus.pair.locate):
        with pytest.raises(medax.MedaxError) as caught:
            call(nan)
        assert (caught.value.status, caught.value.index) == (medax.Status.NON_FINITE, 1)


def test_lengths_that_do_not_agree(torus):
    with pytest.raises(medax.ArgumentError, match="rows, not 3"):
        medax.Triangulation.regular(torus.points, [1.0, 2.0, 3.0])
    with pytest.raises(medax.MedaxError):
        medax.Medial.of(torus.dual, normals=np.ones((3, 3)))
    with pytest.raises(medax.ArgumentError):
        torus.pair.with_inner(XYZ)
    with pytest.raises(medax.ArgumentError):
        torus.crust.with_labels([0, 1])
    with pytest.raises(medax.MedaxError) as caught:
        medax.Balls(XYZ, [1.0])
    assert caught.value.status == medax.Status.MISMATCH


def test_attributes_go_in_and_out():
    given = {
        "vertex": {"radius": [1, 2.5, 3, 4, 5], "normal": XYZ, "label": np.arange(5), "signed": [-1, 0, 1, 2, 3]},
        medax.Element.FACE: {"kind": [7], "flag": [True]},
    }
    made = medax.Complex(XYZ, [[0, 1, 2]], attributes=given)
    assert made.attribute_count == len(made.attributes) == 6
    assert made.values("label").dtype == np.uint32 and made.values("signed").dtype == float
    assert np.array_equal(made.values("normal"), XYZ) and made.values("flag", "face").tolist() == [1]
    kind = made.attribute("face", "kind")
    assert (kind.value_type, kind.values.tolist()) == (medax.ValueType.U32, [7]) and "kind" in repr(kind)
    assert medax.Complex(XYZ, [[0, 1, 2]], attributes=made.attributes).attribute_count == 6
    with pytest.raises(medax.MedaxError):
        made.attribute("face", "radius")
    for wrong in (
        {"vertex": {"a": [1]}},
        {"vertex": {"a": ["x"] * 5}},
        {"a": [1] * 5},
        {"corner": {}, "body": {"a": [1]}},
    ):
        with pytest.raises(medax.MedaxError):
            medax.Complex(XYZ, attributes=wrong)


def test_every_array_of_a_property_is_read_only(torus):
    some = 0
    for made in (*vars(torus).values(), torus.crust.surface, torus.crust.poles):
        for name in dir(type(made)):
            if isinstance(getattr(type(made), name), property):
                value = getattr(made, name)
                if isinstance(value, np.ndarray):
                    some += 1
                    assert not value.flags.writeable, f"{type(made).__name__}.{name}"
    assert some > 40
