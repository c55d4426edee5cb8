"""scenes/dandelions.json, a field of a million dandelions: python3 scenes/models/generate/dandelions.py"""
import math
import sys

from files import linear, mesh, scene
from geometry import Mesh, Random, grid, move, noise, spline, tube, turbulence

# The side of a clump. A tile holds 10 × 10 of them, the field 20 × 20 tiles.
TILE = 2.6


def flower():
    """A head of six rings of narrow petals, a cup of green, on a stem that bends."""
    random, yellow = Random(3), Mesh()
    rings = ((38, 0.42, 0.0), (36, 0.38, 0.035), (30, 0.32, 0.07), (24, 0.25, 0.1), (16, 0.17, 0.125), (9, 0.09, 0.14))
    for ring, (count, length, rise) in enumerate(rings):
        for k in range(count):
            a = 2 * math.pi * (k + 0.5 * (ring % 2)) / count + random.between(-0.08, 0.08)
            c, s, l = math.cos(a), math.sin(a), length * random.between(0.84, 1.06)
            lift, droop = rise + random.between(-0.015, 0.03), random.between(0.0, 0.05)
            ends = []
            for r, w, y in ((0.02, 0.012, 0.02 + 0.5 * rise), (0.55 * l, 0.022, lift + 0.05), (0.92 * l, 0.019, lift + 0.045 - droop), (l, 0.009, lift + 0.03 - 1.3 * droop)):
                ends.append((yellow.vertex((r * c - w * s, 1.0 + y, r * s + w * c)), yellow.vertex((r * c + w * s, 1.0 + y, r * s - w * c))))
            for (p, q), (t, u) in zip(ends, ends[1:]):
                yellow.quad(p, q, u, t)
    return yellow, stalk(random)


def clock():
    """A head that has gone to seed: a ball of stalks, each with a star of down, on a stem that bends."""
    random, white, seeds = Random(7), Mesh(), 130
    for k in range(seeds):
        # Points of a spiral from pole to pole, which are about as far from each other everywhere.
        y = 1 - (2 * k + 1) / seeds
        a, r = k * math.pi * (3 - math.sqrt(5)), math.sqrt(1 - y * y)
        out = (r * math.cos(a), y, r * math.sin(a))
        side = (-math.sin(a), 0.0, math.cos(a))
        up = tuple(out[(i + 1) % 3] * side[(i + 2) % 3] - out[(i + 2) % 3] * side[(i + 1) % 3] for i in range(3))

        def at(far, x=0.0, z=0.0):
            return white.vertex(tuple((0.0, 1.05, 0.0)[i] + far * out[i] + x * side[i] + z * up[i] for i in range(3)))

        white.quad(at(0.04, -0.003), at(0.04, 0.003), at(0.3, 0.003), at(0.3, -0.003))
        turn = random.between(0, math.pi)
        for ray in range(7):
            b = turn + 2 * math.pi * ray / 7
            x, z = math.cos(b), math.sin(b)
            white.triangles.append((at(0.3), at(0.345, 0.075 * x - 0.007 * z, 0.075 * z + 0.007 * x), at(0.345, 0.075 * x + 0.007 * z, 0.075 * z - 0.007 * x)))
    return white, stalk(random)


def stalk(random):
    green = Mesh()
    curve = spline([(0.12, -0.1, 0.05), (0.1, 0.35, 0.03), (0.0, 0.98, 0.0)], 3)
    green.add(tube(curve, [0.024] * len(curve), 5))
    for k in range(7):
        a = 2 * math.pi * k / 7 + random.between(-0.3, 0.3)
        c, s, l = math.cos(a), math.sin(a), random.between(0.45, 0.8)
        points = [(0.02, 0.0, 0.02), (0.35 * l, 0.09, 0.30 * l), (0.7 * l, 0.12, 0.18 * l), (l, 0.03, 0.02)]
        ends = []
        for r, y, w in points:
            w *= 0.42
            ends.append((green.vertex((0.12 + r * c - w * s, y, 0.05 + r * s + w * c)), green.vertex((0.12 + r * c + w * s, y, 0.05 + r * s - w * c))))
        for (p, q), (t, u) in zip(ends, ends[1:]):
            green.quad(p, q, u, t)
    return green


def grass():
    random, m = Random(12), Mesh()
    for _ in range(220):
        x, z, a = random.between(-1.3, 1.3), random.between(-1.3, 1.3), random.between(0, 6.283)
        high, out, w = random.between(0.25, 0.85), random.between(0.05, 0.4), 0.016
        c, s = math.cos(a), math.sin(a)
        ends = []
        for t in (0.0, 0.45, 0.8, 1.0):
            r, y, k = out * t * t, high * t, w * (1 - t) + 0.002
            ends.append((m.vertex((x + r * c - k * s, y, z + r * s + k * c)), m.vertex((x + r * c + k * s, y, z + r * s - k * c))))
        for (p, q), (t, u) in zip(ends, ends[1:]):
            m.quad(p, q, u, t)
    return m


def clump():
    """Twenty-five plants on a square of the side TILE, and the grass between them: what is yellow, what is white, and what is green."""
    random, heads, clocks, greens = Random(41), Mesh(), Mesh(), Mesh()
    yellow, white = flower(), clock()
    for i in range(5):
        for j in range(5):
            x, z = ((k - 2 + random.between(-0.42, 0.42)) * TILE / 5 for k in (i, j))
            size, turn, tilt = random.between(0.34, 0.6), random.between(0, 360), random.between(-16, 16)
            gone = (i, j) in ((0, 3), (3, 1))
            head, green = white if gone else yellow
            (clocks if gone else heads).add(head, move(x, 0, z, turn, tilt, size * (0.95 if gone else 1)))
            greens.add(green, move(x, 0, z, turn, tilt, size * (0.95 if gone else 1)))
    for _ in range(3):
        greens.add(grass(), move(turn=random.between(0, 360), scale=random.between(0.85, 1.0)))
    return heads, clocks, greens


def write_models():
    heads, clocks, greens = clump()
    heads.write("dandelion-heads")
    clocks.write("dandelion-clocks")
    greens.write("dandelion-leaves")
    hills = grid(160, 12, lambda u, v: (900 * (u - 0.5), (4 + 26 * abs(turbulence(6 * u, 0.4, 0, 5, 6))) * v, 30 * v + noise(200 * u, 9 * v, 0, 3)))
    hills.write("far-hills")


def write_scene():
    random = Random(2026)
    tile, field = [], []
    for i in range(10):
        for j in range(10):
            at = [(i - 4.5 + random.between(-0.1, 0.1)) * TILE, 0, (j - 4.5 + random.between(-0.1, 0.1)) * TILE]
            tile.append({"type": "group", "group": "clump", "transform": [{"scale": random.between(0.9, 1.12)}, {"rotate": [0, random.between(0, 360), 0]}, {"translate": at}]})
    for i in range(20):
        for j in range(20):
            field.append({"type": "group", "group": "tile", "transform": [{"rotate": [0, 90 * int(random.between(0, 4)), 0]}, {"translate": [(i - 9.5) * 10 * TILE, 0, (j - 9.5) * 10 * TILE]}]})
    objects = [
        {"name": "ground", "type": "rectangle", "corners": [[-2000, 0, -200], [-2000, 0, 3000], [2000, 0, 3000], [2000, 0, -200]], "material": "earth"},
        {"type": "group", "group": "field", "transform": [{"translate": [0, 0, 230]}]},
        mesh("far-hills", "hill", at=(0, -1, 480)), mesh("far-hills", "far hill", scale=[-1.7, 2.1, 1], at=(80, -2, 800)),
    ]
    scene("dandelions", "A meadow of a million dandelions: a mesh of twenty-five plants, placed 40,000 times by groups within groups.\nModels: scenes/models/generate/dandelions.py.", {
        "name": "A field of dandelions",
        "image": {"width": 1280, "height": 720},
        "camera": {"type": "perspective", "eye": [0, 1.9, -34], "lookAt": [0.6, 1.35, -26], "fieldOfView": 34, "lens": {"radius": 0.03, "focusDistance": 4.5}},
        "shading": {"model": "physical", "background": {"type": "sky", "elevation": 26, "azimuth": -62, "turbidity": 2.8, "groundAlbedo": [0.12, 0.16, 0.06]}},
        "display": {"exposure": 0.9, "tone": "filmic"},
        "materials": {
            "earth": {"type": "matte", "color": linear(0.07, 0.09, 0.03)},
            "leaf": {"type": "matte", "color": linear(0.14, 0.25, 0.06)},
            "far hill": {"type": "matte", "color": linear(0.20, 0.26, 0.28)},
            "petal": {"type": "matte", "color": linear(0.78, 0.56, 0.04)},
            "hill": {"type": "matte", "color": linear(0.09, 0.14, 0.08)},
            "down": {"type": "matte", "color": linear(0.76, 0.75, 0.72)},
        },
        "meshes": {n: {"file": f"models/{n}.ply", "normals": "flat" if n != "far-hills" else "smooth"} for n in ("dandelion-heads", "dandelion-clocks", "dandelion-leaves", "far-hills")},
        "groups": {"clump": [mesh("dandelion-heads", "petal"), mesh("dandelion-clocks", "down"), mesh("dandelion-leaves", "leaf")], "tile": tile, "field": field},
        "objects": objects,
        "render": {"method": "raytrace", "antialias": 8},
    })


if __name__ == "__main__":
    if sys.argv[1:] != ["scene"]:
        write_models()
    write_scene()
