# SPDX-License-Identifier: MIT OR Apache-2.0
"""Samples of built-in shapes and of meshes."""

from __future__ import annotations

import ctypes
import dataclasses
from typing import TYPE_CHECKING, Optional, Union

from . import _ffi
from ._ffi import Shape
from ._library import lib
from .complex import Complex
from .error import check
from .handle import Handle, options, report_of, told
from .job import How, build
from .points import Points
from .view import Floats

if TYPE_CHECKING:
    from typing_extensions import Unpack


@dataclasses.dataclass(frozen=True)
class ShapeFacts:
    """What is known of a shape: a box that holds it, the spacing that its samples have by default, its genus, the
    number of pieces of its surface, and whether that has a tangent plane everywhere."""

    min: tuple[float, float, float]
    max: tuple[float, float, float]
    spacing: float
    genus: int
    components: int
    smooth: bool


def describe(shape: Union[Shape, str]) -> ShapeFacts:
    """What is known of a shape, such as "torus"."""
    facts = report_of(_ffi.medax_shape_facts)
    check(lib.medax_shape_describe(Shape.of(shape), ctypes.byref(facts)))
    return told(ShapeFacts, facts)


class Samples(Handle, stem="samples"):
    """Samples of a surface with its normals."""

    @classmethod
    def of(
        cls,
        surface: Union[Shape, str, Complex],
        *,
        spacing: Optional[float] = None,
        density: Optional[float] = None,
        noise: Optional[float] = None,
        seed: Optional[int] = None,
        **how: Unpack[How],
    ) -> Samples:
        """Samples of a built-in shape ("torus", "box", "capsule", "ellipsoid", "trefoil", "genus3", "bracket",
        "sphere") or of a mesh.

        - `spacing`: no two samples are nearer than this, in input units; by default that of the shape, or a hundredth
          of the diagonal of a mesh's box.
        - `density`: instead of the spacing, about how many samples a unit of area gets.
        - `noise`: the standard deviation along the normal, in input units; 0.
        - `seed`: which of the many samples; 0.
        """
        given = options(_ffi.medax_sample_options, spacing=spacing, density=density, noise=noise, seed=seed)
        made: Samples
        if isinstance(surface, Complex):
            made = build(cls, how, lib.medax_samples_build_from_mesh, surface._ref, ctypes.byref(given))
        else:
            made = build(cls, how, lib.medax_samples_build, Shape.of(surface), ctypes.byref(given))
        return made

    @property
    def coords(self) -> Floats:
        """The samples, (n, 3)."""
        return self._view("coords", 3)

    @property
    def normals(self) -> Floats:
        """The unit normals of the surface there, (n, 3), outward."""
        return self._view("normals", 3)

    @property
    def spacing(self) -> float:
        """The spacing, in input units."""
        return float(self._get("spacing"))

    @property
    def area(self) -> float:
        """The area of the surface, in squared input units."""
        return float(self._get("area"))

    def __len__(self) -> int:
        return len(self.coords)

    def complex(self) -> Complex:
        """The samples as vertices with the attribute `normal`."""
        return self._kept("complex", Complex)

    def points(self, *, skip_non_finite: Optional[bool] = None, **how: Unpack[How]) -> Points:
        """The samples as points. `skip_non_finite` (False) leaves out rows with a NaN or an infinity."""
        return Points(self.coords, skip_non_finite=skip_non_finite, **how)

    def _told(self) -> str:
        return f": {len(self)} samples, {self.spacing:.6g} apart"
