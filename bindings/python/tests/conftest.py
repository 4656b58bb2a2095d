# SPDX-License-Identifier: MIT OR Apache-2.0
"""What the tests share: a torus and what is made of it, and a count of the calls of each function."""

import collections
import os
import pathlib

import numpy as np
import pytest

import medax
from medax import _ffi, _library

REPOSITORY = pathlib.Path(__file__).resolve().parents[3]
# These two are called when the library is loaded.
CALLS = collections.Counter(["medax_version", "medax_version_string"])


def counted(name, function):
    def call(*arguments):
        CALLS[name] += 1
        return function(*arguments)

    return call


# `make test-python` sets this: what is tested is the wheel.
if os.environ.get("MEDAX_TEST_INSTALLED"):
    assert REPOSITORY / "bindings" not in pathlib.Path(medax.__file__).resolve().parents, medax.__file__
    assert pathlib.Path(_library.lib._name).parent == pathlib.Path(medax.__file__).parent, _library.lib._name

for _name in _ffi.FUNCTIONS:
    setattr(_library.lib, _name, counted(_name, getattr(_library.lib, _name)))


def pytest_collection_modifyitems(items):
    """The test of which functions were called comes last, and only after all others."""
    last = [item for item in items if item.name == "test_every_function_was_called"]
    files = {item.path.name for item in items}
    there = {path.name for path in pathlib.Path(__file__).parent.glob("test_*.py")}
    items[:] = [item for item in items if item not in last] + (last if files == there else [])


class Torus:
    """A torus: core circle of radius 1, tube of radius 0.4."""

    def __init__(self):
        self.samples = medax.Samples.of("torus", spacing=0.2)
        self.points = self.samples.points()
        self.triangulation = medax.Triangulation.delaunay(self.points)
        self.dual = medax.Dual.of(self.triangulation, facets=True)
        self.cocone = medax.Cocone.of(self.dual)
        self.labels = medax.Labels.of(self.cocone)
        self.crust = medax.PowerCrust.of(self.points)
        self.medial = medax.Medial.of(self.dual, self.labels)
        self.flow = medax.Flow.of(self.dual, self.labels)
        self.pair = medax.Pair.voronoi(self.dual, self.labels)


@pytest.fixture(scope="session")
def torus():
    return Torus()


@pytest.fixture
def cube():
    """The unit cube, of six quadrilaterals that point out."""
    corners = np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], float)
    faces = [[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]]
    return medax.Complex(corners, faces)


@pytest.fixture(scope="session")
def random_points():
    return np.random.default_rng(1).random((1000, 3))
