"""Surfaces that are smooth, or nearly, through the vertices of a mesh: what of a distance to the mesh is the mesh's own."""

import math
import random


def torus(rows, columns, stirred, seed=1):
    """Points and triangles of a mesh whose vertices are on a torus, core circle of radius 1, tube of radius 0.4; `stirred` of a step at random."""
    numbers = random.Random(seed)
    shift = lambda: stirred * (numbers.random() - 0.5)
    points, triangles = [], []
    for i in range(rows):
        for j in range(columns):
            u = math.tau * (i + 0.5 * (j % 2) + shift()) / rows
            v = math.tau * (j + shift()) / columns
            r = 1 + 0.4 * math.cos(v)
            points.append((r * math.cos(u), r * math.sin(u), 0.4 * math.sin(v)))
    at = lambda i, j: i % rows * columns + j % columns
    for i in range(rows):
        for j in range(columns):
            a, b, c, d = at(i, j), at(i + 1, j), at(i, j + 1), at(i + 1, j + 1)
            triangles += [(a, b, c), (b, d, c)] if j % 2 == 0 else [(a, b, d), (a, d, c)]
    return points, triangles


def read_mesh(path):
    """Points and triangles of an OFF or OBJ file without comments."""
    lines = [line.split() for line in open(path) if line.strip()]
    if lines[0] == ["OFF"]:
        count = int(lines[1][0])
        points = [tuple(map(float, words[:3])) for words in lines[2:2 + count]]
        return points, [tuple(map(int, words[1:4])) for words in lines[2 + count:]]
    points = [tuple(map(float, words[1:4])) for words in lines if words[0] == "v"]
    return points, [tuple(int(word.split("/")[0]) - 1 for word in words[1:4]) for words in lines if words[0] == "f"]


def write_mesh(path, points, triangles):
    with open(path, "w") as file:
        file.write(f"OFF\n{len(points)} {len(triangles)} 0\n")
        file.writelines("%r %r %r\n" % tuple(p) for p in points)
        file.writelines("3 %d %d %d\n" % t for t in triangles)


def butterfly(points, triangles):
    """A closed mesh with its triangles quartered, whose limit is smooth and has all the old vertices: the modified butterfly scheme of
    Zorin, Schröder, Sweldens 1996, *Interpolating subdivision for meshes with arbitrary topology*."""
    third = {}
    for a, b, c in triangles:
        third[a, b], third[b, c], third[c, a] = c, a, b
    valence = {}
    for a, _ in third:
        valence[a] = valence.get(a, 0) + 1

    def weighted(weights):
        return [sum(w * points[v][k] for v, w in weights) for k in range(3)]

    def about(v, first):
        """The point on the edge from an extraordinary vertex, of this vertex's ring alone."""
        ring = [first]
        while (following := third[v, ring[-1]]) != first:
            ring.append(following)
        n = len(ring)
        if n == 3:
            weights = [5 / 12, -1 / 12, -1 / 12]
        elif n == 4:
            weights = [3 / 8, 0, -1 / 8, 0]
        else:
            turns = [math.tau * j / n for j in range(n)]
            weights = [(0.25 + math.cos(t) + 0.5 * math.cos(2 * t)) / n for t in turns]
        return weighted([(v, 0.75), *zip(ring, weights)])

    middle, finer = {}, list(points)
    for a, b in third:
        if a > b:
            continue
        if valence[a] == valence[b] == 6:
            c, d = third[a, b], third[b, a]
            wings = third[c, b], third[a, c], third[d, a], third[b, d]
            point = weighted([(a, 1 / 2), (b, 1 / 2), (c, 1 / 8), (d, 1 / 8), *((w, -1 / 16) for w in wings)])
        elif valence[a] == 6:
            point = about(b, a)
        elif valence[b] == 6:
            point = about(a, b)
        else:
            point = [(x + y) / 2 for x, y in zip(about(a, b), about(b, a))]
        middle[a, b] = middle[b, a] = len(finer)
        finer.append(tuple(point))
    quarters = []
    for a, b, c in triangles:
        x, y, z = middle[a, b], middle[b, c], middle[c, a]
        quarters += [(a, x, z), (b, y, x), (c, z, y), (x, y, z)]
    return finer, quarters
