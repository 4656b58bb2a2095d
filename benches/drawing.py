"""What gallery.py and parameters.py share: runs of the program, and pictures of several panels.

Needs pyvista and pillow (pip install pyvista pillow)."""

import json
import pathlib
import subprocess
import sys

import numpy
import pyvista
from PIL import Image

SOLID = "lightsteelblue"
AXIS = "firebrick"
# The direction from which a model is seen, and what is up.
VIEWS = {
    "3holes": ((0.5, 1.5, 0.8), (0, 1, 0)),
    "fandisk": ((-1, 0.6, 1), (0, 1, 0)),
    "rocker-arm": ((1, 0.6, 0.2), (0, 1, 0)),
    "mannequin": ((1, -1, 0.2), (0, 0, 1)),
    "foot": ((1, 0.1, 0.2), (0, 0, 1)),
    "foot_hole": ((0.8, 0.3, 0.9), (0, 0, 1)),
    "refined_elephant": ((1, 0.5, 0.4), (0, 1, 0)),
    "abc_plate_00000329": ((0.4, -0.6, 1), (0, 1, 0)),
    "stanford-bunny": ((0.2, 0.3, 1), (0, 1, 0)),
    "kitten": ((0.6, 0.3, 1), (0, 1, 0)),
    "igea": ((0.1, 0.1, 1), (0, 1, 0)),
    "knot": ((0.3, 0.3, 1), (0, 1, 0)),
    "range_scan_rops": ((0.3, -0.4, 1), (0, 1, 0)),
    "trefoil": ((0.2, -0.3, 1), (0, 1, 0)),
    "bracket": ((1, -1, 0.8), (0, 0, 1)),
    "from below": ((0.5, -1, 0.5), (0, 0, -1)),
    "plane": ((0, 0, 1), (0, 1, 0)),
}


class Tools:
    """The program, the models, and where its results go."""

    def __init__(self, medax, data, folder):
        self.medax, self.data, self.folder = medax, pathlib.Path(data), pathlib.Path(folder)
        self.count = 0

    def model(self, name):
        return next(path for path in sorted(self.data.iterdir()) if path.stem == name)

    def place(self, ending):
        """A name for a file of its own."""
        self.count += 1
        return self.folder / f"{self.count}.{ending}"

    def report(self, *arguments):
        done = subprocess.run([self.medax, *map(str, arguments), "--json", "--quiet"], capture_output=True, text=True)
        report = json.loads(done.stdout)
        if done.returncode != 0:
            sys.exit(f"{' '.join(map(str, arguments))}: {report['error']['message']}")
        return report

    def file(self, command, source, *options, ending="vtu"):
        """What a command writes."""
        path = self.place(ending)
        self.report(command, source, *options, "-o", path)
        return path

    def read(self, command, source, *options, ending="vtu"):
        return pyvista.read(self.file(command, source, *options, ending=ending))

    def beside(self, command, source, option, *options, ending="vtu"):
        """What a command writes besides its result."""
        path = self.place(ending)
        self.report(command, source, *options, option, path)
        return pyvista.read(path)

    def solid(self, name):
        """A mesh of the data as it is."""
        return self.read("decimate", self.model(name), "--ratio", 1, ending="ply")


def solid(mesh, **more):
    return [(mesh, {"color": SOLID, **more})]


def ghost(mesh, opacity=0.12):
    return [(mesh, {"color": SOLID, "opacity": opacity})]


def axis(cells, color=AXIS, **more):
    """Faces, and loose edges as thick lines."""
    lines = cells.celltypes == pyvista.CellType.LINE
    # Cells of vertices alone stand where there is neither.
    faces = ~lines & (cells.celltypes != pyvista.CellType.VERTEX)
    parts = []
    if faces.any():
        parts.append((cells.extract_cells(faces), {"color": color, **more}))
    if lines.any():
        parts.append((cells.extract_cells(lines), {"color": "crimson" if color != AXIS else "navy", "line_width": 3}))
    return parts


def points(cloud, size=4, color="black", **more):
    return [(pyvista.PolyData(numpy.asarray(cloud.points if hasattr(cloud, "points") else cloud)), {"color": color, "point_size": size, "style": "points", **more})]


def valued(mesh, name, limits=None, **more):
    return [(mesh, {"scalars": name, "cmap": "viridis", "clim": limits, "show_scalar_bar": False, **more})]


def balls(centres, radii, **more):
    """Spheres, as one mesh."""
    cloud = pyvista.PolyData(numpy.asarray(centres))
    cloud["radius"] = numpy.asarray(radii)
    return [(cloud.glyph(scale="radius", geom=pyvista.Sphere(radius=1, theta_resolution=40, phi_resolution=24), orient=False), {"color": "goldenrod", **more})]


def squeezed(picture, most=16):
    """Without all but a little of the rows of pixels that are white from side to side."""
    run, kept = 0, []
    for i, white in enumerate((picture == 255).all(axis=(1, 2))):
        run = run + 1 if white else 0
        if run <= most:
            kept.append(i)
    return picture[kept]


def draw(file, rows, size=(400, 340), colours=160):
    """Rows of panels (title, parts, view, zoom)."""
    height, width = len(rows), max(map(len, rows))
    plotter = pyvista.Plotter(shape=(height, width), off_screen=True, window_size=(size[0] * width, size[1] * height), border=False)
    plotter.set_background("white")
    for row, panels in enumerate(rows):
        for column, panel in enumerate(panels):
            title, parts, view, zoom = panel
            plotter.subplot(row, column)
            for mesh, look in parts:
                if mesh.n_points:
                    plotter.add_mesh(mesh, **look)
            direction, up = VIEWS[view]
            plotter.view_vector(direction, viewup=up)
            if view == "plane":
                plotter.enable_parallel_projection()
            plotter.camera.zoom(zoom)
            # At a place in pixels, where text keeps its size.
            plotter.add_text(title, position=(8, size[1] - 24), font_size=8, color="black")
    plotter.screenshot(file)
    plotter.close()
    picture = Image.fromarray(squeezed(numpy.asarray(Image.open(file).convert("RGB"))))
    picture.quantize(colours, method=Image.Quantize.MEDIANCUT, dither=Image.Dither.NONE).save(file, optimize=True)
    print(f"{pathlib.Path(file).name}: {pathlib.Path(file).stat().st_size // 1024} kB", file=sys.stderr, flush=True)
