# SPDX-License-Identifier: MIT OR Apache-2.0
"""Layers of PyMeshLab in, new layers out: surface from points, medial axis, core, thickness, iso-surface.

    import pymeshlab
    from medax import meshlab

    ms = pymeshlab.MeshSet()
    ms.load_new_mesh("scan.ply")
    meshlab.axis(ms, theta=0.4)
    ms.save_current_mesh("axis.ply")

- What is taken is the current mesh: all its vertices, where its transform matrix puts them. Its faces matter only where
  a function says so. The mesh stays as it is.
- What is made comes as new layers, whose matrix is the identity; the first of them becomes current. Functions return
  the ids of the new layers. Nothing is added unless all has been made.
- Polygons come as triangles. Loose edges beside faces come in a layer of their own, "Core (edges)", since MeshLab shows
  edges only of layers without faces; so do single points, "Core (points)".
- Radii are the vertex scalars (MeshLab's quality), and the custom attribute `radius`. Other lengths and angles of
  vertices and faces are custom attributes, too; one of two columns is two, such as `object_angle_0`.
- Each takes `job=`, or `progress=`, `threads=`, `memory_ceiling=`. `progress` goes once from 0 to 1; the function of a
  `job` is called anew for each build.
- Lengths are in the units of the layer, angles in radians. What is wrong raises MedaxError.
"""

from __future__ import annotations

import warnings
from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any, NamedTuple, Optional, TypedDict, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from ._explained import explain
from ._ffi import Element, Label, LabelRule, Omit, Side, Status
from .cocone import Cocone
from .complex import Complex
from .convert import _module
from .crust import PowerCrust, Sizes
from .dual import Dual
from .error import ArgumentError, MedaxError
from .flow import Flow
from .handle import number
from .job import How, Job, _job_of
from .labels import Labels
from .medial import Medial, MedialFilter
from .pair import Pair
from .points import Points
from .sample import Samples
from .triangulation import Triangulation

if TYPE_CHECKING:
    from typing_extensions import Unpack


class CrustOptions(TypedDict, total=False):
    """How a power crust is made: see `PowerCrust.of`.

    - `deep`: balls whose -cos of the angle between their spheres exceeds this lie on one side, in [0, 1]; 0.4.
    - `lambda_`: the spacing of the sample relative to the feature size, in [0, pi/4), where poles are left out; 0:
      estimated.
    - `round_poles`: centres of balls are rounded to a grid, which is faster; False.
    - `keep_shards`: the vertices of the power diagram that are one sample stay apart; False.
    - `omit`: poles that are left out: "nothing", "side" (noise) or "both" (sharp edges); "nothing".
    - `label_rule`: "auto", "spread" or "least_conflict"; "auto".
    - `viewpoint`: where the scanner of a one-sided scan was, 3 coordinates; none.
    """

    deep: Optional[float]
    lambda_: Optional[float]
    round_poles: Optional[bool]
    keep_shards: Optional[bool]
    omit: Union[Omit, str, None]
    label_rule: Union[LabelRule, str, None]
    viewpoint: Optional[ArrayLike]


if TYPE_CHECKING:

    class CrustAndHow(CrustOptions, How, total=False):
        """Options of a power crust, and how to run it."""

    class FilterAndHow(MedialFilter, How, total=False):
        """A filter, and how to run it."""


#: Of the attributes that are no lengths and angles those that say something without the structures behind them.
_LABELS = ("condition", "label", "side")

#: What tells inside from outside.
_INSIDE = ("cocone", "crust", "mesh")


def surface(
    meshes: Any, *, shape: bool = False, open: bool = False, **options: Unpack[CrustAndHow]
) -> list[int]:
    """Layer "Power Crust": a closed surface from the vertices, which needs no normals.

    - `shape`: layer "Power Shape", too: an approximation of the medial axis, with radii.
    - `open`: without the faces that close holes.
    - the others: those of `PowerCrust.of`.
    """
    given, steps = _split(options, CrustOptions)
    taken = _taken(meshes)
    crust = PowerCrust.of(Points(taken.vertices, job=steps.until(0.02)), **given, job=steps.until(0.9))
    parts = _filled(crust.surface)
    if open:
        parts = crust.open(job=steps.until(1))[0]
        if not len(parts.faces):
            raise ArgumentError("every face closes a hole: nothing is left")
    made = [_Layers("Power Crust", parts)]
    if shape:
        made.append(_Layers("Power Shape", crust.shape(Label.INNER)))
    steps.end()
    return _add(meshes, made)


def axis(
    meshes: Any, *, inside: str = "cocone", margin: float = 0.1, **options: Unpack[FilterAndHow]
) -> list[int]:
    """Layer "Medial Axis": the Voronoi facets of the vertices that a filter lets pass, with radii.

    - `inside`: what tells inside from outside: the surface of Tight Cocone ("cocone"), the power crust ("crust"), or
      the faces of the layer ("mesh"), which must close the solid and point out of it.
    - `margin`: an outer axis, and one of both sides, is clipped to the box of the vertices, grown by this share of its
      diagonal on every side, unless `clip` is given.
    - the others: those of `MedialFilter`, such as `theta`, `rho`, `object_angle`, `lambda_`, `side`.
    """
    given, steps = _split(options, MedialFilter)
    taken = _taken(meshes)
    if Side.of(given.get("side") or "inner") != Side.INNER and given.get("clip") is None:
        given["clip"] = _box(taken.vertices, margin)
    dual, labels = _diagram(taken, inside, 0.6, steps)
    made = _axis(dual, labels, given, 1, steps)
    steps.end()
    return _add(meshes, [_Layers("Medial Axis", made)])


def core(
    meshes: Any,
    *,
    side: Union[Side, str] = "inner",
    repair: bool = True,
    extend: Union[MedialFilter, bool, None] = None,
    inside: str = "cocone",
    **how: Unpack[How],
) -> list[int]:
    """Layer "Core": an axis that is connected as the solid is, by the flow of the distance to the vertices, with radii.

    - `side`: "inner", "outer", "both".
    - `repair`: as much flow is added as the inner core needs to have the homotopy type of the solid.
    - `extend`: by the facets of the medial axis that a filter lets pass, such as `{"theta": 0.4}`; True: by those of
      the default filter.
    - `inside`: as for `axis`.
    """
    steps = _Steps(how)
    if not isinstance(extend, (Mapping, bool, type(None))):
        raise TypeError(f"extend must be a filter, such as {{'theta': 0.4}}, not {extend!r}")
    filter: dict[str, Any] = dict(extend) if isinstance(extend, Mapping) else {}
    _known(filter, MedialFilter)
    which = Side.of(side)
    taken = _taken(meshes)
    dual, labels = _diagram(taken, inside, 0.5, steps)
    flow = Flow.of(dual, labels, job=steps.until(0.7))
    facets = None
    if extend is not None and extend is not False:
        medial = _medial(dual, labels, filter, 0.8, steps)
        facets = medial.selected(**{"side": which, **filter}, job=steps.until(0.82))
    made, report = flow.core(facets, side=which, repair=repair, job=steps.until(1))
    if not len(made.vertices):
        raise ArgumentError("the core is empty: there is no critical point on this side")
    if report.unbounded and which == Side.INNER:
        warnings.warn("the inner core leaves the solid: the points are too sparse somewhere", stacklevel=2)
    steps.end()
    return _add(meshes, [_Layers("Core", made)])


def thickness(
    meshes: Any,
    *,
    size: str = "thickness",
    faces: Optional[bool] = None,
    spacing: Optional[float] = None,
    **options: Unpack[CrustAndHow],
) -> list[int]:
    """Layer "Thickness": the mesh again, with the thickness of the solid at each vertex as its scalar, the diameter of
    the inner ball that touches the surface there; 0 if no sample has one.

    - `size`: "thickness", or "feature_size", the distance to the medial axis; then the layer is "Feature Size". Both
      are custom attributes.
    - `faces`: a sample is taken on the faces, which must close the solid and point out of it; else the vertices are
      the sample. By default wherever there are faces.
    - `spacing`: the least distance between samples on the faces: near edges and in thin walls the thickness is as exact
      as this. A hundredth of the diagonal of the box.
    - the others: those of `PowerCrust.of`.
    """
    given, steps = _split(options, CrustOptions)
    if size not in Sizes._fields:
        raise ArgumentError(f"{size!r} is no size: there are 'thickness', 'feature_size'")
    taken = _taken(meshes)
    if faces is None:
        faces = len(taken.faces) > 0
    if faces:
        mesh = taken.mesh()
        samples = Samples.of(mesh, spacing=spacing, job=steps.until(0.1))
        crust = PowerCrust.of(samples.points(job=steps.until(0.12)), **given, job=steps.until(0.75))
        # The faces know better than the samples what is inside.
        crust = crust.labelled_by_mesh(mesh, job=steps.until(0.85))
    else:
        if spacing is not None:
            raise ArgumentError("spacing is for samples on faces, of which none are used")
        crust = PowerCrust.of(Points(taken.vertices, job=steps.until(0.02)), **given, job=steps.until(0.85))
    sizes = crust.sizes_at(taken.vertices, job=steps.until(1))
    values, name = getattr(sizes, size), size.replace("_", " ")
    if not np.isfinite(values).any():
        raise ArgumentError(f"there is no {name} anywhere: the sample is too sparse")
    if not np.nanmax(values):
        why = "do faces point inward?" if faces else "the sample is too sparse"
        raise ArgumentError(f"every {name} is 0: {why}")
    steps.end()
    module = _module("pymeshlab")
    layer = module.Mesh(taken.vertices, taken.faces, taken.edges, v_scalar_array=values)
    for label, each in sizes._asdict().items():
        layer.add_vertex_custom_scalar_attribute(each, label)
    return _put(meshes, [("Thickness" if size == "thickness" else "Feature Size", layer)])


def iso_surface(
    meshes: Any,
    t: Union[float, Iterable[float]] = 0.5,
    *,
    onto: str = "axis",
    inside: str = "cocone",
    **options: Unpack[FilterAndHow],
) -> list[int]:
    """Layer "Iso-surface 50%": the closed surface a share `t` of the way from an inner structure (0) to the boundary
    (1), which goes through the vertices; one layer for each `t`.

    - `onto`: the inner structure: the medial axis ("axis"), the core ("core"), or the whole inner Voronoi diagram
      ("voronoi").
    - `inside`: as for `axis`.
    - the others: those of `MedialFilter`, for the axis.
    """
    given, steps = _split(options, MedialFilter)
    if onto not in ("axis", "core", "voronoi"):
        raise ArgumentError(f"{onto!r} is no inner structure: there are 'axis', 'core', 'voronoi'")
    if given and onto != "axis":
        raise ArgumentError(f"{', '.join(given)}: a filter is for the axis")
    if Side.of(given.get("side") or "inner") != Side.INNER or given.get("clip") is not None:
        raise ArgumentError("a pair-mesh is made with the inner axis, unclipped")
    shares = [number(each, "t") for each in ([t] if np.ndim(t) == 0 else list(t))]  # type: ignore[arg-type]
    taken = _taken(meshes)
    dual, labels = _diagram(taken, inside, 0.4, steps)
    part = None
    if onto == "axis":
        part = _axis(dual, labels, given, 0.6, steps)
    elif onto == "core":
        part = Flow.of(dual, labels, job=steps.until(0.5)).core(job=steps.until(0.6)).complex
    pair = Pair.voronoi(dual, labels, job=steps.until(0.75))
    if part is not None:
        pair = pair.onto(part, job=steps.until(0.9))
    made = []
    for done, share in enumerate(shares, 1):
        found = _filled(pair.iso_surface(share, job=steps.until(0.9 + 0.1 * done / len(shares))))
        # MeshLab takes what follows a point for a file's ending, and numbers names before it.
        made.append(_Layers(f"Iso-surface {100 * share:g}%", found))
    steps.end()
    return _add(meshes, made)


# ---- Several builds as one ----


class _Steps:
    """One job for several builds, whose progress function sees them as one."""

    def __init__(self, how: Mapping[str, Any]) -> None:
        given: dict[str, Any] = dict(how)
        self._progress = given.get("progress")
        if callable(self._progress) and given.get("job") is None:
            given["progress"] = self._tell
        self._job = _job_of(given)  # type: ignore[arg-type]
        self._from = self._to = 0.0
        self._told = 0.0
        self._stage = ""

    def until(self, share: float) -> Job:
        """The job, for a build that ends when this share of all is done."""
        self._from, self._to = self._to, share
        return self._job

    def _tell(self, fraction: float, stage: str) -> Any:
        share = self._from + fraction * (self._to - self._from)
        self._told, self._stage = share, stage
        answer = self._progress(share, stage)  # type: ignore[misc]
        # A build that is done hears no answer: the next one shall.
        if answer is False:
            self._job.cancel()
        return answer

    def end(self) -> None:
        """All is done: what came last may have left a rest."""
        if self._job.is_cancelled:
            raise MedaxError(Status.CANCELLED, "the build was cancelled")
        if self._told < 1 and callable(self._progress) and self._job._on_progress == self._tell:
            self._progress(1.0, self._stage)


def _known(given: Mapping[str, Any], *kinds: Any) -> None:
    unknown = set(given).difference(*(kind.__annotations__ for kind in kinds))
    if unknown:
        raise TypeError(f"no option is called {', '.join(sorted(unknown))}")


def _split(options: Mapping[str, Any], kind: Any) -> tuple[dict[str, Any], _Steps]:
    """The options of one kind, and how to run. What nobody knows is an error before anything is built."""
    _known(options, kind, How)
    given = {name: value for name, value in options.items() if name in kind.__annotations__ and value is not None}
    return given, _Steps({name: value for name, value in options.items() if name in How.__annotations__})


# ---- Layers in ----


class _Taken(NamedTuple):
    """What is taken from a layer, where its matrix puts it."""

    vertices: NDArray[np.float64]
    faces: NDArray[np.int32]
    edges: NDArray[np.int32]

    def mesh(self) -> Complex:
        """The faces, which are to point out of the solid."""
        if not len(self.faces):
            raise ArgumentError("the current mesh has no faces")
        return Complex(self.vertices, self.faces)


def _taken(meshes: Any) -> _Taken:
    module = _module("pymeshlab")
    if not isinstance(meshes, module.MeshSet):
        raise TypeError(f"a pymeshlab.MeshSet is needed, not {type(meshes).__name__}")
    try:
        mesh = meshes.current_mesh()
    except module.PyMeshLabException:
        raise ArgumentError("the MeshSet has no current mesh") from None
    if not mesh.vertex_number():
        raise MedaxError(Status.TOO_FEW_POINTS, f"the current mesh, {mesh.label()!r}, has no vertices")
    if not mesh.is_compact():
        mesh.compact()
    faces = mesh.face_matrix()
    # A reflection turns solids inside out.
    if np.linalg.det(mesh.transform_matrix()[:3, :3]) < 0:
        faces = faces[:, ::-1]
    vertices, edges = mesh.transformed_vertex_matrix(), mesh.edge_matrix()
    return _Taken(
        np.array(vertices, np.float64, order="C"),
        np.array(faces, np.int32, order="C").reshape(-1, 3),
        np.array(edges, np.int32, order="C").reshape(-1, 2),
    )


def _box(vertices: NDArray[np.float64], margin: float) -> NDArray[np.float64]:
    least, greatest = vertices.min(axis=0), vertices.max(axis=0)
    grown = number(margin, "margin") * float(np.linalg.norm(greatest - least))
    return np.stack([least - grown, greatest + grown])


def _diagram(taken: _Taken, inside: str, end: float, steps: _Steps) -> tuple[Dual, Labels]:
    """The Voronoi diagram, and what is inside."""
    if inside not in _INSIDE:
        raise ArgumentError(f"{inside!r} tells no inside: there are {', '.join(map(repr, _INSIDE))}")
    mesh = taken.mesh() if inside == "mesh" else None
    points = Points(taken.vertices, job=steps.until(0.02))
    triangulation = Triangulation.delaunay(points, job=steps.until(end / 2 - 0.1))
    dual = Dual.of(triangulation, facets=True, job=steps.until(end / 2))
    if inside == "cocone":
        cocone = Cocone.of(dual, job=steps.until(end - 0.05))
        return dual, Labels.of(cocone, job=steps.until(end))
    solid = mesh if mesh is not None else PowerCrust.of(points, job=steps.until(end - 0.05))
    return dual, Labels.of(dual, solid, job=steps.until(end))


def _medial(dual: Dual, labels: Labels, filter: Mapping[str, Any], end: float, steps: _Steps) -> Medial:
    # Scales cost far more than all the rest: only for a filter that asks for them.
    return Medial.of(dual, labels, scales=bool(filter.get("scale")), job=steps.until(end))


def _axis(dual: Dual, labels: Labels, filter: Any, end: float, steps: _Steps) -> Complex:
    made = _medial(dual, labels, filter, end - 0.1, steps).axis(**filter, job=steps.until(end))
    if not len(made.faces):
        raise ArgumentError("no Voronoi facet passes: take a smaller theta or rho")
    return made


def _filled(surface: Complex) -> Complex:
    """A surface that is there: of none no layer comes, and a caller would not know why."""
    if not len(surface.faces):
        raise ArgumentError("the surface is empty: the sample is too sparse")
    return surface


# ---- Layers out ----


class _Layers(NamedTuple):
    """A complex, and the name of the layers that it becomes."""

    name: str
    complex: Complex


def _columns(name: str, values: NDArray[Any]) -> Iterable[tuple[str, NDArray[np.float64]]]:
    """An attribute as arrays of numbers, one a column."""
    numbers = values.astype(np.float64)
    if numbers.ndim == 1:
        return [(name, numbers)]
    return [(f"{name}_{k}", np.ascontiguousarray(numbers[:, k])) for k in range(numbers.shape[1])]


def _attributes(complex: Complex, element: Element) -> dict[str, NDArray[np.float64]]:
    made: dict[str, NDArray[np.float64]] = {}
    for each in complex.attributes:
        if each.element == element and (each.values.dtype.kind == "f" or each.name in _LABELS):
            made.update(_columns(each.name, each.values))
    return made


def _layers(named: _Layers) -> list[tuple[str, Any]]:
    """The layers of a complex: faces, edges beside them, and points of neither."""
    name, complex = named
    module = _module("pymeshlab")
    triangles, edges = complex.triangles.astype(np.int32), complex.edges.astype(np.int32)
    of_vertices, of_faces = _attributes(complex, Element.VERTEX), _attributes(complex, Element.FACE)
    is_loose = np.ones(len(complex.vertices), bool)
    is_loose[triangles] = False
    is_loose[edges] = False
    none = np.empty((0, 3), np.int32), np.empty((0, 2), np.int32)
    parts: list[tuple[str, NDArray[Any], NDArray[Any], NDArray[Any]]] = [
        ("", np.unique(triangles), triangles, none[1]),
        (" (edges)", np.unique(edges), none[0], edges),
        (" (points)", np.flatnonzero(is_loose), *none),
    ]
    made: list[tuple[str, Any]] = []
    for kind, used, faces, lines in parts:
        if not len(used):
            continue
        numbers = np.full(len(complex.vertices), -1, np.int32)
        numbers[used] = np.arange(len(used), dtype=np.int32)
        scalars = {"v_scalar_array": of_vertices["radius"][used]} if "radius" in of_vertices else {}
        layer = module.Mesh(complex.vertices[used], numbers[faces], numbers[lines], **scalars)
        for label, values in of_vertices.items():
            layer.add_vertex_custom_scalar_attribute(values[used], label)
        if len(faces):
            for label, values in of_faces.items():
                layer.add_face_custom_scalar_attribute(values[complex.face_of_triangle], label)
        made.append((name + kind if made else name, layer))
    return made


def _add(meshes: Any, made: Iterable[_Layers]) -> list[int]:
    return _put(meshes, [layer for each in made for layer in _layers(each)])


def _put(meshes: Any, layers: Iterable[tuple[str, Any]]) -> list[int]:
    ids = []
    for name, layer in layers:
        meshes.add_mesh(layer, name)
        ids.append(meshes.current_mesh_id())
    if ids:
        meshes.set_current_mesh(ids[0])
    return ids


for _function in (axis, core, iso_surface, surface, thickness):
    explain(_function)  # type: ignore[arg-type]

__all__ = ["CrustOptions", "axis", "core", "iso_surface", "surface", "thickness"]
