# SPDX-License-Identifier: MIT OR Apache-2.0
"""The flow of the distance to a sample, and its cores."""

from __future__ import annotations

import ctypes
import dataclasses
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _ffi
from ._ffi import Side
from ._library import lib
from .complex import Complex
from .dual import Dual
from .error import check
from .handle import options, ref, report_of, told, whole
from .job import How, Validated, build, run
from .labels import Labels
from .view import Floats, Indices, floats, indices, pointer

if TYPE_CHECKING:
    from typing_extensions import Unpack

#: Rows of `Flow.at`: simplex, driver, vector, distance, angle.
FLOW_POINT = np.dtype(_ffi.medax_flow_point)


class Simplex(NamedTuple):
    """A Delaunay simplex, or its dual, a face of the Voronoi diagram: dimension 0 to 3, and which one."""

    dimension: int
    number: int


class Orbits(NamedTuple):
    """Where some points flow: the row of the critical point where each orbit ends, NONE at infinity; and the orbits
    as loose edges, with `radius` of vertices, `orbit` and `end` of edges."""

    ends: Indices
    complex: Complex


@dataclasses.dataclass(frozen=True)
class CoreReport:
    """What became of the facets by which a core was to be extended."""

    taken: int
    of_surface: int
    elsewhere: int
    leaving: int
    unbounded: int


class Core(NamedTuple):
    """A core, and what became of the facets by which it was to be extended."""

    complex: Complex
    report: CoreReport


class Flow(Validated, stem="flow"):
    """The flow of the distance to a sample: its critical points, and where it goes."""

    @classmethod
    def of(cls, dual: Dual, labels: Labels, *, least_slope: Optional[float] = None, **how: Unpack[How]) -> Flow:
        """The flow of a sample, of its dual with facets; labels tell the inner from the outer medial axis.
        `least_slope` (0.5): above it a critical point belongs to the medial axis and not to the surface."""
        given = options(_ffi.medax_flow_options, least_slope=least_slope)
        inputs = ref(dual, Dual, "dual"), ref(labels, Labels, "labels")
        made: Flow = build(cls, how, lib.medax_flow_build, *inputs, ctypes.byref(given))
        return made

    @property
    def dual(self) -> Dual:
        """The Voronoi diagram."""
        return self._kept("dual", Dual)

    @property
    def labels(self) -> Labels:
        """The labels."""
        return self._kept("labels", Labels)

    @property
    def critical_count(self) -> int:
        """The number of critical points, samples included: c."""
        return int(self._get("critical_count"))

    @property
    def critical_simplices(self) -> Indices:
        """(c, 2): dimension and number of the simplex whose centre each critical point is."""
        return self._view("critical_simplices", 2)

    @property
    def critical_points(self) -> Floats:
        """Where they lie, (c, 3)."""
        return self._view("critical_points", 3)

    @property
    def critical_distances(self) -> Floats:
        """Their distances from the samples, (c,)."""
        return self._view("critical_distances")

    @property
    def critical_corners(self) -> Indices:
        """The samples nearest to each, (c, 4): one to four, then NONE."""
        return self._view("critical_corners", 4)

    @property
    def critical_slopes(self) -> Floats:
        """What decides whether each belongs to the surface, (c,), in [0, 1]."""
        return self._view("critical_slopes")

    @property
    def critical_shares(self) -> Floats:
        """The distance of each by that of the farthest Voronoi vertices of its samples, (c,), in [0, 1]."""
        return self._view("critical_shares")

    @property
    def critical_classes(self) -> Indices:
        """Where each belongs, (c,): a `CriticalClass`."""
        return self._view("critical_classes")

    def critical_row(self, simplex: tuple[int, int]) -> int:
        """The critical point of a simplex; NONE if it has none."""
        return int(lib.medax_flow_critical_row(self._ref, simplex_of(simplex)))

    def gap(self) -> tuple[float, float]:
        """The largest slope of the surface's critical points, and the least of the others."""
        found = np.empty(2)
        check(lib.medax_flow_gap(self._ref, pointer(found)))
        return float(found[0]), float(found[1])

    def critical_complex(self, **how: Unpack[How]) -> Complex:
        """The critical points but the samples as vertices, for writing."""
        made: Complex = build(Complex, how, lib.medax_flow_critical_complex, self._ref)
        return made

    @property
    def triangles(self) -> Indices:
        """The triangles of the triangulation, (t, 2): a cell of each, and the slot of the vertex opposite."""
        return self._view("triangles", 2)

    def driver_of_triangle(self, triangle: int) -> Simplex:
        """The simplex at whose centre the driver inside the triangle's Voronoi edge lies."""
        found = lib.medax_flow_driver_of_triangle(self._ref, whole(triangle, "triangle", 32))
        return Simplex(found.dimension, found.number)

    def driver_of_cell(self, cell: int) -> Simplex:
        """The simplex at whose centre the driver of the cell's Voronoi vertex lies."""
        found = lib.medax_flow_driver_of_cell(self._ref, whole(cell, "cell", 32))
        return Simplex(found.dimension, found.number)

    def at(self, queries: ArrayLike, **how: Unpack[How]) -> Any:
        """The flow at each of some points (q, 3): a record array of `simplex`, `driver` (q, 3), `vector` (q, 3),
        `distance` (in input units) and `angle` (in radians)."""
        xyz = floats(queries, "queries")
        found = np.zeros(len(xyz), FLOW_POINT)
        reference, call = self._ref, lib.medax_flow_at
        run(how, lambda job: int(call(reference, pointer(xyz), len(xyz), job, pointer(found))))
        return found.view(np.recarray)

    def orbits(self, queries: ArrayLike, **how: Unpack[How]) -> Orbits:
        """Where each of some points (q, 3) flows."""
        xyz = floats(queries, "queries")
        ends = np.empty(len(xyz), np.uint32)
        complex_ = build(Complex, how, lib.medax_flow_orbits, self._ref, pointer(xyz), len(xyz), after=(pointer(ends),))
        return Orbits(ends, complex_)

    def core(
        self,
        facets: Optional[ArrayLike] = None,
        *,
        side: Union[Side, str, None] = None,
        repair: Optional[bool] = None,
        **how: Unpack[How],
    ) -> Core:
        """The core of one `side` ("inner", "outer", "both"; "inner"), extended by Voronoi facets, such as
        `Medial.selected` has them. An outer core goes to infinity: nothing clips it. `repair` (True) gives
        the inner core the homotopy type of the labelled solid, however sparse the sample is."""
        given = options(_ffi.medax_core_options, side=None if side is None else Side.of(side), repair=repair)
        extending = indices(() if facets is None else facets, "facets")
        report = report_of(_ffi.medax_core_report)
        complex_ = build(
            Complex,
            how,
            lib.medax_flow_core,
            self._ref,
            pointer(extending),
            len(extending),
            ctypes.byref(given),
            after=(ctypes.byref(report),),
        )
        return Core(complex_, told(CoreReport, report))

    def closure(self, simplices: ArrayLike, **how: Unpack[How]) -> Complex:
        """What flows from the duals of some simplices, (s, 2) rows of dimension and number."""
        given = indices(simplices, "simplices", 2)
        made: Complex = build(Complex, how, lib.medax_flow_closure, self._ref, pointer(given), len(given))
        return made

    def _told(self) -> str:
        return f": {self.critical_count} critical points"


def simplex_of(value: tuple[int, int]) -> Any:
    """A simplex as the library takes it."""
    dimension, which = value
    return _ffi.medax_simplex(whole(dimension, "dimension", 32), whole(which, "number", 32))
