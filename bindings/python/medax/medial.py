# SPDX-License-Identifier: MIT OR Apache-2.0
"""Medial axes straight from Voronoi diagrams."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Any, Optional, TypedDict, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _ffi
from ._ffi import MedialRule, Side
from ._library import lib
from .complex import Complex
from .dual import Dual
from .error import check
from .handle import clipped, options, ref
from .job import How, Validated, build, run
from .labels import Labels
from .view import Flags, Floats, Indices, floats, pointer

if TYPE_CHECKING:
    from typing_extensions import Unpack


class MedialFilter(TypedDict, total=False):
    """Thresholds on the facets: one must pass all of them.

    - `theta`: of the angle condition, in radians in [0, pi/2); pi/8.
    - `rho`: of the ratio condition; 8.
    - `object_angle`: the least object angle, in radians in [0, pi]; 0.
    - `lambda_`: the least lambda, in input units; 0.
    - `scale`: the least pairwise scale; 0 asks for nothing, anything else for a Medial with `scales`.
    - `clip`: two corners of a box to which the axis is clipped, so that it keeps its unbounded facets; none.
    - `rule`: "angle_or_ratio", "angle", "ratio" or "every"; "angle_or_ratio".
    - `side`: "inner", "outer" or "both"; "inner" with labels, else "both".
    """

    theta: Optional[float]
    rho: Optional[float]
    object_angle: Optional[float]
    lambda_: Optional[float]
    scale: Optional[float]
    clip: Optional[ArrayLike]
    rule: Union[MedialRule, str, None]
    side: Union[Side, str, None]


if TYPE_CHECKING:

    class FilterAndHow(MedialFilter, How, total=False):
        """A filter, and how to run it."""


class Medial(Validated, stem="medial"):
    """Every Voronoi facet of a sample with what decides whether it belongs to the medial axis."""

    @classmethod
    def of(
        cls,
        dual: Dual,
        labels: Optional[Labels] = None,
        *,
        normals: Optional[ArrayLike] = None,
        scales: Optional[bool] = None,
        **how: Unpack[How],
    ) -> Medial:
        """What decides, for the facets of a dual that has them. With labels the inner and the outer axis can be told
        apart. `normals`: those of the surface at the vertices, (n, 3), in place of the vectors to the poles. `scales`
        are calculated too, which filters by scale need, and which cost far more than all the rest."""
        owner = ref(dual, Dual, "dual")
        given = options(_ffi.medax_medial_options, scales=scales)
        kept = None
        if normals is not None:
            kept = floats(normals, "normals")
            given.normals, given.normal_count = pointer(kept), len(kept)
        inner = None if labels is None else ref(labels, Labels, "labels")
        made: Medial = build(cls, how, lib.medax_medial_build, owner, inner, ctypes.byref(given))
        del kept
        return made

    def axis(self, **filter: Unpack[FilterAndHow]) -> Complex:
        """The Voronoi facets that a filter (`MedialFilter`) lets pass, as convex polygons: the medial axis.

        Vertices carry `radius`, `cell` (and `scale`); faces `facet`, `samples`, `condition`, `object_angle` (the least
        and the largest on the face, in radians), `lambda` and `side`."""
        given, how = self._filter(dict(filter))
        made: Complex = build(Complex, how, lib.medax_medial_axis, self._ref, ctypes.byref(given))
        return made

    def selected(self, **filter: Unpack[FilterAndHow]) -> Indices:
        """The facets that a filter lets pass, ascending: unbounded ones and those without area as well."""
        given, how = self._filter(dict(filter))
        count = ctypes.c_size_t()
        facets: Indices = np.empty(len(self.sines), np.uint32)
        reference, call = self._ref, lib.medax_medial_selected
        outs = len(facets), pointer(facets), ctypes.byref(count)
        run(how, lambda job: int(call(reference, ctypes.byref(given), job, *outs)))
        some: Indices = facets[: count.value].copy()
        return some

    def _filter(self, given: dict[str, Any]) -> tuple[Any, How]:
        """The filter, and what else was given."""
        fields = {name: given.pop(name) for name in MedialFilter.__annotations__ if name in given}
        fields["lambda"] = fields.pop("lambda_", None)
        fields.update(clipped(fields.pop("clip", None)))
        if fields.get("rule") is not None:
            fields["rule"] = MedialRule.of(fields["rule"])
        side = fields.get("side")
        if side is None:
            # Without labels there are only axes of both sides.
            side = Side.INNER if self.labels is not None else Side.BOTH
        fields["side"] = Side.of(side)
        return options(_ffi.medax_medial_filter, **fields), given  # type: ignore[return-value]

    @property
    def dual(self) -> Dual:
        """The Voronoi diagram."""
        return self._kept("dual", Dual)

    @property
    def labels(self) -> Optional[Labels]:
        """The labels, if any were given."""
        slot = Labels._slot()
        check(lib.medax_medial_labels(self._ref, ctypes.byref(slot)))
        return Labels._take(slot) if slot else None

    @property
    def sines(self) -> Floats:
        """What the angle condition asks of each facet, (f, 2): sines in [0, 1], or minus infinity."""
        return self._view("sines", 2)

    @property
    def ratios(self) -> Floats:
        """What the ratio condition asks of each facet, (f, 2): not negative, or minus infinity."""
        return self._view("ratios", 2)

    @property
    def reaches(self) -> Floats:
        """The least and the largest distance of each facet's points from the middle of its dual edge, (f, 2)."""
        return self._view("reaches", 2)

    @property
    def least_cell(self) -> Indices:
        """For each cell the least with the same sphere, (m,)."""
        return self._view("least_cell")

    @property
    def scales(self) -> Floats:
        """The pairwise scale of each cell's ball, (m,); no row unless `scales` was asked for."""
        return self._view("scales")

    @property
    def umbrella_offsets(self) -> Indices:
        """Where the triangles of each sample's umbrella begin in `umbrella_rims`, (n + 1,)."""
        return self._view("umbrella_offsets")

    @property
    def umbrella_rims(self) -> Indices:
        """The two other vertices of each triangle of each umbrella, (t, 2)."""
        return self._view("umbrella_rims", 2)

    @property
    def umbrella_is_disk(self) -> Flags:
        """Whether each sample's umbrella is a disk, (n,)."""
        return self._view("umbrella_is_disk")

    @property
    def torn_count(self) -> int:
        """The number of samples whose umbrella is no disk."""
        return int(self._get("torn_count"))

    def _told(self) -> str:
        return f": {len(self.sines)} facets, {'with' if self.labels is not None else 'without'} labels"
