#!/usr/bin/env python3
"""Pictures of what the parameters of each algorithm do, for the pages in docs/algorithms: docs/gallery/*.png.

usage: parameters.py MEDAX DATA FOLDER [PICTURE...]

MEDAX is the program, DATA the folder with the models, FOLDER where the pictures go: all, or those that are named. Needs pyvista and pillow
(pip install pyvista pillow)."""

import json
import pathlib
import sys
import tempfile

import numpy
import pyvista

from drawing import Tools, axis, balls, draw, ghost, points, solid, valued


def medial_row(tools, name, option, values, *more, unit=""):
    model, inside = tools.model(name), ghost(tools.solid(name))
    row = []
    for value in values:
        cells = tools.read("medial", model, option, value, *more)
        row.append((f"{option} {value}{unit}", inside + axis(cells), name, 1.25))
    return row


def medial_thresholds(tools, file):
    draw(file, [
        medial_row(tools, "3holes", "--theta-degrees", [10, 22.5, 45], "--rule", "angle"),
        medial_row(tools, "foot", "--rho", [4, 8, 16], "--rule", "ratio"),
    ])


def medial_filters(tools, file):
    length = tools.report("info", tools.model("foot"))["bounds"]["diagonal"]
    alone = ["--rule", "none"]
    draw(file, [
        medial_row(tools, "foot", "--object-degrees", [30, 90, 135], *alone),
        medial_row(tools, "foot", "--lambda", [round(share * length, 3) for share in (0.005, 0.02, 0.08)], *alone),
        medial_row(tools, "foot", "--scale", [1.05, 1.5, 4], *alone),
    ], size=(400, 300))


def crust_labels(tools, file):
    rows = []
    for name, zoom in [("abc_plate_00000329", 1.3), ("range_scan_rops", 1.4)]:
        row = [(f"{name.split('_0')[0]}: --labels {rule}", solid(tools.read("crust", tools.model(name), "--labels", rule, ending="ply")), name, zoom) for rule in ("spread", "least-conflict")]
        rows.append(row)
    draw(file, rows, size=(560, 330))


def crust_noise(tools, file):
    name, source = "mannequin", tools.model("mannequin")
    length = tools.report("info", source)["bounds"]["diagonal"]
    noisy = tools.file("sample", source, "--spacing", 0.012 * length, "--noise", 0.006 * length, ending="ply")
    draw(file, [[
        ("samples", points(pyvista.read(noisy), 2), name, 1.3),
        ("without --noise", solid(tools.read("crust", noisy, ending="ply")), name, 1.3),
        ("--noise", solid(tools.read("crust", noisy, "--noise", ending="ply")), name, 1.3),
    ]])


def crust_sharp(tools, file):
    """The corner of a cube that has no samples on its edges."""
    cube = tools.place("ply")
    pyvista.Cube().triangulate().save(cube)
    samples = tools.file("sample", cube, "--spacing", 0.09, ending="ply")
    look = {"show_edges": True, "edge_opacity": 0.25, "line_width": 0.5}
    draw(file, [[
        ("samples", points(pyvista.read(samples), 5), "bracket", 0.95),
        ("without --sharp-corners", solid(tools.read("crust", samples, ending="ply"), **look), "bracket", 0.95),
        ("--sharp-corners", solid(tools.read("crust", samples, "--sharp-corners", ending="ply"), **look), "bracket", 0.95),
    ]])


def crust_simplify(tools, file):
    name = "rocker-arm"
    source, inside = tools.model(name), ghost(tools.solid(name))
    length = tools.report("info", source)["bounds"]["diagonal"]
    row = [("the power shape", inside + axis(tools.beside("crust", source, "--shape")), name, 1.3)]
    for epsilon, delta in [(0.01, 0.003), (0.04, 0.02)]:
        cells = tools.beside("crust", source, "--shape", "--simplify", "--epsilon", epsilon * length, "--delta", delta * length)
        row.append((f"--epsilon {100 * epsilon:g} %, --delta {100 * delta:g} %", inside + axis(cells), name, 1.3))
    scale = [(f"--scale-axis {factor}", inside + axis(tools.beside("crust", source, "--shape", "--scale-axis", factor)), name, 1.3) for factor in (1.05, 1.2, 1.6)]
    draw(file, [row, scale])


def crust_offset(tools, file):
    name = "rocker-arm"
    source, row = tools.model(name), []
    for distance in (-0.02, -0.01, 0.03):
        surface = tools.read("crust", source, "--offset", distance, ending="ply")
        parts = solid(surface) + ghost(tools.solid(name), 0.15) if distance < 0 else ghost(surface, 0.25) + solid(tools.solid(name))
        row.append((f"--offset {distance}", parts, name, 1.25))
    draw(file, [row])


def crust_holes(tools, file):
    name = "foot_hole"
    source = tools.model(name)
    look = {"backface_params": {"color": "peru"}}
    closed = tools.read("crust", source, ending="ply")
    draw(file, [[
        ("samples", points(tools.solid(name), 2), name, 1.3),
        ("without --holes", solid(closed, **look), name, 1.3),
        ("--holes", solid(tools.read("crust", source, "--holes", "--hole-radius", 0.1, ending="ply"), **look), name, 1.3),
    ]])


def cocone_options(tools, file):
    rows = []
    look = {"backface_params": {"color": "peru"}}
    for name, view in [("foot_hole", "foot_hole"), ("stanford-bunny", "from below")]:
        source = tools.model(name)
        rows.append([
            (f"{name}: --cocone-only", solid(tools.read("cocone", source, "--cocone-only", ending="ply"), **look), view, 1.25),
            ("Tight Cocone", solid(tools.read("cocone", source, ending="ply"), **look), view, 1.25),
        ])
    draw(file, rows, size=(480, 360))


def cocone_thresholds(tools, file):
    """One layer of the fandisk, whose edges are sharp, by what counts as dense enough; where it is open is red."""
    name, source = "fandisk", tools.model("fandisk")

    def row(option, values):
        panels = []
        for value in values:
            layer = tools.read("cocone", source, "--cocone-only", option, value, ending="ply")
            rim = layer.extract_feature_edges(boundary_edges=True, feature_edges=False, manifold_edges=False, non_manifold_edges=False)
            panels.append((f"{option} {value}", solid(layer) + [(rim, {"color": "red", "line_width": 4})], name, 1.3))
        return panels

    draw(file, [row("--angle-degrees", [5, 22.5, 40]), row("--ratio", [1.05, 1.2, 2]), row("--normal-degrees", [5, 30, 60])], size=(400, 300))


def flow_core(tools, file):
    name = "fandisk"
    source, inside = tools.model(name), ghost(tools.solid(name))
    blue = lambda *options: axis(tools.read("flow", source, *options), "steelblue")
    betti = lambda *options: ", ".join(map(str, tools.report("flow", source, *options)["outputs"][0]["topology"]["betti"]))
    draw(file, [
        [(f"{title}: b = {betti(*options)}", inside + blue(*options), name, 1.3) for title, options in [("--plain", ["--plain"]), ("repaired", [])]],
        [(f"--extend {what}", inside + blue("--extend", what), name, 1.3) for what in ("medial", "angle=120")],
    ], size=(520, 400))


def flow_manifolds(tools, file):
    name = "3holes"
    source, inside = tools.model(name), ghost(tools.solid(name))
    critical = tools.read("flow", source, "--critical")
    index, kind = critical.point_data["index"], critical.point_data["class"]
    inner = kind == 1
    marks = []
    for which, color in [(1, "goldenrod"), (2, "seagreen"), (3, "black")]:
        chosen = critical.points[inner & (index == which)]
        if len(chosen):
            marks += points(chosen, 9, color, render_points_as_spheres=True)
    on_surface = [part for which, color in [(1, "goldenrod"), (2, "seagreen")] for part in points(critical.points[(kind == 0) & (index == which)], 2, color)]
    # In the middle of the model, where they are largest.
    saddles = numpy.flatnonzero(inner & (index == 1))
    chosen = saddles[numpy.argsort(numpy.linalg.norm(critical.points[saddles] - tools.solid(name).center, axis=1))][:6]
    manifold = tools.read("flow", source, "--manifold", ",".join(map(str, chosen)))
    starts = tools.place("xyz")
    facing = tools.solid(name).compute_normals(auto_orient_normals=True, split_vertices=False)
    numpy.savetxt(starts, facing.points[::12] - 0.01 * facing.point_data["Normals"][::12])
    orbits = tools.read("flow", source, "--orbits", starts)
    draw(file, [
        [("--critical: the surface's", on_surface, name, 1.3), ("--critical: those of the inner axis", inside + marks, name, 1.3)],
        [("--manifold of six of index 1", inside + axis(manifold, "steelblue") + points(critical.points[chosen], 12, "goldenrod", render_points_as_spheres=True), name, 1.3), ("--orbits", inside + [(orbits, {"color": "steelblue", "line_width": 1.5})], name, 1.3)],
    ], size=(520, 360))


def pair_inner(tools, file):
    name = "kitten"
    source = tools.model(name)
    surface = ghost(tools.read("cocone", source, ending="ply"))
    row = []
    for what in ("voronoi", "medial", "core", "spine"):
        inner = tools.beside("pair", source, "--inner-out", "--inner", what)
        row.append((f"--inner {what}", surface + axis(inner, "steelblue"), name, 1.25))
    draw(file, [row], size=(300, 340))


def pair_spine(tools, file):
    """Surfaces from a spine to the boundary."""
    name = "kitten"
    source, row = tools.model(name), []
    for t in (0.05, 0.3, 0.7, 1):
        path = tools.place("ply")
        tools.report("pair", source, "--inner", "spine", "--iso", t, "--iso-out", path)
        row.append((f"t = {t}", solid(pyvista.read(path), show_edges=True, edge_opacity=0.2, line_width=0.5), name, 1.25))
    draw(file, [row], size=(300, 340))


def figure_lines(tools, name):
    """The curves of a letter."""
    features = json.loads((tools.data / "letters.geojson").read_text())["features"]
    found = next(f for f in features if name in map(str, f["properties"].values()))
    geometry = found["geometry"]
    polygons = geometry["coordinates"] if geometry["type"] == "MultiPolygon" else [geometry["coordinates"]]
    parts = []
    for polygon in polygons:
        for ring in polygon:
            corners = numpy.array([[*place[:2], 0] for place in ring], dtype=float)
            parts.append((pyvista.lines_from_points(corners), {"color": "black", "line_width": 2}))
    return parts


def field_plane(tools, file):
    letters = tools.data / "letters.geojson"
    outline = figure_lines(tools, "B")
    line = {"color": "firebrick", "line_width": 2}
    graph = lambda *options: [(tools.read("field", letters, "--feature", "B", *options), line)]
    dots = lambda *options: points(tools.read("field", letters, "--feature", "B", "--points", *options), 4, "firebrick")
    draw(file, [
        [(f"--object-degrees {angle}", outline + graph("--object-degrees", angle), "plane", 1.2) for angle in (0, 40, 120)],
        [(f"--min-distance {length}", outline + graph("--min-distance", length), "plane", 1.2) for length in (20, 60, 95)],
        [(f"--points --density {length}", outline + dots("--density", length), "plane", 1.2) for length in (160, 40, 10)],
    ], size=(360, 400), colours=48)


def field_space(tools, file):
    name = "fandisk"
    source, inside = tools.model(name), ghost(tools.solid(name))
    length = tools.report("info", source)["bounds"]["diagonal"]
    surface = lambda *options: axis(tools.read("field", source, *options), show_edges=True, edge_opacity=0.25, line_width=0.5)
    draw(file, [
        [(f"--object-degrees 60 --density {share:g} %", inside + surface("--object-degrees", 60, "--density", share * length / 100), name, 1.3) for share in (4, 2)],
        [(f"--object-degrees {angle} --density 2 %", inside + surface("--object-degrees", angle, "--density", 0.02 * length), name, 1.3) for angle in (20, 120)],
    ], size=(520, 400))


def union_spacing(tools, file):
    name = "fandisk"
    source = tools.model(name)
    length = tools.report("info", source)["bounds"]["diagonal"]
    centres = tools.file("field", source, "--points", "--density", 0.02 * length, "--min-distance", 0.01 * length, ending="ma")
    rows = numpy.array([line.split()[1:5] for line in open(centres) if line.startswith("v ")], dtype=float)
    panels = [("balls", balls(rows[:, :3], rows[:, 3]), name, 1.2)]
    for share in (2, 0.5):
        panels.append((f"--spacing {share:g} %", solid(tools.read("union", centres, "--spacing", share * length / 100, ending="ply")), name, 1.2))
    draw(file, [panels])


def sample_options(tools, file):
    rows = [[(f"torus --spacing {spacing}", points(tools.read("sample", "torus", "--spacing", spacing, ending="ply"), 4), "bracket", 1.2) for spacing in (0.2, 0.1, 0.05)],
            [(f"torus --noise {noise}", points(tools.read("sample", "torus", "--noise", noise, ending="ply"), 4), "bracket", 1.2) for noise in (0.01, 0.03, 0.1)]]
    draw(file, rows, size=(400, 280), colours=32)


def decimate_ratio(tools, file):
    name, source, row = "mannequin", tools.model("mannequin"), []
    for ratio in (1, 0.25, 0.05):
        mesh = tools.read("decimate", source, "--ratio", ratio, ending="ply")
        row.append((f"--ratio {ratio}: {mesh.n_cells:,} triangles", solid(mesh, show_edges=True, line_width=0.5, edge_opacity=0.4), name, 1.3))
    draw(file, [row])


def complex_flatten(tools, file):
    name, source = "foot", tools.model("foot")
    inside, row = ghost(tools.solid(name)), []
    for title, options in [("the power shape", []), ("--flatten", ["--flatten"]), ("--flatten --flatness 0.01", ["--flatten", "--flatness", 0.01])]:
        shape = tools.beside("crust", source, "--shape", *options)
        tetra = shape.celltypes == pyvista.CellType.TETRA
        parts = axis(shape.extract_cells(~tetra)) if (~tetra).any() else []
        if tetra.any():
            parts.append((shape.extract_cells(tetra), {"color": "goldenrod"}))
        row.append((f"{title}: {numpy.count_nonzero(tetra):,} tetrahedra", inside + parts, name, 1.25))
    draw(file, [row])


def sizes_colours(tools, file):
    row = []
    for name, attribute, options in [("rocker-arm", "thickness", []), ("rocker-arm", "feature_size", []), ("abc_plate_00000329", "thickness", ["--sharp-corners"])]:
        source = tools.model(name)
        path = tools.place("vtu")
        tools.report("crust", source, *options, "--sizes-at", source, path)
        mesh = pyvista.read(path)
        values = mesh.point_data[attribute]
        row.append((f"{name.split('_0')[0]}: {attribute}", valued(mesh, attribute, numpy.quantile(values, [0.02, 0.98])), name, 1.3 if name == "rocker-arm" else 1))
    draw(file, [row])


def winding_slice(tools, file):
    """Numbers in a plane through the bunny, which has five holes."""
    name, source = "stanford-bunny", tools.model("stanford-bunny")
    mesh = tools.solid(name)
    x0, x1, y0, y1, z0, z1 = mesh.bounds
    plane = pyvista.Plane(center=((x0 + x1) / 2, (y0 + y1) / 2, (z0 + z1) / 2), i_size=1.2 * (x1 - x0), j_size=1.2 * (y1 - y0), i_resolution=300, j_resolution=300)
    where = tools.place("xyz")
    numpy.savetxt(where, plane.points)
    answers = tools.place("vtu")
    tools.report("winding", source, where, "-o", answers)
    found = pyvista.read(answers)
    # Rows may have changed their order.
    numbers = numpy.empty(plane.n_points)
    numbers[found.point_data["row"].astype(int)] = found.point_data["winding"]
    plane["winding"] = numbers
    below = mesh.clip("z", origin=plane.center, invert=True)
    draw(file, [[
        ("winding numbers in a plane", [(plane, {"scalars": "winding", "cmap": "coolwarm", "clim": (0, 1), "show_scalar_bar": False, "lighting": False}), (below, {"color": "white", "opacity": 0.6})], name, 1.2),
        ("inside: above one half", [(plane.threshold(0.5, scalars="winding"), {"color": "indianred", "lighting": False}), (below, {"color": "white", "opacity": 0.6})], name, 1.2),
    ]], size=(480, 420))


def poles_sides(tools, file):
    """Poles with their labels, and those that --noise leaves."""
    name, source = "foot", tools.model("foot")
    length = tools.report("info", source)["bounds"]["diagonal"]
    noisy = tools.file("sample", source, "--spacing", 0.012 * length, "--noise", 0.005 * length, ending="ply")
    inside = ghost(tools.solid(name))
    row = []
    for title, sample, options in [("inner poles", source, []), ("with noise", noisy, []), ("with noise, --noise", noisy, ["--noise"])]:
        poles = tools.beside("crust", sample, "--poles", *options)
        poles = poles.extract_points(poles.point_data["label"] == 1, include_cells=False)
        row.append((title, inside + valued(poles, "radius", point_size=4, style="points"), name, 1.25))
    draw(file, [row])


def labels_cells(tools, file):
    """What the axis is made of, by three who know what is inside, where they do not agree: at the open ankle."""
    name, source = "foot_hole", tools.model("foot_hole")
    row = []
    for title, options in [("--labels cocone", ["--labels", "cocone"]), ("--labels crust", ["--labels", "crust"]), ("--label-mesh", ["--label-mesh", source])]:
        cells = tools.read("medial", source, *options)
        inner = tools.report("medial", source, *options)["labels"]["inner"]
        row.append((f"{title}: {inner:,} inner cells", ghost(tools.solid(name)) + axis(cells), "foot", 1.2))
    draw(file, [row])


def dual_diagram(tools, file):
    """Delaunay cells and the Voronoi facets of few samples, both cut open."""
    samples = tools.file("sample", "sphere", "--spacing", 0.5, ending="ply")
    cloud = pyvista.read(samples)
    rng = numpy.random.default_rng(1)
    both = numpy.vstack([cloud.points, rng.uniform(-0.7, 0.7, (40, 3))])
    path = tools.place("xyz")
    numpy.savetxt(path, both)
    cells = tools.read("triangulate", path)
    cut = cells.extract_cells(cells.cell_centers().points[:, 1] > 0).shrink(0.85)
    facets = tools.read("medial", path, "--rule", "none", "--side", "both", "--clip", 0.1)
    open_facets = facets.extract_cells(facets.cell_centers().points[:, 1] > -0.1)
    draw(file, [[
        ("Delaunay cells", solid(cut, show_edges=True, edge_opacity=0.4) + points(both, 6), "bracket", 1.2),
        ("Voronoi facets", [(open_facets, {"color": "wheat", "show_edges": True, "edge_opacity": 0.5})] + points(both[both[:, 1] > -0.1], 6), "bracket", 1.2),
    ]], size=(480, 420))


def triangulation_weights(tools, file):
    """The same points without weights, and with such as hide some."""
    rng = numpy.random.default_rng(3)
    cloud = pyvista.PolyData(rng.uniform(-1, 1, (60, 3)))
    radii = numpy.where(rng.uniform(size=60) < 0.15, 0.6, 0.05)
    path = tools.place("ply")
    with open(path, "w") as out:
        out.write(f"ply\nformat ascii 1.0\nelement vertex {len(radii)}\nproperty double x\nproperty double y\nproperty double z\nproperty double radius\nend_header\n")
        for place, radius in zip(cloud.points, radii):
            out.write(" ".join(map(repr, map(float, [*place, radius]))) + "\n")
    row = []
    for title, options in [("Delaunay", []), ("--radii radius", ["--radii", "radius"])]:
        cells = tools.read("triangulate", path, *options)
        hidden = tools.report("triangulate", path, *options)["counts"]["hidden"] or 0
        edges = cells.extract_all_edges()
        parts = [(edges, {"color": "steelblue", "line_width": 1})] + points(cloud, 8, "black", render_points_as_spheres=True)
        if options:
            parts += balls(cloud.points[radii > 0.1], radii[radii > 0.1], opacity=0.35)
        row.append((f"{title}: {hidden} hidden", parts, "bracket", 1.2))
    draw(file, [row], size=(480, 420))


def points_order(tools, file):
    """Vertices in their order, along the Hilbert curve."""
    row = []
    for name, source in [("knot", tools.model("knot")), ("mannequin", tools.model("mannequin"))]:
        cells = tools.read("triangulate", source)
        cloud = pyvista.PolyData(numpy.asarray(cells.points))
        cloud["rank"] = numpy.arange(cloud.n_points)
        row.append((f"{name}: the order of its vertices", valued(cloud, "rank", point_size=6, style="points", cmap="hsv"), name, 1.3))
    draw(file, [row], size=(480, 400))


def compare_distances(tools, file):
    """How far decimated surfaces are from the one that they come from."""
    name, source = "mannequin", tools.model("mannequin")
    whole, row = tools.solid(name), []
    for ratio in (0.25, 0.05):
        path = tools.file("decimate", source, "--ratio", ratio, ending="ply")
        found = tools.report("compare", path, source)
        there, length = found["distances"]["a_to_b"], found["distances"]["diagonal"]
        mesh = pyvista.read(path).subdivide(2)
        mesh["off"] = numpy.abs(mesh.compute_implicit_distance(whole)["implicit_distance"])
        row.append((f"--ratio {ratio}: max {100 * there['max'] / length:.2f} %, mean {100 * there['mean'] / length:.3f} %", valued(mesh, "off", (0, 0.0015 * length)), name, 1.3))
    draw(file, [row], size=(480, 420))


def figure_parts(tools, file):
    """What a figure may hold, and its axis: holes, several parts, circles."""
    row = []
    for letter in ("B", "i", "&"):
        graph = tools.read("field", tools.data / "letters.geojson", "--feature", letter, "--side", "both", "--clip", 0.1, "--object-degrees", 20)
        row.append((letter, figure_lines(tools, letter) + [(graph, {"color": "firebrick", "line_width": 1.5})], "plane", 1.1))
    draw(file, [row], size=(360, 400), colours=32)


PICTURES = {name.replace("_", "-"): made for name, made in list(globals().items()) if callable(made) and getattr(made, "__module__", "") == __name__ and name not in ("medial_row", "figure_lines", "main")}


def main():
    medax, data, out, *names = sys.argv[1:]
    pyvista.OFF_SCREEN = True
    for name in names or PICTURES:
        with tempfile.TemporaryDirectory() as folder:
            PICTURES[name](Tools(medax, data, folder), str(pathlib.Path(out) / f"{name}.png"))


if __name__ == "__main__":
    main()
