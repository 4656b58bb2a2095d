# SPDX-License-Identifier: MIT OR Apache-2.0
"""medax for Blender: power crusts, medial axes, cores, thickness, pair-meshes."""

from __future__ import annotations

from typing import Any

import bpy

from . import kept, operators, panel


@bpy.app.handlers.persistent
def _forget(*_: Any) -> None:
    """What was kept belongs to the file that was open."""
    kept.clear()


def register() -> None:
    for each in (*operators.ALL, *panel.ALL):
        bpy.utils.register_class(each)
    bpy.types.VIEW3D_MT_object.append(panel.extend)
    bpy.app.handlers.load_post.append(_forget)


def unregister() -> None:
    bpy.app.handlers.load_post.remove(_forget)
    bpy.types.VIEW3D_MT_object.remove(panel.extend)
    for each in reversed((*operators.ALL, *panel.ALL)):
        bpy.utils.unregister_class(each)
    kept.clear()
