# SPDX-License-Identifier: MIT OR Apache-2.0
"""Unstable flow complexes."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any

import numpy as np
from numpy.typing import ArrayLike

from ._library import lib
from .complex import Complex
from .error import check
from .flow import Flow, simplex_of
from .handle import ref
from .job import How, Validated, build, run
from .view import Floats, Indices, Rows, indices, pointer

if TYPE_CHECKING:
    from typing_extensions import Unpack


class FlowComplex(Validated, stem="flow_complex"):
    """The unstable flow complex of a sample, and its flow DAG.

    Elements are given and told as rows of two: an `Element` (vertex, edge or face), and which one of its kind.
    """

    @classmethod
    def of(cls, flow: Flow, **how: Unpack[How]) -> FlowComplex:
        """All of it."""
        made: FlowComplex = build(cls, how, lib.medax_flow_complex_build, ref(flow, Flow, "flow"))
        return made

    @property
    def flow(self) -> Flow:
        """The flow."""
        return self._kept("flow", Flow)

    @property
    def vertex_count(self) -> int:
        """The number of vertices: the Voronoi vertices, then `points`."""
        return int(self._get("vertex_count"))

    @property
    def points(self) -> Floats:
        """The vertices that come after the Voronoi vertices, (k, 3)."""
        return self._view("points", 3)

    @property
    def triangle_of_point(self) -> Indices:
        """The triangle on whose Voronoi edge each of the points lies, (k,)."""
        return self._view("triangle_of_point")

    @property
    def edges(self) -> Indices:
        """(e, 2) vertices; NONE at infinity."""
        return self._view("edges", 2)

    @property
    def triangle_of_edge(self) -> Indices:
        """The triangle whose Voronoi edge each of the first edges is a part of; those beyond are cuts."""
        return self._view("triangle_of_edge")

    @property
    def faces(self) -> Rows:
        """One row a face: its vertices; NONE at infinity."""
        return self._rows("faces")

    @property
    def face_edges(self) -> Rows:
        """One row a face: its edges, each where it begins."""
        return self._rows("face_edges")

    @property
    def faces_of_facet(self) -> Indices:
        """Where the faces of each Voronoi facet begin, one entry more than facets."""
        return self._view("faces_of_facet")

    @property
    def edge_of_vertex(self) -> Indices:
        """The edge into which each vertex flows; NONE for critical points."""
        return self._view("edge_of_vertex")

    @property
    def face_of_edge(self) -> Indices:
        """The face into which each edge flows; NONE for those that flow along themselves."""
        return self._view("face_of_edge")

    def elements_of(self, simplex: tuple[int, int]) -> Indices:
        """The elements of a Voronoi facet, edge or vertex, the dual of a simplex: (k, 2)."""
        given, count = simplex_of(simplex), ctypes.c_size_t()
        found: Indices = np.empty((8, 2), np.uint32)
        call = lib.medax_flow_complex_elements_of
        check(call(self._ref, given, len(found), pointer(found), ctypes.byref(count)))
        if count.value > len(found):
            found = np.empty((count.value, 2), np.uint32)
            check(call(self._ref, given, len(found), pointer(found), ctypes.byref(count)))
        some: Indices = found[: count.value].copy()
        return some

    def closure(self, elements: ArrayLike, **how: Unpack[How]) -> Indices:
        """The elements that can be reached from some, these included: (k, 2)."""
        return self._reached(lib.medax_flow_complex_closure, elements, how)

    def upstream(self, elements: ArrayLike, **how: Unpack[How]) -> Indices:
        """The elements from which some can be reached, these included: (k, 2)."""
        return self._reached(lib.medax_flow_complex_upstream, elements, how)

    def _reached(self, call: Any, elements: ArrayLike, how: How) -> Indices:
        given = indices(elements, "elements", 2)
        found: Indices = np.empty((self.vertex_count + len(self.edges) + len(self.faces), 2), np.uint32)
        reference, count = self._ref, ctypes.c_size_t()
        outs = len(found), pointer(found), ctypes.byref(count)
        run(how, lambda job: int(call(reference, pointer(given), len(given), job, *outs)))
        some: Indices = found[: count.value].copy()
        return some

    def critical_sets(self, elements: ArrayLike, **how: Unpack[How]) -> Rows:
        """The critical points in whose unstable manifolds each of some elements lies: a row each."""
        given = indices(elements, "elements", 2)
        offsets, rows = np.empty(len(given) + 1, np.uint32), np.empty(16 * len(given) + 1, np.uint32)
        reference, count = self._ref, ctypes.c_size_t()
        call = lib.medax_flow_complex_critical_sets

        def find(job: Any) -> int:
            return int(
                call(
                    reference,
                    pointer(given),
                    len(given),
                    job,
                    pointer(offsets),
                    len(rows),
                    pointer(rows),
                    ctypes.byref(count),
                )
            )

        run(how, find)
        if count.value > len(rows):
            rows = np.empty(count.value, np.uint32)
            run(how, find)
        return Rows(offsets, rows[: count.value].copy())

    def complex(self, **how: Unpack[How]) -> Complex:
        """All that is bounded."""
        made: Complex = build(Complex, how, lib.medax_flow_complex_complex, self._ref)
        return made

    def _told(self) -> str:
        return f": {self.vertex_count} vertices, {len(self.edges)} edges, {len(self.faces)} faces"
