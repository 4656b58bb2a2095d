#!/usr/bin/env python3
"""The figures of the five papers, as far as there is data for them, from what the program writes: docs/gallery.md and docs/gallery/*.png.

usage: gallery.py MEDAX DATA DOCS [PICTURE...]

MEDAX is the program, DATA the folder with the models, DOCS the folder of the documentation. All pictures are made, or those that are named; the
page always. Needs pyvista and pillow (pip install pyvista pillow)."""

import pathlib
import sys
import tempfile

import numpy
import pyvista

from drawing import Tools, axis, balls, draw, ghost, points, solid
from parameters import figure_lines

EDGES = {"show_edges": True, "edge_opacity": 0.25, "line_width": 0.5}


def scan_to_axis(tools, file):
    name, source = "kitten", tools.model("kitten")
    surface = tools.read("crust", source, ending="ply")
    shape = tools.beside("crust", source, "--shape", "--simplify")
    cloud = tools.read("triangulate", source)
    draw(file, [[("samples", points(cloud, 2), name, 1.25), ("power crust", solid(surface), name, 1.25), ("simplified power shape", ghost(surface) + axis(shape), name, 1.25)]])


def polar_balls(tools, file):
    name, source = "foot_hole", tools.model("foot_hole")
    poles = tools.beside("crust", source, "--poles")
    inner = numpy.flatnonzero(poles.point_data["label"] == 1)
    # A tenth of them look like all.
    inner = inner[numpy.argsort(-poles.point_data["radius"][inner])][::10]
    look = {"backface_params": {"color": "peru"}}
    opened = tools.read("crust", source, "--holes", "--hole-radius", 0.1, ending="ply")
    draw(file, [[("inner polar balls", balls(poles.points[inner], poles.point_data["radius"][inner]), name, 1.3), ("power crust, with the hole", solid(opened, **look), name, 1.3)]], size=(480, 380))


def noisy_scan(tools, file):
    name, source = "stanford-bunny", tools.model("stanford-bunny")
    length = tools.report("info", source)["bounds"]["diagonal"]
    noisy = tools.file("sample", source, "--spacing", 0.008 * length, "--noise", 0.003 * length, ending="ply")
    poles = tools.beside("crust", noisy, "--poles", "--noise")
    poles = poles.extract_points(poles.point_data["label"] == 1, include_cells=False)
    surface = tools.read("crust", noisy, "--noise", ending="ply")
    draw(file, [[("samples with noise", points(pyvista.read(noisy), 2), name, 1.25), ("inner poles that are left", ghost(surface) + points(poles, 3, "firebrick"), name, 1.25), ("power crust, --noise", solid(surface), name, 1.25)]])


def sharp_edges(tools, file):
    name = "fandisk"
    source = tools.model(name)
    # Random points of the mesh: none on its edges.
    length = tools.report("info", source)["bounds"]["diagonal"]
    samples = tools.file("sample", source, "--spacing", 0.015 * length, ending="ply")
    draw(file, [[("samples, none on the edges", points(pyvista.read(samples), 2), name, 1.3), ("power crust", solid(tools.read("crust", samples, ending="ply")), name, 1.3), ("--sharp-corners", solid(tools.read("crust", samples, "--sharp-corners", ending="ply")), name, 1.3)]])


def part_with_holes(tools, file):
    row = []
    for name, options, zoom in [("abc_plate_00000329", ["--sharp-corners"], 1), ("rocker-arm", [], 1.3)]:
        source = tools.model(name)
        row.append((name.split("_0")[0], solid(tools.read("crust", source, *options, ending="ply")), name, zoom))
    source = tools.file("sample", "bracket", "--spacing", 0.05, ending="ply")
    row.append(("bracket", solid(tools.read("crust", source, "--sharp-corners", ending="ply")), "bracket", 1))
    draw(file, [row])


def inner_offset(tools, file):
    row = []
    for name, distance in [("mannequin", -0.25), ("rocker-arm", -0.025)]:
        source = tools.model(name)
        row.append((f"{name}: --offset {distance}", [(tools.read("crust", source, ending="ply"), {"color": "gold", "opacity": 0.25}), (tools.read("crust", source, "--offset", distance, ending="ply"), {"color": "indianred"})], name, 1.3))
    draw(file, [row], size=(520, 420))


def noisy_shape(tools, file):
    name, source = "foot", tools.model("foot")
    length = tools.report("info", source)["bounds"]["diagonal"]
    clean = tools.file("sample", source, "--spacing", 0.012 * length, ending="ply")
    noisy = tools.file("sample", source, "--spacing", 0.012 * length, "--noise", 0.002 * length, ending="ply")
    inside, rows = ghost(tools.solid(name)), []
    for title, sample, more in [("samples", clean, []), ("with noise", noisy, ["--noise"])]:
        row = []
        for what, options in [("power shape", []), ("simplified", ["--simplify", "--epsilon", 0.03 * length, "--delta", 0.01 * length])]:
            shape = tools.beside("crust", sample, "--shape", *more, *options)
            row.append((f"{title}: {what}, {shape.n_cells:,} cells", inside + axis(shape), name, 1.3))
        rows.append(row)
    draw(file, rows, size=(480, 320))


def scan_with_gap(tools, file):
    look = {"backface_params": {"color": "peru"}}
    rows = []
    for name, view, radius in [("stanford-bunny", "from below", 0.005), ("range_scan_rops", "range_scan_rops", 0.02)]:
        source = tools.model(name)
        closed, opened = tools.read("crust", source, ending="ply"), tools.read("crust", source, "--holes", "--hole-radius", radius, ending="ply")
        rows.append([("samples", points(tools.read("triangulate", source), 2), view, 1.3), ("power crust", solid(closed, **look), view, 1.3), (f"--holes --hole-radius {radius}", solid(opened, **look), view, 1.3)])
    draw(file, rows)


def decimated(tools, file):
    name = "igea"
    crust = tools.file("crust", tools.model(name), ending="ply")
    row = []
    for title, share in [("", 0.25), ("", 0.02), ("", 0.004)]:
        mesh = tools.read("decimate", crust, "--ratio", share, ending="ply")
        row.append((f"{mesh.n_cells:,} triangles", solid(mesh), name, 1.3))
    draw(file, [row])


def pair_elements(tools, file):
    """The kinds of elements one after the other, cut open."""
    rows = []
    cube = tools.place("ply")
    pyvista.Cube().triangulate().save(cube)
    for name, source, spacing in [("bracket", cube, 0.12), ("mannequin", tools.model("mannequin"), None)]:
        sample = source if spacing is None else tools.file("sample", source, "--spacing", spacing, ending="ply")
        cells = tools.read("pair", sample)
        kind = cells.cell_data["kind"]
        row = []
        middle = cells.cell_centers().points
        direction = numpy.array([1, -1, 0.0])
        kept = middle @ direction < numpy.median(cells.points @ direction)
        for title, most in [("face to vertex", 1), ("and edge to edge", 2), ("and vertex to face", 3)]:
            chosen = cells.extract_cells((kind <= most) & kept)
            colours = {1: "lightsteelblue", 2: "goldenrod", 3: "indianred"}
            parts = []
            for which in range(1, most + 1):
                of_kind = chosen.extract_cells(chosen.cell_data["kind"] == which)
                parts.append((of_kind.extract_surface(algorithm="dataset_surface"), {"color": colours[which], **EDGES}))
            row.append((title, parts, name, 1.05 if name == "bracket" else 1.3))
        rows.append(row)
    draw(file, rows, size=(400, 340))


def pair_removed(tools, file):
    name, source = "mannequin", tools.model("mannequin")
    whole = tools.beside("pair", source, "--inner-out", "--inner", "voronoi")
    medial = tools.beside("pair", source, "--inner-out", "--inner", "medial")
    length = tools.report("info", source)["bounds"]["diagonal"]
    inside = ghost(tools.solid(name))
    draw(file, [[("the inner Voronoi diagram", inside + axis(whole, "khaki"), name, 1.3), ("what of it stays", inside + axis(medial, "steelblue"), name, 1.3)]], size=(480, 420))


def plane_and_solid(tools, file):
    letters = tools.data / "letters.geojson"
    parts = figure_lines(tools, "&")
    graph = tools.read("field", letters, "--feature", "&", "--object-degrees", 40)
    parts.append((graph, {"color": "firebrick", "line_width": 2}))
    largest = int(numpy.argmax(graph.point_data["radius"]))
    parts.append((pyvista.Circle(radius=graph.point_data["radius"][largest]).translate(graph.points[largest]).extract_feature_edges(), {"color": "steelblue", "line_width": 2}))
    name, source = "fandisk", tools.model("fandisk")
    length = tools.report("info", source)["bounds"]["diagonal"]
    surface = tools.read("field", source, "--object-degrees", 60, "--density", 0.015 * length)
    draw(file, [[("a figure, its axis, and a medial ball", parts, "plane", 1.15), ("a solid, and its axis", ghost(tools.solid(name)) + axis(surface), name, 1.3)]], size=(480, 420))


def poles_and_field(tools, file):
    """Points of the axis near the concave parts of a solid, where samples are few."""
    name, source = "foot", tools.model("foot")
    thin = tools.file("decimate", source, "--triangles", 3000, ending="ply")
    mesh = pyvista.read(thin)
    length = tools.report("info", thin)["bounds"]["diagonal"]
    poles = tools.beside("crust", thin, "--poles")
    poles = poles.extract_points(poles.point_data["label"] == 1, include_cells=False)
    cloud = tools.read("field", thin, "--points", "--density", 0.012 * length, "--object-degrees", 40)
    inside = ghost(mesh)
    draw(file, [[(f"mesh of {mesh.n_points:,} vertices", solid(mesh, **EDGES), name, 1.3), ("inner poles of its vertices", inside + points(poles, 3, "firebrick"), name, 1.3), ("points by the distance to its faces", inside + points(cloud, 3, "firebrick"), name, 1.3)]])


def saddles(tools, file):
    """The unstable manifolds of critical points of the inner axis, in six colours by turns."""
    name, source = "3holes", tools.model("3holes")
    critical = tools.read("flow", source, "--critical")
    rows = numpy.flatnonzero((critical.point_data["class"] == 1) & (critical.point_data["index"] == 1))
    colours = ["steelblue", "goldenrod", "indianred", "seagreen", "orchid", "sienna"]
    parts = ghost(tools.solid(name))
    for i, colour in enumerate(colours):
        parts += axis(tools.read("flow", source, "--manifold", ",".join(map(str, rows[i :: len(colours)]))), colour)
    parts += points(critical.points[rows], 8, "black", render_points_as_spheres=True)
    draw(file, [[("unstable manifolds of saddle points of index 1", parts, name, 1.3)]], size=(800, 500))


# Paper, figure, what it shows, picture; a name of a function above, or a path of a picture that another page has made.
FIGURES = [
    ("Amenta, Choi, Kolluri 2001, The Power Crust", [
        ("1", "Samples (of the kitten), the watertight surface, and the simplified axis.", scan_to_axis),
        ("3", "Seconds against the number of samples of an ellipsoid: [scaling.md](scaling.md).", "figure3.svg"),
        ("5", "Inner polar balls of a foot that is open at the ankle, and its power crust, with the hole left open.", polar_balls),
        ("9, 10", "A scan (of a bunny) with noise, the inner poles that are far enough from their samples, and the surface, which is watertight.", noisy_scan),
        ("11, 12", "Sharp edges without samples on them; where both poles of misshapen Voronoi cells are left out, the faces beside meet.", sharp_edges),
        ("13", "Mechanical parts. All holes are there.", part_with_holes),
        ("14", "Inner offset surfaces (red) within the power crusts (yellow).", inner_offset),
        ("16", "The power shape and its simplification, of samples of a foot without and with noise. The simplified ones are alike.", noisy_shape),
        ("18, 19", "Scans with gaps, the bunny from below and figures from one side: closed, and with the faces left out that fill holes.", scan_with_gap),
        ("20", "The power crust of igea, with fewer and fewer triangles.", decimated),
    ]),
    ("Dey, Zhao 2004, Approximating the medial axis from the Voronoi diagram with a convergence guarantee", [
        ("5, 7", "One condition alone: the angle condition (3holes), the ratio condition (foot). Small thresholds leave spikes, large ones make holes.", "gallery/medial-thresholds.png"),
        ("13", "Axes by both conditions, with the same thresholds for all: [medial.md](medial.md).", "axes.png"),
        ("the theorem", "How the axes converge: [convergence.md](convergence.md).", "convergence.svg"),
    ]),
    ("Giesen, Ramos, Sadri 2010, Medial axis approximation and unstable flow complex", [
        ("2", "Critical points of the surface and of the inner axis (yellow index 1, green 2, black 3), one unstable manifold, and orbits.", "gallery/flow-manifolds.png"),
        ("11", "Unstable manifolds of critical points of the inner axis, some saddles of index 1.", saddles),
        ("13", "Cores, axes of MEDIAL, and cores extended by these: [flow.md](flow.md).", "cores.png"),
    ]),
    ("Stolpner, Whitesides 2009, Medial axis approximation with bounded error", [
        ("1", "The axis of a plane figure with a medial ball, and that of a solid.", plane_and_solid),
        ("2", "A mesh with few vertices; the poles of its vertices, and points by the distance to its faces.", poles_and_field),
        ("10", "Models, points of their axes, and the unions of the balls there: [field.md](field.md).", "field.png"),
        ("11", "The Voronoi diagram of three lines in a cube: [algorithms/distance.md](algorithms/distance.md).", "three_lines.png"),
    ]),
    ("Shaham, Shamir, Cohen-Or 2004, Medial axis based solid representation", [
        ("3, 10 to 12", "Pair-meshes of a cube and a head, cut open: pyramids over Voronoi facets (blue), with tetrahedra between edges (yellow), with those over triangles (red).", pair_elements),
        ("8", "The inner Voronoi diagram of the head, and what stays of it when the facets of MEDIAL are asked for.", pair_removed),
        ("5, 13 to 15", "Shapes, and their surfaces from the inner structure to the boundary: [pair.md](pair.md).", "pair.png"),
        ("14", "Inner structures of a kitten: all of the inner Voronoi diagram, the facets of MEDIAL, those in which a core lies, a spine.", "gallery/pair-inner.png"),
        ("14", "Surfaces from the spine to the boundary.", "gallery/pair-spine.png"),
    ]),
]


def main():
    medax, data, docs, *names = sys.argv[1:]
    docs = pathlib.Path(docs)
    lines = ["# Gallery", ""]
    add = lines.append
    add("The figures of the five papers that medax implements, as far as there is data for them, made from what the program writes. `make gallery` makes this page")
    add("and its pictures; those that other pages made are named with these. Figures that explain a proof are left out. What the parameters of each algorithm do")
    add("is shown on the algorithm's page.")
    for paper, figures in FIGURES:
        add(f"\n## {paper}\n")
        for number, text, made in figures:
            path = made
            if callable(made):
                name = made.__name__.replace("_", "-")
                path = f"gallery/{name}.png"
                if not names or name in names:
                    with tempfile.TemporaryDirectory() as folder:
                        made(Tools(medax, data, folder), str(docs / path))
            alternative = text.split(":")[0].rstrip(".")
            add(f"![{alternative}]({path})\n")
            of = f"Figure {number}" if number[0].isdigit() and number.isdigit() else f"Figures {number}" if number[0].isdigit() else number.capitalize()
            add(f"{of}. {text}\n")
    (docs / "gallery.md").write_text("\n".join(lines).rstrip() + "\n")


if __name__ == "__main__":
    main()
