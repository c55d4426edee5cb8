"""scenes/terrace.json, a terrace at a low sun: python3 scenes/models/generate/terrace.py"""
import math
import sys

from files import linear, mesh, models, png, scene
from geometry import Mesh, Random, arc, grid, lathe, noise, planar, rounded_box, spline, tube, turbulence


def leaf(px, py, size=256):
    """A vine leaf of five lobes, its base in the middle below: (inside, shade of its veins)."""
    x, y = 2 * (px + 0.5) / size - 1, 0.9 - 1.9 * (py + 0.5) / size
    r, a = math.hypot(x, y), math.atan2(x, y)
    lobes = 0.62 + 0.22 * math.cos(5 * a) * (1 if abs(a) < 2.6 else 0.4) + 0.16 * math.cos(a) + 0.02 * math.sin(43 * a)
    if abs(a) > 2.75:
        lobes *= max(0.1, 1 - 2.2 * (abs(a) - 2.75))
    inside = max(0.0, min(1.0, (lobes - r) * size / 4 + 0.5))
    vein = min(abs(r * math.sin(a - k * 2 * math.pi / 5)) + (9 if math.cos(a - k * 2 * math.pi / 5) < 0 else 0) for k in range(-2, 3))
    return inside, max(0.0, 1 - vein * 34)


def leaf_color(px, py):
    _, vein = leaf(px, py)
    t = 0.5 + 0.5 * turbulence(px / 40, py / 40, 0, 3, 4)
    base = (0.25 + 0.12 * t, 0.44 + 0.10 * t, 0.12 + 0.03 * t)
    return tuple(b + (v - b) * 0.6 * vein for b, v in zip(base, (0.55, 0.66, 0.3)))


def stone(px, py, size=512, slabs=4):
    """Slabs of warm stone with joints, each of its own shade."""
    u, v = px / size * slabs, py / size * slabs
    u += 0.5 * (math.floor(v) % 2)
    i, j = math.floor(u) % slabs, math.floor(v)
    edge = min(u % 1, 1 - u % 1, v % 1, 1 - v % 1) + 0.008 * noise(px / 9, py / 9, 0, 3)
    shade = 0.5 + 0.12 * noise(i + 0.5, j + 0.5, 0.5, 12) + 0.10 * turbulence(px / 30, py / 30, 0, 4, 6)
    if edge < 0.018:
        shade *= 0.5
    return tuple(max(0.03, min(1.0, c * shade * 2)) for c in (0.66, 0.58, 0.49))


def write_models():
    # A card for a leaf: bent along its middle, with its base at the origin and its tip at +y.
    card = Mesh()
    for j in range(5):
        for i in range(5):
            u, v = i / 4, j / 4
            x = 2 * u - 1
            card.vertex((x, 1.9 * v - 1.0, 0.35 * abs(x) + 0.25 * (v - 0.3) ** 2), u, v)
    for j in range(4):
        for i in range(4):
            card.quad(5 * j + i, 5 * j + i + 1, 5 * j + i + 6, 5 * j + i + 5)
    card.write("vine-leaf", True)
    pot = [(0.0, 0.0), (1.5, 0.0), (1.6, 0.1), (2.1, 2.9), (2.35, 2.95), (2.45, 3.1), (2.5, 3.7), (2.4, 3.8), (2.2, 3.75), (2.1, 3.2), (0.0, 3.1)]
    lathe(pot, 72).write("pot")
    column = [(0.0, 0.0), (0.62, 0.0), (0.62, 0.25)] + arc(0.52, 0.36, 0.11, -60, 70, 6) + [(0.4, 0.6), (0.36, 0.9), (0.5, 1.5), (0.56, 2.0), (0.48, 2.6), (0.3, 3.3), (0.28, 3.6)]
    column += arc(0.32, 3.72, 0.1, -80, 80, 6) + [(0.5, 3.95), (0.5, 4.1), (0.0, 4.1)]
    lathe(column, 48).write("baluster")
    legs = Mesh()
    for k in range(3):
        a = 2 * math.pi * k / 3 + 0.4
        c, s = math.cos(a), math.sin(a)
        curve = spline([(0.15 * c, 5.6, 0.15 * s), (0.2 * c, 3.2, 0.2 * s), (0.5 * c, 1.6, 0.5 * s), (1.9 * c, 0.1, 1.9 * s)], 10)
        legs.add(tube(curve, [0.12] * len(curve), 10))
    legs.add(lathe([(0.0, 5.6), (2.75, 5.6), (2.8, 5.65), (2.8, 5.8), (2.75, 5.85), (0.0, 5.85)], 72))
    legs.write("bistro-table")
    carafe = spline([(0.0, 0.0), (0.9, 0.0), (1.0, 0.15), (1.05, 1.2), (0.7, 2.1), (0.42, 2.7), (0.4, 3.1), (0.55, 3.5)], 7)
    lathe([(r if k else 0.0, y) for k, (r, y) in enumerate(carafe)], 64).write("carafe")
    lathe([(0.0, 0.1), (0.85, 0.1), (0.95, 0.2), (1.0, 1.1), (0.92, 1.4), (0.0, 1.4)], 64).write("lemonade")
    ball = grid(48, 24, lambda u, v: tuple(
        (0.5 + 0.008 * noise(40 * u, 40 * v, 0, 2)) * q * s for q, s in zip(
            (math.cos(math.pi * (v - 0.5)) * math.cos(2 * math.pi * u), math.sin(math.pi * (v - 0.5)), math.cos(math.pi * (v - 0.5)) * math.sin(2 * math.pi * u)), (1, 1.0, 1))), closed_u=True)
    ball.write("orange")


def write_scene():
    random = Random(31)
    objects = [
        {"name": "floor", "type": "mesh", "mesh": "floor", "material": "stone"},
    ]
    # The balustrade at the back, with its rail, and the pillar and beam that the vine grows on.
    for k in range(-9, 12):
        objects.append(mesh("baluster", "marble", at=(1.7 * k, 0.6, 14)))
    objects += [
        {"type": "box", "min": [-20, 0, 13.2], "max": [22, 0.6, 14.8], "material": "marble"},
        {"type": "box", "min": [-20, 4.7, 13.1], "max": [22, 5.3, 14.9], "material": "marble"},
        {"type": "box", "min": [-13.2, 0, 1.0], "max": [-11.4, 16, 2.8], "material": "plaster"},
        {"type": "box", "min": [-30, 12.6, 1.4], "max": [30, 13.4, 2.4], "material": "beam"},
        {"type": "box", "min": [-30, 12.8, 7.4], "max": [30, 13.4, 8.2], "material": "beam"},
        mesh("pot", "terracotta", at=(-8.6, 0.01, 10.2)), mesh("pot", "terracotta", scale=0.75, at=(-5.2, 0.01, 8.6)), mesh("pot", "terracotta", scale=1.1, at=(14.0, 0.01, 10)),
        mesh("bistro-table", "iron", at=(4.2, 0.01, 1.5)),
        mesh("carafe", "pane", at=(3.4, 5.87, 1.9)), mesh("lemonade", "lemonade", at=(3.4, 5.87, 1.9)),
        mesh("orange", "orange", at=(5.0, 6.36, 0.9)), mesh("orange", "orange", rotate=[40, 60, 0], at=(5.9, 6.36, 1.5)), mesh("orange", "orange", rotate=[10, 20, 0], at=(5.2, 6.36, 2.2)),
        mesh("orange", "orange", rotate=[70, 20, 0], at=(5.35, 7.1, 1.55)),
    ]

    def leaves(count, place, size, down):
        out = []
        for _ in range(count):
            x, y, z = place()
            out.append({"type": "mesh", "mesh": "vine-leaf", "material": "leaf" if random.next() < 0.75 else "leaf light",
                        "transform": [{"scale": size * random.between(0.7, 1.25)}, {"rotate": [random.between(-75, 20) + down, random.between(0, 360), random.between(-25, 25)]}, {"translate": [x, y, z]}]})
        return out

    def along():
        x = random.between(-14, 12)
        low = 1.6 + 1.6 * max(0.0, noise(x / 2.2, 0.5, 0, 5)) + (4.2 if x < -9 else 0)
        return x, 13.6 - low * random.next() ** 1.6, random.between(0.6, 3.2)

    def bush(cx, cy, cz, r):
        def of():
            a, b, s = random.between(0, 6.28), random.between(-0.4, 1.5), random.next() ** 0.4
            return cx + r * s * math.cos(a) * math.cos(b), cy + r * s * math.sin(b), cz + r * s * math.sin(a) * math.cos(b)
        return of

    groups = {"vine": leaves(520, along, 0.62, -70), "bush": leaves(170, bush(0, 1.2, 0, 2.2), 0.5, 0)}
    # Hills and the sea before them, from the scene of dandelions.
    objects += [
        {"type": "rectangle", "corners": [[-60000, -60, 60000], [60000, -60, 60000], [60000, -60, 60], [-60000, -60, 60]], "material": "sea"},
        {"type": "mesh", "mesh": "far-hills", "material": "hill", "transform": [{"scale": [1.4, 1.6, 1]}, {"translate": [180, -60, 620]}]},
        {"type": "mesh", "mesh": "far-hills", "material": "far hill", "transform": [{"scale": [-2.6, 3.4, 1]}, {"translate": [-260, -60, 1100]}]},
    ]
    objects += [{"type": "group", "group": "vine"}]
    for x, y, z, s in ((-8.6, 3.2, 10.2, 1.1), (-5.2, 2.4, 8.6, 0.8), (14.0, 3.6, 10, 1.3)):
        objects.append({"type": "group", "group": "bush", "transform": [{"scale": s}, {"rotate": [0, 90 * x, 0]}, {"translate": [x, y, z]}]})
    scene("terrace", "A terrace at a low sun: a clear sky, and a vine whose leaves are cut out of cards by a mask.\n"
          "Models and textures: scenes/models/generate/terrace.py.", {
        "name": "A terrace at a low sun",
        "image": {"width": 1280, "height": 720},
        "camera": {"type": "perspective", "eye": [7.0, 9.2, -23], "lookAt": [0.8, 6.0, 0], "fieldOfView": 33},
        "shading": {"model": "physical", "background": {"type": "sky", "elevation": 16, "azimuth": 118, "turbidity": 3.2, "groundAlbedo": [0.06, 0.08, 0.09]}},
        "display": {"exposure": 0.9, "tone": "filmic"},
        "textures": {
            "leaf": {"file": "../textures/leaf.png"},
            "leaf shape": {"file": "../textures/leaf-shape.png", "encoding": "linear"},
            "stone": {"file": "../textures/stone.png"},
        },
        "materials": {
            "stone": {"type": "matte", "color": {"texture": "stone"}, "roughness": 0.4},
            "marble": {"type": "matte", "color": linear(0.62, 0.58, 0.52)},
            "plaster": {"type": "matte", "color": linear(0.58, 0.44, 0.33), "roughness": 0.5},
            "sea": {"type": "coated", "color": linear(0.02, 0.05, 0.06), "roughness": 0.45},
            "hill": {"type": "matte", "color": linear(0.08, 0.11, 0.07)},
            "far hill": {"type": "matte", "color": linear(0.18, 0.23, 0.26)},
            "beam": {"type": "matte", "color": linear(0.20, 0.13, 0.08)},
            "terracotta": {"type": "matte", "color": linear(0.42, 0.17, 0.09), "roughness": 0.4},
            "iron": {"type": "coated", "color": linear(0.03, 0.06, 0.05), "roughness": 0.4},
            "orange": {"type": "coated", "color": linear(0.75, 0.27, 0.03), "roughness": 0.45},
            "pane": {"type": "glass", "color": "#ffffff", "indexOfRefraction": 1.5},
            "lemonade": {"type": "scattering", "scatteringCoefficient": 0.5, "absorptionCoefficient": [0.02, 0.06, 0.5]},
            "leaf paint": {"type": "coated", "color": {"texture": "leaf"}, "roughness": 0.5},
            "leaf matte": {"type": "matte", "color": {"texture": "leaf"}},
            "leaf": {"type": "mask", "of": "leaf paint", "map": {"texture": "leaf shape"}},
            "leaf light": {"type": "mask", "of": "leaf matte", "map": {"texture": "leaf shape"}},
        },
        "meshes": {**models("pot", "baluster", "bistro-table", "carafe", "lemonade", "orange"), "vine-leaf": {"file": "models/vine-leaf.ply", "normals": "smooth"},
                   "far-hills": {"file": "models/far-hills.ply", "normals": "smooth"},
                   "floor": {"file": "models/terrace-floor.ply", "normals": "flat"}},
        "groups": groups,
        "objects": objects,
        "render": {"method": "raytrace", "antialias": 8},
    })


def write_floor():
    m = Mesh()
    for x, z in ((-40, -40), (-40, 16), (40, 16), (40, -40)):
        m.vertex((x, 0, z), x / 14, z / 14)
    m.quad(0, 1, 2, 3)
    m.write("terrace-floor", True)


if __name__ == "__main__":
    if sys.argv[1:] != ["scene"]:
        png("leaf", 256, 256, leaf_color)
        png("leaf-shape", 256, 256, lambda x, y: leaf(x, y)[0])
        png("stone", 512, 512, stone)
        write_models()
        write_floor()
    write_scene()
