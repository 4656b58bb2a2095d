# SPDX-License-Identifier: MIT OR Apache-2.0
"""Results as the arrays that a mesh of Blender takes; made in the worker's thread, without Blender."""

from __future__ import annotations

import dataclasses

import medax
import numpy as np

#: Types of Blender's attributes by dtype and columns, and what their values are called.
TYPES = {
    ("f", 1): ("FLOAT", "value"),
    ("f", 2): ("FLOAT2", "vector"),
    ("f", 3): ("FLOAT_VECTOR", "vector"),
    ("i", 1): ("INT", "value"),
    ("i", 2): ("INT32_2D", "value"),
}


@dataclasses.dataclass(frozen=True)
class Drawn:
    """A mesh: `corners` has the vertices of all faces, `starts` where each face begins; `edges` are loose;
    `attributes` by domain ("POINT", "FACE") and name."""

    name: str
    xyz: np.ndarray
    starts: np.ndarray
    corners: np.ndarray
    edges: np.ndarray
    attributes: dict[tuple[str, str], np.ndarray]
    smooth: bool = False
    skin: bool = False

    @classmethod
    def of(cls, name: str, made: medax.Complex, triangles: bool = False, smooth: bool = False) -> Drawn:
        """A complex, with its polygons or its triangles."""
        if triangles:
            corners = made.triangles.reshape(-1)
            starts = np.arange(0, len(corners), 3)
            face = made.face_of_triangle
        else:
            corners, starts = made.faces.indices, made.faces.offsets[:-1]
            face = slice(None)
        attributes = {}
        for each in made.attributes:
            domain = {medax.Element.VERTEX: "POINT", medax.Element.FACE: "FACE"}.get(each.element)
            values = each.values
            if domain is None or _type(values) is None:
                continue
            if domain == "FACE":
                values = values[face]
            # What is nothing, NONE, becomes -1.
            single = values.astype(np.float32) if values.dtype.kind == "f" else values.astype(np.uint32).view(np.int32)
            attributes[domain, each.name] = single
        xyz = made.vertices.astype(np.float32)
        starts, corners, edges = (each.astype(np.int32) for each in (starts, corners, made.edges))
        return cls(name, xyz, starts, corners, edges, attributes, smooth)

    def apart(self, name: str) -> list[Drawn]:
        """The faces, and the loose edges under another name, to be skinned; each only if there are any."""
        parts = []
        if len(self.starts):
            used = np.zeros(len(self.xyz), bool)
            used[self.corners] = True
            parts.append(self._part(self.name, used, faces=True))
        if len(self.edges):
            used = np.zeros(len(self.xyz), bool)
            used[self.edges] = True
            parts.append(self._part(name, used, faces=False))
        return parts or [self]

    def skeleton(self, name: str) -> Drawn:
        """All edges, the sides of faces too, and no faces; to be skinned."""
        edges = np.unique(np.sort(np.concatenate([self.edges, self.sides()]), axis=1), axis=0)
        points = {key: values for key, values in self.attributes.items() if key[0] == "POINT"}
        none = np.empty(0, np.int32)
        return Drawn(name, self.xyz, none, none, edges, points, skin=True)

    def sides(self) -> np.ndarray:
        """Each side of each face."""
        # The corner after each one, round its face.
        after = np.arange(1, len(self.corners) + 1)
        after[np.append(self.starts[1:], len(self.corners))[: len(self.starts)] - 1] = self.starts
        return np.stack([self.corners, self.corners[after]], axis=1)

    def _part(self, name: str, used: np.ndarray, faces: bool) -> Drawn:
        row = np.cumsum(used, dtype=np.int32) - 1
        none = np.empty(0, np.int32)
        attributes = {}
        for (domain, title), values in self.attributes.items():
            if domain == "POINT":
                attributes[domain, title] = values[used]
            elif faces:
                attributes[domain, title] = values
        starts, corners = (self.starts, row[self.corners]) if faces else (none, none)
        edges = none.reshape(0, 2) if faces else row[self.edges]
        return Drawn(name, self.xyz[used], starts, corners, edges, attributes, self.smooth, skin=not faces)

    def radii(self) -> np.ndarray | None:
        return self.attributes.get(("POINT", "radius"))

    def roots(self) -> np.ndarray:
        """One vertex of each connected piece: where a skin begins."""
        pairs = np.concatenate([self.edges, self.sides()])
        least = np.arange(len(self.xyz))
        a, b = pairs[:, 0], pairs[:, 1]
        while True:
            low = np.minimum(least[a], least[b])
            before = least.copy()
            # The root of each end is lowered, then everything that hangs on it.
            np.minimum.at(least, before[a], low)
            np.minimum.at(least, before[b], low)
            while True:
                jumped = least[least]
                if (jumped == least).all():
                    break
                least = jumped
            if (least == before).all():
                return np.unique(least[pairs])


@dataclasses.dataclass(frozen=True)
class Painted:
    """Values and colours (RGBA) of the vertices of the object itself."""

    name: str
    attributes: dict[str, np.ndarray]
    colour_name: str
    colours: np.ndarray


def _type(values: np.ndarray) -> tuple[str, str] | None:
    return TYPES.get(("f" if values.dtype.kind == "f" else "i", 1 if values.ndim == 1 else values.shape[1]))


def type_of(values: np.ndarray) -> tuple[str, str]:
    """Blender's type for some values, and what they are called in it."""
    found = _type(values)
    assert found is not None
    return found
