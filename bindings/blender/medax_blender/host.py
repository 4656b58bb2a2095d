# SPDX-License-Identifier: MIT OR Apache-2.0
"""Objects of Blender in, objects out.

The library works where lengths are true: in the space of the object with its scale applied. Results have the object's place and
rotation, and a scale of 1, so that their radii and thicknesses are lengths in Geometry Nodes, in modifiers, and in
the scene alike, however the object was stretched.
"""

from __future__ import annotations

import dataclasses
import hashlib
from collections.abc import Iterator
from typing import Any

import bmesh
import bpy
import numpy as np
from mathutils import Matrix

from .drawn import Drawn, Painted, type_of
from .recipes import Input, Refused

#: What has vertices when it is evaluated.
TYPES = {"MESH", "CURVE", "SURFACE", "FONT", "META", "POINTCLOUD"}


@dataclasses.dataclass(frozen=True)
class Source:
    """An object as it was read: its name, its place and rotation, its scale (and shear) as a matrix (3, 3), and its
    points and triangles with that scale applied; `is_cloud` where these are points of a point cloud, not of a mesh."""

    name: str
    rigid: np.ndarray
    scale: np.ndarray
    input: Input
    is_cloud: bool = False


def divided(matrix: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """A matrix (4, 4) as place and rotation (4, 4), and what it does before: scale, mirror, shear (3, 3)."""
    linear = matrix[:3, :3]
    lengths = np.linalg.norm(linear, axis=0)
    if lengths.min() == 0 or np.linalg.matrix_rank(linear) < 3:
        raise Refused("The object is scaled to nothing in some direction")
    # The matrix is one of single floats: what is a rotation but for rounding leaves coordinates as they are.
    lengths = np.where(np.abs(lengths - 1) < 1e-6, 1.0, lengths)
    rotation = linear / lengths
    if np.allclose(rotation.T @ rotation, np.eye(3), atol=1e-5):
        if np.linalg.det(rotation) < 0:
            rotation, lengths = -rotation, -lengths
        scale = np.diag(lengths)
    else:
        u, stretch, v = np.linalg.svd(linear)
        sign = np.sign(np.linalg.det(u @ v))
        rotation, scale = sign * (u @ v), sign * (v.T * stretch @ v)
    rigid = matrix.copy()
    rigid[:3, :3] = rotation
    return rigid, scale


def _floats(collection: Any, name: str, count: int) -> np.ndarray:
    values = np.empty((count, 3), np.float32)
    collection.foreach_get(name, values.ravel())
    return values


def cloud_of(depsgraph: Any, thing: Any) -> np.ndarray:
    """The points that modifiers make of an object that is no point cloud, such as Mesh to Points: its evaluated data is a
    mesh all the same, an empty one, and only the iterator over the scene comes by them."""
    for instance in depsgraph.object_instances:
        part = instance.object
        if part.type == "POINTCLOUD" and part.original == thing:
            return _floats(part.data.points, "co", len(part.data.points))
    return np.empty((0, 3), np.float32)


def read(context: Any) -> Source:
    """The active object with its modifiers applied."""
    thing = context.active_object
    if thing is None or thing.type not in TYPES:
        raise Refused("There is no active object with vertices")
    depsgraph = context.evaluated_depsgraph_get()
    evaluated = thing.evaluated_get(depsgraph)
    rigid, scale = divided(np.array(evaluated.matrix_world, dtype=float))
    triangles = np.empty((0, 3), np.uint32)
    is_cloud = thing.type == "POINTCLOUD"
    if is_cloud:
        points = evaluated.data.points
        xyz = _floats(points, "co", len(points))
    else:
        mesh = evaluated.to_mesh()
        if mesh is None:
            raise Refused(f"{thing.name} has no vertices")
        try:
            xyz = _floats(mesh.vertices, "co", len(mesh.vertices))
            mesh.calc_loop_triangles()
            corners = np.empty((len(mesh.loop_triangles), 3), np.int32)
            mesh.loop_triangles.foreach_get("vertices", corners.ravel())
            triangles = corners.astype(np.uint32)
        finally:
            evaluated.to_mesh_clear()
        if not len(xyz):
            xyz = cloud_of(depsgraph, thing)
            is_cloud = len(xyz) > 0
    xyz = xyz.astype(float)
    if not np.array_equal(scale, np.eye(3)):
        xyz = xyz @ scale.T
    if np.linalg.det(scale) < 0:
        # Mirrored faces point inwards.
        triangles = np.ascontiguousarray(triangles[:, ::-1])
    digest = hashlib.blake2b(xyz.tobytes(), digest_size=16)
    digest.update(triangles.tobytes())
    return Source(thing.name, rigid, scale, Input(xyz, triangles, digest.digest()), is_cloud)


def write(context: Any, source: Source, parts: list[Any], hide: bool, material: bool = False) -> list[Any]:
    """Makes objects of results, beside the one that was read; they are selected, and the first is active."""
    original = bpy.data.objects.get(source.name)
    if original is None:
        raise Refused(f"{source.name} is no longer there")
    meshes = []
    for part in parts:
        made = painted(context, original, source, part) if isinstance(part, Painted) else drawn(part)
        made.name = f"{source.name} {part.name}"
        meshes.append(made)
    for each in context.selected_objects:
        each.select_set(False)
    shown = set(collections(context.view_layer.layer_collection))
    collection = next((each for each in original.users_collection if each in shown), context.scene.collection)
    objects = []
    for part, mesh in zip(parts, meshes):
        made = bpy.data.objects.new(mesh.name, mesh)
        made.matrix_world = Matrix(source.rigid.tolist())
        collection.objects.link(made)
        if isinstance(part, Drawn) and part.skin:
            skinned(made, part)
        if material and isinstance(part, Painted):
            mesh.materials.clear()
            mesh.materials.append(coloured(part.colour_name))
        made.select_set(True)
        objects.append(made)
    context.view_layer.objects.active = objects[0]
    if hide:
        original.hide_set(True)
    return objects


def collections(layer: Any) -> Iterator[Any]:
    """The collections of a view layer that it does not leave out."""
    if not layer.exclude:
        yield layer.collection
    for child in layer.children:
        yield from collections(child)


def skinned(thing: Any, part: Drawn) -> None:
    """Modifiers that make a solid of a skeleton. Skin folds where edges are far shorter than radii, as Voronoi edges are."""
    radii = part.radii()
    weld = thing.modifiers.new("Weld", "WELD")
    weld.merge_threshold = 0.5 * float(np.median(radii)) if radii is not None else 0
    thing.modifiers.new("Skin", "SKIN")


def attribute(mesh: Any, domain: str, name: str, values: np.ndarray) -> None:
    kind, called = type_of(values)
    made = mesh.attributes.new(name, kind, domain)
    made.data.foreach_set(called, np.ascontiguousarray(values).ravel())


def drawn(part: Drawn) -> Any:
    """A mesh of a result."""
    mesh = bpy.data.meshes.new(part.name)
    radii = part.radii()
    skinned = len(part.edges) > 0 and radii is not None
    if skinned:
        # Only a BMesh makes this layer; of no vertex yet, which is quick.
        empty = bmesh.new()
        empty.verts.layers.skin.new()
        empty.to_mesh(mesh)
        empty.free()
    mesh.vertices.add(len(part.xyz))
    mesh.vertices.foreach_set("co", part.xyz.ravel())
    if len(part.edges):
        mesh.edges.add(len(part.edges))
        mesh.edges.foreach_set("vertices", part.edges.ravel())
    if len(part.starts):
        mesh.loops.add(len(part.corners))
        mesh.loops.foreach_set("vertex_index", part.corners)
        mesh.polygons.add(len(part.starts))
        mesh.polygons.foreach_set("loop_start", part.starts)
    for (domain, name), values in part.attributes.items():
        attribute(mesh, domain, name, values)
    if skinned:
        skin = mesh.skin_vertices[0].data
        skin.foreach_set("radius", np.repeat(radii, 2))
        roots = np.zeros(len(part.xyz), bool)
        roots[part.roots()] = True
        skin.foreach_set("use_root", roots)
    mesh.update(calc_edges=True, calc_edges_loose=True)
    if not part.smooth:
        # Faces of axes have no common side: smooth ones are dark where two of them are turned against each other.
        mesh.shade_flat()
    # Blender must never see a face twice, or one that meets itself.
    mesh.validate()
    return mesh


def painted(context: Any, original: Any, source: Source, part: Painted) -> Any:
    """A copy of an object's mesh, modifiers and scale applied, with values and colours."""
    if source.is_cloud:
        mesh = bpy.data.meshes.new(part.name)
        mesh.vertices.add(len(source.input.xyz))
    else:
        depsgraph = context.evaluated_depsgraph_get()
        evaluated = original.evaluated_get(depsgraph)
        mesh = bpy.data.meshes.new_from_object(evaluated, preserve_all_data_layers=True, depsgraph=depsgraph)
    count = len(mesh.vertices)
    if count != len(part.colours):
        bpy.data.meshes.remove(mesh)
        raise Refused(f"{original.name} has changed meanwhile")
    mesh.vertices.foreach_set("co", source.input.xyz.astype(np.float32).ravel())
    if np.linalg.det(source.scale) < 0:
        mesh.flip_normals()
    for name, values in part.attributes.items():
        remove(mesh, name)
        attribute(mesh, "POINT", name, values)
    remove(mesh, part.colour_name)
    layer = mesh.color_attributes.new(part.colour_name, "FLOAT_COLOR", "POINT")
    layer.data.foreach_set("color", part.colours.ravel())
    index = mesh.color_attributes.find(part.colour_name)
    mesh.color_attributes.active_color_index = index
    mesh.color_attributes.render_color_index = index
    mesh.update()
    return mesh


def remove(mesh: Any, name: str) -> None:
    """Takes an attribute away that a result of the same name replaces."""
    found = mesh.attributes.get(name)
    if found is not None:
        mesh.attributes.remove(found)


def coloured(name: str) -> Any:
    """The material that shows a colour attribute."""
    found = bpy.data.materials.get(name)
    if found is not None:
        return found
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    nodes = made.node_tree.nodes
    colour = nodes.new("ShaderNodeVertexColor")
    colour.layer_name = name
    colour.location = (-300, 200)
    shader = next(node for node in nodes if node.type == "BSDF_PRINCIPLED")
    shader.inputs["Roughness"].default_value = 0.7
    made.node_tree.links.new(colour.outputs["Color"], shader.inputs["Base Color"])
    return made


def length(context: Any, value: float) -> str:
    """A length in the units of the scene."""
    settings = context.scene.unit_settings
    if settings.system == "NONE":
        return f"{value:.6g}"
    return bpy.utils.units.to_string(settings.system, "LENGTH", value * settings.scale_length, precision=4)
