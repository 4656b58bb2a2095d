# SPDX-License-Identifier: MIT OR Apache-2.0
"""Plane figures."""

from __future__ import annotations

import ctypes
import dataclasses
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _ffi
from ._ffi import Crossings
from ._library import lib
from .error import ArgumentError, check
from .handle import options, path_of, report_of, text_of, told
from .job import How, Validated, build
from .points import Path
from .view import Floats, Indices, Rows, floats, pointer

if TYPE_CHECKING:
    from typing_extensions import Unpack


@dataclasses.dataclass(frozen=True)
class Normalised:
    """What was changed and accepted when a figure was made."""

    closing_vertices: int
    repeated_vertices: int
    turned_rings: int
    crossings: int
    misplaced: int


def _chained(chains: Iterable[ArrayLike], name: str) -> tuple[Floats, Indices]:
    """Chains of points of the plane one after the other, and where each begins."""
    arrays = [floats(chain, f"{name}[{number}]", 2) for number, chain in enumerate(chains)]
    offsets = np.cumsum([0, *map(len, arrays)]).astype(np.uint32)
    return np.concatenate(arrays) if arrays else np.empty((0, 2)), offsets


class Figure(Validated, stem="figure"):
    """Polygons with holes, open polylines, points and circles in the plane.

    - `polygons`: each a list of rings (k, 2), the outer one first, then the holes; which way they turn is the same.
    - `polylines`: each (k, 2), open.
    - `points`: (p, 2). `circles`: (c, 3), centre and radius.
    - `crossings`: "refuse" makes curves that cross or touch an error; "accept" counts them.
    """

    def __init__(
        self,
        polygons: Sequence[Sequence[ArrayLike]] = (),
        polylines: Sequence[ArrayLike] = (),
        points: ArrayLike = (),
        circles: ArrayLike = (),
        *,
        crossings: Union[Crossings, str, None] = None,
        **how: Unpack[How],
    ) -> None:
        polygons = [list(polygon) for polygon in polygons]
        for number, polygon in enumerate(polygons):
            if not polygon or np.ndim(polygon[0]) != 2:
                raise ArgumentError(f"polygons[{number}] must be a list of rings of shape (k, 2)")
        ring_vertices, ring_offsets = _chained((ring for polygon in polygons for ring in polygon), "rings")
        polygon_offsets = np.cumsum([0, *map(len, polygons)]).astype(np.uint32)
        polyline_vertices, polyline_offsets = _chained(polylines, "polylines")
        loose, discs = floats(points, "points", 2), floats(circles, "circles")
        parts = options(
            _ffi.medax_figure_parts,
            ring_vertices=pointer(ring_vertices),
            ring_vertex_count=len(ring_vertices),
            ring_offsets=pointer(ring_offsets),
            ring_count=len(ring_offsets) - 1,
            polygon_offsets=pointer(polygon_offsets),
            polygon_count=len(polygon_offsets) - 1,
            polyline_vertices=pointer(polyline_vertices),
            polyline_vertex_count=len(polyline_vertices),
            polyline_offsets=pointer(polyline_offsets),
            polyline_count=len(polyline_offsets) - 1,
            points=pointer(loose),
            point_count=len(loose),
            circles=pointer(discs),
            circle_count=len(discs),
            crossings=None if crossings is None else Crossings.of(crossings),
        )
        self._reference = build(Figure, how, lib.medax_figure_create, ctypes.byref(parts))._reference

    @classmethod
    def read(
        cls,
        path: Path,
        *,
        feature_name: Optional[str] = None,
        feature_number: Optional[int] = None,
        crossings: Union[Crossings, str, None] = None,
        **how: Unpack[How],
    ) -> Figure:
        """A figure of a GeoJSON file: of all features, of those of a name, or of one by its number.

        - `feature_name`: the `id`, or a property `name`, `NAME`, `glyph` or `id`; any.
        - `feature_number`: from 0, not together with a name; any.
        - `crossings`: as for the class; "refuse".
        """
        given = options(
            _ffi.medax_figure_read_options,
            feature_name=None if feature_name is None else text_of(feature_name, "feature_name"),
            feature_number=feature_number,
            crossings=None if crossings is None else Crossings.of(crossings),
        )
        made: Figure = build(cls, how, lib.medax_figure_read, path_of(path), ctypes.byref(given))
        return made

    @property
    def vertices(self) -> Floats:
        """The vertices, chain by chain, (v, 2)."""
        return self._view("vertices", 2)

    @property
    def chains(self) -> Rows:
        """One row a chain: its vertices, numbers in succession."""
        return self._rows("chains")

    @property
    def kinds(self) -> Indices:
        """What each chain is: a `ChainKind`."""
        return self._view("kinds")

    @property
    def parts_of_chains(self) -> Indices:
        """The part of each chain: a polygon, a polyline or a point."""
        return self._view("parts_of_chains")

    @property
    def circles(self) -> Floats:
        """(c, 3): the centre's coordinates and the radius."""
        return self._view("circles", 3)

    @property
    def part_count(self) -> int:
        """The number of polygons, polylines, points and circles."""
        return int(self._get("part_count"))

    @property
    def bounds(self) -> Floats:
        """The smallest box round all, (2, 2): its least corner and its greatest."""
        return self._box(2)

    @property
    def normalised(self) -> Normalised:
        """What was changed and accepted when the figure was made."""
        report = report_of(_ffi.medax_normalised)
        check(lib.medax_figure_normalised(self._ref, ctypes.byref(report)))
        return told(Normalised, report)

    def _told(self) -> str:
        return f": {self.part_count} parts, {len(self.vertices)} vertices, {len(self.circles)} circles"
