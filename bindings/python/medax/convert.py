# SPDX-License-Identifier: MIT OR Apache-2.0
"""Complexes to and from trimesh, meshio and PyVista, each imported when it is used.

What a library does not hold is left out, or is an error, as the functions say. Attributes go along. Where edges, faces
and volume cells share one array, as in PyVista and meshio, an attribute that some of them lack has NaN there, or NONE
(4294967295) if it is of indices; one that has fewer columns on some is filled up likewise. On the way back what is
missing throughout is dropped again.
"""

from __future__ import annotations

import importlib
import warnings
from typing import Any, Optional

import numpy as np
from numpy.typing import NDArray

from ._ffi import CellType, Element
from .complex import Attribute, Complex
from .error import ArgumentError
from .view import NONE, Rows

#: Elements with attributes but vertices, in the order in which they stand in data sets.
_KINDS = (Element.EDGE, Element.FACE, Element.CELL)


def _module(name: str) -> Any:
    try:
        return importlib.import_module(name)
    except ImportError as error:
        raise ImportError(f"medax needs {name} for this: pip install 'medax[{name}]' ({error})") from None


# ---- Attributes of several kinds in one array ----


def _missing(dtype: np.dtype[Any]) -> Any:
    return NONE if dtype.kind == "u" else np.nan


def _joined(complex: Complex, counts: dict[Element, int]) -> dict[str, NDArray[Any]]:
    """The attributes of edges, faces and cells, one array a name."""
    named: dict[str, dict[Element, NDArray[Any]]] = {}
    for attribute in complex.attributes:
        if attribute.element in counts and counts[attribute.element]:
            named.setdefault(attribute.name, {})[attribute.element] = attribute.values
    made = {}
    for name, parts in named.items():
        width = max(1 if part.ndim == 1 else part.shape[1] for part in parts.values())
        whole = all(part.dtype.kind == "u" for part in parts.values())
        dtype = np.dtype(np.uint32 if whole else np.float64)
        array = np.full((sum(counts.values()), width), _missing(dtype), dtype)
        start = 0
        for kind, count in counts.items():
            if kind in parts:
                part = parts[kind].reshape(count, -1)
                array[start : start + count, : part.shape[1]] = part
            start += count
        made[name] = array[:, 0] if width == 1 else array
    return made


def _usable(name: str, values: Any) -> Optional[NDArray[Any]]:
    """An array that can be an attribute; a warning for any other."""
    array = np.asarray(values)
    if array.ndim in (1, 2) and array.dtype.kind in "buif" and (array.ndim == 1 or array.shape[1]):
        return array
    warnings.warn(f"{name!r} is left out: no attribute can be {array.dtype}{array.shape}", stacklevel=4)
    return None


def _stripped(array: NDArray[Any]) -> Optional[NDArray[Any]]:
    """Without what is missing throughout: None, or fewer columns."""
    flat = array.reshape(len(array), -1)
    if array.dtype.kind == "f":
        there = ~np.isnan(flat)
    elif array.dtype == np.uint32:
        there = flat != NONE
    else:
        return array
    columns = np.flatnonzero(there.any(axis=0))
    if not len(columns):
        return None
    flat = flat[:, : columns[-1] + 1]
    return flat[:, 0] if flat.shape[1] == 1 else flat


def _divided(data: dict[str, Any], kinds: NDArray[Any]) -> list[Attribute]:
    """Attributes of arrays with a row for each of some elements, whose kinds are told; -1 for what is none."""
    made = []
    for name, values in data.items():
        array = _usable(name, values)
        if array is None:
            continue
        for kind in _KINDS:
            chosen = kinds == kind
            part = _stripped(array[chosen]) if chosen.any() else None
            if part is not None:
                made.append(Attribute(name, kind, part))
    return made


def _of_vertices(data: Any) -> list[Attribute]:
    found = ((name, _usable(name, values)) for name, values in data.items())
    return [Attribute(name, Element.VERTEX, array) for name, array in found if array is not None]


# ---- Rows of varying length ----


def _fanned(rows: Rows) -> NDArray[np.int64]:
    """Each row with its length before it, all in one: as VTK takes cells."""
    lengths = rows.lengths.astype(np.int64)
    out = np.empty(len(rows.indices) + len(rows), np.int64)
    heads = rows.offsets[:-1].astype(np.int64) + np.arange(len(rows))
    is_index = np.ones(len(out), bool)
    is_index[heads] = False
    out[heads] = lengths
    out[is_index] = rows.indices
    return out


def _unfanned(cells: NDArray[Any]) -> list[NDArray[Any]]:
    """The other way round."""
    rows, at = [], 0
    flat = np.asarray(cells)
    while at < len(flat):
        rows.append(flat[at + 1 : at + 1 + flat[at]])
        at += 1 + int(flat[at])
    return rows


def _segments(line: NDArray[Any]) -> NDArray[Any]:
    return np.column_stack([line[:-1], line[1:]])


def _pyramid_sides(row: Any) -> list[list[int]]:
    """The faces of a pyramid over a polygon: its base, then its sides."""
    *base, apex = (int(vertex) for vertex in row)
    sides = [[b, a, apex] for a, b in zip(base, base[1:] + base[:1])]
    return [base, *sides]


def _pyramid_of(sides: list[list[int]]) -> list[int]:
    """The base and the apex of a polyhedron that is a pyramid."""
    base = max(sides, key=len)
    apexes = {vertex for side in sides for vertex in side} - set(base)
    if len(apexes) != 1 or len(sides) != len(base) + 1 or any(len(side) != 3 for side in sides if side is not base):
        raise ArgumentError("a polyhedron that is no pyramid is no cell of a complex")
    return [*base, apexes.pop()]


# ---- PyVista ----

_LINE, _POLY_LINE, _TRIANGLE, _STRIP, _POLYGON, _PIXEL, _QUAD = 3, 4, 5, 6, 7, 8, 9
_TETRAHEDRON, _PYRAMID, _POLYHEDRON = 10, 14, 42
_VTK_OF_CELL = {
    CellType.TETRAHEDRON: _TETRAHEDRON,
    CellType.PYRAMID: _PYRAMID,
    CellType.POLYGONAL_PYRAMID: _POLYHEDRON,
}


def to_pyvista(complex: Complex) -> Any:
    """A `pyvista.PolyData` of the loose edges and the faces, in this order, or of the vertices where there are neither;
    a `pyvista.UnstructuredGrid` of edges, faces and cells where there are volume cells. Attributes of vertices are
    point data, all others cell data. A pyramid over a polygon is a polyhedron."""
    pyvista = _module("pyvista")
    points, edges, faces, cells = np.array(complex.vertices), complex.edges, complex.faces, complex.cells
    counts = {Element.EDGE: len(edges), Element.FACE: len(faces), Element.CELL: len(cells)}
    lines = np.column_stack([np.full(len(edges), 2), edges.astype(np.int64)]).ravel()
    if len(cells):
        dataset = _grid_of(pyvista, points, len(edges), lines, faces, cells, complex.cell_types)
    elif len(faces) or len(edges):
        given: dict[str, Any] = {}
        if len(faces):
            given["faces"] = _fanned(faces)
        if len(edges):
            given["lines"] = lines
        dataset = pyvista.PolyData(points, **given)
    else:
        dataset = pyvista.PolyData(points)
    for attribute in complex.attributes:
        if attribute.element == Element.VERTEX and len(points):
            dataset.point_data[attribute.name] = attribute.values.copy()
    for name, values in _joined(complex, counts).items():
        dataset.cell_data[name] = values
    return dataset


def _grid_of(
    pyvista: Any, points: Any, edge_count: int, lines: Any, faces: Rows, cells: Rows, types: NDArray[Any]
) -> Any:
    shapes = np.concatenate(
        [
            np.full(edge_count, _LINE),
            np.select([faces.lengths == 3, faces.lengths == 4], [_TRIANGLE, _QUAD], _POLYGON),
            np.array([_VTK_OF_CELL[CellType(kind)] for kind in range(1, 4)])[types.astype(int) - 1],
        ]
    ).astype(np.uint8)
    if not (shapes == _POLYHEDRON).any():
        return pyvista.UnstructuredGrid(np.concatenate([lines, _fanned(faces), _fanned(cells)]), shapes, points)
    grid = pyvista.UnstructuredGrid()
    grid.points = points
    before = _unfanned(np.concatenate([lines, _fanned(faces)]))
    for shape, row in zip(shapes.tolist(), [*before, *cells]):
        if shape == _POLYHEDRON:
            _insert_polyhedron(grid, _pyramid_sides(row))
        else:
            grid.InsertNextCell(shape, len(row), row.tolist())
    return grid


def _insert_polyhedron(grid: Any, sides: list[list[int]]) -> None:
    from vtkmodules.vtkCommonCore import vtkIdList

    stream = vtkIdList()
    for number in [len(sides), *(number for side in sides for number in (len(side), *side))]:
        stream.InsertNextId(number)
    grid.InsertNextCell(_POLYHEDRON, stream)


def from_pyvista(dataset: Any, dimension: int = 3) -> Complex:
    """A complex of a `pyvista.PolyData` or `pyvista.UnstructuredGrid`: points, lines (polylines become edges), faces
    (strips become triangles), tetrahedra, pyramids. Vertex cells are left out with their data. Other volume cells are
    an error: `dataset.triangulate()` makes tetrahedra of them."""
    pyvista = _module("pyvista")
    if isinstance(dataset, pyvista.PolyData):
        cells = [(_POLY_LINE, row) for row in _unfanned(dataset.lines)]
        cells += [(_POLYGON, row) for row in _unfanned(dataset.faces)]
        cells += [(_STRIP, row) for row in _unfanned(dataset.strips)]
        verts = dataset.n_verts
    elif isinstance(dataset, pyvista.UnstructuredGrid):
        cells, verts = _cells_of_grid(dataset), 0
    elif isinstance(dataset, pyvista.PointSet):
        cells, verts = [], 0
    else:
        raise ArgumentError(
            f"{type(dataset).__name__} is neither PolyData nor UnstructuredGrid: its extract_surface(), "
            "or cast_to_unstructured_grid().triangulate(), is"
        )
    made = _Elements()
    for number, (shape, row) in enumerate(cells):
        made.add(verts + number, shape, row)
    data = {} if isinstance(dataset, pyvista.PointSet) and not cells else dict(dataset.cell_data)
    return made.complex(np.asarray(dataset.points, np.float64), data, dict(dataset.point_data), dimension)


def _cells_of_grid(grid: Any) -> list[tuple[int, Any]]:
    from vtkmodules.vtkCommonCore import vtkIdList

    shapes = grid.celltypes.tolist()
    # The name before PyVista 0.47, where the newer one is missing.
    offsets = grid.cell_offsets if hasattr(grid, "cell_offsets") else grid.offset
    connectivity, stream = grid.cell_connectivity, vtkIdList()
    rows: list[tuple[int, Any]] = []
    for number, shape in enumerate(shapes):
        if shape == _POLYHEDRON:
            grid.GetFaceStream(number, stream)
            flat = [stream.GetId(i) for i in range(1, stream.GetNumberOfIds())]
            rows.append((_POLYHEDRON, _pyramid_of([side.tolist() for side in _unfanned(np.array(flat))])))
        else:
            rows.append((shape, connectivity[offsets[number] : offsets[number + 1]]))
    return rows


class _Elements:
    """Edges, faces and cells that are gathered one by one, each with the row of data that is its own."""

    def __init__(self) -> None:
        self.elements: dict[Element, list[Any]] = {kind: [] for kind in _KINDS}
        self.sources: dict[Element, list[int]] = {kind: [] for kind in _KINDS}
        self.types: list[CellType] = []

    def add(self, source: int, shape: int, row: Any) -> None:
        if shape in (0, 1, 2):
            return
        if shape in (_LINE, _POLY_LINE):
            for segment in _segments(np.asarray(row)):
                self._put(Element.EDGE, source, segment)
        elif shape in (_TRIANGLE, _QUAD, _POLYGON):
            self._put(Element.FACE, source, row)
        elif shape == _PIXEL:
            self._put(Element.FACE, source, np.asarray(row)[[0, 1, 3, 2]])
        elif shape == _STRIP:
            for at in range(len(row) - 2):
                corners = row[at : at + 3]
                self._put(Element.FACE, source, corners if at % 2 == 0 else corners[[1, 0, 2]])
        elif shape in (_TETRAHEDRON, _PYRAMID, _POLYHEDRON):
            self._put(Element.CELL, source, row)
            sizes = {4: CellType.TETRAHEDRON, 5: CellType.PYRAMID}
            self.types.append(sizes.get(len(row), CellType.POLYGONAL_PYRAMID))
        else:
            raise ArgumentError(f"cell {source} is of VTK's type {shape}, which no complex has; try triangulate()")

    def _put(self, kind: Element, source: int, row: Any) -> None:
        self.elements[kind].append(np.asarray(row))
        self.sources[kind].append(source)

    def complex(self, points: Any, data: Any, of_points: Any, dimension: int) -> Complex:
        kinds = np.repeat([int(kind) for kind in _KINDS], [len(self.sources[kind]) for kind in _KINDS])
        sources = np.concatenate([np.asarray(self.sources[kind], int) for kind in _KINDS])
        taken = {name: np.asarray(values)[sources] for name, values in data.items()} if len(sources) else {}
        edges = self.elements[Element.EDGE]
        return Complex(
            points,
            self.elements[Element.FACE],
            np.asarray(edges) if edges else None,
            self.elements[Element.CELL],
            self.types,
            _of_vertices(of_points) + _divided(taken, kinds),
            dimension,
        )


# ---- meshio ----


def to_meshio(complex: Complex) -> Any:
    """A `meshio.Mesh`: blocks of lines, triangles, quads, polygons by their number of corners, tetrahedra, pyramids,
    polyhedra; of vertices where there is nothing else. Within a block elements keep their order."""
    meshio = _module("meshio")
    blocks: list[tuple[str, Any]] = []
    order: list[NDArray[Any]] = []
    edges, faces, cells, types = complex.edges, complex.faces, complex.cells, complex.cell_types
    counts = {Element.EDGE: len(edges), Element.FACE: len(faces), Element.CELL: len(cells)}
    if len(edges):
        blocks.append(("line", edges.astype(np.int64)))
        order.append(np.arange(len(edges)))
    lengths = faces.lengths
    for size in np.unique(lengths):
        chosen = np.flatnonzero(lengths == size)
        name = {3: "triangle", 4: "quad"}.get(int(size), "polygon")
        blocks.append((name, np.stack([faces[i] for i in chosen]).astype(np.int64)))
        order.append(len(edges) + chosen)
    sizes = cells.lengths
    for kind, size in sorted({(int(kind), int(size)) for kind, size in zip(types, sizes)}):
        chosen = np.flatnonzero((types == kind) & (sizes == size))
        rows = [cells[i] for i in chosen]
        if kind == CellType.POLYGONAL_PYRAMID:
            blocks.append((f"polyhedron{size}", [_pyramid_sides(row) for row in rows]))
        else:
            name = "tetra" if kind == CellType.TETRAHEDRON else "pyramid"
            blocks.append((name, np.stack(rows).astype(np.int64)))
        order.append(len(edges) + len(faces) + chosen)
    cell_data = {name: [values[rows] for rows in order] for name, values in _joined(complex, counts).items()}
    if not blocks:
        blocks = [("vertex", np.arange(len(complex.vertices), dtype=np.int64)[:, None])]
    of_vertices = [each for each in complex.attributes if each.element == Element.VERTEX]
    return meshio.Mesh(
        np.array(complex.vertices),
        blocks,
        point_data={each.name: each.values.copy() for each in of_vertices},
        cell_data=cell_data,
    )


_SHAPES_OF_MESHIO = {
    "vertex": 1,
    "line": _LINE,
    "triangle": _TRIANGLE,
    "quad": _QUAD,
    "polygon": _POLYGON,
    "tetra": _TETRAHEDRON,
    "pyramid": _PYRAMID,
}


def from_meshio(mesh: Any) -> Complex:
    """A complex of a `meshio.Mesh`: lines, triangles, quads, polygons, tetrahedra, pyramids. Vertex cells are left out
    with their data; other cells are an error. Points of two coordinates make a complex of dimension 2."""
    points = np.asarray(mesh.points, np.float64)
    dimension = 3
    if points.ndim == 2 and points.shape[1] == 2:
        points, dimension = np.column_stack([points, np.zeros(len(points))]), 2
    made, number = _Elements(), 0
    for block in mesh.cells:
        polyhedra = block.type.startswith("polyhedron")
        shape = _POLYHEDRON if polyhedra else _SHAPES_OF_MESHIO.get(block.type)
        if shape is None:
            raise ArgumentError(f"no complex has cells of meshio's type {block.type!r}")
        for row in block.data:
            made.add(number, shape, _pyramid_of([list(map(int, side)) for side in row]) if polyhedra else row)
            number += 1
    data = {name: np.concatenate([np.asarray(b) for b in blocks]) for name, blocks in mesh.cell_data.items()}
    return made.complex(points, data, mesh.point_data, dimension)


# ---- trimesh ----


def to_trimesh(complex: Complex, **options: Any) -> Any:
    """A `trimesh.Trimesh` of the faces, cut into triangles, with attributes of vertices as `vertex_attributes` and of
    faces as `face_attributes`; a `trimesh.path.Path3D` of the loose edges where there are no faces; a
    `trimesh.PointCloud` where there are neither. Volume cells are left out, and so are edges beside faces. `options`
    are those of `trimesh.Trimesh`; its `process` is off, so that vertices keep their numbers."""
    trimesh = _module("trimesh")
    vertices, triangles = np.array(complex.vertices), complex.triangles
    of_vertices = {a.name: a.values.copy() for a in complex.attributes if a.element == Element.VERTEX}
    if len(triangles):
        of_faces = {a.name: a.values[complex.face_of_triangle] for a in complex.attributes if a.element == Element.FACE}
        given = {"process": False, "vertex_attributes": of_vertices, "face_attributes": of_faces, **options}
        return trimesh.Trimesh(vertices, triangles.astype(np.int64), **given)
    if len(complex.edges):
        path = _module("trimesh.path")
        lines = [path.entities.Line(edge) for edge in complex.edges.astype(np.int64)]
        made = path.Path3D(entities=lines, vertices=vertices, process=False)
        made.vertex_attributes.update(of_vertices)
        return made
    return trimesh.PointCloud(vertices, metadata={"attributes": of_vertices})


def from_trimesh(mesh: Any) -> Complex:
    """A complex of a `trimesh.Trimesh`, with its attributes, a `PointCloud`, a `Path3D`, or a `Scene`, all of whose
    meshes become one."""
    trimesh = _module("trimesh")
    if isinstance(mesh, trimesh.Scene):
        mesh = mesh.to_mesh()
    if isinstance(mesh, trimesh.Trimesh):
        attributes = _of_vertices(mesh.vertex_attributes)
        for name, values in mesh.face_attributes.items():
            array = _usable(name, values)
            if array is not None:
                attributes.append(Attribute(name, Element.FACE, array))
        return Complex(mesh.vertices, np.asarray(mesh.faces), attributes=attributes)
    if isinstance(mesh, trimesh.PointCloud):
        return Complex(mesh.vertices, attributes=_of_vertices(mesh.metadata.get("attributes", {})))
    if hasattr(mesh, "entities"):
        nodes = [np.asarray(entity.nodes).reshape(-1, 2) for entity in mesh.entities]
        vertices = np.asarray(mesh.vertices, np.float64)
        dimension = vertices.shape[1]
        if dimension == 2:
            vertices = np.column_stack([vertices, np.zeros(len(vertices))])
        edges = np.concatenate(nodes) if nodes else None
        return Complex(vertices, edges=edges, attributes=_of_vertices(mesh.vertex_attributes), dimension=dimension)
    raise ArgumentError(f"{type(mesh).__name__} is no mesh, point cloud, path or scene of trimesh")
