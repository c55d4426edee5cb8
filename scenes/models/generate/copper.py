"""scenes/copper.json, a kettle, a mortar, a tankard and lacquered bowls: python3 scenes/models/generate/copper.py"""
import math
import sys

from files import linear, mesh, models, png, scene
from geometry import Mesh, Random, arc, grid, lathe, rounded_box, spline, tube, turbulence

DENTS = 12


def hammered(px, py, size=256):
    """Height of metal beaten by a round hammer: shallow dents that meet, in rows set off by half a dent."""
    u, v, deepest = px / size * DENTS, py / size * DENTS, 1.0
    for row in range(math.floor(v) - 1, math.floor(v) + 3):
        for k in range(math.floor(u) - 2, math.floor(u) + 3):
            random = Random(1000 * (row % DENTS) + k % DENTS + 17)
            x, y = k + 0.5 * (row % 2) + random.between(-0.14, 0.14), row + random.between(-0.14, 0.14)
            deepest = min(deepest, ((u - x) ** 2 + (v - y) ** 2) * random.between(1.15, 1.5))
    return deepest


def slate(px, py, size=256):
    u, v = px / size, py / size
    # Turbulence that repeats: the mean of four places, each a repetition away, by weights that come to one.
    t = 0.0
    for i in (0, 1):
        for j in (0, 1):
            weight = (u if i else 1 - u) * (v if j else 1 - v)
            t += weight * turbulence(6 * (u - i) + 40, 22 * (v - j) + 40, 0, 4, 5)
    return 0.5 + 0.3 * t


def wrapped(profile, around, columns, rows):
    """A lathe whose texture repeats, columns times around and rows times along; its seam is at +x."""
    n = len(profile)
    turned = grid(around, n - 1, lambda u, v: (profile[round(v * (n - 1))][0] * math.cos(2 * math.pi * u), profile[round(v * (n - 1))][1], profile[round(v * (n - 1))][0] * math.sin(2 * math.pi * u)))
    turned.vertices = [(x, y, z, u * columns, v * rows) for x, y, z, u, v in turned.vertices]
    return turned


def kettle():
    side = spline([(5.3, 0.3), (6.6, 1.6), (7.1, 3.6), (6.4, 6.2), (4.6, 8.1), (3.1, 8.9)], 10)
    wrapped([(5.0, 0.0), (5.15, 0.08)] + side + [(3.0, 9.2), (3.1, 9.35), (3.0, 9.45), (2.9, 9.3)], 128, 7, 2).write("kettle", True)
    lathe([(3.2, 9.4), (3.22, 9.5)] + spline([(3.1, 9.62), (2.2, 10.05), (1.0, 10.25), (0.0, 10.3)], 6), 96).write("kettle-lid")
    knob = [(0.5, 10.2), (0.42, 10.5), (0.4, 10.75)] + arc(0.0, 11.35, 0.75, -50, 88, 12) + [(0.0, 12.1)]
    fittings = lathe(knob, 48)
    bow = [(5.6, 7.3, 0.0), (6.3, 9.5, 0.0), (5.6, 13.2, 0.0), (3.0, 15.6, 0.0), (0.0, 16.2, 0.0), (-3.0, 15.6, 0.0), (-5.6, 13.2, 0.0), (-6.3, 9.5, 0.0), (-5.6, 7.3, 0.0)]
    bow = spline(bow, 8)
    fittings.add(tube(bow, [0.36] * len(bow), 16))
    for x in (-5.6, 5.6):
        fittings.add(lathe([(0.0, -0.5), (0.9, -0.4), (1.0, 0.0), (0.8, 0.5), (0.0, 0.7)], 32), lambda p, x=x: (p[0] + x, p[1] + 7.2, p[2]))
    fittings.write("kettle-fittings")
    grip = [p for p in bow if abs(p[0]) < 3.1]
    tube(grip, [0.5 + 0.32 * math.sin(math.pi * k / (len(grip) - 1)) ** 0.5 for k in range(len(grip))], 20).write("kettle-grip")
    spout = spline([(5.9, 2.6, 0.0), (8.6, 3.6, 0.0), (9.6, 6.2, 0.0), (10.4, 8.6, 0.0), (11.8, 9.5, 0.0)], 10)
    tube(spout, [1.75 - 1.0 * (k / (len(spout) - 1)) ** 0.6 for k in range(len(spout))], 32).write("kettle-spout")


def write_models():
    kettle()
    outer = [(0.0, 0.0), (3.0, 0.0), (3.15, 0.15), (3.1, 0.6), (2.5, 0.95), (2.3, 1.3)] + spline([(2.4, 1.6), (3.0, 3.0), (3.35, 4.9), (3.6, 6.0)], 8)
    ribs = [(3.85, 6.1), (3.95, 6.3), (3.85, 6.5), (3.7, 6.55), (4.0, 7.1)] + arc(3.9, 7.2, 0.12, -20, 160, 6)
    inner = spline([(3.65, 7.1), (3.2, 5.4), (2.7, 3.2), (1.6, 1.9), (0.0, 1.6)], 8)
    lathe(outer[1:] + ribs + inner, 128).write("mortar")
    pestle = [(0.0, 0.0)] + arc(0.0, 1.0, 1.0, -80, 30, 10) + spline([(0.62, 2.0), (0.45, 4.0), (0.5, 7.0), (0.66, 8.2)], 6) + [(0.95, 8.4), (0.95, 8.8), (0.6, 9.0)] + arc(0.0, 9.6, 0.7, -30, 88, 8) + [(0.0, 10.3)]
    lathe(pestle, 64).write("pestle")
    tankard = [(3.5, 0.0), (3.75, 0.1), (3.8, 0.5), (3.55, 0.75), (3.5, 1.1), (3.15, 4.6), (3.2, 4.75), (3.3, 4.9), (3.2, 5.05), (3.08, 5.2), (2.85, 8.8)] + arc(2.83, 9.0, 0.16, -20, 180, 8)
    tankard += [(2.6, 8.8), (2.9, 4.5), (3.2, 0.8), (0.0, 0.6)]
    body = lathe(tankard, 128)
    ear = spline([(2.9, 8.1, 0.0), (4.6, 8.5, 0.0), (5.6, 6.9, 0.0), (5.0, 4.2, 0.0), (3.3, 2.0, 0.0)], 10)
    body.add(tube(ear, [0.42 - 0.12 * k / (len(ear) - 1) for k in range(len(ear))], 16))
    body.write("tankard")
    outside = [(1.9, 0.0), (2.1, 0.05), (2.05, 0.7)] + spline([(2.2, 0.9), (4.2, 1.8), (5.1, 3.6), (5.4, 5.0)], 10) + arc(5.31, 5.0, 0.09, 0, 180, 6)
    lathe(outside, 128).write("bowl-outside")
    lathe(spline([(5.22, 5.0), (4.9, 3.6), (3.9, 2.0), (2.0, 1.2), (0.0, 1.05)], 10), 128).write("bowl-inside")
    slab = rounded_box(70, 1.6, 30, 0.35, 4)
    slab.vertices = [(x, y, z, x / 14, z / 14) for x, y, z, _, _ in slab.vertices]
    slab.write("slate-slab", True)
    nut = [(0.0, 0.0)] + spline([(0.45, 0.06), (0.8, 0.5), (0.78, 0.95), (0.45, 1.4), (0.12, 1.62)], 5) + [(0.0, 1.64)]
    lathe(nut, 40).write("hazelnut")


def write_scene():
    def placed(name, material, at, turn=0.0):
        return mesh(name, material, rotate=[0, turn, 0], at=at)

    kettle_at, mortar, tankard, bowl = (-5.4, 0, 3.5), (6.4, 0, -1.8), (13.2, 0, 4.4), (-14.4, 0, -2.6)
    objects = [
        {"name": "wall", "type": "rectangle", "corners": [[-90, -50, 40], [-90, 80, 40], [90, 80, 40], [90, -50, 40]], "material": "wall"},
        mesh("slate-slab", "slate", at=(0, -0.8, 3)),
        # The seam of the hammered texture, at +x, is turned away from the viewer and behind the spout.
        placed("kettle", "copper", kettle_at, -60), placed("kettle-lid", "polished copper", kettle_at), placed("kettle-spout", "polished copper", kettle_at, 35),
        placed("kettle-fittings", "brass", kettle_at, 35), placed("kettle-grip", "walnut", kettle_at, 35),
        placed("mortar", "old brass", mortar),
        {"type": "mesh", "mesh": "pestle", "material": "brass", "transform": [{"rotate": [0, 0, -24]}, {"rotate": [0, 20, 0]}, {"translate": [mortar[0] - 0.9, 2.0, mortar[2] + 0.2]}]},
        placed("tankard", "pewter", tankard, -25),
        placed("bowl-outside", "red lacquer", bowl), placed("bowl-inside", "black lacquer", bowl),
        placed("bowl-outside", "black lacquer", (bowl[0] + 0.15, 1.75, bowl[2] + 0.1)), placed("bowl-inside", "red lacquer", (bowl[0] + 0.15, 1.75, bowl[2] + 0.1)),
    ]
    random = Random(8)
    for x, z in ((11.2, -7.4), (13.4, -6.0), (15.4, -8.0), (-2.4, -6.6), (-0.2, -8.0), (16.6, -4.2)):
        objects.append({"type": "mesh", "mesh": "hazelnut", "material": "nut", "transform": [{"rotate": [random.between(70, 100), 0, 0]}, {"rotate": [0, random.between(0, 360), 0]}, {"translate": [x, 0.8, z]}]})
    names = ["kettle", "kettle-lid", "kettle-fittings", "kettle-grip", "kettle-spout", "mortar", "pestle", "tankard", "bowl-outside", "bowl-inside", "slate-slab", "hazelnut"]
    scene("copper", "Copper, brass, pewter and lacquer on slate: metals of roughness 0.12 to 0.5, a bump map of hammered metal, coats over colour.\n"
          "Models and textures: scenes/models/generate/copper.py.", {
        "name": "Copper and lacquer",
        "image": {"width": 1280, "height": 720},
        "camera": {"type": "perspective", "eye": [5, 17, -50], "lookAt": [-0.4, 6.6, 0], "fieldOfView": 25.5, "lens": {"radius": 0.25, "focusDistance": 50}},
        "shading": {"model": "physical", "background": linear(0.2, 0.2, 0.21)},
        "display": {"exposure": 0.5, "tone": "filmic"},
        "textures": {"hammered": {"file": "../textures/hammered.png", "encoding": "linear"}, "slate": {"file": "../textures/slate.png", "encoding": "linear"}},
        "materials": {
            "wall": {"type": "matte", "color": linear(0.24, 0.25, 0.23)},
            "slate": {"type": "bump", "of": {"type": "coated", "color": linear(0.06, 0.065, 0.075), "roughness": 0.5}, "map": {"texture": "slate"}, "height": 0.14},
            "copper": {"type": "bump", "of": {"type": "glossy", "metal": "copper", "roughness": 0.2}, "map": {"texture": "hammered"}, "height": 0.1},
            "polished copper": {"type": "glossy", "metal": "copper", "roughness": 0.17},
            "brass": {"type": "glossy", "metal": "brass", "roughness": 0.22},
            "old brass": {"type": "glossy", "metal": "brass", "color": linear(0.8, 0.74, 0.66), "roughness": 0.38},
            "pewter": {"type": "glossy", "metal": "nickel", "color": linear(0.86, 0.86, 0.9), "roughness": 0.36},
            "walnut": {"type": "coated", "color": linear(0.09, 0.045, 0.02), "roughness": 0.35},
            "red lacquer": {"type": "coated", "color": linear(0.42, 0.03, 0.018), "roughness": 0.12},
            "black lacquer": {"type": "coated", "color": linear(0.012, 0.011, 0.011), "roughness": 0.12},
            "nut": {"type": "coated", "color": linear(0.3, 0.14, 0.05), "roughness": 0.4},
        },
        "meshes": models(*names, crease=45),
        "lights": [
            {"type": "rectangle", "corners": [[-44, 4, 20], [-44, 42, 20], [-36, 42, -22], [-36, 4, -22]], "color": "#fff4e4", "radiance": 4.5},
            {"type": "rectangle", "corners": [[31, 12, 22], [31, 34, 22], [40, 34, 6], [40, 12, 6]], "color": "#ffd9a8", "radiance": 5},
        ],
        "objects": objects,
        "render": {"method": "raytrace", "antialias": 8},
    })


if __name__ == "__main__":
    if sys.argv[1:] != ["scene"]:
        png("hammered", 256, 256, hammered)
        png("slate", 256, 256, slate)
        write_models()
    write_scene()
