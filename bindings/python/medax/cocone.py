# SPDX-License-Identifier: MIT OR Apache-2.0
"""Cocone and Tight Cocone."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Optional

from . import _ffi
from ._library import lib
from .complex import Complex
from .dual import Dual
from .handle import options, ref
from .job import How, Validated, build
from .view import Flags

if TYPE_CHECKING:
    from typing_extensions import Unpack


class Cocone(Validated, stem="cocone"):
    """Cocone and Tight Cocone of a sample."""

    @classmethod
    def of(
        cls,
        dual: Dual,
        *,
        angle: Optional[float] = None,
        ratio: Optional[float] = None,
        normal_angle: Optional[float] = None,
        **how: Unpack[How],
    ) -> Cocone:
        """Both surfaces from the Voronoi diagram of a sample.

        - `angle`: how far from the tangent plane a Voronoi edge of the surface may pass, in radians; pi/8.
        - `ratio`: how many times as far as the corners of its tangent polygon the poles of a sample are that is dense
          enough; 1.2.
        - `normal_angle`: the largest angle between the pole vectors of such neighbours, in radians; pi/6.
        """
        given = options(_ffi.medax_cocone_options, angle=angle, ratio=ratio, normal_angle=normal_angle)
        made: Cocone = build(cls, how, lib.medax_cocone_build, ref(dual, Dual, "dual"), ctypes.byref(given))
        return made

    @property
    def surface(self) -> Complex:
        """The watertight surface of Tight Cocone: triangles that point out of the solid; vertices carry `sample`."""
        return self._kept("surface", Complex)

    @property
    def open_surface(self) -> Complex:
        """The surface of Cocone alone, which has a boundary where the sample is too sparse."""
        return self._kept("open_surface", Complex)

    @property
    def is_inner(self) -> Flags:
        """Whether each cell of the triangulation is inside the watertight surface, (m,)."""
        return self._view("is_inner")

    @property
    def is_undersampled(self) -> Flags:
        """Whether each sample is too sparse beside its neighbours, (n,)."""
        return self._view("is_undersampled")

    @property
    def is_well_sampled(self) -> Flags:
        """Whether the triangles round each sample are a disk that divides inside from outside, (n,)."""
        return self._view("is_well_sampled")

    @property
    def marked_count(self) -> int:
        """The number of cells that well sampled vertices mark as inner or outer."""
        return int(self._get("marked_count"))

    @property
    def used_count(self) -> int:
        """The number of samples that the watertight surface has as vertices."""
        return int(self._get("used_count"))

    def _told(self) -> str:
        return f": {int(self.is_inner.sum())} of {len(self.is_inner)} cells inner, {self.used_count} samples used"
