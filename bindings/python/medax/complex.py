# SPDX-License-Identifier: MIT OR Apache-2.0
"""Complexes: what surfaces, axes and crusts come as."""

from __future__ import annotations

import ctypes
import dataclasses
import html
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, Optional, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _ffi, view
from ._ffi import CellType, Element, ValueType
from ._library import lib
from .error import ArgumentError, check
from .handle import Handle, options, path_of, ref, report_of, text_of, told
from .io import Warnings
from .job import How, Validated, build, run
from .points import Path
from .view import Floats, Indices, Rows, RowsLike, floats, of_view, pointer, real

if TYPE_CHECKING:
    from typing_extensions import Unpack

#: Attributes as they may be given: `{"vertex": {"radius": [...]}, "face": {...}}`, or `Attribute` objects.
AttributesLike = Union[Mapping[Any, Mapping[str, ArrayLike]], Iterable["Attribute"]]


@dataclasses.dataclass(frozen=True, repr=False)
class Attribute:
    """Values with a name on one kind of element: (n,) or (n, k), float64 or uint32."""

    name: str
    element: Element
    values: NDArray[Any]

    @property
    def value_type(self) -> ValueType:
        """F64 for lengths, angles, coordinates; U32 for indices and labels."""
        return ValueType.F64 if self.values.dtype.kind == "f" else ValueType.U32

    def __repr__(self) -> str:
        return f"<medax.Attribute {self.name!r} on {self.element.name.lower()}: {self.values.dtype}{self.values.shape}>"

    @classmethod
    def _of(cls, owner: object, found: Any) -> Attribute:
        kept = found.f64_values if found.value_type == ValueType.F64 else found.u32_values
        return cls(found.name.decode(), Element(found.element), of_view(owner, kept, kept.cols))


class Attributed(Handle):
    """What has attributes: a complex, or a file."""

    @property
    def attribute_count(self) -> int:
        """The number of attributes, over all kinds of elements."""
        return int(self._get("attribute_count"))

    @property
    def attributes(self) -> tuple[Attribute, ...]:
        """All attributes."""
        reference, found = self._ref, _ffi.medax_attribute()
        at = getattr(lib, self._stem + "_attribute_at")
        made = []
        for index in range(self.attribute_count):
            check(at(reference, index, ctypes.byref(found)))
            made.append(Attribute._of(reference, found))
        return tuple(made)

    def attribute(self, element: Union[Element, str], name: str) -> Attribute:
        """The attribute of this name, which must be there."""
        reference, found = self._ref, _ffi.medax_attribute()
        look = getattr(lib, self._stem + "_attribute")
        check(look(reference, Element.of(element), text_of(name, "name"), ctypes.byref(found)))
        return Attribute._of(reference, found)

    def values(self, name: str, element: Union[Element, str] = Element.VERTEX) -> NDArray[Any]:
        """The values of an attribute, of vertices if nothing else is said."""
        return self.attribute(element, name).values


@dataclasses.dataclass(frozen=True)
class Topology:
    """What a complex is, told from its indices alone; `genus` is None for what is no orientable manifold surface."""

    vertices: int
    isolated_vertices: int
    edges: int
    faces: int
    cells: int
    components: int
    euler_characteristic: int
    boundary_edges: int
    boundary_loops: int
    nonmanifold_edges: int
    nonmanifold_vertices: int
    genus: Optional[int]
    betti: tuple[int, int, int]
    closed: bool
    oriented: bool


@dataclasses.dataclass(frozen=True)
class Measure:
    """The area of the faces, in squared input units, and the volume that they enclose, in cubed ones."""

    area: float
    volume: float


@dataclasses.dataclass(frozen=True)
class Comparison:
    """Distances between two complexes, in input units; `diagonal` is that of the box that holds both."""

    a_to_b_max: float
    a_to_b_mean: float
    a_to_b_rms: float
    b_to_a_max: float
    b_to_a_mean: float
    b_to_a_rms: float
    diagonal: float


class Intersections(Handle, stem="intersections"):
    """The pairs of triangles of a complex that intersect."""

    @property
    def pairs(self) -> Indices:
        """(i, 2) rows of `Complex.triangles`, the lesser one first; rows ascend."""
        return self._view("pairs", 2)

    def __len__(self) -> int:
        return len(self.pairs)

    def _told(self) -> str:
        return f": {len(self)} pairs"


class Complex(Validated, Attributed, stem="complex"):
    """Vertices, polygons, loose edges, volume cells and named attributes: every result that can be drawn or written.

    - `vertices`: (v, 3) coordinates, float64.
    - `faces`: polygons: an array (f, k), a list of rings, `Rows`, or a tuple of offsets and indices.
    - `edges`: (e, 2) vertices of edges that are no side of a face.
    - `cells`: volume cells, given like faces, vertices in VTK's order; `cell_types` (`CellType`, one each) may be
      left out where all have four vertices.
    - `attributes`: `{"vertex": {"radius": [...]}, "face": {...}}`, or `Attribute` objects; rows of float64 or uint32.
    - `dimension`: 2 for what lies in the plane, z being 0 throughout, else 3.
    """

    def __init__(
        self,
        vertices: ArrayLike,
        faces: Optional[RowsLike] = None,
        edges: Optional[ArrayLike] = None,
        cells: Optional[RowsLike] = None,
        cell_types: Optional[ArrayLike] = None,
        attributes: Optional[AttributesLike] = None,
        dimension: int = 3,
    ) -> None:
        xyz = floats(vertices, "vertices")
        polygons = view.rows(() if faces is None else faces, "faces")
        loose = view.indices(() if edges is None else edges, "edges", 2)
        volumes = view.rows(() if cells is None else cells, "cells")
        if cell_types is None:
            if len(volumes) and (volumes.lengths != 4).any():
                raise ArgumentError("cell_types must be given where cells are not all tetrahedra")
            cell_types = np.full(len(volumes), CellType.TETRAHEDRON, np.uint32)
        types = view.indices(cell_types, "cell_types", 1, len(volumes))
        named, kept = _parts_of(attributes)
        parts = options(
            _ffi.medax_complex_parts,
            vertices=pointer(xyz),
            vertex_count=len(xyz),
            face_offsets=pointer(polygons.offsets),
            face_indices=pointer(polygons.indices),
            face_count=len(polygons),
            edges=pointer(loose),
            edge_count=len(loose),
            cell_offsets=pointer(volumes.offsets),
            cell_indices=pointer(volumes.indices),
            cell_types=pointer(types),
            cell_count=len(volumes),
            attributes=ctypes.addressof(named) if len(named) else None,
            attribute_count=len(named),
            dimension=dimension,
        )
        slot = self._slot()
        check(lib.medax_complex_create(ctypes.byref(parts), ctypes.byref(slot)))
        del kept
        self._reference = self._take(slot)._reference

    @classmethod
    def read(cls, path: Path, **how: Unpack[How]) -> Complex:
        """A complex of a file: PLY, OFF, OBJ, STL, XYZ, PTS, TXT, CSV, PWN, MA."""
        made: Complex = build(cls, how, lib.medax_complex_read, path_of(path))
        return made

    def write(self, path: Path, *, text: Optional[bool] = None, **how: Unpack[How]) -> Warnings:
        """Writes PLY, OFF, OBJ, STL, XYZ, PTS, TXT, CSV, MA, VTU, or GeoJSON for what is plane, by the path's ending.
        `text` writes PLY as text. The warnings tell what the format could not hold."""
        given = options(_ffi.medax_write_options, text=text)
        made: Warnings = build(Warnings, how, lib.medax_complex_write, self._ref, path_of(path), ctypes.byref(given))
        return made

    @property
    def dimension(self) -> int:
        """2 for plane results, whose z is 0 throughout, else 3."""
        return int(self._get("dimension"))

    @property
    def vertices(self) -> Floats:
        """(v, 3) coordinates in input units."""
        return self._view("vertices", 3)

    @property
    def faces(self) -> Rows:
        """One row a face: a ring of three vertices or more."""
        return self._rows("faces")

    @property
    def edges(self) -> Indices:
        """(e, 2) vertices of the loose edges, those that are no side of a face."""
        return self._view("edges", 2)

    @property
    def cells(self) -> Rows:
        """One row a volume cell: its vertices in VTK's order."""
        return self._rows("cells")

    @property
    def cell_types(self) -> Indices:
        """The `CellType` of each volume cell."""
        return self._view("cell_types")

    @property
    def triangles(self) -> Indices:
        """(t, 3) vertices: the faces cut into fans, in the order of the faces."""
        return self._view("triangles", 3)

    @property
    def face_of_triangle(self) -> Indices:
        """The face that each triangle is part of, (t,)."""
        return self._view("face_of_triangle")

    @property
    def bounds(self) -> Floats:
        """The smallest box that holds every vertex, (2, 3): its least corner and its greatest; NaN without one."""
        xyz = self.vertices
        box = np.stack([xyz.min(axis=0), xyz.max(axis=0)]) if len(xyz) else np.full((2, 3), np.nan)
        box.flags.writeable = False
        return box

    def topology(self, **how: Unpack[How]) -> Topology:
        """Counts, components, boundary, genus, Betti numbers."""
        reference, report = self._ref, report_of(_ffi.medax_topology)
        run(how, lambda job: int(lib.medax_complex_topology(reference, job, ctypes.byref(report))))
        return told(Topology, report, genus=report.genus if report.has_genus else None)

    def measure(self, **how: Unpack[How]) -> Measure:
        """The area of the faces and the volume that they enclose."""
        reference, area, volume = self._ref, ctypes.c_double(), ctypes.c_double()
        call = lib.medax_complex_measure
        run(how, lambda job: int(call(reference, job, ctypes.byref(area), ctypes.byref(volume))))
        return Measure(area.value, volume.value)

    def self_intersections(self, **how: Unpack[How]) -> Intersections:
        """The pairs of triangles that intersect, decided exactly."""
        made: Intersections = build(Intersections, how, lib.medax_complex_self_intersections, self._ref)
        return made

    def winding_numbers(self, queries: ArrayLike, **how: Unpack[How]) -> Floats:
        """How often the faces wind round each of some points (q, 3): (q,), 1 inside, 0 outside."""
        xyz = floats(queries, "queries")
        numbers = np.empty(len(xyz))
        reference, call = self._ref, lib.medax_complex_winding_numbers
        run(how, lambda job: int(call(reference, pointer(xyz), len(xyz), job, pointer(numbers))))
        return numbers

    def vertex_normals(self, **how: Unpack[How]) -> Floats:
        """The unit normals of the surface at its vertices, (v, 3), turned as the faces turn."""
        normals = np.empty((len(self.vertices), 3))
        reference, call = self._ref, lib.medax_complex_vertex_normals
        run(how, lambda job: int(call(reference, job, len(normals), pointer(normals))))
        return normals

    def oriented(self, **how: Unpack[How]) -> Complex:
        """The same with its faces turned so that neighbours agree and solids are inside."""
        made: Complex = build(Complex, how, lib.medax_complex_orient, self._ref)
        return made

    def decimate(
        self, *, triangles: Optional[int] = None, max_error: Optional[float] = None, **how: Unpack[How]
    ) -> Complex:
        """The same surface with fewer triangles: down to a number of `triangles`, none farther than `max_error`, in
        input units, from where it was."""
        given = options(_ffi.medax_decimate_options, triangles=triangles, max_error=max_error)
        made: Complex = build(Complex, how, lib.medax_complex_decimate, self._ref, ctypes.byref(given))
        return made

    def flatten(self, *, flatness: Optional[float] = None, **how: Unpack[How]) -> Flattened:
        """Flat tetrahedra collapsed to their triangles: those whose least altitude is at most the share `flatness`
        (0.1) of their longest edge."""
        given = options(_ffi.medax_flatten_options, flatness=flatness)
        made: Flattened = build(Flattened, how, lib.medax_complex_flatten, self._ref, ctypes.byref(given))
        return made

    def compare(
        self, other: Complex, *, samples: Optional[int] = None, seed: Optional[int] = None, **how: Unpack[How]
    ) -> Comparison:
        """How far this complex (`a`) and another one (`b`) are apart, by `samples` (100,000) points of each, which
        `seed` (0) chooses."""
        given = options(_ffi.medax_compare_options, samples=samples, seed=seed)
        report = report_of(_ffi.medax_comparison)
        a, b, call = self._ref, ref(other, Complex, "other"), lib.medax_complex_compare
        run(how, lambda job: int(call(a, b, ctypes.byref(given), job, ctypes.byref(report))))
        return told(Comparison, report)

    def _counts(self) -> list[tuple[int, str]]:
        counts = [(len(self.vertices), "vertices"), (len(self.faces), "faces")]
        counts += [(len(self.edges), "loose edges"), (len(self.cells), "cells")]
        return [pair for pair in counts if pair[0] or pair[1] == "vertices"]

    def _told(self) -> str:
        return ": " + ", ".join(f"{number} {what}" for number, what in self._counts())

    def _repr_html_(self) -> str:
        """What Jupyter shows: counts, bounds, attributes."""
        if self.closed:
            return f"<code>{html.escape(repr(self))}</code>"
        rows = [(what, f"{number:,}") for number, what in self._counts()]
        if len(self.vertices):
            least, greatest = self.bounds
            rows += [(axis, f"{a:.6g} … {b:.6g}") for axis, a, b in zip("xyz", least, greatest)]
        for attribute in self.attributes:
            values = attribute.values
            shape = f" × {values.shape[1]}" if values.ndim == 2 else ""
            finite = values[np.isfinite(values)] if values.dtype.kind == "f" else values[values != view.NONE]
            span = f": {finite.min():.6g} … {finite.max():.6g}" if finite.size else ""
            where = f"{html.escape(attribute.name)} <small>({attribute.element.name.lower()})</small>"
            rows.append((where, f"{values.dtype}{shape}{span}"))
        lines = "".join(
            f'<tr><th style="text-align:left">{name}</th><td style="text-align:left">{value}</td></tr>'
            for name, value in rows
        )
        return f"<table><caption>medax.Complex</caption>{lines}</table>"

    def to_trimesh(self, **options: Any) -> Any:
        """A `trimesh.Trimesh` of the faces, a `PointCloud` where there are none; see `medax.convert`."""
        from . import convert

        return convert.to_trimesh(self, **options)

    @classmethod
    def from_trimesh(cls, mesh: Any) -> Complex:
        """A complex of a `trimesh` mesh, point cloud, path or scene; see `medax.convert`."""
        from . import convert

        return convert.from_trimesh(mesh)

    def to_meshio(self) -> Any:
        """A `meshio.Mesh`; see `medax.convert`."""
        from . import convert

        return convert.to_meshio(self)

    @classmethod
    def from_meshio(cls, mesh: Any) -> Complex:
        """A complex of a `meshio.Mesh`; see `medax.convert`."""
        from . import convert

        return convert.from_meshio(mesh)

    def to_pyvista(self) -> Any:
        """A `pyvista.PolyData`, or `pyvista.UnstructuredGrid` where there are volume cells; see `medax.convert`."""
        from . import convert

        return convert.to_pyvista(self)

    @classmethod
    def from_pyvista(cls, dataset: Any, dimension: int = 3) -> Complex:
        """A complex of a `pyvista` data set; see `medax.convert`."""
        from . import convert

        return convert.from_pyvista(dataset, dimension)


class Flattened(Handle, stem="flattened"):
    """A complex without its flat tetrahedra, and what became of them."""

    def complex(self) -> Complex:
        """The complex that is left."""
        return self._kept("complex", Complex)

    @property
    def collapses(self) -> Indices:
        """(c, 2): a tetrahedron that went, and its vertex opposite the triangle that went with it, in order."""
        return self._view("collapses", 2)

    @property
    def left_count(self) -> int:
        """The number of flat tetrahedra that could not go."""
        return int(self._get("left_count"))

    def _told(self) -> str:
        return f": {len(self.collapses)} tetrahedra collapsed, {self.left_count} left"


def _parts_of(attributes: Optional[AttributesLike]) -> tuple[Any, list[Any]]:
    """The attributes as the library takes them, and what must stay alive meanwhile."""
    given: list[tuple[Any, str, Any]] = []
    if isinstance(attributes, Mapping):
        for element, named in attributes.items():
            if not isinstance(named, Mapping):
                raise ArgumentError("attributes must be given by element: {'vertex': {'radius': [...]}}")
            given += [(element, name, values) for name, values in named.items()]
    elif attributes is not None:
        given = [(each.element, each.name, each.values) for each in attributes]
    made = (_ffi.medax_attribute * len(given))()
    kept: list[Any] = [made]
    for part, (element, name, values) in zip(made, given):
        array = view._array(values, name)
        if array.ndim not in (1, 2):
            raise ArgumentError(f"attribute {name!r} must have the shape (n,) or (n, k), not {array.shape}")
        cols = array.shape[1] if array.ndim == 2 else 1
        if array.dtype.kind == "b":
            array = array.astype(np.uint32)
        # What indices cannot be, such as negative numbers, are numbers.
        if array.dtype.kind in "iu" and (not array.size or (array.min() >= 0 and array.max() <= view.NONE)):
            array = view.indices(array, name, cols)
            part.value_type, target = ValueType.U32, part.u32_values
        else:
            array = floats(real(array, name), name, cols)
            part.value_type, target = ValueType.F64, part.f64_values
        text = text_of(name, "the name of an attribute")
        kept += [array, text]
        part.name, part.element = text, Element.of(element)
        target.data, target.rows, target.cols = pointer(array), len(array), cols
    return made, kept


__all__ = [
    "Attribute",
    "Comparison",
    "Complex",
    "Flattened",
    "Intersections",
    "Measure",
    "Topology",
]
