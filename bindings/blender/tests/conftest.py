# SPDX-License-Identifier: MIT OR Apache-2.0
"""The extension, installed into an empty Blender from its zip, which EXTENSION names, as a user installs it."""

import importlib
import os
import pathlib
import tempfile
import types

# Before Blender starts: its preferences and extensions are nobody's.
_resources = tempfile.TemporaryDirectory()
os.environ["BLENDER_USER_RESOURCES"] = _resources.name
os.environ.pop("MEDAX_LIBRARY", None)

import bpy  # noqa: E402
import numpy as np  # noqa: E402
import pytest  # noqa: E402

NAME = "bl_ext.user_default.medax"


def pytest_sessionstart(session):
    # Before tests are collected, which import medax from it.
    installed = bpy.ops.extensions.package_install_files(
        filepath=os.environ["EXTENSION"], repo="user_default", enable_on_install=True
    )
    assert installed == {"FINISHED"} and NAME in bpy.context.preferences.addons


@pytest.fixture
def zip_path() -> pathlib.Path:
    return pathlib.Path(os.environ["EXTENSION"])


@pytest.fixture
def addon():
    return importlib.import_module(NAME)


@pytest.fixture(autouse=True)
def scene(addon):
    """An empty file, and nothing kept."""
    bpy.ops.wm.read_homefile(use_empty=True)
    yield bpy.context.scene


def add(name, xyz, faces=(), edges=()):
    """A mesh object, active."""
    mesh = bpy.data.meshes.new(name)
    if len(faces) or len(edges):
        mesh.from_pydata([tuple(row) for row in xyz], edges, faces)
    else:
        mesh.vertices.add(len(xyz))
        mesh.vertices.foreach_set("co", np.asarray(xyz, np.float32).ravel())
    made = bpy.data.objects.new(name, mesh)
    bpy.context.scene.collection.objects.link(made)
    bpy.context.view_layer.objects.active = made
    bpy.context.view_layer.update()
    return made


def torus(around=48, across=20, major=1.0, minor=0.4):
    bpy.ops.mesh.primitive_torus_add(
        major_segments=around, minor_segments=across, major_radius=major, minor_radius=minor
    )
    return bpy.context.active_object


def torus_points(count, seed=0):
    """Points at random on a torus of radii 1 and 0.4, but for density."""
    u, v = np.random.default_rng(seed).uniform(0, 2 * np.pi, (2, count))
    out = 1 + 0.4 * np.cos(v)
    return np.stack([out * np.cos(u), out * np.sin(u), 0.4 * np.sin(v)], axis=1)


def values(mesh, name, called="value", width=1):
    attribute = mesh.attributes[name]
    found = np.empty(len(attribute.data) * width, np.float32)
    attribute.data.foreach_get(called, found)
    return found.reshape(-1, width) if width > 1 else found


def vertices(thing, world=False):
    found = np.empty((len(thing.data.vertices), 3), np.float32)
    thing.data.vertices.foreach_get("co", found.ravel())
    if world:
        matrix = np.array(thing.matrix_world)
        found = found @ matrix[:3, :3].T + matrix[:3, 3]
    return found


def names():
    return sorted(each.name for each in bpy.data.objects)


def event(kind, value="PRESS"):
    return types.SimpleNamespace(type=kind, value=value)


@pytest.fixture
def counted(monkeypatch):
    """How often triangulations, diagrams, axes were built."""
    import medax

    counts = {}

    def count(kind, name):
        original = getattr(kind, name)

        def call(*arguments, **options):
            counts[kind.__name__] = counts.get(kind.__name__, 0) + 1
            return original(*arguments, **options)

        monkeypatch.setattr(kind, name, call)

    for kind, name in (
        (medax.Triangulation, "delaunay"),
        (medax.Dual, "of"),
        (medax.Cocone, "of"),
        (medax.Medial, "of"),
        (medax.Pair, "voronoi"),
        (medax.Pair, "onto"),
        (medax.PowerCrust, "of"),
    ):
        count(kind, name)
    return counts
