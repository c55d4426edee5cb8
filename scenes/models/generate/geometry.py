"""Meshes for the scenes of the gallery: lathes, rounded boxes, extrusions, tubes, grids. Standard library only."""
import math
import struct
from pathlib import Path

MODELS = Path(__file__).resolve().parent.parent


class Mesh:
    """Vertices (x, y, z, u, v) and triangles of their numbers."""

    def __init__(self):
        self.vertices = []
        self.triangles = []

    def vertex(self, p, u=0.0, v=0.0):
        self.vertices.append((p[0], p[1], p[2], u, v))
        return len(self.vertices) - 1

    def quad(self, a, b, c, d):
        self.triangles += [(a, b, c), (a, c, d)]

    def add(self, other, move=lambda p: p):
        first = len(self.vertices)
        for v in other.vertices:
            self.vertices.append((*move(v[:3]), v[3], v[4]))
        self.triangles += [tuple(first + i for i in t) for t in other.triangles]
        return self

    def volume(self):
        """Six times the volume, negative if the triangles wind the other way round than those of a lathe's upward profile."""
        v = self.vertices
        return sum(sum(x * y for x, y in zip(v[a][:3], cross(v[b][:3], v[c][:3]))) for a, b, c in self.triangles)

    def moved(self, move):
        return Mesh().add(self, move)

    def write(self, name, textured=False):
        """Writes scenes/models/NAME.ply; triangles without an area are left out."""
        place = [v[:3] for v in self.vertices]
        kept = [t for t in self.triangles if len({place[i] for i in t}) == 3]
        if self.volume() < 0:
            kept = [(a, c, b) for a, b, c in kept]
        lines = ["ply", "format binary_little_endian 1.0", "comment made by scenes/models/generate"]
        lines.append(f"element vertex {len(self.vertices)}")
        lines += [f"property float {p}" for p in ("xyzuv" if textured else "xyz")]
        lines += [f"element face {len(kept)}", "property list uchar int vertex_indices", "end_header"]
        with open(MODELS / f"{name}.ply", "wb") as f:
            f.write(("\n".join(lines) + "\n").encode("ascii"))
            for v in self.vertices:
                f.write(struct.pack("<5f", *v) if textured else struct.pack("<3f", *v[:3]))
            for t in kept:
                f.write(struct.pack("<B3i", 3, *t))


def grid(nu, nv, at, closed_u=False, closed_v=False):
    """A grid of quadrilaterals: at(u, v) for u, v in 0..1. What is closed shares its first and last vertices."""
    mesh = Mesh()
    rows = nv if closed_v else nv + 1
    columns = nu if closed_u else nu + 1
    for j in range(rows):
        for i in range(columns):
            mesh.vertex(at(i / nu, j / nv), i / nu, j / nv)
    for j in range(nv):
        for i in range(nu):
            a = j * columns + i
            b = j * columns + (i + 1) % columns
            c = (j + 1) % rows * columns + (i + 1) % columns
            d = (j + 1) % rows * columns + i
            mesh.quad(a, d, c, b)
    return mesh


def lathe(profile, around=96, closed=False):
    """The profile [(radius, y), ...] turned about +y; ends at radius 0 are points. Closed: a ring, such as a torus."""
    n = len(profile)

    def at(u, v):
        r, y = profile[round(v * (n if closed else n - 1)) % n]
        return (r * math.cos(2 * math.pi * u), y, r * math.sin(2 * math.pi * u))

    return grid(around, n if closed else n - 1, at, closed_u=True, closed_v=closed)


def arc(cx, cy, radius, start, end, steps):
    """Points of a circle from one angle in degrees to another, for profiles."""
    angles = [math.radians(start + (end - start) * i / steps) for i in range(steps + 1)]
    return [(cx + radius * math.cos(a), cy + radius * math.sin(a)) for a in angles]


def spline(points, steps):
    """A Catmull-Rom curve through points of any dimension."""
    ext = [points[0], *points, points[-1]]
    out = []
    for i in range(len(points) - 1):
        p0, p1, p2, p3 = ext[i : i + 4]
        for s in range(steps):
            t = s / steps
            out.append(
                tuple(
                    0.5 * (2 * b + (c - a) * t + (2 * a - 5 * b + 4 * c - d) * t * t + (3 * b - a - 3 * c + d) * t**3)
                    for a, b, c, d in zip(p0, p1, p2, p3)
                )
            )
    return out + [tuple(points[-1])]


def rounded_box(w, h, d, radius, steps=4):
    """A box around the origin, of these sizes, whose edges and corners are round."""
    quarter = [90 * i / steps for i in range(steps + 1)]
    around = [(90 * q + a, q) for q in range(4) for a in quarter]
    up = [(a - 90, -1) for a in quarter] + [(a, 1) for a in quarter]
    sx, sz = [1, -1, -1, 1], [1, 1, -1, -1]
    half = (w / 2 - radius, h / 2 - radius, d / 2 - radius)

    def at(u, v):
        (lon, q), (lat, sy) = around[round(u * len(around)) % len(around)], up[round(v * (len(up) - 1))]
        lon, lat = math.radians(lon), math.radians(lat)
        return (
            sx[q] * half[0] + radius * math.cos(lat) * math.cos(lon),
            sy * half[1] + radius * math.sin(lat),
            sz[q] * half[2] + radius * math.cos(lat) * math.sin(lon),
        )

    mesh = grid(len(around), len(up) - 1, at, closed_u=True)
    rows = len(up)
    for row, turned in ((0, False), (rows - 1, True)):
        corners = [row * len(around) + q * (steps + 1) for q in range(4)]
        mesh.quad(*(corners[::-1] if turned else corners))
    return mesh


def extruded(outer, inner, y0, y1, bevel=0.0):
    """A flat ring between two outlines [(x, z), ...] of as many points, from y0 to y1, with chamfered edges."""
    n = len(outer)

    def inset(points, by):
        out = []
        for i, (x, z) in enumerate(points):
            (xa, za), (xb, zb) = points[i - 1], points[(i + 1) % n]
            length = math.hypot(xb - xa, zb - za) or 1
            out.append((x - by * (zb - za) / length, z + by * (xb - xa) / length))
        return out

    o, i = inset(outer, bevel), inset(inner, -bevel)
    loops = [(outer, y0 + bevel), (outer, y1 - bevel), (o, y1), (i, y1), (inner, y1 - bevel), (inner, y0 + bevel), (i, y0), (o, y0)]

    def at(u, v):
        points, y = loops[round(v * 8) % 8]
        x, z = points[round(u * n) % n]
        return (x, y, z)

    return grid(n, 8, at, closed_u=True, closed_v=True)


def circle(radius, n):
    return [(radius * math.cos(2 * math.pi * k / n), radius * math.sin(2 * math.pi * k / n)) for k in range(n)]


def frame(along):
    """Two unit vectors perpendicular to a direction and to each other."""
    length = math.sqrt(sum(c * c for c in along))
    t = [c / length for c in along]
    a = [0, 1, 0] if abs(t[1]) < 0.9 else [1, 0, 0]
    s = cross(a, t)
    m = math.sqrt(sum(c * c for c in s))
    s = [c / m for c in s]
    return s, cross(t, s)


def cross(a, b):
    return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def tube(points, radii, around=12, closed=False):
    """A tube around a polyline; its frames are carried along, so that it does not twist. Open ends are closed by points."""
    n = len(points)
    tangents = []
    for i in range(n):
        a = points[i - 1] if closed or i > 0 else points[i]
        b = points[(i + 1) % n] if closed or i < n - 1 else points[i]
        tangents.append([q - p for p, q in zip(a, b)])
    s, _ = frame(tangents[0])
    frames = []
    for t in tangents:
        length = math.sqrt(sum(c * c for c in t))
        t = [c / length for c in t]
        dot = sum(a * b for a, b in zip(s, t))
        s = [a - dot * b for a, b in zip(s, t)]
        m = math.sqrt(sum(c * c for c in s))
        s = [c / m for c in s]
        frames.append((s, cross(t, s)))
    if closed:
        # The twist that is left after one turn is spread over the whole length.
        (s0, b0), (s1, _) = frames[0], frames[-1]
        rest = math.atan2(sum(a * b for a, b in zip(s1, b0)), sum(a * b for a, b in zip(s1, s0)))
        for i, (s, b) in enumerate(frames):
            c, e = math.cos(-rest * i / n), math.sin(-rest * i / n)
            frames[i] = ([c * x + e * y for x, y in zip(s, b)], [c * y - e * x for x, y in zip(s, b)])

    rows = [(p, r, f) for p, r, f in zip(points, radii, frames)]
    if not closed:
        rows = [(points[0], 0, frames[0])] + rows + [(points[-1], 0, frames[-1])]

    def at(u, v):
        p, r, (s, b) = rows[round(v * (len(rows) if closed else len(rows) - 1)) % len(rows)]
        c, e = r * math.cos(2 * math.pi * u), r * math.sin(2 * math.pi * u)
        return tuple(p[k] + c * s[k] + e * b[k] for k in range(3))

    return grid(around, len(rows) if closed else len(rows) - 1, at, closed_u=True, closed_v=closed)


def move(x=0.0, y=0.0, z=0.0, turn=0.0, tilt=0.0, scale=1.0):
    """Scales, tilts about x, turns about y, then moves."""
    c, s = math.cos(math.radians(turn)), math.sin(math.radians(turn))
    ct, st = math.cos(math.radians(tilt)), math.sin(math.radians(tilt))

    def of(p):
        px, py, pz = (scale * k for k in p)
        py, pz = ct * py - st * pz, st * py + ct * pz
        return (c * px + s * pz + x, py + y, c * pz - s * px + z)

    return of


class Random:
    """A small generator of our own, so that the models do not depend on the version of Python."""

    def __init__(self, seed):
        self.state = seed

    def next(self):
        self.state = (self.state * 6364136223846793005 + 1442695040888963407) % 2**64
        x = self.state
        x = ((x >> 30) ^ x) * 0xBF58476D1CE4E5B9 % 2**64
        x = ((x >> 27) ^ x) * 0x94D049BB133111EB % 2**64
        return ((x >> 31) ^ x) % 2**53 / 2**53

    def between(self, a, b):
        return a + (b - a) * self.next()


def noise(x, y, z=0.0, seed=0):
    """Value noise in -1..1."""

    def at(i, j, k):
        h = (i * 374761393 + j * 668265263 + k * 2147483647 + seed * 974711) % 2**32
        h = (h ^ (h >> 13)) * 1274126177 % 2**32
        h = (h ^ (h >> 16)) * 2246822519 % 2**32
        return (h ^ (h >> 15)) % 2**32 / 2**31 - 1

    i, j, k = math.floor(x), math.floor(y), math.floor(z)
    f = [t * t * (3 - 2 * t) for t in (x - i, y - j, z - k)]
    total = 0.0
    for a in (0, 1):
        for b in (0, 1):
            for c in (0, 1):
                weight = (f[0] if a else 1 - f[0]) * (f[1] if b else 1 - f[1]) * (f[2] if c else 1 - f[2])
                total += weight * at(i + a, j + b, k + c)
    return total


def turbulence(x, y, z=0.0, octaves=4, seed=0):
    """Noise of several scales, each half as large and half as high as the one before."""
    return sum(noise(x * 2**o, y * 2**o, z * 2**o, seed + o) / 2**o for o in range(octaves))


def planar(mesh, scale, axes=(0, 2)):
    """The mesh with texture coordinates by two of its coordinates, one repetition for each scale units."""
    out = Mesh()
    out.triangles = list(mesh.triangles)
    out.vertices = [(*v[:3], v[axes[0]] / scale, v[axes[1]] / scale) for v in mesh.vertices]
    return out


def gear(teeth, radius, depth, thickness, spokes, rim=0.16, hub=0.2):
    """A wheel around +y from y = 0: teeth, a rim, spokes and a hub with a hole, as shares of the radius."""
    outer = []
    for k in range(teeth):
        for part, share in ((0.0, 0.0), (0.2, 0.0), (0.32, 0.8), (0.42, 1.0), (0.58, 1.0), (0.68, 0.8), (0.8, 0.0)):
            a = 2 * math.pi * (k + part) / teeth
            r = radius + depth * share
            outer.append((r * math.cos(a), r * math.sin(a)))
    inner = []
    for x, z in outer:
        a = math.atan2(z, x)
        inner.append((radius * (1 - rim) * math.cos(a), radius * (1 - rim) * math.sin(a)))
    bevel = thickness * 0.12
    mesh = extruded(outer, inner, 0, thickness, bevel)
    mesh.add(extruded(circle(radius * hub, 48), circle(radius * hub * 0.45, 48), -0.4 * thickness, 1.4 * thickness, bevel))
    length = radius * (1 - rim - hub * 0.8)
    for k in range(spokes):
        spoke = rounded_box(length, thickness * 0.8, radius * 0.09, bevel, 2)
        mesh.add(spoke, lambda p, k=k: move(turn=360 * k / spokes)((p[0] + radius * hub * 0.8 + length / 2, p[1] + thickness / 2, p[2])))
    return mesh
