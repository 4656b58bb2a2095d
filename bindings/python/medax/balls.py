# SPDX-License-Identifier: MIT OR Apache-2.0
"""Unions of balls."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Optional

import numpy as np
from numpy.typing import ArrayLike

from . import _ffi
from ._library import lib
from .complex import Complex
from .handle import Handle, options, ref
from .job import How, build, run
from .view import Floats, floats, pointer

if TYPE_CHECKING:
    from typing_extensions import Unpack


class Balls(Handle, stem="balls"):
    """Balls, whose union is a solid: those of a medial axis, or any, by their centres (n, 3) and radii (n,)."""

    def __init__(self, centers: ArrayLike, radii: ArrayLike, **how: Unpack[How]) -> None:
        xyz, lengths = floats(centers, "centers"), floats(radii, "radii", 1)
        made = build(Balls, how, lib.medax_balls_create, pointer(xyz), len(xyz), pointer(lengths), len(lengths))
        self._reference = made._reference

    @classmethod
    def of(cls, complex: Complex, **how: Unpack[How]) -> Balls:
        """Balls round the vertices of a complex, which carry `radius`."""
        made: Balls = build(cls, how, lib.medax_balls_of_complex, ref(complex, Complex, "complex"))
        return made

    @property
    def count(self) -> int:
        """The number of balls."""
        return int(self._get("count"))

    def __len__(self) -> int:
        return self.count

    @property
    def centers(self) -> Floats:
        """(n, 3) coordinates."""
        return self._view("centers", 3)

    @property
    def radii(self) -> Floats:
        """(n,), in input units."""
        return self._view("radii")

    @property
    def bounds(self) -> Floats:
        """The smallest box that holds all balls, (2, 3): its least corner and its greatest."""
        return self._box()

    def distances(self, queries: ArrayLike, **how: Unpack[How]) -> Floats:
        """For each of some points (q, 3) the distance from the union; inside, negative, how deep it is in a ball."""
        xyz = floats(queries, "queries")
        found, reference, call = np.empty(len(xyz)), self._ref, lib.medax_balls_distances
        run(how, lambda job: int(call(reference, pointer(xyz), len(xyz), job, pointer(found))))
        return found

    def boundary(self, *, spacing: Optional[float] = None, **how: Unpack[How]) -> Complex:
        """The boundary of the union as a mesh of triangles, of which no point is farther than `spacing` from a vertex;
        by default a hundredth of the box's diagonal."""
        given = options(_ffi.medax_boundary_options, spacing=spacing)
        made: Complex = build(Complex, how, lib.medax_balls_boundary, self._ref, ctypes.byref(given))
        return made

    def _told(self) -> str:
        return f": {self.count} balls"
