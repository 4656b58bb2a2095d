# SPDX-License-Identifier: MIT OR Apache-2.0
"""Power crusts, and what is made of them."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, NamedTuple, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _ffi
from ._ffi import Label, LabelRule, Omit
from ._library import lib
from .complex import Complex
from .handle import Handle, number, options, ref, whole
from .job import How, Validated, build, run
from .points import Points
from .poles import Poles
from .triangulation import Triangulation
from .view import Floats, Indices, floats, indices, pointer

if TYPE_CHECKING:
    from typing_extensions import Unpack


class Sizes(NamedTuple):
    """Two lengths at each of some points, (q,) each, in input units."""

    feature_size: Floats
    thickness: Floats


class PowerCrust(Validated, stem="power_crust"):
    """A power crust with all that it was made from."""

    @classmethod
    def of(
        cls,
        sample: Union[Points, Poles],
        *,
        deep: Optional[float] = None,
        lambda_: Optional[float] = None,
        round_poles: Optional[bool] = None,
        keep_shards: Optional[bool] = None,
        omit: Union[Omit, str, None] = None,
        label_rule: Union[LabelRule, str, None] = None,
        viewpoint: Optional[ArrayLike] = None,
        **how: Unpack[How],
    ) -> PowerCrust:
        """The power crust of points, or of poles with the far box.

        - `deep`: balls whose -cos of the angle between their spheres exceeds this lie on one side; 0.4.
        - `omit`, `lambda_`: which poles are left out, as for `Poles`; only for points.
        - `round_poles`: centres of balls are rounded to a grid, which is faster.
        - `keep_shards`: the vertices of the power diagram that are one sample stay apart.
        - `label_rule`: "auto", "spread" or "least_conflict".
        - `viewpoint`: where the scanner of a one-sided scan was, 3 coordinates.
        """
        given = options(
            _ffi.medax_power_crust_options,
            deep=deep,
            round_poles=round_poles,
            keep_shards=keep_shards,
            omit=None if omit is None else Omit.of(omit),
            label_rule=None if label_rule is None else LabelRule.of(label_rule),
            viewpoint=viewpoint,
            has_viewpoint=viewpoint is not None,
            **{"lambda": lambda_},
        )
        if isinstance(sample, Poles):
            function = lib.medax_power_crust_build_from_poles
        elif isinstance(sample, Points):
            function = lib.medax_power_crust_build
        else:
            raise TypeError(f"sample must be medax.Points or medax.Poles, not {type(sample).__name__}")
        made: PowerCrust = build(cls, how, function, sample._ref, ctypes.byref(given))
        return made

    @property
    def surface(self) -> Complex:
        """The surface: convex polygons that point out of the solid, with `inner_pole` and `outer_pole` of faces,
        `cell` and `sample` of vertices."""
        return self._kept("surface", Complex)

    def shape(self, label: Union[Label, str] = Label.INNER) -> Complex:
        """The power shape of one side ("inner", "outer"): an approximation of the medial axis, with `radius`, `pole`,
        `label` and `object_angle` of vertices, `flatness` of cells."""
        slot = Label.of(label)
        return self._kept("shape", Complex, slot)

    @property
    def poles(self) -> Poles:
        """The poles."""
        return self._kept("poles", Poles)

    @property
    def regular(self) -> Triangulation:
        """The regular triangulation of the polar balls."""
        return self._kept("regular", Triangulation)

    @property
    def labels(self) -> Indices:
        """The `Label` of each pole, (p,)."""
        return self._view("labels")

    def is_visible(self, pole: int) -> bool:
        """Whether a pole takes part in the power diagram."""
        return bool(lib.medax_power_crust_is_visible(self._ref, whole(pole, "pole", 32)))

    @property
    def unreached_count(self) -> int:
        """The number of poles that no label reached."""
        return int(self._get("unreached_count"))

    @property
    def forced_count(self) -> int:
        """The number of poles made outer because their power cells are unbounded."""
        return int(self._get("forced_count"))

    @property
    def conflict(self) -> float:
        """How much the labels contradict each other: 1e-3 and less where a sample is dense."""
        return float(self._get("conflict"))

    @property
    def is_settled(self) -> bool:
        """Whether labels were changed to lessen their conflict."""
        return bool(self._get("is_settled"))

    def poles_complex(self) -> Complex:
        """The poles as vertices with `radius`, `object_angle` and `label`, for writing."""
        return self._kept("poles_complex", Complex)

    def both_shapes(self) -> Complex:
        """The power shapes of both sides in one complex, the inner one first."""
        return self._kept("both_shapes", Complex)

    def with_labels(self, labels: ArrayLike, **how: Unpack[How]) -> PowerCrust:
        """The same poles with other labels, a `Label` for each pole."""
        given = indices(labels, "labels", 1, len(self.labels))
        made: PowerCrust = build(
            PowerCrust, how, lib.medax_power_crust_with_labels, self._ref, pointer(given), len(given)
        )
        return made

    def labelled_by_mesh(self, mesh: Complex, **how: Unpack[How]) -> PowerCrust:
        """The same poles, labelled by a mesh: inner are those round whose centres its faces wind."""
        made: PowerCrust = build(
            PowerCrust, how, lib.medax_power_crust_labelled_by_mesh, self._ref, ref(mesh, Complex, "mesh")
        )
        return made

    def offset(self, distance: float, **how: Unpack[How]) -> PowerCrust:
        """An approximate offset, in input units: outward for a positive distance."""
        made: PowerCrust = build(PowerCrust, how, lib.medax_power_crust_offset, self._ref, number(distance, "distance"))
        return made

    def scale_axis(self, side: Union[Label, str], factor: float, **how: Unpack[How]) -> Complex:
        """The scale axis of one side: the axis of the union of its balls, grown by a factor of at least 1."""
        made: Complex = build(
            Complex, how, lib.medax_power_crust_scale_axis, self._ref, Label.of(side), number(factor, "factor")
        )
        return made

    def simplify(
        self, *, epsilon: Optional[float] = None, delta: Optional[float] = None, **how: Unpack[How]
    ) -> Simplified:
        """Without unstable poles, those whose samples are all within `epsilon` of each other, and redundant ones, whose
        balls lie in larger ones grown by `delta`; input units."""
        given = options(_ffi.medax_simplify_options, epsilon=epsilon, delta=delta)
        made: Simplified = build(Simplified, how, lib.medax_power_crust_simplify, self._ref, ctypes.byref(given))
        return made

    def open(
        self, *, depth: Optional[float] = None, radius: Optional[float] = None, **how: Unpack[How]
    ) -> tuple[Complex, Complex]:
        """The surface without the faces that fill holes, and these: faces between balls that intersect deeper than
        `depth` (0.1) with radii above `radius` (0)."""
        given = options(_ffi.medax_hole_options, depth=depth, radius=radius)
        slots = Complex._slot(), Complex._slot()
        reference, call = self._ref, lib.medax_power_crust_open
        run(how, lambda job: int(call(reference, ctypes.byref(given), job, *map(ctypes.byref, slots))))
        return Complex._take(slots[0]), Complex._take(slots[1])

    def sizes_at(self, queries: ArrayLike, **how: Unpack[How]) -> Sizes:
        """The local feature size and the thickness at each of some points (q, 3). The thickness is 0 if no sample has
        an inner ball."""
        xyz = floats(queries, "queries")
        sizes = Sizes(np.empty(len(xyz)), np.empty(len(xyz)))
        reference, call = self._ref, lib.medax_power_crust_sizes_at
        outs = pointer(sizes.feature_size), pointer(sizes.thickness)
        run(how, lambda job: int(call(reference, pointer(xyz), len(xyz), job, *outs)))
        return sizes

    def samples_complex(self, **how: Unpack[How]) -> Complex:
        """The distinct samples as vertices with `feature_size`, `thickness` and `row`."""
        made: Complex = build(Complex, how, lib.medax_power_crust_samples_complex, self._ref)
        return made

    def with_sizes(self, complex: Complex, **how: Unpack[How]) -> Complex:
        """A complex with `feature_size` and `thickness` at its vertices: the surface, or another mesh of the thing."""
        other = ref(complex, Complex, "complex")
        made: Complex = build(Complex, how, lib.medax_power_crust_with_sizes, self._ref, other)
        return made

    def _told(self) -> str:
        return f": {len(self.labels)} poles, {int((self.labels == Label.INNER).sum())} inner"


class Simplified(Handle, stem="simplified"):
    """A simplified power crust, and what became of the poles."""

    @property
    def crust(self) -> PowerCrust:
        """The power crust of the poles that are left."""
        return self._kept("crust", PowerCrust)

    @property
    def epsilon(self) -> float:
        """The epsilon that was used, in input units."""
        return float(self._get("epsilon"))

    @property
    def delta(self) -> float:
        """The delta that was used, in input units."""
        return float(self._get("delta"))

    @property
    def unstable(self) -> Indices:
        """The poles that were unstable, ascending."""
        return self._view("unstable")

    @property
    def redundant(self) -> Indices:
        """(k, 2): a pole that was redundant, and the one that keeps its place."""
        return self._view("redundant", 2)

    def _told(self) -> str:
        return f": {len(self.unstable)} unstable poles, {len(self.redundant)} redundant ones"
