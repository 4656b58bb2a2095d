# SPDX-License-Identifier: MIT OR Apache-2.0
"""Voronoi and power diagrams."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Optional

from . import _ffi
from ._library import lib
from .handle import options, ref
from .job import How, Validated, build
from .triangulation import Triangulation
from .view import Floats, Indices, Rows

if TYPE_CHECKING:
    from typing_extensions import Unpack


class Dual(Validated, stem="dual"):
    """The Voronoi diagram of a Delaunay triangulation, or the power diagram of a regular one."""

    @classmethod
    def of(cls, triangulation: Triangulation, *, facets: Optional[bool] = None, **how: Unpack[How]) -> Dual:
        """Reads the dual off a triangulation. `facets` keeps the Voronoi facets, which Medial, Flow and Pair need."""
        given = options(_ffi.medax_dual_options, facets=facets)
        owner = ref(triangulation, Triangulation, "triangulation")
        made: Dual = build(cls, how, lib.medax_dual_build, owner, ctypes.byref(given))
        return made

    @property
    def triangulation(self) -> Triangulation:
        """The triangulation."""
        return self._kept("triangulation", Triangulation)

    @property
    def centers(self) -> Floats:
        """The Voronoi vertex of each cell, (m, 3): its circumcentre or orthocentre."""
        return self._view("centers", 3)

    @property
    def radii_squared(self) -> Floats:
        """The squared radius of each cell's sphere, (m,), in squared input units."""
        return self._view("radii_squared")

    @property
    def ray_facets(self) -> Indices:
        """(r, 2): the cell at whose centre each unbounded Voronoi edge begins, and the facet of it that it crosses."""
        return self._view("ray_facets", 2)

    @property
    def ray_directions(self) -> Floats:
        """(r, 3) unit vectors, outward."""
        return self._view("ray_directions", 3)

    @property
    def facets(self) -> Rows:
        """One row a Voronoi facet: the ring of its cells; no row unless `facets` was asked for."""
        return self._rows("facets")

    @property
    def facet_edges(self) -> Indices:
        """(f, 2) vertices: the edge to which each facet is dual."""
        return self._view("facet_edges", 2)

    @property
    def facet_rays(self) -> Indices:
        """(f, 2) rays of each facet; NONE twice for a bounded one."""
        return self._view("facet_rays", 2)

    def _told(self) -> str:
        return f": {len(self.centers)} Voronoi vertices, {len(self.facets)} facets"
