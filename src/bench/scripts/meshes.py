"""Simple scenes as meshes, for renderers that have nothing else: every object and light of a scene file as points, quads and normals, and its camera.

Round things become grids of quads with the normals of the thing itself: FINE, lamps LAMP of them around and along. What is not known is refused.
"""
import math

import numpy

FINE, LAMP = (256, 128), (64, 32)


class Mesh:
    def __init__(self, points, quads, normals=None):
        self.points, self.quads, self.normals = numpy.asarray(points, float), quads, normals

    def area(self):
        a, b, c, d = (self.points[[q[k] for q in self.quads]] for k in range(4))
        return 0.5 * numpy.linalg.norm(numpy.cross(c - a, d - b), axis=1).sum()

    def part(self, keep):
        return Mesh(self.points, [q for k, q in enumerate(self.quads) if keep(k)], self.normals)


def grid(surface, across, along):
    """Of surface(u, v) -> (point, normal); quads turn counterclockwise around normals that dpoint/du x dpoint/dv points along."""
    points, normals = [], []
    for j in range(along + 1):
        for i in range(across + 1):
            p, n = surface(i / across, j / along)
            points.append(p)
            normals.append(n)
    step = across + 1
    quads = [(j * step + i, j * step + i + 1, (j + 1) * step + i + 1, (j + 1) * step + i) for j in range(along) for i in range(across)]
    return Mesh(points, quads, normals)


def unit(v):
    v = numpy.asarray(v, float)
    return v / numpy.linalg.norm(v)


def frame(axis):
    """Two directions with x cross y = axis."""
    axis = unit(axis)
    x = unit(numpy.cross(axis, (1, 0, 0) if abs(axis[0]) < 0.5 else (0, 1, 0)))
    return x, numpy.cross(axis, x), axis


def sphere(center, radius, fine):
    def surface(u, v):
        t, p = math.pi * v, 2 * math.pi * u
        n = numpy.array((math.sin(t) * math.cos(p), math.cos(t), math.sin(t) * math.sin(p)))
        return center + radius * n, n

    return grid(surface, *fine)


def wall(base, top, radius, other, fine):
    """Of a cylinder or a cone, without caps."""
    base, top = numpy.asarray(base, float), numpy.asarray(top, float)
    x, y, axis = frame(top - base)
    height = numpy.linalg.norm(top - base)

    def surface(u, v):
        out = math.cos(2 * math.pi * u) * x + math.sin(2 * math.pi * u) * y
        return base + v * (top - base) + (radius + v * (other - radius)) * out, unit(out + (radius - other) / height * axis)

    return grid(surface, fine[0], 1)


def torus(center, axis, major, minor, fine):
    x, y, z = frame(axis)

    def surface(u, v):
        out = math.cos(2 * math.pi * u) * x + math.sin(2 * math.pi * u) * y
        n = math.cos(2 * math.pi * v) * out + math.sin(2 * math.pi * v) * z
        return center + major * out + minor * n, n

    return grid(surface, *fine)


def disk(center, normal, radius, fine):
    x, y, z = frame(normal)

    def surface(u, v):
        out = math.cos(2 * math.pi * u) * x + math.sin(2 * math.pi * u) * y
        return center + radius * (1 - v) * out, z

    return grid(surface, fine[0], 1)


def box(least, most):
    points = [(x, y, z) for x in (least[0], most[0]) for y in (least[1], most[1]) for z in (least[2], most[2])]
    return Mesh(points, [(0, 1, 3, 2), (4, 6, 7, 5), (0, 4, 5, 1), (2, 3, 7, 6), (0, 2, 6, 4), (1, 5, 7, 3)])


def cube(center, radius, degrees):
    h = radius / math.sqrt(3)
    mesh = box((-h, -h, -h), (h, h, h))
    if degrees[0] or degrees[2]:
        raise SystemExit("cubes turn about y alone here")
    c, s = math.cos(math.radians(degrees[1])), math.sin(math.radians(degrees[1]))
    mesh.points = numpy.asarray(center) + mesh.points @ numpy.array([[c, 0, s], [0, 1, 0], [-s, 0, c]]).T
    return mesh


def rectangle(corners, squares=1):
    """Rows from the top, as the squares of a checker are counted; quads turn counterclockwise around the front's normal."""
    a, b, c, d = (numpy.asarray(p, float) for p in corners)
    points = [b + i / squares * (c - b) + j / squares * (a - b) for j in range(squares + 1) for i in range(squares + 1)]
    step = squares + 1
    quads = [((j + 1) * step + i, j * step + i, j * step + i + 1, (j + 1) * step + i + 1) for j in range(squares) for i in range(squares)]
    return Mesh(points, quads)


def mesh(thing, fine=FINE, squares=1):
    kind = thing["type"]
    at = lambda key: numpy.asarray(thing[key], float)
    if kind == "rectangle":
        return rectangle(thing["corners"], squares)
    if kind == "sphere":
        return sphere(at("center"), thing["radius"], fine)
    if kind == "box":
        return box(thing["min"], thing["max"])
    if kind == "cube":
        return cube(thing["center"], thing["radius"], thing.get("rotation", (0, 0, 0)))
    if kind == "cylinder":
        return wall(thing["base"], thing["top"], thing["radius"], thing["radius"], fine)
    if kind == "cone" and not thing.get("capped", True):
        return wall(thing["base"], thing["apex"], thing["radius"], thing.get("topRadius", 0), fine)
    if kind == "torus":
        return torus(at("center"), thing["axis"], thing["majorRadius"], thing["minorRadius"], fine)
    if kind == "disk":
        return disk(at("center"), thing["normal"], thing["radius"], fine)
    raise SystemExit(f"no mesh for: {kind}")


def things(scene):
    """(mesh, material, None) of each object and (mesh, None, light) of each light; a checkered rectangle becomes two things of plain colours."""
    for o in scene["objects"]:
        material = scene["materials"][o["material"]]
        name = material.get("color", {}).get("texture") if isinstance(material.get("color"), dict) else None
        if name is None:
            yield mesh(o), material, None
            continue
        texture = scene["textures"][name]
        n = texture["scale"]
        whole = mesh(o, squares=n)
        for k in (0, 1):
            yield whole.part(lambda q: (q % n + q // n) % 2 == k), {**material, "color": texture["colors"][k]}, None
    for light in scene["lights"]:
        lamp = mesh(light, LAMP)
        if light["type"] == "sphere":
            # As large as the ball, or it would be darker: what is seen of a convex thing is a quarter of its surface, on average.
            lamp.points = light["center"] + (lamp.points - light["center"]) * light["radius"] * math.sqrt(4 * math.pi / lamp.area())
        yield lamp, None, light


def linear(color):
    return [float(v) for v in color["linear"]]


class Camera:
    """eye, forward, right and up; half the picture's width and height, and its centre, in the plane at distance 1."""

    def __init__(self, scene):
        c, image = scene["camera"], scene["image"]
        self.eye = numpy.asarray(c["eye"], float)
        if c["type"] == "window":
            left, top = numpy.asarray(c["lowerLeft"], float), numpy.asarray(c["upperRight"], float)
            distance = left[2] - self.eye[2]
            self.forward, self.up = numpy.array((0.0, 0, 1)), numpy.array((0.0, 1, 0))
            self.half = tuple((top - left)[:2] / (2 * distance))
            self.center = tuple(((left + top) / 2 - self.eye)[:2] / distance)
        else:
            self.forward = unit(numpy.asarray(c["lookAt"], float) - self.eye)
            up = numpy.asarray(c.get("up", (0, 1, 0)), float)
            self.up = unit(up - (up @ self.forward) * self.forward)
            height = math.tan(math.radians(c["fieldOfView"]) / 2)
            self.half = (height * image["width"] / image["height"], height)
            self.center = (0.0, 0.0)
