"""scenes/lanterns.json, three hundred lanterns on a lake: python3 scenes/models/generate/lanterns.py"""
import math
import sys

from files import linear, mesh, png, scene
from geometry import Mesh, Random, grid, lathe, noise, rounded_box, tube, turbulence


def waves(px, py, size=512):
    """Ripples that repeat: sums of waves whose lengths divide the picture."""
    u, v = 2 * math.pi * px / size, 2 * math.pi * py / size
    h = 0.0
    for k, (i, j, p) in enumerate(((3, 5, 0.3), (-4, 7, 1.1), (7, 9, 2.0), (-9, 14, 0.7), (13, 17, 4.0), (-15, 23, 5.2), (21, 26, 2.4), (4, 31, 3.3))):
        h += math.sin(i * u + j * v + p + 0.8 * math.sin(2 * u + v + k)) / (1 + 0.35 * k)
    return 0.5 + 0.11 * h


def write_models():
    # A paper lantern: four bulging sides, open above, on a wooden raft.
    def at(u, v):
        a = 2 * math.pi * u
        p = 4.5
        r = 0.42 / (abs(math.cos(a)) ** p + abs(math.sin(a)) ** p) ** (1 / p)
        r *= 0.86 + 0.14 * math.sin(math.pi * (0.15 + 0.7 * v))
        return (r * math.cos(a), 0.1 + 0.95 * v, r * math.sin(a))

    grid(64, 10, at, closed_u=True).write("lantern-paper")
    frame = rounded_box(1.05, 0.09, 1.05, 0.03, 2).moved(lambda p: (p[0], p[1] + 0.04, p[2]))
    for x in (-0.375, 0.375):
        for z in (-0.375, 0.375):
            frame.add(rounded_box(0.04, 1.05, 0.04, 0.01, 1), lambda p, x=x, z=z: (p[0] + x, p[1] + 0.58, p[2] + z))
    for y in (0.12, 1.06):
        for turn in range(4):
            a = math.pi / 2 * turn
            frame.add(rounded_box(0.8, 0.035, 0.03, 0.008, 1), lambda p, a=a, y=y: (
                math.cos(a) * p[0] + math.sin(a) * (p[2] + 0.385), p[1] + y, math.cos(a) * (p[2] + 0.385) - math.sin(a) * p[0]))
    frame.write("lantern-frame")
    # Hills on the other shore, and a boat.
    for name, seed, high in (("hills-near", 4, 9), ("hills-far", 9, 17)):
        m = grid(160, 6, lambda u, v: (240 * (u - 0.5), -1 + (high * (0.35 + 0.45 * turbulence(5 * u, 0.5, 0, 4, seed) + 0.3 * math.sin(3 * u + seed) ** 2) + 1) * v, -14 * (1 - v) ** 2 + 2 * noise(60 * u, 4 * v, 0, seed)))
        m.write(name)

    def hull(u, v):
        a = math.pi * (v - 0.5)
        x = 5.2 * (2 * u - 1)
        w = 1.05 * (1 - (2 * u - 1) ** 2) ** 0.7 + 0.02
        lift = 0.55 * abs(2 * u - 1) ** 3
        return (x, 0.75 - 0.95 * math.cos(a) + lift, w * math.sin(a))

    boat = grid(48, 16, hull)
    for x in (-1.8, 0.2, 2.1):
        boat.add(rounded_box(0.5, 0.08, 1.75, 0.02, 1), lambda p, x=x: (p[0] + x, p[1] + 0.55, p[2]))
    boat.add(tube([(-0.6, 0.9, -0.5), (2.4, 0.62, -4.4)], [0.05, 0.05], 10))
    boat.write("boat")
    jetty = Mesh()
    for k in range(26):
        jetty.add(rounded_box(4.2, 0.16, 0.62, 0.03, 1), lambda p, k=k: (p[0] - 8.6 + 0.05 * math.sin(9 * k), p[1] + 1.1, p[2] - 19 + 0.68 * k))
    for z in (-12, -7.5, -3):
        for x in (-10.3, -6.9):
            jetty.add(lathe([(0.0, 2.2), (0.2, 2.15), (0.22, 2.0), (0.22, -1), (0.0, -1)], 20), lambda p, x=x, z=z: (p[0] + x, p[1], p[2] + z))
    jetty.write("jetty")


def write_scene():
    random, spots = Random(77), []
    while len(spots) < 300:
        share = random.next()
        z = -11 + 105 * share**1.5
        x = (random.next() - 0.46) * (15 + 0.95 * (z + 16)) + 6 * math.sin(z / 13)
        near = math.hypot(x - 2.0, (z - 9) / 0.8)
        if x < -4.6 and z < 0 or near < 6.0 or any(math.hypot(x - a, z - b) < 1.7 for a, b in spots):
            continue
        spots.append((x, z))
    objects = [
        {"name": "lake", "type": "mesh", "mesh": "lake", "material": "water"},
        mesh("hills-near", "hill", at=(0, 0, 120)), mesh("hills-far", "far hill", at=(-20, 0, 190), scale=[1.6, 1.2, 1]),
        mesh("boat", "boat", rotate=[0, 28, 0], at=(2.6, 0, 9)), mesh("jetty", "jetty"),
    ]
    for k, (x, z) in enumerate(spots):
        objects.append({"type": "group", "group": "lantern" if k % 4 else "pale lantern",
                        "transform": [{"rotate": [random.between(-3, 3), random.between(0, 90), random.between(-3, 3)]}, {"translate": [x, 0.03, z]}]})
    for x, y, z in ((2.0, 0.66, 8.6), (4.5, 0.66, 7.6), (-7.4, 1.2, -9.0)):
        objects.append({"type": "group", "group": "lantern", "transform": [{"rotate": [0, 31, 0]}, {"translate": [x, y, z]}]})
    scene("lanterns", "Three hundred lanterns on a lake after sunset: each is a light of its own, and is seen once more in the ripples.\n"
          "Models and textures: scenes/models/generate/lanterns.py.", {
        "name": "Three hundred lanterns",
        "image": {"width": 1280, "height": 720},
        "camera": {"type": "perspective", "eye": [-1.5, 5.4, -24], "lookAt": [0.6, 2.3, 8], "fieldOfView": 34},
        "shading": {"model": "physical", "background": {"type": "sky", "elevation": 4, "azimuth": 20, "turbidity": 3, "radiance": [0.20, 0.15, 0.34], "sun": False}},
        "display": {"exposure": 0.5, "tone": "filmic"},
        "textures": {"waves": {"file": "../textures/waves.png", "encoding": "linear"}},
        "materials": {
            "water": {"type": "bump", "of": {"type": "coated", "color": linear(0.006, 0.012, 0.016), "roughness": 0.16, "indexOfRefraction": 1.33}, "map": {"texture": "waves"}, "height": 0.07},
            "hill": {"type": "matte", "color": linear(0.03, 0.04, 0.04)},
            "far hill": {"type": "matte", "color": linear(0.07, 0.08, 0.10)},
            "boat": {"type": "coated", "color": linear(0.16, 0.08, 0.04), "roughness": 0.45},
            "jetty": {"type": "matte", "color": linear(0.22, 0.16, 0.11), "roughness": 0.5},
            "frame": {"type": "matte", "color": linear(0.12, 0.06, 0.03)},
            "paper": {"type": "matte", "color": linear(0.7, 0.5, 0.3), "radiance": [1.5, 0.5, 0.12]},
            "pale paper": {"type": "matte", "color": linear(0.7, 0.6, 0.45), "radiance": [1.4, 0.72, 0.28]},
        },
        "meshes": {"lantern-frame": {"file": "models/lantern-frame.ply", "normals": "flat"},
                   "lake": {"file": "models/lake.ply", "normals": "flat"}, "hills-near": {"file": "models/hills-near.ply", "normals": "smooth"}, "hills-far": {"file": "models/hills-far.ply", "normals": "smooth"},
                   "boat": {"file": "models/boat.ply", "normals": "smooth", "crease": 40}, "jetty": {"file": "models/jetty.ply", "normals": "smooth", "crease": 40}},
        "groups": {n: [mesh("lantern-frame", "frame"), *[{"type": "rectangle", "corners": c, "material": p} for c in SIDES]] for n, p in (("lantern", "paper"), ("pale lantern", "pale paper"))},
        "objects": objects,
        "render": {"method": "raytrace", "antialias": 8},
    })


SIDES = [
    [[-0.36, 0.12, -0.36], [-0.36, 1.04, -0.36], [0.36, 1.04, -0.36], [0.36, 0.12, -0.36]],
    [[-0.36, 0.12, 0.36], [-0.36, 1.04, 0.36], [0.36, 1.04, 0.36], [0.36, 0.12, 0.36]],
    [[-0.36, 0.12, -0.36], [-0.36, 1.04, -0.36], [-0.36, 1.04, 0.36], [-0.36, 0.12, 0.36]],
    [[0.36, 0.12, -0.36], [0.36, 1.04, -0.36], [0.36, 1.04, 0.36], [0.36, 0.12, 0.36]],
]


def write_lake():
    m = Mesh()
    for x, z in ((-200, -40), (-200, 240), (200, 240), (200, -40)):
        m.vertex((x, 0, z), x / 11, z / 11)
    m.quad(0, 1, 2, 3)
    m.write("lake", True)


if __name__ == "__main__":
    if sys.argv[1:] != ["scene"]:
        png("waves", 512, 512, waves)
        write_models()
        write_lake()
    write_scene()
