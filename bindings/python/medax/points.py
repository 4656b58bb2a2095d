# SPDX-License-Identifier: MIT OR Apache-2.0
"""Sets of points."""

from __future__ import annotations

import ctypes
import os
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike

from . import _ffi
from ._library import lib
from .handle import Handle, options, path_of
from .io import Warnings
from .job import How, build
from .view import Floats, Indices, _array, _shaped, pointer, real

if TYPE_CHECKING:
    from typing_extensions import Unpack

Path = Union[str, bytes, os.PathLike[Any]]


class Points(Handle, stem="points"):
    """Distinct points in spatial order, with maps from and to the input's rows.

    `xyz`: an array of shape (n, 3) of coordinates in any unit. Rows of float64 or float32 that lie in one piece are
    read where they are, however far apart (so a slice of columns needs no copy); anything else is converted first.
    `skip_non_finite` leaves rows with a NaN or an infinity out, which are an error otherwise.
    """

    def __init__(self, xyz: ArrayLike, *, skip_non_finite: Optional[bool] = None, **how: Unpack[How]) -> None:
        given = options(_ffi.medax_points_options, skip_non_finite=skip_non_finite)
        rows = _shaped(real(_array(xyz, "xyz"), "xyz"), "xyz", 3)
        if rows.dtype not in (np.float64, np.float32) or not rows.dtype.isnative:
            rows = rows.astype(np.float64)
        size = rows.dtype.itemsize
        if rows.strides[1] != size or rows.strides[0] < 3 * size:
            rows = np.ascontiguousarray(rows)
        create = lib.medax_points_create_f64 if size == 8 else lib.medax_points_create_f32
        stride = rows.strides[0] if len(rows) > 1 else 0
        made = build(Points, how, create, pointer(rows), len(rows), stride, ctypes.byref(given))
        self._reference = made._reference

    @classmethod
    def read(cls, path: Path, *, skip_non_finite: Optional[bool] = None, **how: Unpack[How]) -> Points:
        """The points of a file: of a mesh the vertices that a face or an edge uses, else all. `skip_non_finite`
        (False) leaves out rows with a NaN or an infinity."""
        given = options(_ffi.medax_points_options, skip_non_finite=skip_non_finite)
        made: Points = build(cls, how, lib.medax_points_read, path_of(path), ctypes.byref(given))
        return made

    def write(self, path: Path, *, text: Optional[bool] = None, **how: Unpack[How]) -> Warnings:
        """Writes the distinct points in the order of their vertices. `text` writes PLY as text."""
        given = options(_ffi.medax_write_options, text=text)
        made: Warnings = build(Warnings, how, lib.medax_points_write, self._ref, path_of(path), ctypes.byref(given))
        return made

    @property
    def coords(self) -> Floats:
        """The distinct points in spatial order, the vertices of all that is built from them: (n, 3)."""
        return self._view("coords", 3)

    @property
    def vertex_of_row(self) -> Indices:
        """The vertex of each row of the input, (rows,); NONE for a row left out."""
        return self._view("vertex_of_row")

    @property
    def row_of_vertex(self) -> Indices:
        """The first row of the input at each vertex, (n,)."""
        return self._view("row_of_vertex")

    @property
    def duplicate_of(self) -> Indices:
        """The first row with the same coordinates, (rows,); NONE where the row is itself the first, or left out."""
        return self._view("duplicate_of")

    @property
    def count(self) -> int:
        """The number of distinct points."""
        return int(self._get("count"))

    def __len__(self) -> int:
        return self.count

    @property
    def row_count(self) -> int:
        """The number of rows of the input."""
        return int(self._get("row_count"))

    @property
    def duplicate_count(self) -> int:
        """The number of rows that repeat an earlier one."""
        return int(self._get("duplicate_count"))

    @property
    def skipped_count(self) -> int:
        """The number of rows that were left out."""
        return int(self._get("skipped_count"))

    @property
    def bounds(self) -> Floats:
        """The smallest box that holds every point, (2, 3): its least corner and its greatest."""
        return self._box()

    def _told(self) -> str:
        extra = [
            f"{number} {what}"
            for number, what in ((self.duplicate_count, "duplicates"), (self.skipped_count, "skipped"))
            if number
        ]
        return f": {', '.join([f'{self.count} points', *extra])}"
