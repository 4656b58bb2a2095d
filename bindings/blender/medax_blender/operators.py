# SPDX-License-Identifier: MIT OR Apache-2.0
"""The operators: their settings, and how Blender runs them."""

import math
from typing import Any

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty

from . import host, recipes
from .recipes import Refused
from .session import Session


def length(name: str, description: str) -> Any:
    """A setting in the scene's units; 0 leaves it to the library."""
    return FloatProperty(name=name, description=description, default=0, min=0, subtype="DISTANCE", precision=4)


def sample(default: str) -> Any:
    return EnumProperty(
        name="Sample",
        items=(
            ("VERTICES", "Vertices", "The vertices of the object are the sample of the surface"),
            ("FACES", "Faces", "A sample is taken on the faces; of an object without faces the vertices are taken"),
        ),
        default=default,
    )


class Base:
    """What all operators have. Settings with the names of those of the recipe are its settings."""

    bl_options = {"REGISTER", "UNDO"}
    recipe: type[recipes.Recipe]

    spacing: length("Spacing", "The least distance of the points on the faces; 0: a hundredth of the diagonal")
    hide: BoolProperty(name="Hide Original", description="Hide the object that was read", default=True)

    @classmethod
    def poll(cls, context: Any) -> bool:
        thing = context.active_object
        if context.mode != "OBJECT":
            cls.poll_message_set("In Object Mode only")
            return False
        if thing is None or thing.type not in host.TYPES:
            cls.poll_message_set("There must be an active object with vertices")
            return False
        return True

    def _settings(self) -> recipes.Recipe:
        names = self.recipe.__dataclass_fields__
        return self.recipe(**{name: getattr(self, name) for name in names if hasattr(self, name)})

    def _begin(self, context: Any) -> Session | None:
        material = getattr(self, "material", False)
        try:
            return Session(context, self._settings(), self.report, self.hide, material)
        except Refused as error:
            self.report({"ERROR"}, str(error))
            return None

    def invoke(self, context: Any, event: Any) -> set[str]:
        self.session = self._begin(context)
        if self.session is None:
            return {"CANCELLED"}
        context.window_manager.modal_handler_add(self)
        return self.session.start(context)

    def modal(self, context: Any, event: Any) -> set[str]:
        return self.session.step(context, event)

    def cancel(self, context: Any) -> None:
        """Blender calls this when it closes the window or the file under a running operator."""
        self.session.cancel(context)

    def execute(self, context: Any) -> set[str]:
        session = self._begin(context)
        return {"CANCELLED"} if session is None else session.run(context)

    def draw(self, context: Any) -> None:
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        # What is used often comes first; what was inherited, last.
        for name in self.shown:
            if self._applies(name):
                layout.prop(self, name)

    def _applies(self, name: str) -> bool:
        if name == "spacing":
            return self.sample == "FACES"
        return True


class Inside:
    """What tells inside from outside."""

    sample: sample("VERTICES")
    inside: EnumProperty(
        name="Inside",
        description="What tells inside from outside",
        items=(
            ("COCONE", "Tight Cocone", "The watertight surface that Tight Cocone makes of the sample"),
            ("CRUST", "Power Crust", "The power crust of the sample"),
            ("FACES", "Faces", "The object's own faces, which must close the solid and point out of it"),
        ),
        default="COCONE",
    )


class Filter:
    """Which facets of the medial axis pass."""

    theta: FloatProperty(
        name="Theta",
        description="The angle condition of the medial axis: more prunes more",
        subtype="ANGLE",
        default=math.pi / 8,
        min=0,
        max=math.radians(89.9),
    )
    rho: FloatProperty(
        name="Rho",
        description="The ratio condition of the medial axis: more prunes more",
        default=8,
        min=0,
        soft_max=40,
    )

    def _applies(self, name: str) -> bool:
        return self._filters(name) if name in ("theta", "rho") else super()._applies(name)

    def _filters(self, name: str) -> bool:
        """Whether this condition counts."""
        raise NotImplementedError


class Poles:
    """How a power crust chooses and labels its poles."""

    omit: EnumProperty(
        name="Omit",
        description="Poles that are left out",
        items=(
            ("nothing", "Nothing", "No pole is left out"),
            ("side", "For Noise", "Poles that are too near to their sample, as noise makes them"),
            ("both", "For Sharp Edges", "Both poles of a sample where one is too near, as at sharp edges"),
        ),
        default="nothing",
    )
    lambda_: FloatProperty(
        name="Lambda",
        description="The spacing of the sample relative to the feature size, for poles that are left out; 0: estimated",
        default=0,
        min=0,
        max=0.78,
    )
    label_rule: EnumProperty(
        name="Labels",
        description="How inner poles are told from outer ones",
        items=(
            ("auto", "Automatic", "By least conflict where spreading leaves much of it"),
            ("spread", "Spread", "Labels spread from outside"),
            ("least_conflict", "Least Conflict", "Labels that contradict each other least"),
        ),
        default="auto",
    )

    def _applies(self, name: str) -> bool:
        return self.omit != "nothing" if name == "lambda_" else super()._applies(name)


class MEDAX_OT_power_crust(Poles, Base, bpy.types.Operator):
    """Make a closed surface of points"""

    bl_idname = "medax.power_crust"
    bl_label = "Power Crust"
    recipe = recipes.PowerCrust
    shown = ("sample", "spacing", "omit", "lambda_", "label_rule", "triangles", "open", "hide")

    sample: sample("VERTICES")
    triangles: BoolProperty(name="Triangles", description="Cut the polygons into triangles", default=False)
    open: BoolProperty(name="Open Holes", description="Leave out the faces that close holes", default=False)


class MEDAX_OT_medial_axis(Inside, Filter, Base, bpy.types.Operator):
    """Make the medial axis of a solid, with the distance to its surface as the attribute radius"""

    bl_idname = "medax.medial_axis"
    bl_label = "Medial Axis"
    recipe = recipes.MedialAxis
    shown = ("theta", "rho", "rule", "object_angle", "side", "margin", "inside", "sample", "spacing", "hide")

    rule: EnumProperty(
        name="Rule",
        description="Which conditions a facet must meet",
        items=(
            ("angle_or_ratio", "Angle or Ratio", "One of the two conditions"),
            ("angle", "Angle", "The angle condition"),
            ("ratio", "Ratio", "The ratio condition"),
            ("every", "Every", "No condition but those below"),
        ),
        default="angle_or_ratio",
    )
    object_angle: FloatProperty(
        name="Object Angle",
        description="The least angle between the directions to the two nearest samples",
        subtype="ANGLE",
        default=0,
        min=0,
        max=math.pi,
    )
    side: EnumProperty(
        name="Side",
        items=(
            ("inner", "Inner", "In the solid"),
            ("outer", "Outer", "Outside of the solid"),
            ("both", "Both", "On both sides"),
        ),
        default="inner",
    )
    margin: FloatProperty(
        name="Margin",
        description="By which part of its diagonal the box of the sample is grown, to which the outer axis is clipped",
        default=0.1,
        min=0,
        soft_max=1,
    )

    def _applies(self, name: str) -> bool:
        return self.side != "inner" if name == "margin" else super()._applies(name)

    def _filters(self, name: str) -> bool:
        return self.rule in ({"theta": "angle", "rho": "ratio"}[name], "angle_or_ratio")


class MEDAX_OT_core(Inside, Filter, Base, bpy.types.Operator):
    """Make the core of a solid: curves and sheets with its topology, and radii for a Skin modifier"""

    bl_idname = "medax.core"
    bl_label = "Core"
    recipe = recipes.Core
    shown = ("repair", "extend", "theta", "rho", "skin", "inside", "sample", "spacing", "hide")

    repair: BoolProperty(
        name="Repair", description="Add what the inner core needs to be connected as the solid is", default=True
    )
    extend: BoolProperty(name="Extend", description="Add the facets of the medial axis that pass", default=False)
    skin: BoolProperty(
        name="Skin",
        description="Make a skeleton of edges with a Skin modifier; faces by which the core is extended stay apart",
        default=False,
    )

    def _filters(self, name: str) -> bool:
        return self.extend


class MEDAX_OT_thickness(Poles, Base, bpy.types.Operator):
    """Measure how thick the solid is at each vertex, as an attribute and as colours"""

    bl_idname = "medax.thickness"
    bl_label = "Thickness"
    recipe = recipes.Thickness
    shown = ("size", "least", "most", "material", "sample", "spacing", "omit", "lambda_", "label_rule", "hide")

    sample: sample("FACES")
    size: EnumProperty(
        name="Size",
        items=(
            ("thickness", "Thickness", "The diameter of the ball inside that touches the surface there"),
            ("feature_size", "Feature Size", "The distance to the medial axis on either side"),
        ),
        default="thickness",
    )
    least: length("Red", "What is red; 0: the least, but for one in fifty")
    most: length("Blue", "What is blue; 0: the largest, but for one in fifty")
    material: BoolProperty(name="Material", description="Show the colours by a material", default=True)


class MEDAX_OT_iso_surface(Inside, Filter, Base, bpy.types.Operator):
    """Make a closed surface between an inner structure and the boundary of a solid, by its pair-mesh"""

    bl_idname = "medax.iso_surface"
    bl_label = "Pair-Mesh Iso-Surface"
    recipe = recipes.IsoSurface
    shown = ("t", "inner", "theta", "rho", "inside", "sample", "spacing", "hide")

    t: FloatProperty(
        name="T", description="0: the inner structure, 1: the boundary", default=0.5, min=0, max=1, subtype="FACTOR"
    )
    inner: EnumProperty(
        name="Inner Structure",
        items=(
            ("voronoi", "Voronoi", "All of the Voronoi diagram inside"),
            ("medial", "Medial Axis", "The facets that pass"),
            ("core", "Core", "The Voronoi faces in which the core lies"),
            ("spine", "Spine", "As little as possible"),
        ),
        default="voronoi",
    )

    def _filters(self, name: str) -> bool:
        return self.inner == "medial"


ALL = (MEDAX_OT_power_crust, MEDAX_OT_medial_axis, MEDAX_OT_core, MEDAX_OT_thickness, MEDAX_OT_iso_surface)
