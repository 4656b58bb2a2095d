#!/usr/bin/env python3
"""Seconds against the number of samples of an ellipsoid, as in Figure 3 of Amenta, Choi, Kolluri 2001: docs/scaling.md and its plot.

usage: figure3.py MEDAX FOLDER [COUNT...]

MEDAX is the program; scaling.md and figure3.svg are written to FOLDER. The samples are random and uniform on the surface, as the paper's are: what
`medax sample` makes is spread evenly, and easier. Seconds are of the processor, with one thread; 4,000,000 samples take some GB."""

import array
import datetime
import json
import math
import os
import pathlib
import platform
import random
import statistics
import subprocess
import sys
import tempfile

HALF_AXES = (1.4, 1.0, 0.7)
COUNTS = [10_000, 20_000, 50_000, 100_000, 200_000, 500_000, 1_000_000, 2_000_000, 4_000_000]
# Name, colour, and the stages of `medax triangulate` or `medax crust` that count.
SERIES = [
    ("Delaunay triangulation of the samples", "#0b62a4", "triangulate", {"order", "triangulate"}),
    ("regular triangulation of the poles", "#c2571a", "crust", {"regular"}),
    ("power crust, all stages", "#2b7a2b", "crust", {"order", "triangulate", "dual", "poles", "regular", "label", "extract"}),
]


def write_samples(path, count):
    """Uniform by area: a uniform point of the sphere is taken with the probability that the map to the ellipsoid stretches its area by."""
    numbers = random.Random(count)
    most = 1 / min(HALF_AXES)
    values = array.array("d")
    while len(values) < 3 * count:
        u = [numbers.gauss(0, 1) for _ in range(3)]
        length = math.hypot(*u)
        stretch = math.hypot(*(x / half for x, half in zip(u, HALF_AXES))) / length
        if numbers.random() * most < stretch:
            values.extend(x * half / length for x, half in zip(u, HALF_AXES))
    if sys.byteorder == "big":
        values.byteswap()
    properties = "".join(f"property double {axis}\n" for axis in "xyz")
    with open(path, "wb") as file:
        file.write(f"ply\nformat binary_little_endian 1.0\nelement vertex {count}\n{properties}end_header\n".encode())
        values.tofile(file)


def run(medax, command, path):
    done = subprocess.run([medax, command, path, "--threads", "1", "--json", "--quiet"], capture_output=True, text=True)
    report = json.loads(done.stdout)
    if done.returncode != 0:
        raise SystemExit(f"{command} {path}: {report['error']['message']}")
    return report


def measure(medax, count, path):
    """Seconds of each series, the peak in bytes, and the surface; medians of as many rounds as do not take for ever."""
    write_samples(path, count)
    rounds = 5 if count <= 200_000 else 3 if count <= 1_000_000 else 1
    seconds, peaks = [], []
    for _ in range(rounds):
        reports = {command: run(medax, command, path) for command in ("triangulate", "crust")}
        spent = lambda command, names: sum(s["cpu_seconds"] for s in reports[command]["stages"] if s["name"] in names)
        seconds.append([spent(command, names) for _, _, command, names in SERIES])
        peaks.append(reports["crust"]["peak_memory_bytes"])
    topology = reports["crust"]["outputs"][0]["topology"]
    print(count, [statistics.median(column) for column in zip(*seconds)], max(peaks), file=sys.stderr)
    return [statistics.median(column) for column in zip(*seconds)], max(peaks), topology


def exponent(counts, seconds):
    """The slope of the line through the logarithms, by least squares."""
    x, y = [math.log(n) for n in counts], [math.log(s) for s in seconds]
    mx, my = statistics.mean(x), statistics.mean(y)
    return sum((a - mx) * (b - my) for a, b in zip(x, y)) / sum((a - mx) ** 2 for a in x)


def plot(counts, columns):
    """The picture as SVG: logarithmic axes, a decade as long on either."""
    decade, left, top = 135, 62, 16
    x0, x1 = math.floor(math.log10(counts[0])), math.log10(counts[-1]) + 0.12
    y0 = math.floor(math.log10(min(min(column) for column in columns)))
    y1 = math.log10(max(max(column) for column in columns)) + 0.25
    width, height = (x1 - x0) * decade, (y1 - y0) * decade
    at = lambda n, s: (left + (math.log10(n) - x0) * decade, top + (y1 - math.log10(s)) * decade)
    words = lambda n: f"{n:,}" if n >= 1 else f"{n:g}"
    out = []
    def text(x, y, what, anchor="middle", extra=""):
        out.append(f'<text x="{x:.1f}" y="{y:.1f}" text-anchor="{anchor}"{extra}>{what}</text>')
    def line(a, b, c, d, style):
        out.append(f'<line x1="{a:.1f}" y1="{b:.1f}" x2="{c:.1f}" y2="{d:.1f}" {style}/>')
    total = (left + width + 16, top + height + 48)
    out.append(f'<svg xmlns="http://www.w3.org/2000/svg" viewBox="0 0 {total[0]:.0f} {total[1]:.0f}" width="{total[0]:.0f}" '
               f'height="{total[1]:.0f}" font-family="sans-serif" font-size="12" fill="#222">')
    out.append(f'<title>Seconds against the number of samples of an ellipsoid</title>\n<rect width="100%" height="100%" fill="#fff"/>')
    for e in range(x0, math.floor(x1) + 1):
        for k in (1, 2, 5):
            n = k * 10 ** e
            if math.log10(n) <= x1:
                x = at(n, 1)[0]
                line(x, top, x, top + height, f'stroke="{"#ccc" if k == 1 else "#eee"}"')
                text(x, top + height + 16, f"{n // 10 ** 6}M" if n >= 10 ** 6 else f"{n // 1000}k")
    for e in range(y0, math.floor(y1) + 1):
        y = at(1, 10.0 ** e)[1]
        line(left, y, left + width, y, 'stroke="#ccc"')
        text(left - 6, y + 4, words(10 ** e if e >= 0 else 10.0 ** e), "end")
    out.append(f'<rect x="{left}" y="{top}" width="{width:.1f}" height="{height:.1f}" fill="none" stroke="#888"/>')
    text(left + width / 2, total[1] - 10, "samples")
    text(0, 0, "seconds of the processor", extra=f' transform="translate(14 {top + height / 2:.1f}) rotate(-90)"')
    # Slope 1, below all of them.
    low = max(0.7 * columns[0][0], 1.05 * 10.0 ** y0)
    a, b = at(counts[0], low), at(counts[-1], low * counts[-1] / counts[0])
    line(*a, *b, 'stroke="#777" stroke-dasharray="5 4"')
    for (_, colour, _, _), column in zip(SERIES, columns):
        points = [at(n, s) for n, s in zip(counts, column)]
        out.append(f'<polyline points="{" ".join(f"{x:.1f},{y:.1f}" for x, y in points)}" fill="none" stroke="{colour}" stroke-width="1.6"/>')
        out += [f'<circle cx="{x:.1f}" cy="{y:.1f}" r="3" fill="{colour}"/>' for x, y in points]
    # Named in the order in which they lie, the uppermost first.
    for row, (name, colour, _, _) in enumerate(reversed(SERIES)):
        y = top + 22 + 19 * row
        line(left + 14, y - 4, left + 38, y - 4, f'stroke="{colour}" stroke-width="1.6"')
        out.append(f'<circle cx="{left + 26}" cy="{y - 4}" r="3" fill="{colour}"/>')
        text(left + 46, y, name, "start")
    line(left + 14, top + 75, left + 38, top + 75, 'stroke="#777" stroke-dasharray="5 4"')
    text(left + 46, top + 79, "slope 1", "start")
    return "\n".join(out) + "\n</svg>\n"


def machine():
    """The processor, as the system names it."""
    try:
        lines = pathlib.Path("/proc/cpuinfo").read_text().split("\n")
        model = next(line.split(":")[1].strip() for line in lines if line.startswith("model name"))
    except (OSError, StopIteration):
        model = platform.processor() or platform.machine()
    return f"{model}, {os.cpu_count()} cores, {platform.system()}"


def main():
    medax, folder = sys.argv[1], pathlib.Path(sys.argv[2])
    counts = [int(word) for word in sys.argv[3:]] or COUNTS
    version = subprocess.run([medax, "--version"], capture_output=True, text=True).stdout.strip()
    with tempfile.TemporaryDirectory() as temporary:
        found = [measure(medax, count, pathlib.Path(temporary) / "ellipsoid.ply") for count in counts]
    columns = list(zip(*(seconds for seconds, _, _ in found)))
    (folder / "figure3.svg").write_text(plot(counts, columns))
    page = ["# Time against size\n"]
    page.append("Random points, uniform by area on an ellipsoid of half axes 1.4, 1, 0.7, as in Figure 3 of Amenta, Choi, Kolluri 2001, *The Power")
    page.append("Crust*: there the Delaunay triangulation of such points takes time in proportion to their number. `make figure3` makes this page and its")
    page.append(f"plot; {version}, one thread, {machine()}, {datetime.date.today():%-d %B %Y}. Seconds of the processor, without reading and")
    page.append("writing: medians of five rounds up to 200,000 samples, of three up to 1,000,000; one above, which may be a tenth off where the machine has")
    page.append("other work. Memory is the peak of the whole program.\n")
    page.append("![Seconds against the number of samples, on logarithmic axes](figure3.svg)\n")
    page.append("| samples | Delaunay, s | regular, s | power crust, s | µs a sample | peak, MB | bytes a sample | genus |")
    page.append("|--:|--:|--:|--:|--:|--:|--:|--:|")
    for count, (seconds, peak, topology) in zip(counts, found):
        cells = [f"{count:,}", *(f"{s:.3f}" if s < 10 else f"{s:.1f}" for s in seconds), f"{seconds[2] / count * 1e6:.1f}",
                 round(peak / 1e6), round(peak / count), f"{topology['genus']}" if topology["closed"] else "open"]
        page.append("| " + " | ".join(str(cell) for cell in cells) + " |")
    fitted = [f"{exponent(counts, column):.3f} for the {name}" for (name, _, _, _), column in zip(SERIES, columns)]
    page.append("\nFitted to t = c n^k by least squares of the logarithms, k is " + ", ".join(fitted) + ".")
    (folder / "scaling.md").write_text("\n".join(page) + "\n")


main()
