#!/usr/bin/env python3
"""Pair-meshes of models and built-in shapes, of all of the inner Voronoi diagram and of parts of it: docs/pair.md; and pictures in the manner of Shaham, Shamir, Cohen-Or 2004: their surfaces from the inner
structure to the boundary as in Figures 13 to 15, docs/pair.png and docs/pair-medial.png, their elements and inner structures as in Figures 3 and 10 to 12, docs/pair-elements.png.

usage: pair.py MEDAX DATA FOLDER

MEDAX is the program, DATA the folder with the models, FOLDER where the page and the pictures go. Seconds are those of the processor. Needs pyvista (pip install pyvista)."""

import datetime
import json
import pathlib
import platform
import subprocess
import sys
import tempfile

import numpy
import pyvista
from PIL import Image

MODELS = ["3holes.off", "rocker-arm.obj", "mannequin.off", "foot.off", "kitten.xyz", "igea.ply", "refined_elephant.off", "fandisk.off", "abc_plate_00000329.obj", "ant.off", "cavity_and_ring.off", "hotdogs.pts", "knot.pts", "octopus.off", "stanford-bunny.obj"]
LARGE = ["igea", "refined_elephant", "cavity_and_ring", "stanford-bunny", "octopus"]
SHAPES = ["ellipsoid", "torus", "genus3", "trefoil", "sphere", "capsule", "box", "bracket"]
VARIANTS = [["--inner", "medial"], ["--inner", "core"], ["--inner", "core", "--facets", "medial"], ["--inner", "spine"]]
# Seconds that a command may take.
LIMIT = 900

# What is drawn: the shapes of the paper's figures, as far as there are such. Where from they are seen, what is up, how much they are enlarged; the normal of the plane by which their elements are clipped; the distance
# between samples, in diagonals.
DRAWN = {
    "ball": ((1, 0.6, 0.4), (0, 1, 0), 1.2, (1, 0.2, 0.2), 0.02),
    "cylinder": ((1, 0.4, 0.4), (0, 1, 0), 1.2, (0, 0.3, 1), 0.02),
    "wheel": ((0.5, -0.5, 1), (0, 1, 0), 1.2, (0, 0, 1), 0.012),
    "cube": ((1, 0.7, 0.5), (0, 1, 0), 1, (1, 0, 0), 0.02),
    "mannequin": ((1, -1, 0.2), (0, 0, 1), 1.15, (1, -1, 0), None),
}
# Those with thin parts.
THIN = ["ball", "wheel"]
# Those of Figures 13, and 14 and 15; None is the inner structure.
TIMES_OF_BALL = [0.001, 0.003, 0.01, 0.05, 0.1, 0.5, 1]
TIMES = [None, 0.001, 0.1, 0.3, 0.5, 0.75, 1]
SIDE = 240
KINDS = ["#ffd35c", "#e0605e", "#6c9fd8"]
REASONS = ["lightsteelblue", "orange", "crimson"]
EDGES = "slategray"


def run(medax, *arguments):
    """What the program reports, or `error`."""
    try:
        done = subprocess.run([medax, *map(str, arguments), "--json", "--quiet"], capture_output=True, text=True, timeout=LIMIT)
        return json.loads(done.stdout)
    except subprocess.TimeoutExpired:
        return {"error": {"message": f"takes longer than {LIMIT} s"}}
    except json.JSONDecodeError:
        return {"error": {"message": f"ends with {done.returncode}: {done.stderr.strip()}"}}


def betti(report, output):
    return ", ".join(map(str, report["outputs"][output]["topology"]["betti"]))


def seconds(report):
    return sum(stage["cpu_seconds"] for stage in report["stages"] if stage["name"] == "pair")


def problems(report):
    return str(report["validation"]["problems"])


def samples(medax, data, folder):
    paths = [data / name for name in MODELS]
    for shape in SHAPES:
        path = folder / f"{shape}.ply"
        run(medax, "sample", shape, "-o", path)
        paths.append(path)
    return paths


def head(add, columns, texts=()):
    add("| " + " | ".join(columns) + " |")
    add("| " + " | ".join("---" if column in texts else "--:" for column in columns) + " |")


def failed(add, path, report, columns):
    """Adds a row with the reason why there is nothing to tell, if there is not."""
    if "error" in report:
        add(f"| {path.stem} | {report['error']['message']}" + " |" * (columns - 1))
    return "error" in report


def table(medax, paths, folder, add):
    """The table of the Voronoi-based pair-meshes, and their reports."""
    add("## All of the inner Voronoi diagram\n")
    add("*Betti*: numbers of S; of the surface at 0.5; of the solid; of the inner structure.\n")
    columns = ["sample", "samples", "pyramids", "between edges", "over triangles", "moved, of inner vertices", "removed", "Betti", "problems", "s"]
    head(add, columns, ["sample", "Betti"])
    reports = {}
    for path in paths:
        report = run(medax, "pair", path, "--validate", "--iso", "0.5,1", "--iso-out", folder / "iso.ply")
        if failed(add, path, report, len(columns)):
            continue
        reports[path] = report
        pair = report["pair"]
        counts = [f"{pair[key]:,}" for key in ["face_vertex", "edge_edge", "vertex_face"]]
        cells = [path.stem, f"{report['input']['points']:,}", *counts, f"{pair['moved']:,} of {pair['inner_vertices']:,}", str(pair["removed"]), "; ".join(betti(report, output) for output in [3, 2, 0, 1]), problems(report), f"{seconds(report):.2f}"]
        add("| " + " | ".join(cells) + " |")
        print(path.stem, file=sys.stderr)
    add("")
    return reports


def stays(pair):
    return pair["enclosed"] + pair["unseen"], pair["unasked_edges"]


def variant(medax, paths, all_of_it, options, add):
    """The table of a medial-axis-based variant."""
    add(f"## `{' '.join(options)}`\n")
    columns = ["sample", "pyramids of all", "pyramids", "faces asked for", "enclosed", "unseen", "loose edges unasked", "M reached", "Betti", "problems", "s"]
    head(add, columns, ["sample", "Betti"])
    summary, count = [], 0
    for path in paths:
        report = run(medax, "pair", path, "--validate", *options)
        if failed(add, path, report, len(columns)):
            continue
        count += 1
        pair = report["pair"]
        same = "?"
        before = "?"
        if path in all_of_it:
            before = f"{all_of_it[path]['pair']['face_vertex']:,}"
            same = "as all" if betti(report, 1) == betti(all_of_it[path], 1) else f"**{betti(report, 1)}**"
        counts = [f"{pair[key]:,}" for key in ["face_vertex", "asked", "enclosed", "unseen", "unasked_edges"]]
        reached = "yes" if sum(stays(pair)) == 0 else "no"
        cells = [path.stem, before, *counts, reached, same, problems(report), f"{seconds(report):.2f}"]
        summary.append((reached == "yes", same == "as all", report["validation"]["problems"] == 0))
        add("| " + " | ".join(cells) + " |")
        print(path.stem, *options, file=sys.stderr)
    reached, same, valid = (sum(row[i] for row in summary) for i in range(3))
    add(f"\nOf {len(paths)} samples {count} have a pair-mesh, {valid} a valid one, {same} one with the Betti numbers of all of the diagram, {reached} exactly M.\n")


def subdivided(medax, paths, add):
    """What stays without and with smaller triangles."""
    add("## `--subdivide`\n")
    add("Faces and loose edges that stay unasked, without and with triangles of the boundary divided, and samples with the vertices added; not of the largest samples, which take minutes.\n")
    names = ["medial", "core", "spine"]
    columns = ["sample"] + [f"{name}, {what}" for name in names for what in ["without", "with", "vertices"]]
    head(add, columns, ["sample"])
    for path in paths:
        if path.stem in LARGE:
            continue
        cells = [path.stem]
        for name in names:
            for options in [[], ["--subdivide"]]:
                report = run(medax, "pair", path, "--validate", "--inner", name, *options)
                if "error" in report:
                    cells.append(report["error"]["message"])
                    vertices = ""
                    continue
                faces, edges = stays(report["pair"])
                wrong = report["validation"]["problems"]
                cells.append(f"{faces:,} + {edges:,}" + (f", **{wrong} problems**" if wrong else ""))
                vertices = f"{report['pair']['boundary_vertices']:,}"
            cells.append(vertices)
        add("| " + " | ".join(cells) + " |")
        print(path.stem, "subdivided", file=sys.stderr)
    add("")


def mesh_of(name):
    """A mesh of a shape of the paper, from which samples are taken."""
    if name == "ball":
        return pyvista.Sphere(radius=1, theta_resolution=60, phi_resolution=60)
    if name == "cylinder":
        return pyvista.Cylinder(radius=0.5, height=2, resolution=60).triangulate()
    if name == "cube":
        return pyvista.Cube().triangulate()
    if name == "wheel":
        x, y, z = numpy.meshgrid(*(numpy.linspace(-1.3, 1.3, 131),) * 2, numpy.linspace(-0.25, 0.25, 31), indexing="ij")
        value = 0.15 - numpy.hypot(numpy.hypot(x, y) - 1, z)
        value = numpy.maximum(value, numpy.minimum(0.25 - numpy.hypot(x, y), 0.15 - abs(z)))
        for k in range(6):
            a = numpy.pi * k / 3
            along, across = x * numpy.cos(a) + y * numpy.sin(a), y * numpy.cos(a) - x * numpy.sin(a)
            value = numpy.maximum(value, numpy.minimum(0.08 - numpy.hypot(across, z), numpy.minimum(along, 1 - along)))
        grid = pyvista.ImageData(dimensions=x.shape, spacing=(2.6 / 130, 2.6 / 130, 0.5 / 30), origin=(-1.3, -1.3, -0.25))
        grid["value"] = value.ravel(order="F")
        return grid.contour([0], scalars="value").triangulate().clean()
    return None


def sources(medax, data, folder):
    """Samples of what is drawn."""
    files = {}
    for name, (*_, spacing) in DRAWN.items():
        mesh = mesh_of(name)
        files[name] = data / f"{name}.off"
        if mesh is not None:
            files[name] = folder / f"{name}-drawn.ply"
            mesh.save(folder / "mesh.ply")
            run(medax, "sample", folder / "mesh.ply", "-o", files[name], "--spacing", spacing * mesh.length)
    return files


def panel(plotter, place, name, text, bounds=None):
    """Finishes a panel, seen as DRAWN tells. Without bounds what it holds fills it."""
    plotter.subplot(*place)
    view, up, zoom = DRAWN[name][:3]
    plotter.view_vector(view, viewup=up)
    plotter.reset_camera(bounds=bounds)
    plotter.camera.zoom(zoom if bounds else 1)
    plotter.add_text(text, position=(8 * SCALE, (SIDE - 18) * SCALE), font_size=7 * SCALE, color="black")


# Pictures are drawn larger, and then made smaller, so that edges are smooth.
SCALE = 2
LOOK = {"ambient": 0.25, "diffuse": 0.8, "specular": 0, "show_edges": True, "edge_opacity": 0.22, "line_width": 0.5 * SCALE}


def add_faces(plotter, faces, color, edges=None):
    """Draws faces; and their edges in a colour of their own, where they may be too thin to be seen."""
    plotter.add_mesh(faces, color=color, **LOOK)
    if edges:
        plotter.add_mesh(faces.extract_all_edges(), color=edges, line_width=0.6 * SCALE)


def plotter_of(rows, columns):
    return pyvista.Plotter(shape=(rows, columns), off_screen=True, window_size=(SCALE * SIDE * columns, SCALE * SIDE * rows), border=False)


def save(plotter, file):
    image = Image.fromarray(plotter.screenshot(return_img=True))
    image = image.resize((image.width // SCALE, image.height // SCALE), Image.LANCZOS)
    image.quantize(64, dither=Image.Dither.NONE).save(file, optimize=True)
    plotter.close()


def add_structure(plotter, structure, name):
    """Draws an inner structure of a shape: its faces by reason, its loose edges, or its only point."""
    if structure.n_cells == 0:
        plotter.add_mesh(pyvista.PolyData(structure.points), color="black", point_size=8 * SCALE, render_points_as_spheres=True)
        return
    for reason, color in enumerate(REASONS):
        part = structure.extract_cells(structure.cell_data["reason"] == reason)
        faces = part.extract_cells(part.celltypes != pyvista.CellType.LINE)
        edges = part.extract_cells(part.celltypes == pyvista.CellType.LINE)
        if faces.n_cells:
            add_faces(plotter, faces, color, [EDGES, *REASONS[1:]][reason] if name in THIN else None)
        if edges.n_cells:
            plotter.add_mesh(edges, color="black" if reason == 0 else color, line_width=1.5 * SCALE)


def surfaces(medax, files, folder, inner, file):
    """The surfaces from an inner structure to the boundary."""
    plotter = plotter_of(len(DRAWN), len(TIMES))
    for row, name in enumerate(DRAWN):
        times = TIMES_OF_BALL if name == "ball" else TIMES
        list_of_times = ",".join(str(t) for t in times if t is not None)
        report = run(medax, "pair", files[name], "--inner", inner, "--inner-out", folder / "inner.vtu", "--iso", list_of_times, "--iso-out", folder / "iso.ply")
        if "error" in report:
            sys.exit(f"{name}: {report['error']['message']}")
        bounds = pyvista.read(folder / "iso-1.ply").bounds
        for column, t in enumerate(times):
            plotter.subplot(row, column)
            if t is None:
                add_structure(plotter, pyvista.read(folder / "inner.vtu"), name)
                panel(plotter, (row, column), name, "inner structure", bounds)
                continue
            surface = pyvista.read(folder / f"iso-{t}.ply")
            add_faces(plotter, surface, REASONS[0], EDGES if name in THIN and t < 0.05 else None)
            panel(plotter, (row, column), name, f"t = {t}", None if name == "ball" else bounds)
    save(plotter, file)


def elements(medax, files, folder, file):
    """Elements of the pair-meshes of medial axes, by kind, and inner structures."""
    inner = ["voronoi", "medial", "core", "spine"]
    plotter = plotter_of(len(DRAWN), 3 + len(inner))
    for row, name in enumerate(DRAWN):
        report = run(medax, "pair", files[name], "--inner", "medial", "-o", folder / "solid.vtu")
        if "error" in report:
            sys.exit(f"{name}: {report['error']['message']}")
        solid = pyvista.read(folder / "solid.vtu")
        normal = numpy.array(DRAWN[name][3])
        is_behind = (solid.cell_centers().points - solid.center) @ normal <= 0
        for column, text in enumerate(["pyramids", "+ between edges", "+ over triangles"]):
            plotter.subplot(row, column)
            for kind in range(1, column + 2):
                part = solid.extract_cells(is_behind & (solid.cell_data["kind"] == kind))
                add_faces(plotter, part.extract_surface(algorithm="geometry"), KINDS[kind - 1], "#a07a18" if name in THIN and column == 0 else None)
            panel(plotter, (row, column), name, text, solid.bounds)
        for column, which in enumerate(inner, 3):
            run(medax, "pair", files[name], "--inner", which, "--inner-out", folder / "inner.vtu")
            structure = pyvista.read(folder / "inner.vtu")
            plotter.subplot(row, column)
            add_structure(plotter, structure, name)
            panel(plotter, (row, column), name, which, None if name == "ball" else solid.bounds)
    save(plotter, file)


def main():
    medax, data, docs = sys.argv[1], pathlib.Path(sys.argv[2]), pathlib.Path(sys.argv[3])
    lines = ["# Pair-meshes\n"]
    add = lines.append
    machine = f"{platform.machine()}, {platform.system()}"
    add("Solids between an inner structure and their surface S (Shaham, Shamir, Cohen-Or 2004; [docs/algorithms/pair.md](algorithms/pair.md)). `make pair` makes this page;")
    add(f"this one was made on {datetime.date.today()}, {machine}.\n")
    add("Surfaces at values of t from the inner structure to the boundary, as in Figures 13 to 15; the ball is enlarged, since its inner structure is small. Of all of the inner Voronoi diagram:\n")
    add("![Shapes, and their surfaces from all of the inner Voronoi diagram to the boundary](pair.png)\n")
    add("Of a medial axis, `--inner medial`:\n")
    add("![Shapes, and their surfaces from a medial axis to the boundary](pair-medial.png)\n")
    add("Elements of `--inner medial` on the far side of a plane, as in Figures 3 and 10 to 12: pyramids (yellow), tetrahedra between edges (red) and over triangles (blue). Beside them inner structures: faces asked for (grey), enclosed (orange), unseen (red); loose edges asked for are black. Those of the ball are enlarged.\n")
    add("![Elements of pair-meshes by kind, and inner structures](pair-elements.png)\n")
    add("In the tables, labels are those of Tight Cocone, *problems* are the checks of `validate` that fail, *s* is the stage `pair`.\n")
    with tempfile.TemporaryDirectory() as folder:
        folder = pathlib.Path(folder)
        files = sources(medax, data, folder)
        surfaces(medax, files, folder, "voronoi", docs / "pair.png")
        surfaces(medax, files, folder, "medial", docs / "pair-medial.png")
        elements(medax, files, folder, docs / "pair-elements.png")
        paths = samples(medax, data, folder)
        all_of_it = table(medax, paths, folder, add)
        add("Where S passes through one sample on several sides, as that of octopus does, a tunnel has no width there: the solid has fewer holes than its interior, the Betti numbers of which are those of the inner structure.\n")
        add("In the tables below *pyramids of all* are those of all of the diagram, *Betti* tells whether the inner structure has the numbers of all of the diagram, and M is what was asked for: it is reached if nothing else stays.")
        add("What stays is enclosed, no edge of it being free, or unseen: without it an element would be folded. M of a core has whole facets, which touch where the core does not: so it has holes that the core has not, and faces that fill them are enclosed.\n")
        for options in VARIANTS:
            variant(medax, paths, all_of_it, options, add)
        subdivided(medax, paths, add)
    (docs / "pair.md").write_text("\n".join(lines).rstrip() + "\n")


if __name__ == "__main__":
    main()
