# SPDX-License-Identifier: MIT OR Apache-2.0
"""How operators run: steps, cancel, undo, what is not built again, errors."""

import math
import re
import time

import bpy
import numpy as np
import pytest
from conftest import add, event, names, torus, torus_points, values, vertices


def drive(session, limit=60):
    """Timer events until it ends."""
    end = time.monotonic() + limit
    while time.monotonic() < end:
        found = session.step(bpy.context, event("TIMER", "NOTHING"))
        if found != {"RUNNING_MODAL"}:
            return found
        time.sleep(0.01)
    raise AssertionError("it did not end")


@pytest.fixture
def said():
    return []


@pytest.fixture
def begin(addon, said):
    def make(recipe):
        return addon.session.Session(bpy.context, recipe, lambda kind, text: said.append((kind, text)))

    return make


def test_steps_and_their_progress(addon, begin, said):
    add("Scan", torus_points(30000))
    session = begin(addon.recipes.MedialAxis())
    assert session.start(bpy.context) == {"RUNNING_MODAL"}
    shares, titles, found = [], [], {"RUNNING_MODAL"}
    while found == {"RUNNING_MODAL"}:
        found = session.step(bpy.context, event("TIMER"))
        shares.append(session.task.steps.progress)
        titles.append(session.task.steps.title)
        # What is done meanwhile is left to the view, or waits.
        assert session.step(bpy.context, event("WHEELUPMOUSE")) == {"PASS_THROUGH"}
        assert session.step(bpy.context, event("X")) == {"RUNNING_MODAL"}
        time.sleep(0.005)
    assert found == {"FINISHED"}
    assert shares == sorted(shares) and 0 <= shares[0] < shares[-1] <= 1 and len(set(shares)) > 5
    assert {"Delaunay triangulation", "Tight Cocone"} <= set(titles)
    assert said[-1][0] == {"INFO"} and "faces, radius" in said[-1][1]
    assert names() == ["Scan", "Scan Medial Axis"]


def test_a_million_points_are_cancelled_in_time(addon, begin, said, capsys):
    add("Scan", torus_points(1_000_000))
    before = [len(kind) for kind in (bpy.data.objects, bpy.data.meshes)]
    took = []
    # At a share of the work: seconds would be others on another machine.
    recipes = addon.recipes
    for share, recipe in ((0.01, recipes.MedialAxis()), (0.1, recipes.PowerCrust()), (0.4, recipes.Core())):
        session = begin(recipe)
        session.start(bpy.context)
        while session.task.steps.progress < share:
            assert session.step(bpy.context, event("TIMER")) == {"RUNNING_MODAL"}
            time.sleep(0.01)
        start = time.monotonic()
        found = session.step(bpy.context, event("ESC"))
        took.append(time.monotonic() - start)
        # The work has stopped, not only the waiting for it.
        assert found == {"CANCELLED"} and not session.task._thread.is_alive()
        assert said[-1] == ({"INFO"}, f"{recipe.title}: cancelled")
    with capsys.disabled():
        print(f"\n  cancelled within {', '.join(f'{1000 * each:.0f} ms' for each in took)}")
    assert max(took) < 0.1
    assert [len(kind) for kind in (bpy.data.objects, bpy.data.meshes)] == before
    assert not bpy.context.active_object.hide_get()


@pytest.fixture
def driven(addon):
    """An operator like Core, but that it sends itself the events of a list, over and over the last one: in background
    Blender invokes nothing."""
    sent, found = [], []
    core = addon.operators.MEDAX_OT_core

    class MEDAX_OT_driven(addon.operators.Inside, addon.operators.Base, bpy.types.Operator):
        bl_idname, bl_label, recipe = "medax.driven", "Driven", core.recipe
        __annotations__ = core.__annotations__

        def execute(self, context):
            self.session = self._begin(context)
            found.append(self.session.start(context))
            while found[-1] == {"RUNNING_MODAL"}:
                found.append(self.modal(context, sent.pop(0) if len(sent) > 1 else sent[0]))
                time.sleep(0.01)
            return found[-1]

    bpy.utils.register_class(MEDAX_OT_driven)
    yield sent, found
    bpy.utils.unregister_class(MEDAX_OT_driven)


def test_the_operator_itself_is_modal(driven):
    driven[0].append(event("TIMER", "NOTHING"))
    torus()
    assert bpy.ops.medax.driven() == {"FINISHED"}
    assert names() == ["Torus", "Torus Core"]


def test_esc_cancels_the_operator_itself(driven):
    driven[0][:] = [event("TIMER", "NOTHING"), event("MOUSEMOVE", "NOTHING"), event("ESC")]
    add("Scan", torus_points(100_000))
    assert bpy.ops.medax.driven() == {"CANCELLED"}
    assert driven[1] == 3 * [{"RUNNING_MODAL"}] + [{"CANCELLED"}]
    assert names() == ["Scan"] and not bpy.context.active_object.hide_get()


def test_invoked_without_events_it_runs_to_the_end():
    torus()
    assert bpy.ops.medax.core("INVOKE_DEFAULT") == {"FINISHED"}


def test_a_file_closed_meanwhile_cancels(addon, begin, said):
    add("Scan", torus_points(200_000))
    session = begin(addon.recipes.MedialAxis())
    session.start(bpy.context)
    assert session.cancel(bpy.context) == {"CANCELLED"}
    assert not session.task._thread.is_alive()


def test_the_slider_triangulates_once(counted):
    add("Scan", torus_points(20_000))
    faces, seconds = [], []
    for theta in (0.2, 0.4, 0.8, 1.2):
        bpy.context.view_layer.objects.active = bpy.data.objects["Scan"]
        start = time.monotonic()
        assert bpy.ops.medax.medial_axis(theta=theta, rho=8 + theta) == {"FINISHED"}
        seconds.append(time.monotonic() - start)
        faces.append(len(bpy.context.active_object.data.polygons))
    assert counted == {"Triangulation": 1, "Dual": 1, "Cocone": 1, "Medial": 1}
    assert faces == sorted(faces, reverse=True) and faces[0] > faces[-1]
    assert max(seconds[1:]) < seconds[0] / 3
    # Nor does another operator of the same sample.
    bpy.context.view_layer.objects.active = bpy.data.objects["Scan"]
    bpy.ops.medax.core()
    assert counted == {"Triangulation": 1, "Dual": 1, "Cocone": 1, "Medial": 1}
    # Another sample does.
    bpy.data.objects["Scan"].data.vertices[0].co.x += 0.01
    bpy.context.view_layer.objects.active = bpy.data.objects["Scan"]
    bpy.ops.medax.medial_axis()
    assert counted["Triangulation"] == 2


def test_t_makes_the_pair_mesh_once(counted):
    torus(32, 14)
    for t in (0.2, 0.5, 0.9):
        bpy.context.view_layer.objects.active = bpy.data.objects["Torus"]
        bpy.ops.medax.iso_surface(t=t, inner="spine")
    assert counted == {"Triangulation": 1, "Dual": 1, "Cocone": 1, "Pair": 2}


def test_other_labels_triangulate_nothing(counted):
    source = torus(32, 14)
    for inside in ("COCONE", "CRUST", "FACES"):
        bpy.context.view_layer.objects.active = source
        assert bpy.ops.medax.medial_axis(inside=inside) == {"FINISHED"}
    assert counted == {"Triangulation": 1, "Dual": 1, "Cocone": 1, "Medial": 3, "PowerCrust": 1}


def test_undo_and_another_value(counted):
    torus(32, 14)
    # Without a window there is no undo until a script asks for it.
    bpy.ops.ed.undo_push(message="Torus")
    assert bpy.ops.medax.medial_axis("EXEC_DEFAULT", True, theta=0.3) == {"FINISHED"}
    assert names() == ["Torus", "Torus Medial Axis"] and bpy.data.objects["Torus"].hide_get()
    many = len(bpy.context.active_object.data.polygons)
    bpy.ops.ed.undo()
    assert names() == ["Torus"] and not bpy.data.objects["Torus"].hide_get()
    assert bpy.context.active_object.name == "Torus"
    # So does Blender when a setting is changed: undo, and again.
    assert bpy.ops.medax.medial_axis("EXEC_DEFAULT", True, theta=1.2, rule="angle") == {"FINISHED"}
    assert len(bpy.context.active_object.data.polygons) < many
    assert counted["Triangulation"] == 1
    bpy.ops.ed.undo()
    bpy.ops.ed.redo()
    assert names() == ["Torus", "Torus Medial Axis"]


OPERATORS = "power_crust", "medial_axis", "core", "thickness", "iso_surface"


@pytest.mark.parametrize("name", OPERATORS)
@pytest.mark.parametrize(
    "xyz, message",
    (
        (np.empty((0, 3)), "there is no point"),
        (np.zeros((5, 3)), "needs 4 distinct points, not 1"),
        (np.c_[torus_points(50)[:, :2], np.zeros(50)], "all points lie in a plane"),
        (np.r_[torus_points(50), [[0, np.nan, 0]]], "row 50: a coordinate is NaN or infinite"),
    ),
)
def test_errors_change_nothing(name, xyz, message):
    source = add("Odd", xyz)
    source.select_set(True)
    meshes = len(bpy.data.meshes)
    with pytest.raises(RuntimeError, match=message):
        getattr(bpy.ops.medax, name)()
    assert names() == ["Odd"] and len(bpy.data.meshes) == meshes
    assert not source.hide_get() and source.select_get() and bpy.context.active_object == source
    assert not source.data.attributes.get("thickness")


def test_what_is_refused():
    add("Scan", torus_points(300))
    with pytest.raises(RuntimeError, match="The object has no faces"):
        bpy.ops.medax.medial_axis(inside="FACES")
    bpy.context.active_object.scale = (1, 1, 0)
    bpy.context.view_layer.update()
    with pytest.raises(RuntimeError, match="scaled to nothing"):
        bpy.ops.medax.medial_axis()
    bpy.ops.object.light_add()
    with pytest.raises(RuntimeError, match="active object with vertices"):
        bpy.ops.medax.medial_axis()
    torus()
    bpy.ops.object.mode_set(mode="EDIT")
    with pytest.raises(RuntimeError, match="Object Mode"):
        bpy.ops.medax.core()
    bpy.ops.object.mode_set(mode="OBJECT")


def test_an_object_deleted_meanwhile(begin, addon, said):
    torus(24, 10)
    session = begin(addon.recipes.Core())
    session.start(bpy.context)
    bpy.data.objects.remove(bpy.data.objects["Torus"])
    assert drive(session) == {"CANCELLED"}
    assert said[-1] == ({"ERROR"}, "Torus is no longer there")


def test_results_are_those_of_the_library(addon):
    import medax

    xyz = torus_points(500).astype(np.float32)
    add("Scan", xyz)
    bpy.ops.medax.power_crust()
    expected = medax.PowerCrust.of(medax.Points(xyz)).surface
    made = bpy.context.active_object
    assert np.array_equal(vertices(made), expected.vertices.astype(np.float32))
    assert [list(face.vertices) for face in made.data.polygons] == expected.faces.to_list()
    sample = np.empty(len(made.data.vertices), np.int32)
    made.data.attributes["sample"].data.foreach_get("value", sample)
    assert np.array_equal(sample, expected.values("sample").astype(np.uint32).view(np.int32))
    assert math.isfinite(values(made.data, "sample").sum())


def cube():
    bpy.ops.mesh.primitive_cube_add()
    return bpy.context.active_object


def inward():
    source = torus()
    source.data.flip_normals()
    return source


@pytest.mark.parametrize(
    "make, name, settings, message",
    (
        (cube, "power_crust", {}, "The surface is empty: the sample is too sparse"),
        (cube, "medial_axis", {}, "No facet passes: take a smaller theta or rho"),
        (cube, "medial_axis", {"rule": "every", "object_angle": 1.0}, "or a denser sample"),
        (inward, "thickness", {}, "Every thickness is 0: do faces point inward?"),
        (cube, "thickness", {"sample": "VERTICES"}, "the sample is too sparse"),
    ),
)
def test_where_nothing_is_made_that_is_an_error(make, name, settings, message):
    source = make()
    before = names(), len(bpy.data.meshes), len(bpy.data.materials)
    with pytest.raises(RuntimeError, match=re.escape(message)):
        getattr(bpy.ops.medax, name)(**settings)
    assert (names(), len(bpy.data.meshes), len(bpy.data.materials)) == before
    assert not source.hide_get() and source.select_get() and bpy.context.active_object == source


@pytest.mark.parametrize("name", OPERATORS)
def test_a_cube_makes_something_or_is_an_error(name):
    cube()
    try:
        assert getattr(bpy.ops.medax, name)() == {"FINISHED"}
    except RuntimeError:
        assert names() == ["Cube"]
    else:
        assert len(bpy.context.active_object.data.vertices)
