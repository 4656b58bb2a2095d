"""How thick the walls of a part are, at the vertices of its mesh."""

import sys

import medax


def run(part_path: str, limit: str, mesh_path: str) -> str:
    """Writes the part with its thickness and says how many vertices are thinner than the limit."""
    part = medax.Complex.read(part_path)
    points = medax.Samples.of(part).points()
    # The part has sharp edges; its own faces tell inside from outside.
    crust = medax.PowerCrust.of(points, omit="both").labelled_by_mesh(part)
    sized = crust.with_sizes(part)
    sized.write(mesh_path)
    thickness = sized.values("thickness")
    thin = (thickness < float(limit)).sum()
    return f"{points.count} samples, {len(thickness)} vertices, {thin} thinner than {limit}"


if __name__ == "__main__":
    try:
        _, _, limit, _ = sys.argv
        float(limit)
    except ValueError:
        print("usage: wall_thickness PART LIMIT MESH", file=sys.stderr)
        sys.exit(2)
    try:
        print(run(*sys.argv[1:]))
    except medax.MedaxError as error:
        sys.exit(error.message)
