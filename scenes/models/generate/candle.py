"""scenes/candle.json, a candle in fog at a window: python3 scenes/models/generate/candle.py"""
import math
import sys

from files import linear, mesh, models, scene
from geometry import Mesh, Random, arc, grid, lathe, noise, rounded_box, spline, tube


def write_models():
    def wax(u, v):
        a = 2 * math.pi * u
        profile = [(0.0, 0.0), (0.92, 0.0), (0.95, 0.05), (0.93, 1.2), (0.92, 2.4), (0.91, 3.5), (0.9, 4.05), (0.84, 4.12), (0.74, 4.05), (0.66, 3.75), (0.4, 3.62), (0.0, 3.6)]
        k = v * (len(profile) - 1)
        i = min(int(k), len(profile) - 2)
        r, y = (p + (q - p) * (k - i) for p, q in zip(profile[i], profile[i + 1]))
        if y > 3.55 and r > 0.6:
            y += 0.22 * noise(2 * math.cos(a), 2 * math.sin(a), 0.5, 3) - 0.1
        drip = max(0.0, noise(3.2 * math.cos(a) + 4, 3.2 * math.sin(a), 0.35 * y, 8))
        if 0.3 < y < 4.0 and r > 0.85:
            r += 0.16 * drip
        return (r * math.cos(a), y, r * math.sin(a))

    grid(128, 55, wax, closed_u=True).write("candle-wax")
    wick = spline([(0.0, 3.55, 0.0), (0.01, 3.85, 0.0), (0.06, 4.08, 0.02)], 8)
    tube(wick, [0.045] * len(wick), 10).write("candle-wick")
    flame = [(0.0, 3.92)] + spline([(0.1, 3.97), (0.19, 4.15), (0.2, 4.35), (0.13, 4.7), (0.05, 5.0), (0.012, 5.12)], 5) + [(0.0, 5.16)]
    lathe(flame, 32).write("candle-flame")
    dish = [(0.0, 0.1), (1.6, 0.1), (1.9, 0.18), (2.2, 0.42)] + arc(2.26, 0.44, 0.06, 150, -30, 5) + [(2.0, 0.12), (1.7, 0.0), (0.0, 0.0)]
    m = lathe(dish, 96)
    ring = [(2.75 + 0.5 * math.cos(a), 0.36 + 0.5 * math.sin(a) * 0.9, 0.0) for a in [2 * math.pi * k / 40 for k in range(40)]]
    m.add(tube(ring, [0.09] * 40, 14, closed=True))
    m.write("candle-dish")
    # The window: a frame of two sashes with six panes each, and a sill.
    w = Mesh()
    for x in (-6.2, -3.1, 0.0, 3.1, 6.2):
        w.add(rounded_box(0.5 if x in (-6.2, 0.0, 6.2) else 0.22, 11.0, 0.5, 0.07, 3), lambda p, x=x: (p[0] + x, p[1] + 5.5, p[2]))
    for y in (0.2, 3.7, 7.2, 10.8):
        w.add(rounded_box(12.8, 0.5 if y in (0.2, 10.8) else 0.22, 0.46, 0.07, 3), lambda p, y=y: (p[0], p[1] + y, p[2]))
    w.write("window-frame")
    rounded_box(17, 0.5, 4.6, 0.12, 3).write("window-sill")
    rounded_box(3.0, 0.62, 2.1, 0.09, 3).write("book")
    apple = [(0.0, 0.12)] + spline([(0.28, 0.02), (0.62, 0.12), (0.95, 0.6), (1.0, 1.05), (0.82, 1.5), (0.45, 1.66), (0.16, 1.52)], 6) + [(0.0, 1.42)]
    m = lathe(apple, 64)
    m.write("apple")
    tube([(0.0, 1.4, 0.0), (0.05, 1.7, 0.02), (0.16, 1.95, 0.03)], [0.05, 0.04, 0.06], 10).write("apple-stalk")


def write_scene():
    random = Random(5)
    objects = [
        mesh("window-frame", "paint", at=(0.6, 0, 3.4)),
        mesh("window-sill", "paint", at=(0.6, -0.26, 1.6)),
        {"name": "wall below", "type": "box", "min": [-16, -9, 1.2], "max": [16, -0.5, 3.4], "material": "plaster"},
        {"name": "wall left", "type": "box", "min": [-16, -9, 2.4], "max": [-5.7, 14, 3.6], "material": "plaster"},
        {"name": "wall right", "type": "box", "min": [6.9, -9, 2.4], "max": [16, 14, 3.6], "material": "plaster"},
        {"name": "wall above", "type": "box", "min": [-16, 10.9, 2.4], "max": [16, 18, 3.6], "material": "plaster"},
        mesh("candle-dish", "brass", rotate=[0, 200, 0], at=(-1.7, 0.01, 0.7)), mesh("candle-wax", "wax", at=(-1.7, 0.12, 0.7)),
        mesh("candle-wick", "wick", at=(-1.7, 0.12, 0.7)), mesh("candle-flame", "flame", at=(-1.7, 0.12, 0.7)),
        mesh("book", "red cloth", rotate=[0, 12, 0], at=(3.2, 0.33, 0.9)), mesh("book", "blue cloth", scale=[0.92, 0.8, 0.95], rotate=[0, -7, 0], at=(3.3, 0.9, 0.95)),
        mesh("apple", "apple", scale=0.62, rotate=[8, 30, 0], at=(3.1, 1.17, 0.8)), mesh("apple-stalk", "wick", scale=0.62, rotate=[8, 30, 0], at=(3.1, 1.17, 0.8)),
        {"name": "garden", "type": "rectangle", "corners": [[-90, -12, 5], [-90, -12, 140], [90, -12, 140], [90, -12, 5]], "material": "meadow"},
        # The evening sky: light from infinitely far would not come through this air.
        {"name": "evening sky", "type": "rectangle", "corners": [[-260, -60, 170], [-260, 160, 170], [260, 160, 170], [260, -60, 170]], "material": "sky"},
    ]
    # Trees in the mist outside: bare trunks with a few boughs.
    for k in range(16):
        x, z = random.between(-42, 46), random.between(26, 100)
        high, thick = random.between(22, 36), random.between(0.4, 0.9)
        lean = random.between(-2.5, 2.5)
        objects.append({"type": "cone", "base": [x, -12, z], "radius": thick, "apex": [x + lean, high - 12, z], "topRadius": 0.08, "material": "bark"})
        for _ in range(7):
            s = random.between(0.3, 0.85)
            side, out = random.between(-1, 1), (1 - s) * random.between(7, 14)
            a = 1 if side > 0 else -1
            bx, by = x + lean * s, -12 + high * s
            objects.append({"type": "cone", "base": [bx, by, z], "radius": thick * (1 - s) * 0.55, "apex": [bx + a * out, by + out * random.between(0.5, 1.1), z + random.between(-4, 4)], "topRadius": 0.04, "material": "bark"})
    scene("candle", "A candle at a window on a foggy evening: its light in the haze of the room and in its own wax.\nModels: scenes/models/generate/candle.py.", {
        "name": "A candle in fog",
        "image": {"width": 1280, "height": 720},
        "camera": {"type": "perspective", "eye": [-0.3, 4.6, -16], "lookAt": [0.5, 3.5, 1.5], "fieldOfView": 31},
        "shading": {"model": "physical", "medium": {"scatteringCoefficient": 0.004, "absorptionCoefficient": 0.002, "anisotropy": 0.5}},
        "display": {"exposure": 0.9, "tone": "filmic"},
        "materials": {
            "paint": {"type": "coated", "color": linear(0.52, 0.50, 0.45), "roughness": 0.45},
            "plaster": {"type": "matte", "color": linear(0.38, 0.30, 0.24)},
            "brass": {"type": "glossy", "metal": "brass", "roughness": 0.3},
            "wax": {"type": "scattering", "color": linear(0.74, 0.58, 0.38), "meanFreePath": [0.42, 0.32, 0.22]},
            "wick": {"type": "matte", "color": linear(0.04, 0.03, 0.025)},
            "flame": {"type": "matte", "color": "#000000", "radiance": [46, 22, 6.5]},
            "sky": {"type": "matte", "color": "#000000", "radiance": [0.2, 0.37, 0.72]},
            "red cloth": {"type": "matte", "color": linear(0.30, 0.05, 0.04)},
            "blue cloth": {"type": "matte", "color": linear(0.05, 0.10, 0.18)},
            "apple": {"type": "coated", "color": linear(0.42, 0.09, 0.04), "roughness": 0.3},
            "meadow": {"type": "matte", "color": linear(0.10, 0.12, 0.07)},
            "bark": {"type": "matte", "color": linear(0.08, 0.07, 0.06)},
        },
        "meshes": models("candle-wax", "candle-wick", "candle-flame", "candle-dish", "window-frame", "window-sill", "book", "apple", "apple-stalk", crease=50),
        # The rest of the room: what a wall in the candle's light sends back.
        "lights": [{"type": "rectangle", "corners": [[-14, -4, -30], [-14, 16, -30], [14, 16, -30], [14, -4, -30]], "color": "#ffd2a0", "radiance": 0.3}],
        "objects": objects,
        "render": {"method": "raytrace", "antialias": 8},
    })


if __name__ == "__main__":
    if sys.argv[1:] != ["scene"]:
        write_models()
    write_scene()
