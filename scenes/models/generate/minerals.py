"""scenes/minerals.json, minerals under black light: python3 scenes/models/generate/minerals.py"""
import math
import sys

from files import linear, mesh, models, scene
from geometry import Mesh, Random, grid, rounded_box, turbulence


def rock(radius, seed, flat=0.75, steps=56):
    """A ball that noise has broken: facets where steep, grains where not."""

    def at(u, v):
        a, b = 2 * math.pi * u, math.pi * (v - 0.5)
        d = (math.cos(b) * math.cos(a), math.sin(b), math.cos(b) * math.sin(a))
        n = turbulence(1.3 * d[0] + 7, 1.3 * d[1], 1.3 * d[2], 4, seed)
        ridge = abs(turbulence(1.9 * d[0], 1.9 * d[1] + 3, 1.9 * d[2], 3, seed + 50))
        r = radius * (1 + 0.28 * n - 0.22 * ridge + 0.02 * turbulence(9 * d[0], 9 * d[1], 9 * d[2], 2, seed + 9))
        return (r * d[0], flat * r * d[1], r * d[2])

    return grid(2 * steps, steps, at, closed_u=True)


def crystal(height, radius, random, sides=6):
    """A column of six sides with a point that is not quite in the middle."""
    m = Mesh()
    wide = [radius * random.between(0.8, 1.15) for _ in range(sides)]
    shoulder = [height * random.between(0.66, 0.78) for _ in range(sides)]
    for ring in range(2):
        for k in range(sides):
            a = 2 * math.pi * k / sides
            m.vertex((wide[k] * math.cos(a), shoulder[k] * ring - (1 - ring) * 0.4, wide[k] * math.sin(a)))
    tip = m.vertex((random.between(-0.2, 0.2) * radius, height, random.between(-0.2, 0.2) * radius))
    foot = m.vertex((0, -0.4, 0))
    for k in range(sides):
        n = (k + 1) % sides
        m.quad(k, k + sides, n + sides, n)
        m.triangles += [(k + sides, tip, n + sides), (k, n, foot)]
    return m


def leaning(out, turn):
    """Leans a crystal outwards by degrees, in the direction of a turn about +y."""
    t, c = math.radians(out), math.radians(turn)

    def of(p):
        x, y, z = p
        x, y = x * math.cos(t) + y * math.sin(t), y * math.cos(t) - x * math.sin(t)
        return (x * math.cos(c) - z * math.sin(c), y, x * math.sin(c) + z * math.cos(c))

    return of


def cluster(seed, count, high, wide):
    random, m = Random(seed), Mesh()
    for k in range(count):
        share = k / count
        lean, turn = 58 * share + random.between(-5, 5), 137.5 * k + random.between(-15, 15)
        size = (1 - 0.55 * share) * random.between(0.8, 1.1)
        away = wide * 2.4 * math.sqrt(share)
        a = math.radians(turn)
        m.add(crystal(high * size, wide * size, random), lambda p: tuple(q + s for q, s in zip(leaning(lean, turn)(p), (away * math.cos(a), 0, away * math.sin(a)))))
    return m


def cubes(seed, count, size):
    """Fluorite: cubes that grow through each other."""
    random, m = Random(seed), Mesh()
    for k in range(count):
        s = size * random.between(0.5, 1.0)
        a, r = random.between(0, 2 * math.pi), size * 0.9 * math.sqrt(random.next())
        box, turn = rounded_box(s, s, s, 0.03 * s, 2), random.between(0, 90)
        c, d = math.cos(math.radians(turn)), math.sin(math.radians(turn))
        h = 0.45 * s + random.between(0, 0.5) * (size - r)
        m.add(box, lambda p: (c * p[0] + d * p[2] + r * math.cos(a), p[1] + h, c * p[2] - d * p[0] + r * math.sin(a)))
    return m


def write_models():
    for name, radius, seed in (("rock-large", 3.6, 3), ("rock-flat", 3.0, 21), ("rock-small", 1.5, 8)):
        rock(radius, seed, 0.6 if name == "rock-flat" else 0.75).write(name)
    cluster(5, 26, 6.2, 0.85).write("crystals-tall")
    cluster(17, 22, 3.2, 0.5).write("crystals-low")
    cubes(9, 16, 2.4).write("fluorite")


def glowing(color, emission, quantum=0.85):
    return {"type": "fluorescent", "color": color, "absorption": [300, 420], "emission": emission, "yield": quantum}


def write_scene():
    def placed(name, material, at, turn=0.0, scale=None):
        return mesh(name, material, scale=scale, rotate=[0, turn, 0], at=at)

    objects = [
        {"name": "shelf", "type": "rectangle", "corners": [[-60, 0, -40], [-60, 0, 22], [60, 0, 22], [60, 0, -40]], "material": "slate"},
        {"name": "back", "type": "rectangle", "corners": [[-60, 0, 22], [-60, 60, 22], [60, 60, 22], [60, 0, 22]], "material": "back"},
        placed("rock-large", "host", (-6.4, 1.7, 2.0), 20), placed("crystals-tall", "calcite", (-6.0, 3.3, 1.4), 40, 0.95),
        placed("rock-flat", "willemite", (1.4, 1.1, -1.4), 130), placed("rock-small", "host", (4.6, 0.8, -4.2), 60),
        placed("fluorite", "fluorite", (7.2, 0.1, 1.6), 15, 1.3), placed("crystals-low", "autunite", (1.3, 2.2, -1.0), 0, 0.9),
        placed("rock-small", "sodalite", (-1.6, 0.8, -6.0), 200, 1.05), placed("rock-small", "willemite", (-9.6, 0.7, -4.4), 10, 0.8),
        placed("crystals-low", "calcite", (11.6, 0.1, -3.6), 77, 0.8), placed("rock-large", "host", (15.5, 1.4, 9.0), 200, 1.2),
        placed("rock-small", "sodalite", (8.6, 0.4, -6.4), 300, 0.5), placed("rock-small", "scheelite", (-5.0, 0.5, -7.4), 140, 0.55),
        placed("crystals-tall", "scheelite", (15.0, 2.9, 8.6), 10, 0.8), placed("fluorite", "autunite", (-15.0, 0.1, 6.0), 70, 1.1),
    ]
    scene("minerals", "Minerals under black light: two tubes of ultraviolet light that give little that is seen, and stones that answer in their colours.\n"
          "Models: scenes/models/generate/minerals.py.", {
        "name": "Minerals under black light",
        "image": {"width": 1280, "height": 720},
        "camera": {"type": "perspective", "eye": [1.5, 13, -34], "lookAt": [0.6, 2.9, 0], "fieldOfView": 26},
        "shading": {"model": "physical", "background": linear(0.012, 0.012, 0.02)},
        "display": {"exposure": 0, "tone": "filmic"},
        "materials": {
            "slate": {"type": "coated", "color": linear(0.05, 0.05, 0.055), "roughness": 0.4},
            "back": {"type": "matte", "color": linear(0.06, 0.06, 0.07)},
            "host": {"type": "matte", "color": linear(0.22, 0.20, 0.18), "roughness": 0.6},
            "calcite": glowing(linear(0.42, 0.36, 0.34), [590, 680]),
            "willemite": glowing(linear(0.26, 0.25, 0.20), [505, 560]),
            "autunite": glowing(linear(0.36, 0.38, 0.16), [510, 590]),
            "fluorite": glowing(linear(0.34, 0.30, 0.42), [415, 480]),
            "sodalite": glowing(linear(0.20, 0.21, 0.24), [570, 640]),
            "scheelite": glowing(linear(0.45, 0.43, 0.40), [440, 520]),
        },
        "meshes": {n: {"file": f"models/{n}.ply", "normals": "flat"} for n in ("rock-large", "rock-flat", "rock-small", "crystals-tall", "crystals-low", "fluorite")},
        "lights": [
            {"type": "rectangle", "corners": [[-20, 20, -16], [-20, 23, -11], [8, 23, -11], [8, 20, -16]], "color": "#7a5cff", "radiance": 0.8, "ultraviolet": 20},
            {"type": "rectangle", "corners": [[10, 17, 14], [10, 20, 17], [24, 20, 12], [24, 17, 9]], "color": "#7a5cff", "radiance": 1.6, "ultraviolet": 20},
        ],
        "objects": objects,
        "render": {"method": "raytrace", "antialias": 8},
    })


if __name__ == "__main__":
    if sys.argv[1:] != ["scene"]:
        write_models()
    write_scene()
