# SPDX-License-Identifier: MIT OR Apache-2.0
"""What a file holds."""

from __future__ import annotations

import ctypes
from typing import TYPE_CHECKING, Optional

from . import _ffi
from ._library import lib
from .complex import Attributed, Complex
from .handle import options, path_of
from .io import Warnings
from .job import How, build
from .points import Path, Points
from .view import Floats, Indices, Rows

if TYPE_CHECKING:
    from typing_extensions import Unpack


class File(Attributed, stem="file"):
    """What a file holds, before points or a complex are made of it."""

    @classmethod
    def read(cls, path: Path, **how: Unpack[How]) -> File:
        """Reads PLY, OFF, OBJ, STL, XYZ, PTS, TXT, CSV, PWN or MA. An error names the line or the byte."""
        made: File = build(cls, how, lib.medax_file_read, path_of(path))
        return made

    @property
    def is_mesh(self) -> bool:
        """Whether there is a face or an edge."""
        return bool(self._get("is_mesh"))

    @property
    def vertices(self) -> Floats:
        """The rows of the vertex table as they are, (v, 3): they may be NaN."""
        return self._view("vertices", 3)

    @property
    def faces(self) -> Rows:
        """One row a face: a ring of three vertices or more."""
        return self._rows("faces")

    @property
    def edges(self) -> Indices:
        """(e, 2) vertices of the edges that the file lists, sides of faces among them."""
        return self._view("edges", 2)

    @property
    def warnings(self) -> Warnings:
        """What was left out in reading."""
        return self._kept("warnings", Warnings)

    def points(self, *, skip_non_finite: Optional[bool] = None, **how: Unpack[How]) -> Points:
        """The points of a file: of a mesh the vertices that a face or an edge uses, else all. `skip_non_finite`
        (False) leaves out rows with a NaN or an infinity."""
        given = options(_ffi.medax_points_options, skip_non_finite=skip_non_finite)
        made: Points = build(Points, how, lib.medax_file_points, self._ref, ctypes.byref(given))
        return made

    def complex(self, **how: Unpack[How]) -> Complex:
        """All vertices, the faces, the edges that are no side of a face, the attributes."""
        made: Complex = build(Complex, how, lib.medax_file_complex, self._ref)
        return made

    def _told(self) -> str:
        return f": {len(self.vertices)} vertices, {len(self.faces)} faces, {len(self.edges)} edges"
