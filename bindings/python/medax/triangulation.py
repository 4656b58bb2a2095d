# SPDX-License-Identifier: MIT OR Apache-2.0
"""Delaunay and regular triangulations, and their incidences."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, NamedTuple

import numpy as np
from numpy.typing import ArrayLike

from . import _ffi
from ._library import lib
from .complex import Complex
from .error import check
from .handle import Handle, options, ref, whole
from .job import How, Validated, build
from .points import Points
from .view import Floats, Indices, Rows, floats, pointer, vector

if TYPE_CHECKING:
    from typing_extensions import Unpack


class Ring(NamedTuple):
    """The cells round an edge, in order, and whether they close."""

    cells: Indices
    closed: bool


class Triangulation(Validated, stem="triangulation"):
    """A Delaunay or regular triangulation: finite cells and their neighbours."""

    @classmethod
    def delaunay(cls, points: Points, **how: Unpack[How]) -> Triangulation:
        """The Delaunay triangulation of points."""
        given = options(_ffi.medax_triangulation_options)
        made: Triangulation = build(
            cls, how, lib.medax_delaunay_build, ref(points, Points, "points"), ctypes.byref(given)
        )
        return made

    @classmethod
    def regular(cls, points: Points, weights: ArrayLike, **how: Unpack[How]) -> Triangulation:
        """The regular triangulation of weighted points: `weights` in squared input units, one per row of the points'
        input."""
        given, owner = options(_ffi.medax_triangulation_options), ref(points, Points, "points")
        heavy = floats(weights, "weights", 1, points.row_count)
        made: Triangulation = build(
            cls, how, lib.medax_regular_build, owner, pointer(heavy), len(heavy), ctypes.byref(given)
        )
        return made

    @property
    def points(self) -> Points:
        """The points."""
        return self._kept("points", Points)

    @property
    def coords(self) -> Floats:
        """The coordinates of the vertices, (n, 3)."""
        return self._view("coords", 3)

    @property
    def weights(self) -> Floats:
        """The weights of the vertices, (n,), in squared input units; no row for a Delaunay triangulation."""
        return self._view("weights")

    @property
    def row_of_vertex(self) -> Indices:
        """The row of the input that each vertex stands for, (n,)."""
        return self._view("row_of_vertex")

    @property
    def cells(self) -> Indices:
        """The finite cells, (m, 4) vertices, positively oriented."""
        return self._view("cells", 4)

    @property
    def neighbors(self) -> Indices:
        """(m, 4) cells: column i shares the facet opposite vertex i; NONE on the hull."""
        return self._view("neighbors", 4)

    @property
    def hidden(self) -> Indices:
        """The vertices that no cell uses, because their weights are too small."""
        return self._view("hidden")

    def locate(self, point: ArrayLike, hint_cell: int = 0) -> int:
        """A cell that holds a point (3 coordinates); NONE outside the hull."""
        xyz, cell = vector(point, "point"), ctypes.c_uint32()
        hint = whole(hint_cell, "hint_cell", 32)
        check(lib.medax_triangulation_locate(self._ref, pointer(xyz), hint, ctypes.byref(cell)))
        return cell.value

    def ring(self, cell: int, a: int, b: int) -> Ring:
        """The ring of cells round the edge `a` `b` of a cell, counterclockwise seen from `b` to `a`."""
        edge = [whole(value, name, 32) for value, name in ((cell, "cell"), (a, "a"), (b, "b"))]
        cells, count, closed = np.empty(32, np.uint32), ctypes.c_size_t(32), ctypes.c_uint32()
        while True:
            check(
                lib.medax_triangulation_ring(
                    self._ref, *edge, len(cells), pointer(cells), ctypes.byref(count), ctypes.byref(closed)
                )
            )
            if count.value <= len(cells):
                return Ring(cells[: count.value].copy(), bool(closed.value))
            cells = np.empty(count.value, np.uint32)

    def complex(self) -> Complex:
        """The vertices with `row` (and `weight`), and the cells as tetrahedra, for writing."""
        return self._kept("complex", Complex)

    def _told(self) -> str:
        return f": {len(self.coords)} vertices, {len(self.cells)} cells"


class Incidence(Handle, stem="incidence"):
    """The cells of each vertex of a triangulation, and its edges."""

    @classmethod
    def of(cls, triangulation: Triangulation, **how: Unpack[How]) -> Incidence:
        """The incidences of a triangulation."""
        owner = ref(triangulation, Triangulation, "triangulation")
        made: Incidence = build(cls, how, lib.medax_incidence_build, owner)
        return made

    @property
    def cells_of_vertex(self) -> Rows:
        """One row a vertex: the cells that have it, ascending."""
        return self._rows("cells_of_vertex")

    @property
    def edges(self) -> Indices:
        """(e, 2) vertices, the lesser one first; edges ascend."""
        return self._view("edges", 2)

    @property
    def cell_of_edge(self) -> Indices:
        """The least cell that has each edge, (e,)."""
        return self._view("cell_of_edge")

    def _told(self) -> str:
        return f": {len(self.edges)} edges"
