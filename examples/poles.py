"""The poles of a file of points, with the radii of their balls."""

import sys

import medax


def run(points_path: str, poles_path: str) -> str:
    """Writes the poles and says how many there are."""
    points = medax.Points.read(points_path)
    triangulation = medax.Triangulation.delaunay(points)
    poles = medax.Poles.of(medax.Dual.of(triangulation))
    poles.complex().write(poles_path)
    return f"{points.count} samples, {len(poles.balls)} poles"


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: poles POINTS POLES")
    try:
        print(run(*sys.argv[1:]))
    except medax.MedaxError as error:
        sys.exit(error.message)
