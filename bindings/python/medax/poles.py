# SPDX-License-Identifier: MIT OR Apache-2.0
"""Poles: the Voronoi vertices that stand for the medial axis."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _ffi
from ._ffi import Omit
from ._library import lib
from .complex import Complex
from .dual import Dual
from .handle import options, ref
from .job import How, Validated, build, run
from .points import Points
from .triangulation import Triangulation
from .view import Flags, Floats, Indices, Rows, floats, pointer

if TYPE_CHECKING:
    from typing_extensions import Unpack


class Poles(Validated, stem="poles"):
    """The poles of a sample, and their balls."""

    @classmethod
    def of(
        cls,
        dual: Dual,
        *,
        lambda_: Optional[float] = None,
        omit: Union[Omit, str, None] = None,
        **how: Unpack[How],
    ) -> Poles:
        """The poles of a sample from its Voronoi diagram. `omit` ("nothing", "side", "both") says what is left out
        where Voronoi cells are not long and thin for the spacing `lambda_`, in [0, pi/4), 0 to estimate it."""
        left_out = None if omit is None else Omit.of(omit)
        given = options(_ffi.medax_poles_options, **{"lambda": lambda_, "omit": left_out})
        made: Poles = build(cls, how, lib.medax_poles_build, ref(dual, Dual, "dual"), ctypes.byref(given))
        return made

    @classmethod
    def with_far_box(
        cls,
        points: Points,
        *,
        lambda_: Optional[float] = None,
        omit: Union[Omit, str, None] = None,
        **how: Unpack[How],
    ) -> Poles:
        """The poles of a sample with the far box: those from which a power crust is made. `omit` and `lambda_` as
        for `of`: "nothing", and 0 to estimate it."""
        left_out = None if omit is None else Omit.of(omit)
        given = options(_ffi.medax_poles_options, **{"lambda": lambda_, "omit": left_out})
        owner = ref(points, Points, "points")
        made: Poles = build(cls, how, lib.medax_poles_build_with_far_box, owner, ctypes.byref(given))
        return made

    @property
    def triangulation(self) -> Triangulation:
        """The triangulation whose cells' circumcentres the poles are."""
        return self._kept("triangulation", Triangulation)

    @property
    def has_far_box(self) -> bool:
        """Whether the poles were chosen with the far box."""
        return bool(self._get("has_far_box"))

    @property
    def balls(self) -> Floats:
        """The polar balls, (p, 4): centre and radius."""
        return self._view("balls", 4)

    @property
    def radii_squared(self) -> Floats:
        """(p,), in squared input units."""
        return self._view("radii_squared")

    @property
    def cell_of_pole(self) -> Indices:
        """The cell whose circumcentre each pole is, (p,)."""
        return self._view("cell_of_pole")

    @property
    def touches_far_box(self) -> Flags:
        """Whether the cell of each pole has a corner of the far box, (p,)."""
        return self._view("touches_far_box")

    @property
    def pole_of_sample(self) -> Indices:
        """The first and second pole of each sample, (n, 2); NONE where there is none."""
        return self._view("pole_of_sample", 2)

    @property
    def samples_on_balls(self) -> Rows:
        """One row a pole: the samples on its ball, ascending."""
        return self._rows("samples_on_balls")

    @property
    def object_angles(self) -> Floats:
        """The largest angle at each pole between two samples on its ball, (p,), in radians in [0, pi]."""
        return self._view("object_angles")

    @property
    def lambda_(self) -> float:
        """The lambda by which poles were left out."""
        return float(self._get("lambda"))

    @property
    def normals(self) -> Floats:
        """The unit vector from each sample towards its first pole, (n, 3)."""
        return self._view("normals", 3)

    def feature_size(self, queries: ArrayLike, **how: Unpack[How]) -> Floats:
        """The distance from each of some points (q, 3) to the nearest pole, (q,): an estimate of the local feature
        size."""
        xyz = floats(queries, "queries")
        distances, reference, call = np.empty(len(xyz)), self._ref, lib.medax_poles_feature_size
        run(how, lambda job: int(call(reference, pointer(xyz), len(xyz), job, pointer(distances))))
        return distances

    def complex(self) -> Complex:
        """The poles as vertices with `radius` and `object_angle`, for writing."""
        return self._kept("complex", Complex)

    def samples_complex(self) -> Complex:
        """The samples as vertices with `normal`, for writing."""
        return self._kept("samples_complex", Complex)

    def _told(self) -> str:
        return f": {len(self.balls)} poles of {len(self.pole_of_sample)} samples"
