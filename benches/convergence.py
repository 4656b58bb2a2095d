#!/usr/bin/env python3
"""The page and the plot of the convergence of MEDIAL from what the benchmark `convergence` prints: docs/convergence.md and docs/convergence.svg.

usage: convergence.py TABLE FOLDER

TABLE is a file of that output; convergence.md and convergence.svg are written to FOLDER."""

import math
import pathlib
import statistics
import sys

SHAPES = [("torus", "#0b62a4"), ("ellipsoid", "#c2571a"), ("trefoil", "#2b7a2b")]
# Where the distances of a row of a smooth shape are: of the whole axis and of the part of which convergence is proved.
COLUMNS = {"to": 9, "to mean": 10, "from": 11, "from mean": 12, "part to": 13, "part to mean": 14, "part from": 15, "part from mean": 16}


def slope(x, y):
    """That of the line through the logarithms, by least squares."""
    x, y = [math.log(value) for value in x], [math.log(value) for value in y]
    mx, my = statistics.mean(x), statistics.mean(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)


def short(x):
    """A number with three digits."""
    return f"{float(x):.1e}" if float(x) < 1e-3 else f"{float(x):.3g}"


def plot(rows):
    """Largest and mean distances against epsilon as SVG, on logarithmic axes: from the axis on the left, to the axis on the right."""
    width, height, left, top, gap = 300, 420, 76, 40, 90
    x0, x1 = math.log10(0.04), math.log10(0.5)
    every = [float(row[k]) for row in rows for k in COLUMNS.values()]
    y0, y1 = math.floor(math.log10(min(every))), math.ceil(math.log10(max(every)))
    out = []
    def text(x, y, what, anchor="middle", extra=""):
        out.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{extra}>{what}</text>')
    def line(a, b, c, d, style):
        out.append(f'<line x1="{a:.1f}" y1="{b:.1f}" x2="{c:.1f}" y2="{d:.1f}" {style}/>')
    total = (left + 2 * width + gap + 16, top + height + 118)
    out.append(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {total[0]} {total[1]}" width="{total[0]}" height="{total[1]}" '
               'font-family="sans-serif" font-size="12" fill="#222">')
    out.append('<title>Distances between axes and exact axes against the sampling density</title>\n<rect width="100%" height="100%" fill="#fff"/>')
    for panel, (title, name) in enumerate([("from the axis to the exact axis", "to"), ("from the exact axis to the axis", "from")]):
        begin = left + panel * (width + gap)
        at = lambda e, d: (begin + (math.log10(e) - x0) / (x1 - x0) * width, top + (y1 - math.log10(d)) / (y1 - y0) * height)
        text(begin + width / 2, top - 14, title)
        for e in (0.05, 0.1, 0.2, 0.4):
            x = at(e, 1)[0]
            line(x, top, x, top + height, 'stroke="#ddd"')
            text(x, top + height + 16, f"{e:g}")
        for k in range(y0, y1 + 1):
            y = at(0.1, 10.0 ** k)[1]
            line(begin, y, begin + width, y, 'stroke="#ddd"')
            text(begin - 6, y + 4, f"1e{k}" if k else "1", "end")
        out.append(f'<rect x="{begin}" y="{top}" width="{width}" height="{height}" fill="none" stroke="#888"/>')
        text(begin + width / 2, top + height + 34, "epsilon")
        for shape, colour in SHAPES:
            mine = [row for row in rows if row[1] == shape]
            for series, style in [(name, 'stroke-width="1.8"'), (name + " mean", 'stroke-width="1.8" stroke-dasharray="5 4"'),
                                  ("part " + name, 'stroke-width="1.6" stroke-dasharray="2 3"')]:
                points = [at(float(row[6]), float(row[COLUMNS[series]])) for row in mine]
                out.append(f'<polyline points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in points)}" fill="none" stroke="{colour}" {style}/>')
                if "part" not in series:
                    out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="2.6" fill="{colour}"/>' for x, y in points]
    text(0, 0, "distance by the diagonal", extra=f' transform="translate(16 {top + height / 2:.1f}) rotate(-90)"')
    for i, (shape, colour) in enumerate(SHAPES):
        x, y = left + 130 * i, top + height + 62
        line(x, y - 4, x + 26, y - 4, f'stroke="{colour}" stroke-width="1.8"')
        text(x + 34, y, shape, "start")
    styles = [("largest", 'stroke-width="1.8"'), ("mean", 'stroke-width="1.8" stroke-dasharray="5 4"'),
              ("largest, of the part for which it is proved", 'stroke-width="1.6" stroke-dasharray="2 3"')]
    for i, (name, style) in enumerate(styles):
        x, y = left + 130 * i, top + height + 86
        line(x, y - 4, x + 26, y - 4, f'stroke="#222" {style}')
        text(x + 34, y, name, "start")
    return "\n".join(out) + "\n</svg>\n"


def main():
    table, folder = pathlib.Path(sys.argv[1]), pathlib.Path(sys.argv[2])
    rows = [line.split("\t") for line in table.read_text().splitlines()]
    smooth, degenerate, density = ([row for row in rows if row[0] == kind] for kind in ("smooth", "degenerate", "density"))
    (folder / "convergence.svg").write_text(plot(smooth))
    page = []
    add = page.append
    add("# Convergence of MEDIAL\n")
    add("How near the inner medial axis that `Medial` takes from the Voronoi diagram (Dey, Zhao 2004) comes to the exact one, with the paper's thresholds, pi/8 and 8,")
    add("for all. `make convergence` makes this page and its plot; the exact axes and local feature sizes are derived in `benches/convergence/`.\n")
    add("## Smooth shapes\n")
    add("The torus has a core circle of radius 1 and a tube of radius 0.4; its inner axis is the circle. The ellipsoid has half axes 1.4, 1 and 0.7; its axis is an elliptic disc.")
    add("The trefoil tube has a radius of 0.3; its axis is the knot. Samples are random, jittered, and up to 1 / 0.6 times as dense in some places as in others, beyond what the")
    add("local feature size asks. *Certified* is an epsilon of which they certainly are an epsilon-sample: the surface is cut into patches until for each the")
    add("distance of the nearest sample, with what a Lipschitz bound leaves open, is at most that many local feature sizes. *Seen* is the largest found at the middle of a patch. A facet")
    add("is inner if all its corners lie in the shape.\n")
    add("Distances are by the diagonal of the shape's box. *To* is from the axis to the exact one, at all its vertices and 200,000 points spread evenly; *from* is from")
    add("the exact axis to ours, at as many points of it and at its own vertices (a polygon for a curve, off by less than 3e-8; one for the rim of the disc, by 6e-6). No umbrella was torn.\n" if all(row[5] == "0" for row in smooth) else
        "the exact axis to ours, at as many points of it and at its own vertices (a polygon for a curve, off by less than 3e-8; one for the rim of the disc, by 6e-6).\n")
    add("![Distances against epsilon, on logarithmic axes](convergence.svg)\n")
    add("| shape | epsilon | certified | seen | samples | facets | to, max | to, mean | from, max | from, mean | proved facets | to, max | to, mean |")
    add("| --- | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: |")
    for row in smooth:
        certified = math.ceil(float(row[7]) * 1e5) / 1e5
        cells = [row[1], f"{float(row[6]):g}", f"{certified:.5f}", f"{float(row[8]):.4f}", row[2], row[3],
                 *(short(row[COLUMNS[k]]) for k in ("to", "to mean", "from", "from mean")), row[4],
                 *(short(row[COLUMNS[k]]) for k in ("part to", "part to mean"))]
        add("| " + " | ".join(cells) + " |")
    add("\nSlopes of lines fitted to the logarithms: the distance goes with epsilon to this power. Where it is positive the error falls as samples grow dense; as a slope over the")
    add("density 1 / epsilon it is negative. The last columns are between the two densest samples alone.\n")
    add("| shape | to, max | to, mean | from, max | from, mean | proved: to, max | to, mean | last two: to, max | to, mean | proved: to, max | to, mean |")
    add("| --- | --: | --: | --: | --: | --: | --: | --: | --: | --: | --: |")
    for shape, _ in SHAPES:
        mine = sorted((row for row in smooth if row[1] == shape), key=lambda row: -float(row[6]))
        fit = lambda rows, name: f"{slope([float(row[6]) for row in rows], [float(row[COLUMNS[name]]) for row in rows]):.2f}"
        names = ("to", "to mean", "from", "from mean", "part to", "part to mean")
        last = ("to", "to mean", "part to", "part to mean")
        add(f"| {shape} | " + " | ".join([*(fit(mine, k) for k in names), *(fit(mine[-2:], k) for k in last)]) + " |")
    add("")
    ratios = ["| " + " | ".join([*row[2:4], *(short(cell) for cell in row[4:])]) + " |" for row in rows if row[0] == "ratio"]
    add(NOTES.format(ratios="\n".join(ratios)))
    add("## Degenerate cases\n")
    add("Balls that touch the surface along a whole sphere or in circles of one radius: every Voronoi vertex inside is a sliver's. The samples, no two nearer than the spacing, are exact but for")
    add("rounding. The sphere has radius 1, the capsule is 0.5 about a segment of length 2, the box has half sides 0.8, 0.55, 0.3 and is rounded by 0.2 more.\n")
    add("| shape | spacing | samples | facets | to, max | to, mean | from, max | from, mean |")
    add("| --- | --: | --: | --: | --: | --: | --: | --: |")
    for row in sorted(degenerate, key=lambda row: row[1]):
        add("| " + " | ".join([row[1], row[5], row[2], row[3], *(cell if cell == "-" else short(cell) for cell in row[6:10])]) + " |")
    add("")
    add(DEGENERATE)
    add("## Cores\n")
    add("The same samples: the core of the flow (Giesen, Ramos, Sadri 2010), not repaired, and the core extended by the flow of MEDIAL's facets, with Betti numbers; distances as above. *Starts* and *orbits* measure Corollary 4.6: the")
    add("largest distance of MEDIAL's axis to the exact one, and of the orbits that begin at its corners (20,000 of them at most).\n")
    add("| shape | epsilon | samples | core: Betti numbers | to, max | to, mean | from, max | from, mean | extended: Betti numbers | to, max | to, mean | from, max | from, mean | starts | orbits |")
    add("| --- | --: | --: | --- | --: | --: | --: | --: | --- | --: | --: | --: | --: | --: | --: |")
    for row in rows:
        if row[0] == "flow":
            cells = [row[1], f"{float(row[3]):g}", row[2], row[5], *(short(cell) for cell in row[6:10]), row[10], *(short(cell) for cell in row[11:17])]
            add("| " + " | ".join(cells) + " |")
    add("")
    add(CORES)
    add("## Density independence\n")
    add("One half of each sample, that of larger x, thinned to a tenth of its density; nothing else changes, the thresholds least of all. Distances between the two axes by the")
    add("diagonal: from the even sample's axis to the uneven one's, and back.\n")
    add("| sample | samples | facets | Betti numbers | thinned | facets | Betti numbers | to, max | to, mean | back, max | back, mean |")
    add("| --- | --: | --: | --- | --: | --: | --- | --: | --: | --: | --: |")
    for row in density:
        add("| " + " | ".join([*row[1:8], *(short(cell) for cell in row[8:12])]) + " |")
    add("")
    add(DENSITY)
    (folder / "convergence.md").write_text("\n".join(page).rstrip() + "\n")


NOTES = """Every point of the exact axes comes near ours, faster than epsilon falls. The other way the mean stops falling for the tubes, and the maximum for all three. The ratio
condition alone chooses facets whose samples are only eight circumradii apart, however dense these are, on a circle or an arc that a ball touches all along; their corners are off
by a constant share of the radius, which falls with rho (below). That is no error of the program: the paper proves convergence only for the
part of its output that the angle condition chooses, or whose edges are at least epsilon^(1/4) times as long as the ball's radius (Definition 4, Theorem 1).
*Proved* is that part; it converges in the maximum and in the mean for all three shapes.

The torus, with the densest samples and other thresholds of the ratio condition; distances to the exact axis by the tube's radius:

| rho | facets | to, max | to, mean |
| --: | --: | --: | --: |
{ratios}
"""
DEGENERATE = """For the sphere every inner facet has the centre for its corners but for rounding. Along the capsule and in the rounded box the axis is covered better and better,
while, as in the tubes above, the largest distance to it stops falling at the capsule.
"""
CORES = """The core covers little of the ellipsoid's disc, and need not: it has the disc's homotopy type. Extended, it covers what MEDIAL covers.
"""
DENSITY = """In the mean the two axes are within 0.2 per cent of the diagonal of each other. The exact axis of the torus is a circle, b0 = 1 and b1 = 1; ours is many facets
round it, which may leave a tunnel. The exact axis of a mesh has a leaf at each edge that bends outward: samples much finer than the triangles of 3holes begin to show
these edges as the sharp ones that they are. That is probably where the many pieces of its axis come from.
"""

main()
