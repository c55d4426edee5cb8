"""scenes/breakfast.json, milk, honey, coffee and an egg: python3 scenes/models/generate/breakfast.py"""
import math
import sys

from files import linear, mesh, models, png, scene
from geometry import Mesh, arc, lathe, noise, planar, rounded_box, spline, tube, turbulence


def cloth(px, py, size=256):
    """Linen: threads that go over and under each other, and wide stripes."""
    u, v = px / size, py / size
    weave = 0.5 + 0.25 * math.sin(2 * math.pi * 48 * u) * math.cos(2 * math.pi * 24 * v) + 0.12 * noise(u * 90, v * 9, 0, 2) + 0.12 * noise(u * 9, v * 90, 0, 3)
    stripe = 1.0 if 0.1 < v % 0.5 < 0.16 or 0.2 < v % 0.5 < 0.22 else 0.0
    a = (0.86, 0.84, 0.79)
    b = (0.36, 0.47, 0.60)
    return tuple((p + (q - p) * stripe) * (0.86 + 0.14 * weave) for p, q in zip(a, b))


def oak(px, py, size=512):
    u, v = px / size, py / size
    grain = turbulence(u * 3, v * 60, 0, 3, 15) * 0.45 + turbulence(u * 1.5, v * 9 + 1.2 * noise(u * 2, v * 2, 0, 13), 0, 2, 19) * 0.7
    t = 0.5 + 0.45 * grain
    if v % 0.25 < 0.006:
        t = -0.9
    a, b = (0.50, 0.35, 0.22), (0.70, 0.53, 0.36)
    return tuple(max(0.04, p + (q - p) * t) for p, q in zip(a, b))


def write_models():
    # Jug and jar have walls without thickness, which bend no light; what is in them stands apart from the wall.
    outer = [(0.0, 0.0), (3.0, 0.0)] + arc(3.0, 0.3, 0.3, -90, 0, 4) + spline([(3.3, 0.3), (3.9, 2.0), (4.0, 4.0), (3.4, 6.4), (2.6, 8.2), (2.5, 9.4), (2.9, 10.8)], 8)
    inner = spline([(2.72, 10.8), (2.3, 9.4), (2.4, 8.2), (3.2, 6.4), (3.78, 4.0), (3.68, 2.0), (3.0, 0.62), (0.0, 0.5)], 8)
    lathe(outer[1:], 96).write("jug")
    level = 6.9
    body = [(r, y) for r, y in inner if y < level]
    lathe([(0.0, level), (body[0][0] - 0.1, level), (body[0][0], level + 0.04)] + body, 96).write("jug-milk")
    handle = spline([(2.5, 9.0, 0.0), (4.6, 9.3, 0.0), (5.7, 7.4, 0.0), (5.1, 5.2, 0.0), (3.75, 4.6, 0.0)], 12)
    tube(handle, [0.36 + 0.1 * abs(1 - 2 * k / (len(handle) - 1)) for k in range(len(handle))], 20).write("jug-handle")
    cup = [(0.0, 0.0), (1.7, 0.0), (1.9, 0.12), (1.9, 0.4)] + spline([(1.9, 0.4), (3.1, 1.4), (3.75, 3.2), (3.95, 5.0)], 8)
    cup += arc(3.86, 5.0, 0.09, 0, 180, 5)[1:-1] + spline([(3.77, 5.0), (3.55, 3.2), (2.9, 1.6), (1.8, 0.75), (0.0, 0.65)], 8)
    lathe(cup, 96).write("cup")
    ear = spline([(3.6, 4.3, 0.0), (5.3, 4.5, 0.0), (5.7, 3.2, 0.0), (4.6, 1.9, 0.0), (3.1, 1.5, 0.0)], 10)
    tube(ear, [0.27] * len(ear), 16).write("cup-ear")
    lathe([(0.0, 4.2), (3.2, 4.2), (3.62, 4.21), (3.8, 4.28), (3.7, 4.1)], 96).write("coffee")
    saucer = [(0.0, 0.25), (2.2, 0.25), (2.5, 0.35), (4.6, 0.75), (6.4, 1.15)] + arc(6.4, 1.05, 0.1, 90, -90, 5) + [(4.6, 0.55), (2.7, 0.1), (2.5, 0.0), (0.0, 0.0)]
    lathe(saucer, 128).write("saucer")
    egg = []
    for k in range(65):
        t = math.pi * k / 64
        egg.append((2.15 * math.sin(t) * (1 + 0.14 * math.cos(t)) if 0 < k < 64 else 0.0, -2.8 * math.cos(t) + 2.8))
    lathe(egg, 96).write("egg")
    holder = [(0.0, 0.0), (1.9, 0.0), (2.0, 0.1), (1.9, 0.3), (0.75, 0.9), (0.65, 1.6), (1.1, 2.2), (1.85, 2.8), (2.15, 3.7), (2.2, 4.2)]
    holder = spline(holder, 5) + [(2.1, 4.25), (2.02, 4.2), (1.95, 3.7), (1.5, 2.9), (0.0, 2.5)]
    lathe(holder, 96).write("egg-cup")
    # A jar of honey: square with round corners would be usual; this one is round, with honey up to its shoulder.
    jar = [(0.0, 0.0), (2.9, 0.0)] + arc(2.9, 0.3, 0.3, -90, 0, 4) + [(3.2, 4.4)] + arc(2.6, 4.5, 0.6, 0, 80, 6) + [(2.6, 5.3), (2.6, 6.3)]
    hollow = [(2.4, 6.3), (2.4, 5.2), (2.45, 4.95)] + arc(2.5, 4.4, 0.5, 75, 0, 6) + [(3.0, 0.5), (2.8, 0.32), (0.0, 0.3)]
    lathe(jar[1:], 96).write("jar")
    top = 4.1
    honey = [(r, y) for r, y in hollow if y < top]
    lathe([(0.0, top), (2.8, top), (2.98, top + 0.05)] + honey, 96).write("honey")
    dipper = [(0.0, 0.0), (0.5, 0.05)]
    for k in range(6):
        r = [0.8, 1.0, 1.1, 1.1, 1.0, 0.8][k]
        dipper += [(r, 0.2 + 0.34 * k), (r, 0.36 + 0.34 * k), (0.5, 0.4 + 0.34 * k), (0.5, 0.5 + 0.34 * k)]
    dipper += [(0.3, 2.4), (0.27, 9.0), (0.34, 9.6), (0.2, 9.9), (0.0, 9.95)]
    lathe(dipper, 48).write("dipper")
    spoon = Mesh()
    bowl = []
    for k in range(33):
        t = k / 32
        bowl.append((10.2 + 4.2 * t, 0.0, 1.45 * math.sqrt(max(0.0, math.sin(math.pi * t))) * (0.86 + 0.28 * t)))
    for layer, lift in ((0, 0.0), (1, -0.12)):
        rows = []
        for x, _, w in bowl:
            row = []
            for j in range(17):
                s = 2 * j / 16 - 1
                deep = 0.75 * (1 - s * s) * math.sin(math.pi * (x - 10.2) / 4.2)
                row.append(spoon.vertex((x, 0.8 - deep + lift, w * s)))
            rows.append(row)
        for a, b in zip(rows, rows[1:]):
            for j in range(16):
                spoon.quad(a[j], a[j + 1], b[j + 1], b[j])
    stem = spline([(0.0, 0.45, 0.0), (2.5, 0.35, 0.0), (7.0, 0.75, 0.0), (10.4, 0.75, 0.0)], 10)
    spoon.add(tube(stem, [0.42 - 0.2 * min(1, k / 20) for k in range(len(stem))], 12), lambda p: (p[0], 0.6 * p[1] + 0.3, p[2]))
    spoon.write("spoon")
    # A slice of bread, and a napkin with round folds.
    crust = [(x, z) for x, z in spline([(-4.2, -4.0), (4.2, -4.0), (4.5, 1.5), (5.0, 3.4), (2.6, 5.4), (0.0, 5.7), (-2.6, 5.4), (-5.0, 3.4), (-4.5, 1.5), (-4.2, -4.0)], 10)[:-1]]
    n = len(crust)

    def rings(mesh, rows):
        """Rings of the slice's outline, each (share of its size, height, height of pores), joined from one to the next."""
        for share, y, pores in rows:
            for x, z in crust:
                x, z = x * share, z * share
                mesh.vertex((x, y + pores * turbulence(x * 2.2, z * 2.2, 0, 4, 2), z))
        for j in range(len(rows) - 1):
            for i in range(n):
                mesh.quad(j * n + i, (j + 1) * n + i, (j + 1) * n + (i + 1) % n, j * n + (i + 1) % n)
        return mesh

    rings(Mesh(), [(0.97, 0.0, 0), (1.01, 0.06, 0), (1.03, 0.35, 0), (1.03, 1.0, 0), (1.01, 1.28, 0), (0.97, 1.36, 0.0), (0.955, 1.35, 0)]).write("bread-crust")
    rings(Mesh(), [(0.957 * (1 - k / 24), 1.352, 0.09 * min(1, k / 2)) for k in range(24)] + [(0.0, 1.352, 0.0)]).write("bread")
    planar(rounded_box(34, 0.16, 22, 0.08, 2), 14).write("tablecloth", True)
    rounded_box(13, 1.0, 15, 0.3, 4).write("board")
    butter = rounded_box(2.6, 1.0, 2.2, 0.18, 4)
    butter.write("butter")


def write_scene():
    def placed(name, material, at, turn=0.0):
        return mesh(name, material, rotate=[0, turn, 0], at=at)

    jug, cup, jar, egg = (-7.2, 0.17, 4.2), (3.4, 0.17, -2.2), (-1.2, 0.17, 6.0), (-5.4, 0.17, -4.2)
    up = (cup[0], cup[1] + 0.7, cup[2])
    board = (11.6, 0.0, 5.4)
    objects = [
        {"name": "table", "type": "rectangle", "corners": [[-60, 0, -40], [-60, 0, 60], [60, 0, 60], [60, 0, -40]], "material": "table"},
        {"name": "wall", "type": "rectangle", "corners": [[-90, -40, 62], [-90, 90, 62], [90, 90, 62], [90, -40, 62]], "material": "wall"},
        placed("tablecloth", "linen", (-1.0, 0.09, 0.0), 9),
        placed("jug", "glass", jug), placed("jug-milk", "milk", jug), placed("jug-handle", "glass", jug, 150),
        placed("saucer", "china", cup), placed("cup", "china", up), placed("cup-ear", "china", up, 35), placed("coffee", "coffee", up),
        placed("jar", "glass", jar), placed("honey", "honey", jar),
        {"type": "mesh", "mesh": "dipper", "material": "beech", "transform": [{"rotate": [0, 0, -16]}, {"translate": [jar[0] - 0.9, jar[1] + 0.9, jar[2]]}]},
        placed("egg-cup", "china blue", egg),
        {"type": "mesh", "mesh": "egg", "material": "egg", "transform": [{"rotate": [4, 0, -5]}, {"translate": [egg[0] + 0.2, egg[1] + 2.6, egg[2]]}]},
        {"type": "mesh", "mesh": "spoon", "material": "silver", "transform": [{"rotate": [0, 16, 0]}, {"translate": [-3.0, 0.0, -8.0]}]},
        placed("board", "beech", (board[0], 0.5, board[2]), -16),
        *({"type": "mesh", "mesh": part, "material": part, "transform": [{"rotate": turn}, {"translate": at}]}
          for part in ("bread", "bread-crust")
          for turn, at in (([0, 20, 0], [board[0] - 0.4, 1.02, board[2] + 0.8]), ([-9, -30, 4], [board[0] + 0.9, 2.5, board[2] + 0.2]))),
        placed("butter", "butter", (8.6, 1.55, 0.6), 40),
    ]
    names = ["jug", "jug-milk", "jug-handle", "cup", "cup-ear", "coffee", "saucer", "egg", "egg-cup", "jar", "honey", "dipper", "spoon", "bread", "bread-crust", "tablecloth", "board", "butter"]
    scene("breakfast", "Breakfast at a window: milk and honey in glass, coffee in china, a boiled egg, bread and butter.\n"
          "Models and textures: scenes/models/generate/breakfast.py.", {
        "name": "Breakfast",
        "image": {"width": 1280, "height": 720},
        "camera": {"type": "perspective", "eye": [3.0, 22, -40], "lookAt": [1.0, 3.6, 0], "fieldOfView": 28},
        "shading": {"model": "physical", "background": linear(0.42, 0.44, 0.47)},
        "display": {"exposure": 0.1, "tone": "filmic"},
        "textures": {"cloth": {"file": "../textures/cloth.png"}, "oak": {"file": "../textures/oak.png"}},
        "materials": {
            "table": {"type": "coated", "color": {"texture": "oak"}, "roughness": 0.5},
            "wall": {"type": "matte", "color": linear(0.46, 0.42, 0.36)},
            "linen": {"type": "matte", "color": {"texture": "cloth"}, "roughness": 0.5},
            "glass": {"type": "glass", "color": "#ffffff", "indexOfRefraction": 1.5, "smoothRefraction": True},
            "milk": {"type": "scattering", "scatteringCoefficient": [3, 3.4, 3.6], "absorptionCoefficient": [0.004, 0.008, 0.03]},
            "honey": {"type": "glass", "color": "#ffffff", "indexOfRefraction": 1.48, "absorption": [0.012, 0.11, 0.75], "smoothRefraction": True},
            "china": {"type": "coated", "color": linear(0.78, 0.77, 0.74), "roughness": 0.25},
            "china blue": {"type": "coated", "color": linear(0.18, 0.33, 0.48), "roughness": 0.25},
            "coffee": {"type": "coated", "color": linear(0.035, 0.014, 0.006), "roughness": 0.1, "indexOfRefraction": 1.34},
            "egg": {"type": "coated", "color": linear(0.66, 0.43, 0.30), "roughness": 0.55},
            "silver": {"type": "glossy", "metal": "silver", "roughness": 0.26},
            "beech": {"type": "coated", "color": linear(0.42, 0.24, 0.12), "roughness": 0.55},
            "bread": {"type": "matte", "color": linear(0.70, 0.56, 0.36), "roughness": 0.6},
            "bread-crust": {"type": "coated", "color": linear(0.34, 0.16, 0.06), "roughness": 0.6},
            "butter": {"type": "coated", "color": linear(0.78, 0.64, 0.26), "roughness": 0.35},
        },
        "meshes": models(*names, crease=50),
        "lights": [
            {"type": "rectangle", "corners": [[-42, 2, 50], [-42, 46, 50], [-42, 46, -14], [-42, 2, -14]], "color": "#fff3e2", "radiance": 5.0},
        ],
        "objects": objects,
        "render": {"method": "raytrace", "antialias": 8},
    })


if __name__ == "__main__":
    if sys.argv[1:] != ["scene"]:
        png("cloth", 256, 256, cloth)
        png("oak", 512, 512, oak)
        write_models()
    write_scene()
