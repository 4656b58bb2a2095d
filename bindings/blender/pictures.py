#!/usr/bin/env python3
# SPDX-License-Identifier: MIT OR Apache-2.0
"""Renders a picture for each operator: `pictures.py EXTENSION.zip FOLDER [NAME...]`, in a Python that has bpy 4.2."""

import os
import sys
import tempfile

_resources = tempfile.TemporaryDirectory()
os.environ["BLENDER_USER_RESOURCES"] = _resources.name

import bpy  # noqa: E402
import numpy as np  # noqa: E402
from mathutils import Vector  # noqa: E402

SIZE = 900, 420
GREY, BLUE, ORANGE = (0.4, 0.41, 0.43), (0.12, 0.3, 0.62), (0.85, 0.25, 0.02)


def material(name, colour, alpha=1.0):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    shader = next(node for node in made.node_tree.nodes if node.type == "BSDF_PRINCIPLED")
    shader.inputs["Base Color"].default_value = (*colour, 1)
    shader.inputs["Roughness"].default_value = 0.6
    shader.inputs["Alpha"].default_value = alpha
    return made


def shaded(thing, made):
    thing.data.materials.clear()
    thing.data.materials.append(made)
    thing.hide_render = False


def by_radius(name, least, most):
    """A material that shows the attribute radius."""
    made = material(name, GREY)
    nodes, links = made.node_tree.nodes, made.node_tree.links
    attribute = nodes.new("ShaderNodeAttribute")
    attribute.attribute_name = "radius"
    share = nodes.new("ShaderNodeMapRange")
    share.inputs["From Min"].default_value, share.inputs["From Max"].default_value = least, most
    ramp = nodes.new("ShaderNodeValToRGB")
    ramp.color_ramp.elements[0].color = (0.6, 0.02, 0.02, 1)
    ramp.color_ramp.elements[1].color = (0.03, 0.1, 0.5, 1)
    ramp.color_ramp.elements.new(0.5).color = (0.95, 0.75, 0.3, 1)
    links.new(attribute.outputs["Fac"], share.inputs["Value"])
    links.new(share.outputs["Result"], ramp.inputs["Fac"])
    shader = next(node for node in nodes if node.type == "BSDF_PRINCIPLED")
    links.new(ramp.outputs["Color"], shader.inputs["Base Color"])
    return made


def points(name, xyz):
    mesh = bpy.data.meshes.new(name)
    mesh.vertices.add(len(xyz))
    mesh.vertices.foreach_set("co", np.asarray(xyz, np.float32).ravel())
    return link(bpy.data.objects.new(name, mesh))


def link(thing):
    bpy.context.scene.collection.objects.link(thing)
    return active(thing)


def active(thing):
    bpy.context.view_layer.objects.active = thing
    bpy.context.view_layer.update()
    return thing


def dots(thing, radius, made):
    """Shows vertices as balls."""
    thing.hide_render = False
    tree = bpy.data.node_groups.new("Dots", "GeometryNodeTree")
    for way in ("INPUT", "OUTPUT"):
        tree.interface.new_socket("Geometry", in_out=way, socket_type="NodeSocketGeometry")
    kinds = "NodeGroupInput", "GeometryNodeMeshToPoints", "GeometryNodeSetMaterial", "NodeGroupOutput"
    nodes = [tree.nodes.new(kind) for kind in kinds]
    nodes[1].inputs["Radius"].default_value = radius
    nodes[2].inputs["Material"].default_value = made
    for a, b in zip(nodes, nodes[1:]):
        tree.links.new(a.outputs[0], b.inputs[0])
    thing.modifiers.new("Dots", "NODES").node_group = tree


def run(name, source, **settings):
    active(source)
    assert getattr(bpy.ops.medax, name)(**settings) == {"FINISHED"}
    source.hide_set(False)
    source.hide_render = True
    return bpy.context.active_object


def beside(thing, x):
    thing.location.x += x


def render(path, look_at, distance, direction=(0.2, -1, 0.75), lens=70):
    scene = bpy.context.scene
    camera = link(bpy.data.objects.new("Camera", bpy.data.cameras.new("Camera")))
    camera.data.lens = lens
    camera.location = Vector(look_at) + distance * Vector(direction).normalized()
    camera.rotation_euler = (Vector(look_at) - camera.location).to_track_quat("-Z", "Y").to_euler()
    scene.camera = camera
    sun = link(bpy.data.objects.new("Sun", bpy.data.lights.new("Sun", "SUN")))
    sun.data.energy, sun.data.angle = 1.6, 0.3
    sun.rotation_euler = (0.7, 0.2, 0.6)
    world = bpy.data.worlds.new("White")
    world.use_nodes = True
    world.node_tree.nodes["Background"].inputs["Color"].default_value = (1, 1, 1, 1)
    world.node_tree.nodes["Background"].inputs["Strength"].default_value = 0.4
    scene.world = world
    scene.render.engine = "CYCLES"
    scene.cycles.device, scene.cycles.samples = "CPU", 32
    scene.cycles.use_denoising = True
    scene.cycles.transparent_max_bounces = 32
    scene.render.film_transparent = True
    scene.render.resolution_x, scene.render.resolution_y = SIZE
    scene.view_settings.view_transform = "Standard"
    settings = scene.render.image_settings
    settings.file_format, settings.color_mode, settings.compression = "PNG", "RGBA", 100
    # What is transparent is white in every reader of the page.
    scene.use_nodes = True
    nodes, links = scene.node_tree.nodes, scene.node_tree.links
    layers = next(node for node in nodes if node.type == "R_LAYERS")
    composite = next(node for node in nodes if node.type == "COMPOSITE")
    over = nodes.new("CompositorNodeAlphaOver")
    over.inputs[1].default_value = (1, 1, 1, 1)
    links.new(layers.outputs["Image"], over.inputs[2])
    links.new(over.outputs["Image"], composite.inputs["Image"])
    settings.color_mode = "RGB"
    scene.render.filepath = path
    bpy.ops.render.render(write_still=True)


def power_crust(path):
    import medax

    scan = points("Scan", medax.Samples.of("trefoil", spacing=0.16).coords)
    crust = run("power_crust", scan)
    shaded(crust, material("Surface", BLUE))
    width = 1.1 * scan.dimensions.x
    dots(scan, 0.035, material("Points", (0.15, 0.15, 0.17)))
    beside(crust, width)
    render(path, (width / 2, 0, 0), 4.2 * width, (0, -0.8, 1))


def medial_axis(path):
    import medax

    scan = points("Scan", medax.Samples.of("genus3", spacing=0.05).coords)
    scan.scale = (1, 1, 0.45)
    width = 1.08 * scan.dimensions.x
    for column, theta in enumerate((0.4, 1.0)):
        surface = run("power_crust", scan)
        shaded(surface, material("Surface", GREY, 0.1))
        axis = run("medial_axis", scan, theta=theta, rule="angle")
        shaded(axis, by_radius(f"Radius {theta}", 0.14, 0.21))
        for thing in (surface, axis):
            beside(thing, column * width)
    render(path, (width / 2, 0, 0), 4 * width, (0, -0.8, 1))


def core(path):
    import medax

    scan = points("Scan", medax.Samples.of("genus3", spacing=0.1).coords)
    width = 1.08 * scan.dimensions.x
    surface = run("power_crust", scan)
    shaded(surface, material("Surface", GREY, 0.12))
    thin = run("core", scan)
    # All radii small, to be seen.
    layer = thin.data.skin_vertices[0].data
    layer.foreach_set("radius", np.full(2 * len(layer), 0.02, np.float32))
    thin.modifiers.new("Skin", "SKIN")
    shaded(thin, material("Core", ORANGE))
    skinned = run("core", scan, skin=True)
    skinned.modifiers["Skin"].use_smooth_shade = True
    skinned.modifiers.new("Subdivision", "SUBSURF").render_levels = 2
    shaded(skinned, material("Skin", BLUE))
    beside(skinned, width)
    render(path, (width / 2, 0, 0), 4 * width, (0, -0.7, 1))


def thickness(path):
    bpy.ops.mesh.primitive_cube_add(size=1)
    part = bpy.context.active_object
    part.name = "Part"
    part.scale = (2.6, 1.4, 0.25)
    bpy.ops.object.transform_apply(scale=True)

    def tool(operation, make, **where):
        make(**where)
        made = bpy.context.active_object
        made.hide_render = True
        modifier = part.modifiers.new("Boolean", "BOOLEAN")
        modifier.operation, modifier.object = operation, made

    cube, cylinder = bpy.ops.mesh.primitive_cube_add, bpy.ops.mesh.primitive_cylinder_add
    tool("UNION", cube, size=1, location=(-1.1, 0, 0.5), scale=(0.4, 1.4, 1.2))
    tool("UNION", cylinder, radius=0.45, depth=0.7, location=(0.6, 0, 0.2), vertices=64)
    tool("DIFFERENCE", cylinder, radius=0.3, depth=2, location=(0.6, 0, 0), vertices=64)
    tool("DIFFERENCE", cylinder, radius=0.25, depth=2, location=(-1.1, 0.0, 0.65), rotation=(0, np.pi / 2, 0), vertices=64)
    remesh = part.modifiers.new("Remesh", "REMESH")
    remesh.mode, remesh.voxel_size = "VOXEL", 0.025
    measured = run("thickness", part, spacing=0.02, omit="both", least=0.1, most=0.45)
    measured.hide_render = False
    render(path, (-0.05, 0, 0.27), 10.4, (0.45, -1, 0.85))


def iso_surface(path):
    import medax

    scan = points("Scan", medax.Samples.of("genus3", spacing=0.12).coords)
    width = 1.08 * scan.dimensions.x
    for column, t in enumerate((0.05, 0.35, 0.7, 1.0)):
        surface = run("iso_surface", scan, t=t, inner="core")
        shaded(surface, material(f"Surface {t}", BLUE))
        beside(surface, column % 2 * width)
        surface.location.y -= column // 2 * 1.1 * scan.dimensions.y
    render(path, (width / 2, -0.55 * scan.dimensions.y, 0), 4.1 * width, (0, -0.5, 1))


ALL = (power_crust, medial_axis, core, thickness, iso_surface)

if __name__ == "__main__":
    extension, folder, *wanted = sys.argv[1:]
    bpy.ops.extensions.package_install_files(filepath=extension, repo="user_default", enable_on_install=True)
    for draw in ALL:
        if not wanted or draw.__name__ in wanted:
            bpy.ops.wm.read_homefile(use_empty=True)
            draw(os.path.abspath(os.path.join(folder, f"blender-{draw.__name__.replace('_', '-')}.png")))
