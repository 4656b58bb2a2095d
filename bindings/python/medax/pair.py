# SPDX-License-Identifier: MIT OR Apache-2.0
"""Pair-meshes, and their half-faces."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Optional, TypeVar, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _ffi
from ._ffi import PairElement
from ._library import lib
from .complex import Complex
from .dual import Dual
from .error import ArgumentError, check
from .handle import Handle, number, options, ref, whole
from .job import How, Validated, build, run
from .labels import Labels
from .view import Floats, Indices, Rows, floats, pointer

if TYPE_CHECKING:
    from typing_extensions import Unpack

D = TypeVar("D", bound=np.generic)

#: Rows of `Pair.locate`: element, piece, weights, t.
PLACE = np.dtype(_ffi.medax_place)


class Pair(Validated, stem="pair"):
    """A solid between an inner structure and its boundary, in pyramids and tetrahedra."""

    @classmethod
    def voronoi(cls, dual: Dual, labels: Labels, **how: Unpack[How]) -> Pair:
        """Between the inner part of a Voronoi diagram, a dual with facets, and the surface between inner and outer
        cells."""
        inputs = ref(dual, Dual, "dual"), ref(labels, Labels, "labels")
        made: Pair = build(cls, how, lib.medax_pair_voronoi, *inputs)
        return made

    def onto(
        self, part: Complex, *, subdivide: Optional[bool] = None, exact: Optional[bool] = None, **how: Unpack[How]
    ) -> Pair:
        """The pair-mesh of the part of the inner structure in which a complex of Voronoi faces lies, such as a medial
        axis or a core. `subdivide` divides triangles of the boundary where that is needed; `exact` fails where
        anything stays that was not asked for."""
        given = options(_ffi.medax_pair_onto_options, subdivide=subdivide, exact=exact)
        asked = ref(part, Complex, "part")
        made: Pair = build(Pair, how, lib.medax_pair_onto, self._ref, asked, ctypes.byref(given))
        return made

    @property
    def missing(self) -> int:
        """How many Voronoi facets and edges that `onto` asked for the inner structure does not have."""
        return int(self._get("missing"))

    def reasons(self) -> Indices:
        """Why each inner face is there: a `PairReason`."""
        found = np.empty(len(self.inner_faces), np.uint32)
        check(lib.medax_pair_reasons(self._ref, pointer(found)))
        return found

    def element_count(self, kind: Union[PairElement, str, None] = None) -> int:
        """The number of elements, or of those of one kind."""
        return int(lib.medax_pair_element_count(self._ref, 0 if kind is None else PairElement.of(kind)))

    @property
    def boundary_vertices(self) -> Floats:
        """(n, 3) coordinates."""
        return self._view("boundary_vertices", 3)

    @property
    def boundary_samples(self) -> Indices:
        """The sample that each vertex of the boundary is, (n,); NONE for one by which triangles were divided."""
        return self._view("boundary_samples")

    @property
    def inner_vertices(self) -> Floats:
        """(m, 3) coordinates."""
        return self._view("inner_vertices", 3)

    @property
    def inner_cells(self) -> Indices:
        """The cell of which each inner vertex is the Voronoi vertex, (m,), or NONE."""
        return self._view("inner_cells")

    @property
    def voronoi_vertices(self) -> Floats:
        """Where each inner vertex would be, had nothing been turned inside out, (m, 3)."""
        return self._view("voronoi_vertices", 3)

    @property
    def inner_faces(self) -> Rows:
        """One row a face of the inner structure: inner vertices."""
        return self._rows("inner_faces")

    @property
    def nodes(self) -> Indices:
        """(k, 2): a vertex of the boundary, an inner vertex."""
        return self._view("nodes", 2)

    @property
    def rings(self) -> Rows:
        """One row an element: its nodes."""
        return self._rows("rings")

    @property
    def removed(self) -> Indices:
        """The samples inside the solid, which were removed, ascending."""
        return self._view("removed")

    @property
    def enclosed_volume(self) -> float:
        """The volume that the boundary encloses, in cubed input units."""
        return float(self._get("enclosed_volume"))

    def volumes(self, **how: Unpack[How]) -> Floats:
        """The volume of each element; less than 0 where one is turned inside out."""
        return self._each("volumes", np.empty(self.element_count()), how)

    def centroids(self, **how: Unpack[How]) -> Floats:
        """The centroid of each element, (e, 3)."""
        return self._each("centroids", np.empty((self.element_count(), 3)), how)

    def shells(self, **how: Unpack[How]) -> Indices:
        """The closed surface that each element is a face of for every t."""
        return self._each("shells", np.empty(self.element_count(), np.uint32), how)

    def folded(self, **how: Unpack[How]) -> Indices:
        """The elements that are turned inside out."""
        count = ctypes.c_size_t()
        found = self._each("folded", np.empty(self.element_count(), np.uint32), how, ctypes.byref(count))
        some: Indices = found[: count.value].copy()
        return some

    def _each(self, name: str, out: NDArray[D], how: How, *more: Any) -> NDArray[D]:
        reference, call = self._ref, getattr(lib, "medax_pair_" + name)
        run(how, lambda job: int(call(reference, job, pointer(out), *more)))
        return out

    def iso_surface(self, t: float, **how: Unpack[How]) -> Complex:
        """The surface on which each node is at `t` on its way from the inner structure (0) to the boundary (1)."""
        made: Complex = build(Complex, how, lib.medax_pair_iso_surface, self._ref, number(t, "t"))
        return made

    def solid(self, **how: Unpack[How]) -> Complex:
        """The elements as volume cells, with `kind` and `volume`; vertices carry `t` and `sample`."""
        made: Complex = build(Complex, how, lib.medax_pair_solid, self._ref)
        return made

    def boundary(self, **how: Unpack[How]) -> Complex:
        """The boundary: triangles that point out of the solid."""
        made: Complex = build(Complex, how, lib.medax_pair_boundary, self._ref)
        return made

    def inner(self, **how: Unpack[How]) -> Complex:
        """The inner structure: its faces, and the edges that belong to none."""
        made: Complex = build(Complex, how, lib.medax_pair_inner, self._ref)
        return made

    def locate(self, queries: ArrayLike, **how: Unpack[How]) -> Any:
        """The place of each of some points (q, 3): a record array of `element` (NONE outside the solid), `piece`,
        `weights` (q, 4) and `t`."""
        xyz = floats(queries, "queries")
        found = np.zeros(len(xyz), PLACE)
        reference, call = self._ref, lib.medax_pair_locate
        run(how, lambda job: int(call(reference, pointer(xyz), len(xyz), job, pointer(found))))
        return found.view(np.recarray)

    def positions(self, places: ArrayLike) -> Floats:
        """The points at some places, as `locate` has them, (q, 3)."""
        given = np.asarray(places)
        if given.dtype.names != PLACE.names or given.ndim != 1:
            raise ArgumentError(f"places must be rows of {', '.join(PLACE.names or ())}, as of Pair.locate")
        given = np.ascontiguousarray(given, PLACE)
        xyz = np.empty((len(given), 3))
        check(lib.medax_pair_positions(self._ref, pointer(given), len(given), pointer(xyz)))
        return xyz

    def piece(self, element: int, piece: int) -> Indices:
        """The four corners of a tetrahedron of an element: vertices of the boundary count first, then inner ones."""
        corners = np.empty(4, np.uint32)
        which = whole(element, "element", 32), whole(piece, "piece", 32)
        check(lib.medax_pair_piece(self._ref, *which, pointer(corners)))
        return corners

    def with_inner(self, places: ArrayLike, **how: Unpack[How]) -> Pair:
        """With the inner vertices at other places, (m, 3), which the boundary follows."""
        xyz = floats(places, "places", 3, len(self.inner_vertices))
        made: Pair = build(Pair, how, lib.medax_pair_with_inner, self._ref, pointer(xyz), len(xyz))
        return made

    def with_boundary(self, places: ArrayLike, **how: Unpack[How]) -> Pair:
        """With the boundary at other places, (n, 3), which the inner vertices follow."""
        xyz = floats(places, "places", 3, len(self.boundary_vertices))
        made: Pair = build(Pair, how, lib.medax_pair_with_boundary, self._ref, pointer(xyz), len(xyz))
        return made

    def _told(self) -> str:
        return f": {self.element_count()} elements, {len(self.nodes)} nodes"


class HalfFaces(Handle, stem="half_faces"):
    """Every face of every element of a pair-mesh, seen from inside that element, with its edges."""

    @classmethod
    def of(cls, pair: Pair, **how: Unpack[How]) -> HalfFaces:
        """The half-faces of a pair-mesh."""
        made: HalfFaces = build(cls, how, lib.medax_half_faces_build, ref(pair, Pair, "pair"))
        return made

    @property
    def of_element(self) -> Indices:
        """Where the half-faces of each element begin, one entry more than elements."""
        return self._view("of_element")

    @property
    def offsets(self) -> Indices:
        """Where the half-edges of each half-face begin, one entry more than half-faces."""
        return self._view("offsets")

    @property
    def duals(self) -> Indices:
        """The half-face on the other side of each; NONE on the boundary."""
        return self._view("duals")

    @property
    def origins(self) -> Indices:
        """The vertex at which each half-edge begins."""
        return self._view("origins")

    @property
    def opposites(self) -> Indices:
        """The half-edge on the other side of each edge within the element."""
        return self._view("opposites")

    @property
    def partners(self) -> Indices:
        """The half-edge of the same edge in the dual half-face; NONE where there is none."""
        return self._view("partners")

    def _told(self) -> str:
        return f": {len(self.duals)} half-faces, {len(self.origins)} half-edges"
