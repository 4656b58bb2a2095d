# SPDX-License-Identifier: MIT OR Apache-2.0
"""Where the operators are found: a tab in the sidebar of the 3D view, and a menu in the menu Object."""

from __future__ import annotations

from typing import Any

import bpy

from . import operators

ICONS = {
    "medax.power_crust": "MESH_ICOSPHERE",
    "medax.medial_axis": "MOD_SKIN",
    "medax.core": "OUTLINER_OB_ARMATURE",
    "medax.thickness": "MOD_THICKNESS",
    "medax.iso_surface": "MOD_SOLIDIFY",
}


def _list(layout: Any) -> None:
    # From a menu or a button an operator is invoked, and so modal.
    layout.operator_context = "INVOKE_DEFAULT"
    for each in operators.ALL:
        layout.operator(each.bl_idname, icon=ICONS[each.bl_idname])


class MEDAX_PT_sidebar(bpy.types.Panel):
    bl_label = "medax"
    bl_category = "medax"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"

    def draw(self, context: Any) -> None:
        _list(self.layout.column(align=True))


class MEDAX_MT_object(bpy.types.Menu):
    bl_label = "medax"

    def draw(self, context: Any) -> None:
        _list(self.layout)


def extend(menu: Any, context: Any) -> None:
    """Adds the menu to another one."""
    menu.layout.separator()
    menu.layout.menu(MEDAX_MT_object.__name__)


ALL = (MEDAX_PT_sidebar, MEDAX_MT_object)
