# SPDX-License-Identifier: MIT OR Apache-2.0
"""Handles and arrays that outlive each other in every order."""

import copy
import gc
import itertools
import pickle
import sys
import threading
import weakref

import numpy as np
import pytest

import medax


def made(xyz):
    """A chain of structures, and an array of each."""
    points = medax.Points(xyz)
    triangulation = medax.Triangulation.delaunay(points)
    dual = medax.Dual.of(triangulation, facets=True)
    kept = {
        "points": points,
        "triangulation": triangulation,
        "dual": dual,
        "coords": points.coords,
        "cells": triangulation.cells,
        "facets": dual.facets,
    }
    return kept, {name: sums(value) for name, value in kept.items()}


def sums(value):
    if isinstance(value, medax.Rows):
        return int(value.indices.sum(dtype=np.uint64)), len(value)
    if isinstance(value, medax.Points):
        return float(value.coords.sum()), value.count
    if isinstance(value, medax.Triangulation):
        return int(value.cells.sum(dtype=np.uint64)), float(value.points.coords.sum())
    if isinstance(value, medax.Dual):
        return float(value.centers.sum()), int(value.triangulation.cells.sum(dtype=np.uint64))
    return float(value.sum(dtype=float)), value.shape


def test_every_order_of_dropping(random_points):
    for order in itertools.permutations(["points", "triangulation", "dual", "coords", "cells", "facets"]):
        kept, expected = made(random_points[:60])
        for name in order:
            del kept[name]
            for left, value in kept.items():
                assert sums(value) == expected[left], (order, name, left)


def test_every_order_of_closing(random_points):
    for order in itertools.permutations(["points", "triangulation", "dual"]):
        kept, expected = made(random_points[:60])
        for name in order:
            kept[name].close()
            assert kept[name].closed and "closed" in repr(kept[name])
            for left in ("coords", "cells", "facets"):
                assert sums(kept[left]) == expected[left]
            with pytest.raises(ValueError, match="closed"):
                _ = kept[name]._ref
            kept[name].close()


def test_the_last_of_all_gives_the_memory_back(random_points):
    points = medax.Points(random_points)
    reference = weakref.ref(points._reference)
    array, part = points.coords, points.coords[3:5, 1]
    points.close()
    del points
    assert reference() is not None and array.sum() == np.sum(array)
    del array
    assert reference() is not None
    assert part.shape == (2,)
    del part
    gc.collect()
    assert reference() is None


def test_rows_and_attributes_keep_their_owner(torus):
    surface = medax.Cocone.of(torus.dual).surface
    reference = weakref.ref(surface._reference)
    row, attribute = surface.faces[0], surface.attribute("vertex", "sample")
    expected = row.tolist(), attribute.values.tolist()
    del surface
    gc.collect()
    assert (row.tolist(), attribute.values.tolist()) == expected
    del row, attribute
    assert reference() is None


def test_memory_does_not_grow():
    resource = pytest.importorskip("resource")
    xyz = np.random.default_rng(2).random((200_000, 3))

    def use():
        with medax.Points(xyz) as points:
            return float(points.coords[0, 0])

    for _ in range(5):
        use()
    before = resource.getrusage(resource.RUSAGE_SELF).ru_maxrss
    for _ in range(40):
        use()
    grown = (resource.getrusage(resource.RUSAGE_SELF).ru_maxrss - before) / (1 if sys.platform == "darwin" else 1024)
    # Forty times the points would be 250 MB and more.
    assert grown < 60


def test_with_and_clone(random_points):
    with medax.Points(random_points) as points:
        assert not points.closed
        others = points.clone(), copy.copy(points), copy.deepcopy(points)
    assert points.closed
    with pytest.raises(medax.ArgumentError, match="this Points is closed"):
        _ = points.count
    with pytest.raises(medax.ArgumentError, match="this Points is closed"):
        medax.Triangulation.delaunay(points)
    for other in others:
        assert other.count == len(random_points)
    assert others[0].coords.ctypes.data == others[1].coords.ctypes.data
    job = medax.Job(progress=print)
    assert job.clone()._on_progress is print


def test_what_cannot_be():
    with pytest.raises(TypeError, match="Dual is made by of"):
        medax.Dual()
    with pytest.raises(TypeError, match="made by delaunay"):
        medax.Triangulation(3)
    with pytest.raises(TypeError, match="pickled"):
        pickle.dumps(medax.Points([[0, 0, 0]]))
    with pytest.raises(TypeError, match="triangulation must be a medax.Triangulation, not Points"):
        medax.Dual.of(medax.Points([[0, 0, 0]]))
    with pytest.raises(AttributeError):
        medax.Points([[0, 0, 0]]).coords = 1


def test_a_handle_used_by_many_threads(torus):
    expected = torus.triangulation.cells.sum(dtype=np.uint64)
    wrong = []

    def use():
        for _ in range(20):
            dual = medax.Dual.of(torus.triangulation, threads=1)
            if dual.triangulation.cells.sum(dtype=np.uint64) != expected:
                wrong.append(dual)

    threads = [threading.Thread(target=use) for _ in range(6)]
    for thread in threads:
        thread.start()
    for thread in threads:
        thread.join()
    assert not wrong


def test_closing_during_a_build():
    """A call keeps what it was given, whatever becomes of the object meanwhile."""
    xyz = np.random.default_rng(4).random((100_000, 3))
    points = medax.Points(xyz)

    def close(fraction, stage):
        points.close()

    triangulation = medax.Triangulation.delaunay(points, progress=close)
    assert points.closed and triangulation.points.count == 100_000


def test_a_failed_constructor_leaves_nothing():
    for _ in range(3):
        with pytest.raises(medax.MedaxError):
            medax.Points([[np.nan, 0, 0]])
        with pytest.raises(medax.MedaxError):
            medax.Complex([[0, 0, 0]], [[0, 0, 5]])
    gc.collect()
