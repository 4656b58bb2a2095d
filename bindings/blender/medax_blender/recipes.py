# SPDX-License-Identifier: MIT OR Apache-2.0
"""What each operator asks of the library, without Blender: a recipe holds the settings, and cooks in a worker's thread."""

from __future__ import annotations

import dataclasses
import math
from typing import Any, Optional

import medax
import numpy as np

from . import colours, kept
from .drawn import Drawn, Painted
from .task import Steps


@dataclasses.dataclass(frozen=True)
class Input:
    """Points (n, 3), triangles (t, 3) if there are faces, and a key that only equal inputs share."""

    xyz: np.ndarray
    triangles: np.ndarray
    key: bytes


@dataclasses.dataclass(frozen=True)
class Result:
    """What is to become objects, and a sentence with lengths to be filled in, in the scene's units."""

    parts: list[Any]
    text: str
    lengths: tuple[float, ...] = ()


@dataclasses.dataclass(frozen=True)
class Recipe:
    """- `sample`: the "VERTICES" as they are, or points on the "FACES" (where there are none: the vertices).
    - `spacing`: the least distance of points on faces; 0: a hundredth of the diagonal.
    - `inside`: what tells inside from outside: "COCONE", "CRUST" or "FACES"."""

    title = ""
    sample: str = "VERTICES"
    spacing: float = 0.0
    inside: str = "COCONE"

    def cook(self, source: Input, steps: Steps) -> Result:
        raise NotImplementedError

    def _on_faces(self, source: Input) -> bool:
        return self.sample == "FACES" and len(source.triangles) > 0

    def _kept(self, source: Input) -> kept.Kept:
        on_faces = self._on_faces(source)
        return kept.of((source.key, on_faces, self.spacing if on_faces else None))

    def _points(self, source: Input, steps: Steps) -> medax.Points:
        def make() -> medax.Points:
            xyz = source.xyz
            if self._on_faces(source):
                spacing = self.spacing or None
                xyz = medax.Samples.of(mesh(source), spacing=spacing, job=steps.job(0.05, "Sample")).coords
            return medax.Points(xyz, job=steps.job(0.07, "Points"))

        return self._kept(source).once("points", None, make)

    def _diagram(self, source: Input, steps: Steps, end: float) -> tuple[medax.Dual, medax.Labels]:
        """The Voronoi diagram and what is inside, made from 0.07 to `end`."""
        have = self._kept(source)
        points = self._points(source, steps)

        def dual() -> medax.Dual:
            job = steps.job(0.07 + (end - 0.07) * 0.4, "Delaunay triangulation")
            triangulation = medax.Triangulation.delaunay(points, job=job)
            return medax.Dual.of(
                triangulation, facets=True, job=steps.job(0.07 + (end - 0.07) * 0.6, "Voronoi diagram")
            )

        made = have.once("dual", None, dual)

        def labels() -> medax.Labels:
            if self.inside == "FACES":
                return medax.Labels.of(made, mesh(source), job=steps.job(end, "Inside and outside"))
            between = 0.07 + (end - 0.07) * 0.9
            if self.inside == "CRUST":
                crust = medax.PowerCrust.of(points, job=steps.job(between, "Power crust"))
                return medax.Labels.of(made, crust, job=steps.job(end, "Inside and outside"))
            cocone = medax.Cocone.of(made, job=steps.job(between, "Tight Cocone"))
            return medax.Labels.of(cocone, job=steps.job(end, "Inside and outside"))

        return made, have.once("labels", self.inside, labels)

    def _medial(self, source: Input, steps: Steps, end: float) -> medax.Medial:
        dual, labels = self._diagram(source, steps, 0.8 * end)

        def make() -> medax.Medial:
            return medax.Medial.of(dual, labels, job=steps.job(end, "Conditions of the axis"))

        return self._kept(source).once("medial", self.inside, make)

    def _flow(self, source: Input, steps: Steps, end: float) -> medax.Flow:
        dual, labels = self._diagram(source, steps, 0.7 * end)

        def make() -> medax.Flow:
            return medax.Flow.of(dual, labels, job=steps.job(end, "Flow"))

        return self._kept(source).once("flow", self.inside, make)


class Refused(Exception):
    """What cannot be asked of this input."""


def mesh(source: Input) -> medax.Complex:
    """The faces of the input."""
    if not len(source.triangles):
        raise Refused("The object has no faces: let Tight Cocone or the power crust tell inside from outside")
    return medax.Complex(source.xyz, source.triangles)


def filled(made: medax.Complex, message: str) -> medax.Complex:
    """A result of which something is to be seen: of nothing no object is made."""
    if not len(made.vertices):
        raise Refused(message)
    return made


EMPTY = "The surface is empty: the sample is too sparse"


def span(values: np.ndarray) -> tuple[float, float]:
    """The least and the largest of some lengths."""
    values = values[np.isfinite(values)]
    return (float(values.min()), float(values.max())) if len(values) else (math.nan, math.nan)


@dataclasses.dataclass(frozen=True)
class PowerCrust(Recipe):
    """A closed surface of points."""

    title = "Power Crust"
    omit: str = "nothing"
    lambda_: float = 0.0
    label_rule: str = "auto"
    triangles: bool = False
    open: bool = False

    def cook(self, source: Input, steps: Steps) -> Result:
        crust = crust_of(self, source, steps, 0.85)
        surface = filled(crust.surface, EMPTY)
        if self.open:
            surface = filled(crust.open(job=steps.job(0.95, "Holes"))[0], "Every face closes a hole: nothing is left")
        drawn = Drawn.of(self.title, surface, triangles=self.triangles, smooth=True)
        return Result([drawn], f"{len(surface.faces)} faces")


def crust_of(recipe: Any, source: Input, steps: Steps, end: float) -> medax.PowerCrust:
    """The power crust of a recipe that has settings for it."""
    points = recipe._points(source, steps)

    def make() -> medax.PowerCrust:
        return medax.PowerCrust.of(
            points,
            omit=recipe.omit,
            lambda_=recipe.lambda_ or None,
            label_rule=recipe.label_rule,
            job=steps.job(end, "Power crust"),
        )

    return recipe._kept(source).once("crust", (recipe.omit, recipe.lambda_, recipe.label_rule), make)


@dataclasses.dataclass(frozen=True)
class MedialAxis(Recipe):
    """The Voronoi facets that a filter lets pass."""

    title = "Medial Axis"
    theta: float = math.pi / 8
    rho: float = 8.0
    rule: str = "angle_or_ratio"
    object_angle: float = 0.0
    side: str = "inner"
    margin: float = 0.1

    def cook(self, source: Input, steps: Steps) -> Result:
        medial = self._medial(source, steps, 0.9)
        clip = None
        if self.side != "inner":
            # The outer axis goes to infinity.
            least, greatest = medial.dual.triangulation.points.bounds
            grown = self.margin * np.linalg.norm(greatest - least)
            clip = least - grown, greatest + grown
        axis = medial.axis(
            theta=self.theta,
            rho=self.rho,
            rule=self.rule,
            object_angle=self.object_angle,
            side=self.side,
            clip=clip,
            job=steps.job(0.97, "Facets of the axis"),
        )
        filled(axis, "No facet passes: take a smaller theta or rho, or a denser sample")
        least, most = span(axis.values("radius"))
        return Result([Drawn.of(self.title, axis)], f"{len(axis.faces)} faces, radius {{}} to {{}}", (least, most))


@dataclasses.dataclass(frozen=True)
class Core(Recipe):
    """The core: what flows from the critical points inside. That of the other side goes to infinity, and nothing clips it."""

    title = "Core"
    repair: bool = True
    extend: bool = False
    theta: float = math.pi / 8
    rho: float = 8.0
    skin: bool = False

    def cook(self, source: Input, steps: Steps) -> Result:
        facets = None
        if self.extend:
            medial = self._medial(source, steps, 0.7)
            job = steps.job(0.75, "Facets of the axis")
            facets = medial.selected(theta=self.theta, rho=self.rho, job=job)
        flow = self._flow(source, steps, 0.85)
        core = flow.core(facets, repair=self.repair, job=steps.job(0.97, "Core")).complex
        filled(core, "The core is empty: there is no critical point inside")
        parts = [Drawn.of(self.title, core)]
        if self.skin:
            # Skin makes something of every edge, those of faces included: good for the few of a core, not for an axis.
            parts = parts[0].apart("Skeleton") if self.extend else [parts[0].skeleton("Skeleton")]
        least, most = span(core.values("radius"))
        text = f"{len(core.faces)} faces, {len(core.edges)} edges, radius {{}} to {{}}"
        return Result(parts, text, (least, most))


@dataclasses.dataclass(frozen=True)
class Thickness(Recipe):
    """The diameter of the ball inside that touches the surface at each vertex; `least` and `most` are what the ends of
    the colours mean, 0 for what the values say themselves."""

    title = "Thickness"
    sample: str = "FACES"
    omit: str = "nothing"
    lambda_: float = 0.0
    label_rule: str = "auto"
    size: str = "thickness"
    least: float = 0.0
    most: float = 0.0

    def cook(self, source: Input, steps: Steps) -> Result:
        have = self._kept(source)
        crust = crust_of(self, source, steps, 0.75)

        def sizes() -> medax.Sizes:
            decided = crust
            if self._on_faces(source):
                # The faces know better than the samples what is inside.
                decided = crust.labelled_by_mesh(mesh(source), job=steps.job(0.85, "Inside and outside"))
            return decided.sizes_at(source.xyz, job=steps.job(0.97, "Sizes"))

        key = (self.omit, self.lambda_, self.label_rule)
        values = getattr(have.once("sizes", key, sizes), self.size)
        self._check(source, values)
        ends = colours.ends(values, self.least, self.most)
        attributes = {self.size: values.astype(np.float32)}
        painted = Painted(self.title, attributes, self.size + "_colour", colours.of(values, *ends))
        name = self.size.replace("_", " ")
        return Result([painted], f"{name} {{}} to {{}}; red {{}}, blue {{}}", (*span(values), *ends))

    def _check(self, source: Input, values: np.ndarray) -> None:
        """What is 0 or nothing everywhere is no thickness."""
        name = self.size.replace("_", " ")
        if not np.isfinite(values).any():
            raise Refused(f"There is no {name} anywhere: the sample is too sparse")
        if not np.nanmax(values):
            why = "do faces point inward?" if self._on_faces(source) else "the sample is too sparse"
            raise Refused(f"Every {name} is 0: {why}")


@dataclasses.dataclass(frozen=True)
class IsoSurface(Recipe):
    """A closed surface between an inner structure (t = 0) and the boundary (t = 1)."""

    title = "Iso-Surface"
    t: float = 0.5
    inner: str = "voronoi"
    theta: float = math.pi / 8
    rho: float = 8.0

    def cook(self, source: Input, steps: Steps) -> Result:
        have = self._kept(source)
        dual, labels = self._diagram(source, steps, 0.4)
        whole = have.once(
            "pair", self.inside, lambda: medax.Pair.voronoi(dual, labels, job=steps.job(0.6, "Pair-mesh"))
        )
        pair = whole
        if self.inner != "voronoi":
            filter_ = (self.theta, self.rho) if self.inner == "medial" else None
            pair = have.once("onto", (self.inside, self.inner, filter_), lambda: self._onto(source, steps, whole))
        surface = filled(pair.iso_surface(self.t, job=steps.job(0.97, "Surface")), EMPTY)
        return Result([Drawn.of(self.title, surface, smooth=True)], f"{len(surface.faces)} faces")

    def _onto(self, source: Input, steps: Steps, whole: medax.Pair) -> medax.Pair:
        part: Optional[medax.Complex] = None
        if self.inner == "medial":
            medial = self._medial(source, steps, 0.7)
            part = medial.axis(theta=self.theta, rho=self.rho, job=steps.job(0.75, "Facets of the axis"))
        elif self.inner == "core":
            flow = self._flow(source, steps, 0.7)
            part = flow.core(job=steps.job(0.75, "Core")).complex
        else:
            # Nothing is asked for, and a spine is left.
            part = medax.Complex(np.empty((0, 3)))
        return whole.onto(part, job=steps.job(0.95, "Pair-mesh of the inner structure"))
