"""scenes/dandelions.json, a field of a million dandelions: python3 scenes/models/generate/dandelions.py"""
import math
import sys

from files import linear, mesh, scene
from geometry import Mesh, Random, grid, move, noise, spline, tube, turbulence

# The side of a clump. A tile holds 10 × 10 of them, the field 20 × 20 tiles.
TILE = 2.6


def flower():
    """A head of four rings of petals, a cup of green, on a stem that bends."""
    random, yellow, green = Random(3), Mesh(), Mesh()
    for ring, (count, length, rise) in enumerate(((26, 0.42, 0.05), (22, 0.36, 0.11), (16, 0.27, 0.18), (9, 0.16, 0.22))):
        for k in range(count):
            a = 2 * math.pi * (k + 0.5 * (ring % 2)) / count + random.between(-0.05, 0.05)
            c, s, l = math.cos(a), math.sin(a), length * random.between(0.9, 1.08)
            lift = rise + 0.3 * rise * random.next()
            ends = []
            for r, w, y in ((0.04, 0.022, 0.02 + 0.3 * rise), (0.6 * l, 0.042, lift + 0.05), (l, 0.034, lift + 0.02)):
                ends.append((yellow.vertex((r * c - w * s, 1.0 + y, r * s + w * c)), yellow.vertex((r * c + w * s, 1.0 + y, r * s - w * c))))
            for (p, q), (t, u) in zip(ends, ends[1:]):
                yellow.quad(p, q, u, t)
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
    return yellow, green


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
    """Twenty-five plants on a square of the side TILE, and the grass between them: what is yellow, and what is green."""
    random, heads, greens = Random(41), Mesh(), Mesh()
    yellow, green = flower()
    for i in range(5):
        for j in range(5):
            x, z = ((k - 2 + random.between(-0.42, 0.42)) * TILE / 5 for k in (i, j))
            size, turn, tilt = random.between(0.34, 0.6), random.between(0, 360), random.between(-16, 16)
            heads.add(yellow, move(x, 0, z, turn, tilt, size))
            greens.add(green, move(x, 0, z, turn, tilt, size))
    for _ in range(3):
        greens.add(grass(), move(turn=random.between(0, 360), scale=random.between(0.85, 1.0)))
    return heads, greens


def write_models():
    heads, greens = clump()
    heads.write("dandelion-heads")
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
        "display": {"exposure": 0.6, "tone": "filmic"},
        "materials": {
            "earth": {"type": "matte", "color": linear(0.07, 0.09, 0.03)},
            "leaf": {"type": "matte", "color": linear(0.14, 0.25, 0.06)},
            "far hill": {"type": "matte", "color": linear(0.20, 0.26, 0.28)},
            "petal": {"type": "matte", "color": linear(0.78, 0.56, 0.04)},
            "hill": {"type": "matte", "color": linear(0.09, 0.14, 0.08)},
        },
        "meshes": {n: {"file": f"models/{n}.ply", "normals": "flat" if n != "far-hills" else "smooth"} for n in ("dandelion-heads", "dandelion-leaves", "far-hills")},
        "groups": {"clump": [mesh("dandelion-heads", "petal"), mesh("dandelion-leaves", "leaf")], "tile": tile, "field": field},
        "objects": objects,
        "render": {"method": "raytrace", "antialias": 8},
    })


if __name__ == "__main__":
    if sys.argv[1:] != ["scene"]:
        write_models()
    write_scene()
