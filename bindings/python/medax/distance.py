# SPDX-License-Identifier: MIT OR Apache-2.0
"""Distances to sites, and the medial axes read off them."""

from __future__ import annotations

import ctypes
import dataclasses
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, ClassVar, NamedTuple, Optional, TypedDict, Union

import numpy as np
from numpy.typing import ArrayLike, NDArray

from . import _ffi
from ._ffi import DecideTest, PieceKind, Side
from ._library import lib
from .complex import Complex
from .error import ArgumentError, check
from .figure import Figure
from .handle import Handle, clipped, number, options, ref, report_of, told, whole
from .job import How, Validated, build, run
from .view import Flags, Floats, Indices, Rows, _array, flags, floats, indices, pointer, real, vector

if TYPE_CHECKING:
    from typing_extensions import Unpack

#: Rows of `Sites.nearest`: point, distance, direction, piece, site.
NEAREST = np.dtype(_ffi.medax_nearest)
#: Rows of `Sites.pieces`: kind, site, numbers.
PIECE = np.dtype(_ffi.medax_piece)
#: Rows of `FieldAxis.covers`.
COVER = np.dtype(_ffi.medax_cover)


class Piece(NamedTuple):
    """A piece of a boundary, and the number of its site. Points have three coordinates, or two in the plane."""

    kind: PieceKind
    site: int
    numbers: tuple[float, ...]

    @classmethod
    def point(cls, p: ArrayLike, site: int = 0) -> Piece:
        """A point."""
        return cls._of(PieceKind.POINT, site, p)

    @classmethod
    def segment(cls, a: ArrayLike, b: ArrayLike, site: int = 0) -> Piece:
        """The points between two ends."""
        return cls._of(PieceKind.SEGMENT, site, a, b)

    @classmethod
    def ray(cls, origin: ArrayLike, along: ArrayLike, site: int = 0) -> Piece:
        """An origin, and all that lies from there into a direction."""
        return cls._of(PieceKind.RAY, site, origin, along)

    @classmethod
    def line(cls, on_it: ArrayLike, along: ArrayLike, site: int = 0) -> Piece:
        """A line by a point of it and its direction."""
        return cls._of(PieceKind.LINE, site, on_it, along)

    @classmethod
    def triangle(cls, a: ArrayLike, b: ArrayLike, c: ArrayLike, site: int = 0) -> Piece:
        """A triangle in space."""
        return cls._of(PieceKind.TRIANGLE, site, a, b, c)

    @classmethod
    def sphere(cls, center: ArrayLike, radius: float, site: int = 0) -> Piece:
        """A sphere, a circle in the plane: the surface alone."""
        return cls._of(PieceKind.SPHERE, site, center, (number(radius, "radius"), 0.0, 0.0))

    @classmethod
    def _of(cls, kind: PieceKind, site: int, *points: ArrayLike) -> Piece:
        numbers: list[float] = []
        for point in points:
            array = real(_array(point, "point"), "point")
            numbers += vector(array, "point", 2 if array.shape == (2,) else 3).tolist()
            numbers += [0.0] * (-len(numbers) % 3)
        return cls(kind, whole(site, "site", 32), tuple(numbers + [0.0] * (9 - len(numbers))))


@dataclasses.dataclass(frozen=True)
class Decision:
    """What is known of a circle or a sphere.

    `center` (3,), `radius`, `object_angle` (radians), `feet` (2, 3) and `pieces` are of the medial point that `test`
    has found; `gap` is the longest arc between neighbours of `theta` (k, 3), where the gradient was looked at.
    """

    center: tuple[float, float, float]
    radius: float
    object_angle: float
    feet: Floats
    gap: float
    unconfirmed: int
    pieces: tuple[int, int]
    test: DecideTest
    theta: Floats

    @property
    def has_point(self) -> bool:
        """Whether it holds a medial point."""
        return self.test != DecideTest.NONE


class AllNearest(Handle, stem="all_nearest"):
    """All that is nearest to each of some points."""

    @property
    def pieces(self) -> Rows:
        """One row a query: the pieces, which ascend. The other arrays have a row for each of these."""
        return self._rows("pieces")

    @property
    def sites(self) -> Indices:
        """The sites of these pieces, (m,)."""
        return self._view("sites")

    @property
    def points(self) -> Floats:
        """The nearest points, (m, 3)."""
        return self._view("points", 3)

    @property
    def distances(self) -> Floats:
        """Their distances, (m,)."""
        return self._view("distances")

    @property
    def directions(self) -> Floats:
        """The ways there, (m, 3), of length 1 or 0."""
        return self._view("directions", 3)

    def _told(self) -> str:
        return f": {len(self.sites)} of {len(self.pieces)} queries"


class Sites(Handle, stem="sites"):
    """What distances are measured to.

    `Sites(dimension, pieces)`: pieces in the plane (2) or in space (3), as `Piece` objects or as `Sites.pieces` has
    them; in the plane `is_closed`, a flag for each, tells those of closed curves. Queries have three coordinates, in
    the plane with z 0.
    """

    def __init__(
        self,
        dimension: int,
        pieces: Union[Sequence[Piece], NDArray[Any]],
        is_closed: Optional[ArrayLike] = None,
        **how: Unpack[How],
    ) -> None:
        if not isinstance(pieces, np.ndarray):
            pieces = np.array([tuple(piece) for piece in pieces], PIECE)
        elif pieces.dtype.names != PIECE.names or pieces.ndim != 1:
            raise ArgumentError("pieces must be medax.Piece objects, or rows as Sites.pieces has them")
        given = np.ascontiguousarray(pieces, PIECE)
        closed = flags(() if is_closed is None else is_closed, "is_closed")
        inputs = whole(dimension, "dimension", 32), pointer(given), len(given), pointer(closed), len(closed)
        self._reference = build(Sites, how, lib.medax_sites_create, *inputs)._reference

    @classmethod
    def of(cls, source: Union[Figure, Complex], is_closed: Optional[ArrayLike] = None, **how: Unpack[How]) -> Sites:
        """The curves and points of a plane figure, a site for each part; or a mesh or polygon soup: one site."""
        if isinstance(source, Figure) and is_closed is None:
            made: Sites = build(cls, how, lib.medax_sites_of_figure, source._ref)
            return made
        return cls._of_complex(lib.medax_sites_of_complex, source, is_closed, how)

    @classmethod
    def of_components(cls, complex: Complex, is_closed: Optional[ArrayLike] = None, **how: Unpack[How]) -> Sites:
        """A mesh or polygon soup, a site for each connected component."""
        return cls._of_complex(lib.medax_sites_of_components, complex, is_closed, how)

    @classmethod
    def _of_complex(cls, function: Any, source: Any, is_closed: Optional[ArrayLike], how: How) -> Sites:
        owner = ref(source, Complex, "complex")
        closed = flags(() if is_closed is None else is_closed, "is_closed")
        made: Sites = build(cls, how, function, owner, pointer(closed), len(closed))
        return made

    @property
    def dimension(self) -> int:
        """2 in the plane, else 3."""
        return int(self._get("dimension"))

    @property
    def piece_count(self) -> int:
        """The number of pieces."""
        return int(self._get("piece_count"))

    def pieces(self) -> Any:
        """The pieces: a record array of `kind`, `site` and `numbers` (p, 9)."""
        found = np.zeros(self.piece_count, PIECE)
        check(lib.medax_sites_pieces(self._ref, 0, len(found), pointer(found)))
        return found.view(np.recarray)

    @property
    def site_of_piece(self) -> Indices:
        """The site of each piece."""
        return self._view("site_of_piece")

    @property
    def site_count(self) -> int:
        """The number of sites: one more than the largest number."""
        return int(self._get("site_count"))

    @property
    def bounds(self) -> Floats:
        """The smallest box round the bounded pieces, (2, 3): its least corner and its greatest."""
        return self._box()

    @property
    def size(self) -> float:
        """The diagonal of that box, in input units; 1 without one."""
        return float(self._get("size"))

    def nearest(self, queries: ArrayLike, **how: Unpack[How]) -> Any:
        """What is nearest to each of some points (q, 3): a record array of `point` (q, 3), `distance`, `direction`
        (q, 3), `piece` and `site`."""
        xyz = floats(queries, "queries")
        found, reference, call = np.zeros(len(xyz), NEAREST), self._ref, lib.medax_sites_nearest
        run(how, lambda job: int(call(reference, pointer(xyz), len(xyz), job, pointer(found))))
        return found.view(np.recarray)

    def all_nearest(self, queries: ArrayLike, tolerance: float, **how: Unpack[How]) -> AllNearest:
        """All that is no farther than the nearest and a tolerance, in input units."""
        xyz = floats(queries, "queries")
        inputs = self._ref, pointer(xyz), len(xyz), number(tolerance, "tolerance")
        made: AllNearest = build(AllNearest, how, lib.medax_sites_all_nearest, *inputs)
        return made

    def is_inside(self, queries: ArrayLike, **how: Unpack[How]) -> Flags:
        """Whether each of some points (q, 3) lies inside, (q,)."""
        xyz = floats(queries, "queries")
        found, reference, call = np.zeros(len(xyz), np.uint8), self._ref, lib.medax_sites_is_inside
        run(how, lambda job: int(call(reference, pointer(xyz), len(xyz), job, pointer(found))))
        return found.view(np.bool_)

    def even_directions(self, count: int) -> Floats:
        """Directions spread evenly, (count, 3), for decisions."""
        found = np.empty((whole(count, "count", 32), 3))
        check(lib.medax_sites_even_directions(self._ref, len(found), pointer(found)))
        return found

    def decide(
        self,
        center: ArrayLike,
        radius: float,
        directions: ArrayLike,
        *,
        tolerance: Optional[float] = None,
        epsilon: Optional[float] = None,
        **how: Unpack[How],
    ) -> Decision:
        """Whether a circle or a sphere that the boundary does not enter holds a medial point. It is looked at into some
        directions (d, 3).

        - `tolerance`: nearest points no farther apart than this are the same, in input units; 1e-9 of `size`.
        - `epsilon`: how far a point that is found may be from the axis, in input units; 1e-6 of `size`.
        """
        given = options(_ffi.medax_decide_options, tolerance=tolerance, epsilon=epsilon)
        at, ways, length = vector(center, "center"), floats(directions, "directions"), number(radius, "radius")
        theta, report = np.empty((2 * len(ways), 3)), report_of(_ffi.medax_decision)
        reference, call = self._ref, lib.medax_sites_decide

        def decide(job: Any) -> int:
            looked = reference, pointer(at), length, pointer(ways), len(ways), ctypes.byref(given)
            return int(call(*looked, job, len(theta), pointer(theta), ctypes.byref(report)))

        run(how, decide)
        return told(
            Decision,
            report,
            feet=np.array(report.feet).reshape(2, 3),
            test=DecideTest(report.test),
            theta=theta[: report.theta_count].copy(),
        )

    def _told(self) -> str:
        return f": {self.piece_count} pieces of {self.site_count} sites, dimension {self.dimension}"


def largest_missed_angle(gap: float, radius: float, distance: float) -> float:
    """The largest object angle, in radians, of a medial point that a circle can hold unnoticed; pi for no claim."""
    numbers = number(gap, "gap"), number(radius, "radius"), number(distance, "distance")
    return float(lib.medax_largest_missed_angle(*numbers))


class FieldAxisOptions(TypedDict, total=False):
    """Which points of the medial axis, how dense, and how near to it. Lengths in input units, angles in radians.

    - `density`: within this distance of what is found there is a point; a hundredth of `Sites.size`.
    - `object_angle`: the least object angle of a point, in radians in [0, pi]; 0.
    - `min_distance`: the least distance of a point from the boundary; a quarter of the density in the plane, 0 in
      space.
    - `bound`: in the plane the largest object angle that a point may have and be missed, in radians; pi/9.
    - `tolerance`: nearest points no farther apart than this are the same; 1e-9 of `Sites.size`.
    - `epsilon`: how far a point may be from the axis; 1e-6 of `Sites.size`.
    - `clip`: two corners of a box that holds what is looked at; the box of the sites, larger if the outside is asked
      for.
    - `side`: "inner", "outer" or "both"; "inner".
    - `samples`: the number of points at which each circle or sphere is looked at; what the bound takes in the plane,
      60 in space.
    - `between_sites`: only what has its nearest points on two sites; False.
    """

    density: Optional[float]
    object_angle: Optional[float]
    min_distance: Optional[float]
    bound: Optional[float]
    tolerance: Optional[float]
    epsilon: Optional[float]
    clip: Optional[ArrayLike]
    side: Union[Side, str, None]
    samples: Optional[int]
    between_sites: Optional[bool]


class MedialGraphOptions(TypedDict, total=False):
    """Which part of the axis, and how finely. Lengths in input units, angles in radians.

    - `spacing`: the longest edge of an arc; a hundredth of `Sites.size`.
    - `object_angle`: the least object angle, in radians in [0, pi]; 0.
    - `min_distance`: the least distance from the boundary; 0.
    - `clip`: two corners of a box that holds what is looked at; the box of the sites, larger if the outside is asked
      for.
    - `side`: "inner", "outer" or "both"; "inner".
    - `between_sites`: only what has its nearest points on two sites; False.
    """

    spacing: Optional[float]
    object_angle: Optional[float]
    min_distance: Optional[float]
    clip: Optional[ArrayLike]
    side: Union[Side, str, None]
    between_sites: Optional[bool]


if TYPE_CHECKING:

    class FieldAxisAndHow(FieldAxisOptions, How, total=False):
        """Options of a field axis, and how to run it."""

    class MedialGraphAndHow(MedialGraphOptions, How, total=False):
        """Options of a medial graph, and how to run it."""


class Claim(NamedTuple):
    """What may have been missed: the largest object angle where there is a claim, in radians, and the number of covers
    that make none."""

    angle: float
    unclaimed: int


class AxisPoints(Validated):
    """Points of the medial axis of sites, with what they were found by."""

    _options: ClassVar[Any]

    @classmethod
    def _of(cls, sites: Sites, given: dict[str, Any], pairs: Optional[ArrayLike] = None) -> Any:
        """What is built by some of the options and by settings of a job, of all sites or of pairs of them."""
        fields = {name: given.pop(name) for name in cls._options.__annotations__ if name in given}
        fields.update(clipped(fields.pop("clip", None)))
        if fields.get("side") is not None:
            fields["side"] = Side.of(fields["side"])
        struct = options(getattr(_ffi, cls._stem + "_options"), **fields)
        inputs: tuple[Any, ...] = (ref(sites, Sites, "sites"),)
        if pairs is not None:
            rows = indices(pairs, "pairs", 2)
            inputs += pointer(rows), len(rows)
        function = getattr(lib, f"{cls._stem}_{'build' if pairs is None else 'between'}")
        how: Any = given
        return build(cls, how, function, *inputs, ctypes.byref(struct))

    @property
    def sites(self) -> Sites:
        """What distances were measured to."""
        return self._kept("sites", Sites)

    @property
    def points(self) -> Floats:
        """Where the points lie, (m, 3)."""
        return self._view("points", 3)

    @property
    def radii(self) -> Floats:
        """Their distances from the boundary, (m,)."""
        return self._view("radii")

    @property
    def object_angles(self) -> Floats:
        """The angles between the ways to their nearest points, (m,), in radians."""
        return self._view("object_angles")

    @property
    def feet(self) -> Floats:
        """Two nearest points, (m, 6)."""
        return self._view("feet", 6)

    @property
    def pieces(self) -> Indices:
        """The pieces that have these, (m, 2)."""
        return self._view("pieces", 2)

    @property
    def sites_of_points(self) -> Indices:
        """The sites of these pieces, (m, 2)."""
        return self._view("sites_of_points", 2)


class FieldAxis(AxisPoints, stem="field_axis"):
    """Points of the medial axis of sites, and where they were looked for."""

    _options = FieldAxisOptions

    @classmethod
    def of(cls, sites: Sites, **options: Unpack[FieldAxisAndHow]) -> FieldAxis:
        """Points of the medial axis, by `FieldAxisOptions`."""
        made: FieldAxis = cls._of(sites, dict(options))
        return made

    @classmethod
    def between(cls, sites: Sites, pairs: ArrayLike, **options: Unpack[FieldAxisAndHow]) -> FieldAxis:
        """Only what has its nearest points on one of some pairs of sites, (k, 2)."""
        made: FieldAxis = cls._of(sites, dict(options), pairs)
        return made

    @property
    def resolved(self) -> FieldAxisOptions:
        """What was asked for, with numbers in place of the defaults."""
        found = report_of(_ffi.medax_field_axis_options)
        check(lib.medax_field_axis_resolved(self._ref, ctypes.byref(found)))
        clip = (tuple(found.clip_min), tuple(found.clip_max)) if found.has_clip else None
        made: Any = {name: getattr(found, name) for name in FieldAxisOptions.__annotations__ if name != "clip"}
        made.update(clip=clip, side=Side(found.side), between_sites=bool(found.between_sites))
        resolved: FieldAxisOptions = made
        return resolved

    @property
    def cover_of_point(self) -> Indices:
        """The circle or sphere in which each point was found, (m,)."""
        return self._view("cover_of_point")

    def covers(self) -> Any:
        """The circles or spheres that were looked at: a record array of `center` (c, 3), `radius`, `half`, `gap`,
        `distance`, `missed_angle` and `found`."""
        found = np.zeros(self._get("cover_count"), COVER)
        check(lib.medax_field_axis_covers(self._ref, 0, len(found), pointer(found)))
        return found.view(np.recarray)

    def claim(self) -> Claim:
        """What may have been missed in all."""
        angle, unclaimed = ctypes.c_double(), ctypes.c_size_t()
        check(lib.medax_field_axis_claim(self._ref, ctypes.byref(angle), ctypes.byref(unclaimed)))
        return Claim(angle.value, unclaimed.value)

    @property
    def unconfirmed(self) -> int:
        """How often a test fired of which no point came."""
        return int(self._get("unconfirmed"))

    def complex(self, **how: Unpack[How]) -> Complex:
        """The points as vertices, for writing."""
        made: Complex = build(Complex, how, lib.medax_field_axis_complex, self._ref)
        return made

    def surface(self, **how: Unpack[How]) -> Complex:
        """In space the axis as polygons, and loose edges where it is a curve."""
        made: Complex = build(Complex, how, lib.medax_field_axis_surface, self._ref)
        return made

    def _told(self) -> str:
        return f": {len(self.points)} points"


class MedialGraph(AxisPoints, stem="medial_graph"):
    """The medial axis of sites in the plane as a graph: nodes, where arcs meet or end, and arcs."""

    _options = MedialGraphOptions

    @classmethod
    def of(cls, sites: Sites, **options: Unpack[MedialGraphAndHow]) -> MedialGraph:
        """The graph, by `MedialGraphOptions`."""
        made: MedialGraph = cls._of(sites, dict(options))
        return made

    @classmethod
    def between(cls, sites: Sites, pairs: ArrayLike, **options: Unpack[MedialGraphAndHow]) -> MedialGraph:
        """Only what has its nearest points on one of some pairs of sites, (k, 2)."""
        made: MedialGraph = cls._of(sites, dict(options), pairs)
        return made

    @property
    def node_count(self) -> int:
        """How many of the points are nodes: the first ones."""
        return int(self._get("node_count"))

    @property
    def arcs(self) -> Rows:
        """One row an arc: its points in order."""
        return self._rows("arcs")

    @property
    def torn(self) -> int:
        """How many sides of arcs have no other side that agrees with them."""
        return int(self._get("torn"))

    def complex(self, **how: Unpack[How]) -> Complex:
        """The arcs as loose edges, for writing."""
        made: Complex = build(Complex, how, lib.medax_medial_graph_complex, self._ref)
        return made

    def _told(self) -> str:
        return f": {self.node_count} nodes, {len(self.arcs)} arcs"
