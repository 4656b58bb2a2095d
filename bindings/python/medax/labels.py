# SPDX-License-Identifier: MIT OR Apache-2.0
"""Which cells of a Delaunay triangulation lie in the solid."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Optional, Union

from numpy.typing import ArrayLike

from ._library import lib
from .cocone import Cocone
from .complex import Complex
from .crust import PowerCrust
from .dual import Dual
from .error import check
from .handle import Handle, ref
from .job import How, build
from .triangulation import Triangulation
from .view import Flags, flags, pointer

if TYPE_CHECKING:
    from typing_extensions import Unpack


class Labels(Handle, stem="labels"):
    """For each cell of a Delaunay triangulation whether it lies in the solid.

    Given ones: `is_inner` has a boolean, or 0 or 1, for each cell of the triangulation.
    """

    def __init__(self, triangulation: Triangulation, is_inner: ArrayLike) -> None:
        owner = ref(triangulation, Triangulation, "triangulation")
        given, slot = flags(is_inner, "is_inner", len(triangulation.cells)), self._slot()
        check(lib.medax_labels_create(owner, pointer(given), len(given), ctypes.byref(slot)))
        self._reference = self._take(slot)._reference

    @classmethod
    def of(
        cls,
        source: Union[Cocone, Dual],
        solid: Union[PowerCrust, Complex, None] = None,
        **how: Unpack[How],
    ) -> Labels:
        """Labels by Tight Cocone: `Labels.of(cocone)`; by a power crust of the same samples: `Labels.of(dual, crust)`;
        or by a mesh whose faces point out of the solid: `Labels.of(dual, mesh)`."""
        made: Optional[Labels] = None
        if isinstance(source, Cocone) and solid is None:
            made = build(cls, how, lib.medax_labels_of_cocone, source._ref)
        elif isinstance(source, Dual) and isinstance(solid, PowerCrust):
            made = build(cls, how, lib.medax_labels_of_crust, source._ref, solid._ref)
        elif isinstance(source, Dual) and isinstance(solid, Complex):
            made = build(cls, how, lib.medax_labels_of_mesh, source._ref, solid._ref)
        if made is None:
            raise TypeError("labels are of a Cocone, or of a Dual and a PowerCrust or a Complex")
        return made

    @property
    def triangulation(self) -> Triangulation:
        """The triangulation whose cells have the labels."""
        return self._kept("triangulation", Triangulation)

    @property
    def is_inner(self) -> Flags:
        """Whether each cell lies in the solid, (m,)."""
        return self._view("is_inner")

    @property
    def inner_count(self) -> int:
        """The number of cells in the solid."""
        return int(self._get("inner_count"))

    def disagreement(self, other: Labels) -> int:
        """In how many cells other labels of the same triangulation differ."""
        count = ctypes.c_size_t()
        check(lib.medax_labels_disagreement(self._ref, ref(other, Labels, "other"), ctypes.byref(count)))
        return count.value

    def _told(self) -> str:
        return f": {self.inner_count} of {len(self.is_inner)} cells inner"
