#!/usr/bin/env python3
"""Makes the meshes of scenes/knot.json: python3 src/bench/scripts/meshes.py FOLDER"""
import math
import struct
import sys


def write(path, vertices, normals, uv, triangles):
    with open(path, "wb") as f:
        lines = ["ply", "format binary_little_endian 1.0", "comment made by src/bench/scripts/meshes.py"]
        lines.append(f"element vertex {len(vertices)}")
        lines += [f"property float {p}" for p in ("x", "y", "z", "nx", "ny", "nz", "u", "v")]
        lines += [f"element face {len(triangles)}", "property list uchar int vertex_indices", "end_header"]
        f.write(("\n".join(lines) + "\n").encode("ascii"))
        for p, n, t in zip(vertices, normals, uv):
            f.write(struct.pack("<8f", *p, *n, *t))
        for t in triangles:
            f.write(struct.pack("<B3i", 3, *t))


def minus(a, b):
    return [a[k] - b[k] for k in range(3)]


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def unit(a):
    s = math.sqrt(sum(x * x for x in a))
    return [x / s for x in a]


def knot(along, around, radius):
    """A tube around a trefoil knot, whose seams have vertices of their own, since texture coordinates differ there."""

    def centre(t):
        return [math.sin(t) + 2 * math.sin(2 * t), math.cos(t) - 2 * math.cos(2 * t), -math.sin(3 * t)]

    vertices, normals, uv, triangles = [], [], [], []
    for i in range(along + 1):
        t = 2 * math.pi * i / along
        c = centre(t)
        tangent = unit(minus(centre(t + 1e-4), centre(t - 1e-4)))
        # A frame that comes back to itself: by the direction from the knot's axis.
        side = unit(cross(tangent, [math.cos(t), -math.sin(t), 2]))
        up = cross(side, tangent)
        for k in range(around + 1):
            a = 2 * math.pi * k / around
            n = [math.cos(a) * side[j] + math.sin(a) * up[j] for j in range(3)]
            vertices.append([c[j] + radius * n[j] for j in range(3)])
            normals.append(n)
            uv.append([24 * i / along, 3 * k / around])
    row = around + 1
    for i in range(along):
        for k in range(around):
            a = i * row + k
            triangles += [(a, a + row, a + 1), (a + 1, a + row, a + row + 1)]
    p, q, r = (vertices[j] for j in triangles[0])
    outside = sum(x * y for x, y in zip(cross(minus(q, p), minus(r, p)), normals[triangles[0][0]]))
    if outside < 0:
        triangles = [(a, c, b) for a, b, c in triangles]
    return vertices, normals, uv, triangles


def ball(cuts):
    """A sphere of 20·4^cuts triangles."""
    g = (1 + math.sqrt(5)) / 2
    v = [unit(p) for p in (
        (-1, g, 0), (1, g, 0), (-1, -g, 0), (1, -g, 0), (0, -1, g), (0, 1, g),
        (0, -1, -g), (0, 1, -g), (g, 0, -1), (g, 0, 1), (-g, 0, -1), (-g, 0, 1))]
    f = [(0, 11, 5), (0, 5, 1), (0, 1, 7), (0, 7, 10), (0, 10, 11), (1, 5, 9), (5, 11, 4), (11, 10, 2), (10, 7, 6),
         (7, 1, 8), (3, 9, 4), (3, 4, 2), (3, 2, 6), (3, 6, 8), (3, 8, 9), (4, 9, 5), (2, 4, 11), (6, 2, 10),
         (8, 6, 7), (9, 8, 1)]
    for _ in range(cuts):
        middles, g = {}, []

        def middle(a, b):
            key = (min(a, b), max(a, b))
            if key not in middles:
                v.append(unit([v[a][k] + v[b][k] for k in range(3)]))
                middles[key] = len(v) - 1
            return middles[key]

        for a, b, c in f:
            x, y, z = middle(a, b), middle(b, c), middle(c, a)
            g += [(a, x, z), (b, y, x), (c, z, y), (x, y, z)]
        f = g
    return v, f


def pebble(cuts):
    """A ball with dents; its normals are those of the surface, by differences."""

    def point(d):
        h = sum(math.sin(w[0] * d[0] + w[1] * d[1] + w[2] * d[2] + w[3]) * w[4] for w in (
            (3, 1, 2, 0.3, 0.12), (-2, 4, 1, 1.1, 0.08), (5, -3, 4, 2.0, 0.035), (7, 6, -5, 0.7, 0.02)))
        return [d[0] * (1 + h), 0.7 * d[1] * (1 + h), d[2] * (1 + h)]

    directions, triangles = ball(cuts)
    vertices, normals, uv = [], [], []
    for d in directions:
        a = unit(cross(d, [0, 1, 0] if abs(d[1]) < 0.9 else [1, 0, 0]))
        b = cross(d, a)
        e = 1e-4
        p = [point(unit([d[k] + s * e * w[k] for k in range(3)])) for w in (a, b) for s in (1, -1)]
        n = unit(cross(minus(p[0], p[1]), minus(p[2], p[3])))
        vertices.append(point(d))
        normals.append(n if sum(x * y for x, y in zip(n, d)) > 0 else [-x for x in n])
        uv.append([0.5 + math.atan2(d[0], d[2]) / (2 * math.pi), 0.5 + math.asin(d[1]) / math.pi])
    return vertices, normals, uv, triangles


folder = sys.argv[1]
write(folder + "/knot.ply", *knot(192, 24, 0.55))
write(folder + "/pebble.ply", *pebble(4))
