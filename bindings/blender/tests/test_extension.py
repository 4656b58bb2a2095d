# SPDX-License-Identifier: MIT OR Apache-2.0
"""The extension as a file, and as Blender knows it."""

import pathlib
import subprocess
import sys
import tomllib
import zipfile

import bpy
import medax
from conftest import NAME


def test_manifest_and_wheel(zip_path):
    with zipfile.ZipFile(zip_path) as archive:
        assert archive.testzip() is None
        manifest = tomllib.loads(archive.read("blender_manifest.toml").decode())
        names = archive.namelist()
    assert manifest["id"] == "medax" and manifest["blender_version_min"] == "4.2.0"
    assert manifest["version"] == medax.__version__
    assert manifest["wheels"] and all(wheel.removeprefix("./") in names for wheel in manifest["wheels"])
    assert manifest["platforms"] == ["linux-x64"]
    assert {"LICENSE-MIT", "LICENSE-APACHE"} <= set(names)


def test_blender_finds_it_valid(zip_path):
    """By Blender's own tool, which `blender --command extension validate` runs."""
    tool = pathlib.Path(bpy.utils.resource_path("LOCAL")) / "scripts/addons_core/bl_pkg/cli/blender_ext.py"
    done = subprocess.run([sys.executable, tool, "validate", zip_path], capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr
    assert "WARN" not in done.stdout + done.stderr


def test_the_library_is_the_wheels():
    extensions = pathlib.Path(bpy.utils.user_resource("EXTENSIONS"))
    assert extensions / ".local" in pathlib.Path(medax.__file__).parents


def test_registered_and_unregistered_twice(addon):
    for _ in range(2):
        addon.unregister()
        assert not hasattr(bpy.types, "MEDAX_OT_core")
        addon.register()
        assert bpy.ops.medax.core.get_rna_type().name == "Core"
    draws = [each.__module__ for each in bpy.types.VIEW3D_MT_object._dyn_ui_initialize()]
    assert draws.count(f"{NAME}.panel") == 1
    bpy.ops.preferences.addon_disable(module=NAME)
    assert NAME not in bpy.context.preferences.addons
    bpy.ops.preferences.addon_enable(module=NAME)
    assert NAME in bpy.context.preferences.addons


def test_what_operators_promise(addon):
    for each in addon.operators.ALL:
        known = getattr(bpy.types, each.__name__)
        assert known.bl_options == {"REGISTER", "UNDO"}
        # Each setting is shown, and each of the recipe's is one of the operator's.
        rna = getattr(bpy.ops.medax, each.bl_idname.split(".")[1]).get_rna_type()
        settings = set(rna.properties.keys()) - {"rna_type"}
        assert settings == set(each.shown)
        assert set(each.recipe.__dataclass_fields__) - settings <= {"inside"}
        assert each.recipe.title
    panel = bpy.types.MEDAX_PT_sidebar
    assert (panel.bl_space_type, panel.bl_region_type) == ("VIEW_3D", "UI")
    icons = bpy.types.UILayout.bl_rna.functions["operator"].parameters["icon"].enum_items.keys()
    assert set(addon.panel.ICONS) == {each.bl_idname for each in addon.operators.ALL}
    assert set(addon.panel.ICONS.values()) <= set(icons)
