# SPDX-License-Identifier: MIT OR Apache-2.0
"""What each operator makes, as objects of Blender."""

import math

import bmesh
import bpy
import medax
import numpy as np
import pytest
from conftest import add, names, torus, torus_points, values, vertices
from mathutils import Matrix, kdtree


def topology(mesh):
    """Euler's characteristic, and whether every edge has two faces."""
    made = bmesh.new()
    made.from_mesh(mesh)
    euler = len(made.verts) - len(made.edges) + len(made.faces)
    closed = all(edge.is_manifold for edge in made.edges) and bool(made.faces)
    volume = made.calc_volume(signed=True)
    made.free()
    return euler, closed, volume


def nearest(points, queries):
    tree = kdtree.KDTree(len(points))
    for index, point in enumerate(points):
        tree.insert(point, index)
    tree.balance()
    return np.array([tree.find(query)[2] for query in queries])


TORUS = 2 * math.pi**2 * 0.4**2


@pytest.mark.parametrize("triangles", (False, True))
def test_power_crust(triangles):
    add("Scan", torus_points(1500))
    assert bpy.ops.medax.power_crust(triangles=triangles) == {"FINISHED"}
    crust = bpy.context.active_object
    assert crust.name == "Scan Power Crust"
    euler, closed, volume = topology(crust.data)
    # A closed surface in one piece of genus 1.
    assert (euler, closed) == (0, True)
    assert volume == pytest.approx(TORUS, rel=0.02)
    sides = {len(face.vertices) for face in crust.data.polygons}
    assert sides == {3} if triangles else len(sides) > 1
    assert bpy.data.objects["Scan"].hide_get()


def test_power_crust_of_faces():
    bpy.ops.mesh.primitive_torus_add(major_segments=12, minor_segments=8, major_radius=1, minor_radius=0.4)
    assert bpy.ops.medax.power_crust(sample="FACES", spacing=0.06, hide=False) == {"FINISHED"}
    assert topology(bpy.context.active_object.data)[:2] == (0, True)
    assert not bpy.data.objects["Torus"].hide_get()


def values_of_sharp(mesh):
    sharp = np.empty(len(mesh.polygons), bool)
    mesh.attributes["sharp_face"].data.foreach_get("value", sharp)
    return sharp


def test_medial_axis():
    source = torus()
    assert bpy.ops.medax.medial_axis() == {"FINISHED"}
    axis = bpy.context.active_object
    radius = values(axis.data, "radius")
    assert axis.data.attributes["radius"].domain == "POINT"
    assert np.allclose(radius, nearest(vertices(source), vertices(axis)), atol=1e-6)
    assert values_of_sharp(axis.data).all()
    # The axis of a torus is the circle in its middle.
    at = vertices(axis)
    assert np.abs(np.hypot(at[:, 0], at[:, 1]) - 1).max() < 0.1
    assert {"side", "object_angle", "lambda"} <= set(axis.data.attributes.keys())


def test_outer_axis_is_clipped():
    torus()
    assert bpy.ops.medax.medial_axis(side="outer") == {"FINISHED"}
    at = vertices(bpy.context.active_object)
    assert np.abs(at).max() < 2
    # It goes through the middle of the hole.
    assert np.linalg.norm(at[:, :2], axis=1).min() < 0.1


def test_core_is_a_skeleton_for_skin():
    source = add("Scan", medax.Samples.of("torus", spacing=0.1).coords)
    assert bpy.ops.medax.core() == {"FINISHED"}
    core = bpy.context.active_object
    mesh = core.data
    assert len(mesh.edges) > 40
    # A closed curve: as many edges as vertices.
    assert topology(mesh)[0] == 0 and not len(mesh.polygons)
    radius = values(mesh, "radius")
    assert np.allclose(radius, nearest(vertices(source), vertices(core)), atol=1e-6)
    skin = mesh.skin_vertices[0].data
    radii = np.empty(2 * len(skin), np.float32)
    skin.foreach_get("radius", radii)
    assert np.array_equal(radii.reshape(-1, 2), np.stack([radius, radius], axis=1))
    assert sum(each.use_root for each in skin) == 1
    core.modifiers.new("Skin", "SKIN")
    skinned = core.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    euler, closed, volume = topology(skinned)
    # A square tube in a round one: about two thirds.
    assert closed and euler == 0 and 0.5 * TORUS < volume < TORUS


def test_core_with_faces_and_its_skeleton_apart():
    bpy.ops.mesh.primitive_monkey_add()
    monkey = bpy.context.active_object
    monkey.modifiers.new("Subdivision", "SUBSURF").levels = 2
    assert bpy.ops.medax.core(extend=True, sample="FACES", skin=True) == {"FINISHED"}
    assert names() == ["Suzanne", "Suzanne Core", "Suzanne Skeleton"]
    faces, skeleton = bpy.data.objects["Suzanne Core"], bpy.data.objects["Suzanne Skeleton"]
    assert len(faces.data.polygons) and not faces.data.skin_vertices
    assert len(skeleton.data.edges) and not skeleton.data.polygons
    assert [modifier.type for modifier in skeleton.modifiers] == ["WELD", "SKIN"]
    # A root for each piece.
    made = bmesh.new()
    made.from_mesh(skeleton.data)
    left, pieces = set(made.verts), 0
    while left:
        pieces, todo = pieces + 1, [left.pop()]
        while todo:
            for edge in todo.pop().link_edges:
                more = set(edge.verts) & left
                left -= more
                todo += more
    made.free()
    assert sum(each.use_root for each in skeleton.data.skin_vertices[0].data) == pieces


def test_core_as_a_skeleton():
    # Some of the core of this regular torus are faces; their sides are in the skeleton.
    torus()
    bpy.ops.medax.core()
    core = bpy.context.active_object.data
    sides = {tuple(sorted(edge.vertices)) for edge in core.edges}
    bpy.context.view_layer.objects.active = bpy.data.objects["Torus"]
    assert bpy.ops.medax.core(skin=True) == {"FINISHED"}
    skeleton = bpy.context.active_object
    assert skeleton.name == "Torus Skeleton" and len(core.polygons) and not skeleton.data.polygons
    assert {tuple(sorted(edge.vertices)) for edge in skeleton.data.edges} == sides
    assert [modifier.type for modifier in skeleton.modifiers] == ["WELD", "SKIN"]
    skinned = skeleton.evaluated_get(bpy.context.evaluated_depsgraph_get()).to_mesh()
    euler, closed, volume = topology(skinned)
    # About the solid: what Skin makes where a bar is short may fold.
    assert closed and 0.5 * TORUS < volume < 1.5 * TORUS


def plate():
    """A cube of edge 2, subdivided by a modifier and scaled to 4 by 4 by 0.3."""
    bpy.ops.mesh.primitive_cube_add(size=2, location=(5, 6, 7), rotation=(0.3, 0.2, 0.1))
    made = bpy.context.active_object
    made.scale = (2, 2, 0.15)
    modifier = made.modifiers.new("Subdivision", "SUBSURF")
    modifier.subdivision_type, modifier.levels = "SIMPLE", 4
    bpy.context.view_layer.update()
    return made


def test_thickness_of_a_scaled_cube_with_a_modifier():
    source = plate()
    assert bpy.ops.medax.thickness(spacing=0.06) == {"FINISHED"}
    made = bpy.context.active_object
    assert len(made.data.vertices) == 6 * 16 * 16 + 2 and len(source.data.vertices) == 8
    thickness = values(made.data, "thickness")
    at = vertices(made)
    middle = (np.abs(at[:, :2]) < 1.7).all(axis=1)
    assert middle.sum() > 200
    # A ball between the samples of a wall is a little larger.
    assert np.all(thickness[middle] > 0.299) and np.all(thickness[middle] < 0.33)
    assert np.allclose(np.abs(at[:, 2]).max(), 0.15)
    # Place and rotation are the object's, its scale is applied.
    assert np.allclose(made.matrix_world.to_scale(), 1)
    seen = source.evaluated_get(bpy.context.evaluated_depsgraph_get())
    assert np.allclose(vertices(made, world=True), vertices(seen, world=True), atol=1e-5)
    colour = made.data.color_attributes["thickness_colour"]
    assert made.data.color_attributes.active_color == colour and colour.domain == "POINT"
    rgba = values(made.data, "thickness_colour", "color", 4)
    ends = rgba[thickness.argmin()], rgba[thickness.argmax()]
    assert ends[0][0] > 2 * ends[0][2] and ends[1][2] > 2 * ends[1][0]
    assert [slot.name for slot in made.data.materials] == ["thickness_colour"]


def test_thickness_ends_of_colours():
    plate()
    bpy.ops.medax.thickness(spacing=0.1, least=10, most=20, material=False)
    made = bpy.context.active_object
    assert len(np.unique(values(made.data, "thickness_colour", "color", 4), axis=0)) == 1
    assert not made.data.materials


def test_thickness_of_points():
    add("Scan", torus_points(4000))
    assert bpy.ops.medax.thickness() == {"FINISHED"}
    thickness = values(bpy.context.active_object.data, "thickness")
    assert np.quantile(thickness, 0.5) == pytest.approx(0.8, abs=0.02)


@pytest.mark.parametrize("inner", ("voronoi", "medial", "core", "spine"))
def test_iso_surface(inner):
    torus(32, 14)
    volumes = []
    for t in (0.4, 1.0):
        bpy.context.view_layer.objects.active = bpy.data.objects["Torus"]
        assert bpy.ops.medax.iso_surface(t=t, inner=inner) == {"FINISHED"}
        euler, closed, volume = topology(bpy.context.active_object.data)
        assert (euler, closed) == (0, True)
        volumes.append(volume)
    assert 0 < volumes[0] < volumes[1]


@pytest.mark.parametrize(
    "matrix",
    (
        Matrix.Translation((1, 2, 3)),
        Matrix.LocRotScale((1, 2, 3), Matrix.Rotation(0.7, 3, (1, 2, 3)), (3, 3, 3)),
        Matrix.LocRotScale((-1, 0, 3), Matrix.Rotation(2.7, 3, (1, 2, 3)), (3, -0.5, 1)),
        Matrix.Shear("XY", 4, (0.5, 0.3)) @ Matrix.LocRotScale((1, 0, 3), Matrix.Rotation(0.7, 3, (1, 2, 3)), (-1, 2, 1)),
    ),
)
def test_transforms(matrix):
    source = torus(32, 14)
    source.matrix_world = matrix
    bpy.context.view_layer.update()
    assert bpy.ops.medax.medial_axis() == {"FINISHED"}
    axis = bpy.context.active_object
    radius = values(axis.data, "radius")
    # Radii are lengths in the scene and in the result's own space.
    assert np.allclose(axis.matrix_world.to_scale(), 1, atol=1e-5)
    assert np.allclose(radius, nearest(vertices(source, True), vertices(axis, True)), atol=2e-5)
    bpy.context.view_layer.objects.active = source
    assert bpy.ops.medax.iso_surface(t=1, inside="FACES") == {"FINISHED"}
    # Not inside out, mirrored or not.
    assert topology(bpy.context.active_object.data)[2] > 0
    bpy.context.view_layer.objects.active = source
    assert bpy.ops.medax.thickness() == {"FINISHED"}
    made = bpy.context.active_object
    assert topology(made.data)[2] > 0
    assert np.allclose(vertices(made, True), vertices(source, True), atol=1e-5)


def test_places_are_kept_to_the_bit():
    source = torus(24, 10)
    source.matrix_world = Matrix.LocRotScale((0.1, 0.2, 0.3), Matrix.Rotation(0.7, 3, (1, 2, 3)), (1, 1, 1))
    bpy.context.view_layer.update()
    bpy.ops.medax.thickness()
    made = bpy.context.active_object
    assert np.array_equal(vertices(made), vertices(source))
    assert np.allclose(made.matrix_world, source.matrix_world, atol=1e-7)


def test_lengths_are_told_in_the_units_of_the_scene(scene, addon):
    said = []
    scene.unit_settings.system, scene.unit_settings.scale_length = "METRIC", 0.001
    torus(32, 14)
    recipe = addon.recipes.MedialAxis()
    session = addon.session.Session(bpy.context, recipe, lambda kind, text: said.append(text))
    assert session.run(bpy.context) == {"FINISHED"}
    # Blender units are millimetres here; attributes stay in Blender units.
    assert " mm to " in said[0]
    assert values(session.objects[0].data, "radius").max() > 0.3
    assert bpy.ops.medax.medial_axis.get_rna_type().properties["theta"].subtype == "ANGLE"
    assert bpy.ops.medax.thickness.get_rna_type().properties["spacing"].subtype == "DISTANCE"


def test_curves_are_read():
    bpy.ops.curve.primitive_bezier_circle_add()
    curve = bpy.context.active_object
    curve.data.bevel_depth = 0.4
    curve.data.bevel_resolution = 6
    curve.data.resolution_u = 16
    assert bpy.ops.medax.core() == {"FINISHED"}
    assert len(bpy.context.active_object.data.edges) > 20


def test_radius_is_a_radius_of_curves_in_geometry_nodes():
    torus(32, 14)
    bpy.ops.medax.core()
    core = bpy.context.active_object
    least = values(core.data, "radius").min()
    tree = bpy.data.node_groups.new("Tubes", "GeometryNodeTree")
    tree.interface.new_socket("Geometry", in_out="INPUT", socket_type="NodeSocketGeometry")
    tree.interface.new_socket("Geometry", in_out="OUTPUT", socket_type="NodeSocketGeometry")
    kinds = "NodeGroupInput", "GeometryNodeMeshToCurve", "GeometryNodeCurveToMesh", "NodeGroupOutput"
    nodes = [tree.nodes.new(kind) for kind in kinds]
    circle = tree.nodes.new("GeometryNodeCurvePrimitiveCircle")
    circle.inputs["Radius"].default_value = 1
    for a, b in zip(nodes, nodes[1:]):
        tree.links.new(a.outputs[0], b.inputs[0])
    tree.links.new(circle.outputs[0], nodes[2].inputs["Profile Curve"])
    core.modifiers.new("Tubes", "NODES").node_group = tree
    tube = core.evaluated_get(bpy.context.evaluated_depsgraph_get())
    height = vertices(tube)[:, 2].max()
    assert height == pytest.approx(0.4, abs=0.05) and height > least * 0.9


def to_points(thing):
    """A modifier that makes a point cloud of vertices."""
    tree = bpy.data.node_groups.new("Points", "GeometryNodeTree")
    for way in ("INPUT", "OUTPUT"):
        tree.interface.new_socket("Geometry", in_out=way, socket_type="NodeSocketGeometry")
    nodes = [tree.nodes.new(kind) for kind in ("NodeGroupInput", "GeometryNodeMeshToPoints", "NodeGroupOutput")]
    for a, b in zip(nodes, nodes[1:]):
        tree.links.new(a.outputs[0], b.inputs[0])
    thing.modifiers.new("Points", "NODES").node_group = tree
    bpy.context.view_layer.update()


def test_points_that_a_modifier_makes_are_read():
    source = torus()
    source.location, source.scale = (1, 2, 3), (2, 2, 2)
    to_points(source)
    assert bpy.ops.medax.medial_axis(hide=False) == {"FINISHED"}
    axis = bpy.context.active_object
    assert np.allclose(values(axis.data, "radius"), nearest(vertices(source, True), vertices(axis, True)), atol=1e-5)
    bpy.context.view_layer.objects.active = source
    assert bpy.ops.medax.thickness() == {"FINISHED"}
    made = bpy.context.active_object
    assert len(made.data.vertices) == len(source.data.vertices) and not made.data.polygons
    assert np.quantile(values(made.data, "thickness"), 0.5) == pytest.approx(1.6, abs=0.05)


def test_what_the_viewport_shows_is_read():
    source = torus(24, 10)
    modifier = source.modifiers.new("Subdivision", "SUBSURF")
    modifier.show_viewport, modifier.show_render = False, True
    assert bpy.ops.medax.thickness() == {"FINISHED"}
    assert len(bpy.context.active_object.data.vertices) == len(source.data.vertices)


def test_the_core_is_an_inner_one():
    assert "side" not in bpy.ops.medax.core.get_rna_type().properties
    source = torus()
    assert bpy.ops.medax.core(extend=True) == {"FINISHED"}
    assert np.abs(vertices(bpy.context.active_object)).max() <= np.abs(vertices(source)).max()


def test_results_lie_in_a_collection_that_the_view_layer_shows():
    source = torus()
    shown, excluded = (bpy.data.collections.new(name) for name in ("Shown", "Excluded"))
    for collection in (excluded, shown):
        bpy.context.scene.collection.children.link(collection)
        collection.objects.link(source)
    bpy.context.scene.collection.objects.unlink(source)
    layers = bpy.context.view_layer.layer_collection.children
    layers["Excluded"].exclude = True
    bpy.context.view_layer.objects.active = source
    assert bpy.ops.medax.power_crust() == {"FINISHED"}
    made = bpy.context.active_object
    assert [each.name for each in made.users_collection] == ["Shown"] and made.select_get()
