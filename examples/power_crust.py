"""A watertight mesh of a file of points."""

import sys

import medax


def run(points_path: str, mesh_path: str) -> str:
    """Writes the mesh and says what it is made of."""
    points = medax.Points.read(points_path)
    surface = medax.PowerCrust.of(points).surface
    surface.write(mesh_path)
    return f"{points.count} samples, {len(surface.faces)} faces"


if __name__ == "__main__":
    if len(sys.argv) != 3:
        sys.exit("usage: power_crust POINTS MESH")
    try:
        print(run(*sys.argv[1:]))
    except medax.MedaxError as error:
        sys.exit(error.message)
