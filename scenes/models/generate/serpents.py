"""scenes/serpents.json, a knotted serpent in five materials: python3 scenes/models/generate/serpents.py"""
import math
import sys

from files import linear, mesh, scene
from geometry import Mesh, cross, frame, grid, lathe


def serpent(along=720, around=40):
    """A body of scales along a knot, thick in its middle, thin at the tail, with a head that rests on its coils."""
    last = 0.955

    def centre(t):
        a = 2 * math.pi * t
        wide = 2.0 + 0.75 * math.cos(3 * a)
        return (wide * math.cos(2 * a), 0.85 * math.sin(3 * a) + 1.45 + 0.35 * math.sin(a), wide * math.sin(2 * a))

    points = [centre(last * k / along) for k in range(along + 1)]
    s, rows = None, []
    for k, p in enumerate(points):
        a, b = points[max(0, k - 1)], points[min(along, k + 1)]
        t = [y - x for x, y in zip(a, b)]
        m = math.sqrt(sum(c * c for c in t))
        t = [c / m for c in t]
        if s is None:
            s, _ = frame(t)
        dot = sum(x * y for x, y in zip(s, t))
        s = [x - dot * y for x, y in zip(s, t)]
        m = math.sqrt(sum(c * c for c in s))
        s = [c / m for c in s]
        rows.append((p, s, cross(t, s)))

    def radius(v):
        body = 0.5 * min(1.0, (v / 0.55) ** 0.7)
        neck = 1 - 0.35 * math.exp(-(((v - 0.93) / 0.03) ** 2))
        head = 1 + 0.35 * math.exp(-(((v - 0.972) / 0.016) ** 2))
        nose = math.sqrt(max(0.0, (1 - v) / 0.03)) if v > 0.97 else 1.0
        return body * neck * head * min(1.0, nose)

    def at(u, v):
        p, s, b = rows[round(v * along)]
        scale = abs(math.sin(11 * math.pi * u + 70 * math.pi * v)) * abs(math.sin(11 * math.pi * u - 70 * math.pi * v))
        fade = min(1.0, 25 * v) * min(1.0, max(0.0, 22 * (0.965 - v)))
        r = radius(v) * (1 + 0.11 * fade * scale ** 0.6)
        c, d = r * math.cos(2 * math.pi * u), r * math.sin(2 * math.pi * u)
        return tuple(p[i] + c * s[i] + d * b[i] for i in range(3))

    return grid(around * 2, along, at, closed_u=True)


def write_models():
    serpent().write("serpent")
    lathe([(0.0, 0.0), (3.55, 0.0), (3.6, 0.05), (3.6, 0.4), (3.5, 0.5), (3.45, 0.62), (3.35, 0.66), (0.0, 0.66)], 128).write("plinth")


def write_scene():
    objects = [
        {"name": "floor", "type": "mesh", "mesh": "sweep", "material": "paper"},
    ]
    for x, z, turn, material in ((-11.6, 7.0, 65, "clay"), (-7.0, -0.4, 80, "lacquer"), (0.8, -3.4, 150, "gold"), (8.2, -0.6, 215, "jade"), (12.4, 7.2, 290, "glass")):
        objects += [mesh("plinth", "stone", at=(x, 0.01, z)), mesh("serpent", material, scale=1.18, rotate=[0, turn, 0], at=(x, 0.74, z))]
    scene("serpents", "One knotted serpent in five materials: clay, lacquer, gold, jade and glass.\nModels: scenes/models/generate/serpents.py.", {
        "name": "Five serpents",
        "image": {"width": 1280, "height": 720},
        "camera": {"type": "perspective", "eye": [0, 10.5, -36], "lookAt": [0.5, 1.9, 0], "fieldOfView": 24},
        "shading": {"model": "physical", "background": linear(0.20, 0.21, 0.23)},
        "display": {"exposure": 0.1, "tone": "filmic"},
        "materials": {
            "paper": {"type": "matte", "color": linear(0.24, 0.26, 0.28)},
            "stone": {"type": "coated", "color": linear(0.05, 0.05, 0.055), "roughness": 0.4},
            "clay": {"type": "matte", "color": linear(0.50, 0.27, 0.17), "roughness": 0.5},
            "lacquer": {"type": "coated", "color": linear(0.42, 0.025, 0.02), "roughness": 0.26, "nonlinear": True},
            "gold": {"type": "glossy", "metal": "gold", "roughness": 0.27},
            "jade": {"type": "scattering", "color": linear(0.30, 0.62, 0.40), "meanFreePath": [0.25, 0.4, 0.3]},
            "glass": {"type": "glass", "color": "#ffffff", "indexOfRefraction": 1.5, "absorption": [0.22, 0.06, 0.03], "smoothRefraction": True},
        },
        "meshes": {"serpent": {"file": "models/serpent.ply", "normals": "smooth"}, "plinth": {"file": "models/plinth.ply", "normals": "smooth", "crease": 40},
                   "sweep": {"file": "models/sweep.ply", "normals": "smooth"}},
        "lights": [
            {"type": "rectangle", "corners": [[-22, 12, -16], [-19, 24, -4], [-3, 24, -8], [-6, 12, -20]], "color": "#fff4e4", "radiance": 6.5},
            {"type": "rectangle", "corners": [[14, 15, 20], [14, 22, 20], [26, 22, 12], [26, 15, 12]], "color": "#d8e6ff", "radiance": 9},
        ],
        "objects": objects,
        "render": {"method": "raytrace", "antialias": 8},
    })


def write_sweep():
    """A backdrop that bends upwards behind the subject, without an edge."""
    line = [(-40, 0.0)] + [(14 + 12 * math.sin(math.radians(a)), 12 - 12 * math.cos(math.radians(a))) for a in range(0, 91, 5)] + [(26, 60)]
    m = Mesh()
    for z, y in line:
        m.vertex((-90, y, z))
        m.vertex((90, y, z))
    for k in range(len(line) - 1):
        m.quad(2 * k, 2 * k + 2, 2 * k + 3, 2 * k + 1)
    m.write("sweep")


if __name__ == "__main__":
    if sys.argv[1:] != ["scene"]:
        write_models()
        write_sweep()
    write_scene()
