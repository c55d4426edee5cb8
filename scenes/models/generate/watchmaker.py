"""scenes/watchmaker.json, the watchmaker's table: python3 scenes/models/generate/watchmaker.py"""
import math
import sys

from files import linear, mesh, models, png, scene
from geometry import Mesh, Random, arc, circle, extruded, gear, grid, lathe, move, noise, planar, rounded_box, spline, tube, turbulence

NUMERALS = ["XII", "I", "II", "III", "IIII", "V", "VI", "VII", "VIII", "IX", "X", "XI"]
WIDTHS = {"I": 0.028, "V": 0.062, "X": 0.066}


def strokes(numeral):
    """Segments (x0, y0, x1, y1, half width) of a numeral that stands upright around the origin, of the height 0.13."""
    x, out = -sum(WIDTHS[c] for c in numeral) / 2, []
    for c in numeral:
        w, h = WIDTHS[c], 0.065
        a, b, m = x + 0.008, x + w - 0.008, x + w / 2
        if c == "I":
            out.append((m, -h, m, h, 0.0075))
        elif c == "V":
            out += [(m, -h, a, h, 0.0075), (m, -h, b, h, 0.003)]
        else:
            out += [(b, -h, a, h, 0.0075), (a, -h, b, h, 0.003)]
        x += w
    out += [(-x, h, x, h, 0.003), (-x, -h, x, -h, 0.003)]
    return out


def distance(x, y, x0, y0, x1, y1):
    dx, dy = x1 - x0, y1 - y0
    t = max(0, min(1, ((x - x0) * dx + (y - y0) * dy) / (dx * dx + dy * dy)))
    return math.hypot(x - x0 - t * dx, y - y0 - t * dy)


SIGNS = [strokes(n) for n in NUMERALS]


def dial(px, py, size=768):
    x, y = 2 * (px + 0.5) / size - 1, 1 - 2 * (py + 0.5) / size
    r, angle = math.hypot(x, y), math.atan2(x, y) % (2 * math.pi)
    pixel, ink = 2 / size, 0.0

    def cover(d):
        return max(0.0, min(1.0, 0.5 - d / pixel))

    hour = round(angle / (math.pi / 6)) % 12
    if 0.55 < r < 0.8:
        c, s = math.cos(hour * math.pi / 6), math.sin(hour * math.pi / 6)
        lx, ly = c * x - s * y, s * x + c * y - 0.68
        ink = max(cover(distance(lx, ly, *seg[:4]) - seg[4]) for seg in SIGNS[hour])
    minute = round(angle / (math.pi / 30))
    off = abs(r * math.sin(angle - minute * math.pi / 30))
    if 0.86 < r < 0.92:
        ink = max(ink, cover(off - (0.006 if minute % 5 == 0 else 0.0025)))
    ink = max(ink, cover(abs(r - 0.86) - 0.002), cover(abs(r - 0.92) - 0.002))
    seconds = math.hypot(x, y + 0.36)
    if seconds < 0.2:
        tick = math.atan2(x, y + 0.36) / (math.pi / 6)
        ink = 0.0
        if seconds > 0.15:
            ink = cover(abs(seconds * math.sin((tick - round(tick)) * math.pi / 6)) - 0.003)
        ink = max(ink, cover(abs(seconds - 0.185) - 0.002), cover(abs(seconds - 0.15) - 0.0015))
    paper = (0.94, 0.925, 0.88)
    return tuple(p * (1 - ink) + 0.07 * ink for p in paper)


def wood(px, py, size=512):
    u, v = px / size, py / size
    grain = turbulence(u * 6, v * 70, 0, 3, 5) * 0.5 + turbulence(u * 2, v * 14 + 0.8 * noise(u * 3, v * 3, 0, 3), 0, 2, 9)
    t = 0.5 + 0.42 * grain
    a, b = (0.20, 0.105, 0.06), (0.36, 0.21, 0.12)
    return tuple((p + (q - p) * max(0, min(1, t))) for p, q in zip(a, b))


def leather(px, py, size=256, cells=22):
    """Cells whose borders are creases; the pattern repeats."""
    x, y = px / size * cells, py / size * cells
    near = []
    for i in range(math.floor(x) - 1, math.floor(x) + 2):
        for j in range(math.floor(y) - 1, math.floor(y) + 2):
            a, b = i % cells, j % cells
            cx = i + 0.5 + 0.45 * noise(a + 0.5, b + 0.5, 0.5, 1)
            cy = j + 0.5 + 0.45 * noise(a + 0.5, b + 0.5, 0.5, 2)
            near.append(math.hypot(x - cx, y - cy))
    near.sort()
    return min(1.0, 1.6 * (near[1] - near[0])) ** 0.5


def brushed(px, py, size=256):
    return 0.5 + 0.5 * noise(px * 0.01, py * 0.7, 0, 4) * 0.6 + 0.2 * noise(px * 0.02, py * 1.9, 0, 8)


def hand(points, thickness):
    """A flat hand with a spine, along +z, of half widths [(z, half width), ...]."""
    m = Mesh()
    for z, w in points:
        m.vertex((-w, 0, z))
        m.vertex((0, thickness, z))
        m.vertex((w, 0, z))
    for i in range(len(points) - 1):
        a, b = 3 * i, 3 * i + 3
        m.quad(a, b, b + 1, a + 1)
        m.quad(a + 1, b + 1, b + 2, a + 2)
    return m


def write_models():
    # The watch: dial in the plane y = 0, twelve towards +z, of the radius 2.3.
    case = [(0.0, -0.55), (1.6, -0.52), (2.3, -0.35)] + arc(2.42, 0.0, 0.35, -70, 65, 14) + [(2.5, 0.4), (2.3, 0.34), (2.28, 0.06), (2.26, 0.0)]
    lathe(case, 128).write("watch-case")
    rim = grid(128, 4, lambda u, v: ((2.3 * v + 1e-3) * math.sin(2 * math.pi * u), 0.02, (2.3 * v + 1e-3) * math.cos(2 * math.pi * u)))
    for i, (x, y, z, _, _) in enumerate(rim.vertices):
        rim.vertices[i] = (x, y, z, 0.5 + x / 4.6, 0.5 + z / 4.6)
    rim.write("watch-dial", True)
    crystal = [(2.29, 0.33), (2.2, 0.42)] + spline([(2.0, 0.5), (1.4, 0.6), (0.7, 0.65), (0.0, 0.66)], 6)
    lathe(crystal, 96).write("watch-crystal")
    hands = hand([(-0.4, 0.06), (0, 0.09), (0.6, 0.05), (0.85, 0.13), (1.05, 0.1), (1.3, 0.03), (1.4, 0.01)], 0.05).moved(move(y=0.1, turn=-54))
    hands.add(hand([(-0.5, 0.05), (0, 0.08), (1.0, 0.035), (1.35, 0.09), (1.55, 0.06), (1.85, 0.02), (1.95, 0.005)], 0.05), move(y=0.2, turn=62))
    hands.add(hand([(-0.12, 0.03), (0, 0.03), (0.36, 0.01)], 0.03), move(y=0.07, z=-0.828, turn=200))
    hands.add(lathe([(0.0, 0.3), (0.08, 0.28), (0.1, 0.05)], 24))
    hands.write("watch-hands")
    crown = Mesh()
    knurl = [(0.34 + 0.03 * math.cos(24 * a), a) for a in [2 * math.pi * k / 192 for k in range(192)]]
    outline = [(r * math.cos(a), r * math.sin(a)) for r, a in knurl]
    crown.add(extruded(outline, circle(0.05, 192), 2.95, 3.4, 0.06))
    crown.add(lathe([(0.0, 3.46), (0.14, 3.44), (0.22, 3.36)], 32))
    crown.add(lathe([(0.2, 2.6), (0.2, 3.0)], 32))
    crown = crown.moved(lambda p: (p[0], p[2] - 0.02, p[1]))
    bow = [(0.72 * math.cos(a), 0.0, 3.5 + 0.62 * math.sin(a)) for a in [math.radians(-60 + 300 * k / 60) for k in range(61)]]
    crown.add(tube(bow, [0.11] * 61, 16))
    crown.write("watch-crown")
    # A chain: links of a torus, turned alternately.
    link = lathe(arc(0.26, 0, 0.06, 0, 330, 11), 28, closed=True).moved(lambda p: (p[0] * 1.35, p[1], p[2] * 0.8))
    link.write("chain-link")
    gear(60, 1.9, 0.14, 0.16, 5).write("gear-large")
    gear(36, 1.1, 0.13, 0.16, 4).write("gear-middle")
    gear(14, 0.42, 0.14, 0.22, 3, 0.3, 0.4).write("gear-small")
    balance = extruded(circle(1.25, 96), circle(1.08, 96), 0, 0.16, 0.02)
    balance.add(rounded_box(2.2, 0.12, 0.14, 0.02, 2), move(y=0.08))
    for k in range(12):
        a = 2 * math.pi * k / 12
        balance.add(lathe([(0.0, 0.2), (0.08, 0.19), (0.1, 0.12), (0.1, 0)], 12), move(1.3 * math.cos(a), 0, 1.3 * math.sin(a)))
    balance.write("balance-wheel")
    turns = [((0.12 + 0.075 * t) * math.cos(2 * math.pi * t), 0.3, (0.12 + 0.075 * t) * math.sin(2 * math.pi * t)) for t in [k / 36 for k in range(36 * 11)]]
    tube(turns, [0.018] * len(turns), 6).write("hairspring")
    lathe([(0.0, 0.22), (0.18, 0.21), (0.21, 0.17), (0.21, 0.06), (0.1, 0.04), (0.1, -0.5), (0.0, -0.52)], 32).write("screw")
    handle = [(0.0, 0.0), (0.24, 0.02), (0.3, 0.1), (0.3, 0.35), (0.2, 0.45), (0.2, 0.55)]
    handle += [(0.27, 0.65), (0.27, 2.6)] + arc(0.12, 2.75, 0.15, 0, 90, 5)
    lathe(handle, 48).write("driver-handle")
    lathe([(0.1, 2.8), (0.1, 5.4), (0.075, 5.6), (0.07, 5.9), (0.05, 6.1), (0.0, 6.12)], 24).write("driver-blade")
    lathe([(1.05, 0.0), (1.15, 0.0), (1.2, 0.05), (1.2, 0.5), (1.3, 0.6), (1.3, 0.75), (1.2, 0.85), (1.45, 2.3), (1.55, 2.4), (1.5, 2.5), (1.4, 2.45), (1.1, 0.9), (1.05, 0.8)], 96, closed=True).write("loupe")
    lens = arc(0, -1.75, 2.2, 61.2, 90, 12)
    lathe([(r, y + 0.22) for r, y in lens[:-1]] + [(0.0, 0.67)] + [(r, 0.4 - y) for r, y in lens[-2::-1]], 64).write("loupe-lens")
    # The dome, its foot, and the frame of the movement within.
    dome = spline([(3.4, 0.0), (3.4, 2.0), (3.4, 4.4), (3.2, 5.9), (2.4, 7.3), (1.2, 8.0), (0.45, 8.2)], 8) + arc(0, 8.55, 0.42, -50, 90, 14)
    lathe([(max(r, 1e-3), y) for r, y in dome], 128).write("dome")
    foot = [(0.0, 1.0), (3.2, 1.0), (3.25, 0.95), (3.55, 0.95)] + arc(3.6, 0.8, 0.15, 90, -20, 6) + [(3.75, 0.62)] + arc(3.8, 0.4, 0.22, 90, -60, 8) + [(3.9, 0.1), (3.85, 0.0), (0.0, 0.0)]
    lathe(foot, 128).write("dome-foot")
    cage = Mesh()
    for k in range(4):
        a = math.pi / 4 + math.pi / 2 * k
        column = [(0.22, 0.0), (0.22, 0.12), (0.12, 0.2), (0.1, 2.2), (0.16, 2.3), (0.16, 2.5), (0.1, 2.6), (0.1, 4.6), (0.2, 4.7), (0.2, 4.85), (0.12, 5.0), (0.16, 5.15), (0.0, 5.35)]
        cage.add(lathe(column, 24), move(2.0 * math.cos(a), 0, 2.0 * math.sin(a)))
    for y in (0.2, 2.35, 4.7):
        cage.add(extruded(circle(2.3, 96), circle(1.75 if y < 4 else 1.9, 96), y, y + 0.14, 0.03))
        cage.add(rounded_box(3.8, 0.12, 0.5, 0.03, 2), move(y=y + 0.07, turn=35))
    for x, z in ((0, 0), (0.9, 0.63), (-0.9, -0.63)):
        cage.add(lathe([(0.07, 0.0), (0.07, 4.9), (0.0, 5.0)], 16), move(x, 0.1, z))
    cage.write("movement-cage")
    planar(rounded_box(15.0, 0.3, 9.4, 0.12, 3), 3.2).write("leather-mat", True)
    planar(rounded_box(4.2, 1.5, 3.0, 0.14, 4), 2.5).write("bench-block", True)


def write_scene():
    lean = [{"rotate": [-52, 0, 0]}, {"rotate": [0, -14, 0]}, {"translate": [2.35, 2.25, -1.2]}]

    def watch(name, material):
        return {"type": "mesh", "mesh": name, "material": material, "transform": lean}

    objects = [
        {"name": "table", "type": "rectangle", "corners": [[-24, 0, -16], [-24, 0, 16], [24, 0, 16], [24, 0, -16]], "material": "table"},
        {"name": "wall", "type": "rectangle", "corners": [[-70, -30, 48], [-70, 50, 48], [70, 50, 48], [70, -30, 48]], "material": "wall"},
        mesh("leather-mat", "leather", rotate=[0, -8, 0], at=(1.2, 0.16, -3.2)),
        mesh("bench-block", "steel", rotate=[0, 24, 0], at=(6.6, 1.07, -0.4)),
        watch("watch-case", "gold"), watch("watch-dial", "enamel"), watch("watch-hands", "blued steel"),
        watch("watch-crown", "gold"), watch("watch-crystal", "crystal"),
        mesh("dome-foot", "ebony", at=(-5.6, 0, 5.5)), mesh("dome", "crystal", at=(-5.6, 0.96, 5.5)),
        mesh("movement-cage", "brass", at=(-5.6, 1.0, 5.5)),
        mesh("gear-large", "brass", at=(-5.6, 1.9, 5.5)), mesh("gear-middle", "steel plain", at=(-4.7, 2.3, 6.13)),
        mesh("gear-middle", "brass", rotate=[0, 5, 0], at=(-6.5, 4.1, 4.87)), mesh("gear-large", "gold", at=(-5.6, 4.7, 5.5)),
        mesh("gear-small", "steel plain", at=(-4.7, 4.1, 6.13)), mesh("balance-wheel", "gold", at=(-5.6, 6.35, 5.5)),
        mesh("hairspring", "blued steel", at=(-5.6, 6.3, 5.5)),
        mesh("loupe", "brass", rotate=[0, 20, 0], at=(6.4, 1.84, -0.3)), mesh("loupe-lens", "crystal", at=(6.4, 2.7, -0.3)),
    ]
    # Tools and parts on the leather.
    top = 0.32
    for x, z, turn, metal in ((-4.4, -4.9, 62, "brass"), (-3.6, -5.7, 66, "steel plain")):
        for part, material in (("driver-handle", metal), ("driver-blade", "steel plain")):
            objects.append({"type": "mesh", "mesh": part, "material": material, "transform": [{"rotate": [90, 0, 0]}, {"rotate": [0, turn, 0]}, {"translate": [x - 2.5, top + 0.31, z]}]})
    objects += [
        mesh("gear-large", "brass", rotate=[0, 8, 0], at=(-1.9, top + 0.08, -2.3)),
        mesh("gear-middle", "gold", rotate=[0, 3, 0], at=(-0.6, top + 0.3, -3.4)),
        mesh("gear-small", "steel plain", rotate=[0, 3, 0], at=(0.9, top + 0.1, -5.3)),
        mesh("balance-wheel", "gold", rotate=[0, 50, 0], at=(5.6, top + 0.03, -5.3)),
        mesh("hairspring", "blued steel", at=(5.6, top + 0.05, -5.3)),
        mesh("gear-middle", "brass", rotate=[0, 20, 0], at=(7.3, top + 0.07, -2.3)),
    ]
    random = Random(11)
    for _ in range(9):
        x, z = random.between(1.6, 4.2), random.between(-6.6, -5.0)
        objects.append({"type": "mesh", "mesh": "screw", "material": "blued steel" if random.next() < 0.5 else "steel plain",
                        "transform": [{"scale": 0.7}, {"rotate": [90 + random.between(-3, 12), 0, 0]}, {"rotate": [0, random.between(0, 360), 0]}, {"translate": [x, top + 0.15, z]}]})
    path = spline([(2.0, 5.45, 0.35), (2.5, 5.3, 0.75), (3.3, 4.9, 1.0), (4.0, 4.0, 0.9), (4.3, 2.2, 0.3), (4.7, 0.55, -1.2), (4.4, 0.42, -2.6), (5.6, 0.42, -3.9), (7.6, 0.42, -4.6), (9.0, 0.42, -3.6), (10.6, 0.2, -3.0)], 60)
    since, k = 0.0, 0
    for a, b in zip(path, path[1:]):
        since += math.dist(a, b)
        if since >= 0.44:
            since, d = 0.0, [q - p for p, q in zip(a, b)]
            turn = -math.degrees(math.atan2(d[2], d[0]))
            rise = math.degrees(math.atan2(d[1], math.hypot(d[0], d[2])))
            objects.append({"type": "mesh", "mesh": "chain-link", "material": "gold",
                            "transform": [{"rotate": [90 * (k % 2) + 20, 0, 0]}, {"rotate": [0, 0, rise]}, {"rotate": [0, turn, 0]}, {"translate": list(b)}]})
            k += 1
    names = ["watch-case", "watch-dial", "watch-crystal", "watch-hands", "watch-crown", "chain-link", "gear-large", "gear-middle", "gear-small", "balance-wheel",
             "hairspring", "screw", "driver-handle", "driver-blade", "loupe", "loupe-lens", "dome", "dome-foot", "movement-cage", "leather-mat", "bench-block"]
    scene("watchmaker", "A watchmaker's table: gold, brass, blued steel, brushed steel, enamel, leather and glass before a window, with a lens of shallow focus.\n"
          "Models and textures: scenes/models/generate/watchmaker.py.", {
        "name": "A watchmaker's table",
        "image": {"width": 1280, "height": 720},
        "camera": {"type": "perspective", "eye": [1.2, 11.5, -25], "lookAt": [0.1, 4.3, 0], "fieldOfView": 29.5, "lens": {"radius": 0.22, "focusDistance": 25.0}},
        "shading": {"model": "physical", "background": linear(0.14, 0.125, 0.11)},
        "display": {"exposure": 0.75, "tone": "filmic"},
        "textures": {
            "dial": {"file": "../textures/dial.png"},
            "wood": {"file": "../textures/wood.png"},
            "leather": {"file": "../textures/leather.png", "encoding": "linear"},
            "brushed": {"file": "../textures/brushed.png", "encoding": "linear"},
        },
        "materials": {
            "table": {"type": "coated", "color": {"texture": "wood"}, "roughness": 0.35},
            "wall": {"type": "matte", "color": linear(0.07, 0.10, 0.095)},
            "leather": {"type": "bump", "of": {"type": "coated", "color": linear(0.035, 0.085, 0.055), "roughness": 0.5}, "map": {"texture": "leather"}, "height": 0.035},
            "gold": {"type": "glossy", "metal": "gold", "roughness": 0.25},
            "brass": {"type": "glossy", "metal": "brass", "roughness": 0.27},
            "steel plain": {"type": "glossy", "metal": "chromium", "roughness": 0.25},
            "steel": {"type": "bump", "of": {"type": "glossy", "metal": "iron", "roughness": 0.3}, "map": {"texture": "brushed"}, "height": 0.006},
            "blued steel": {"type": "glossy", "color": linear(0.09, 0.16, 0.5), "roughness": 0.25},
            "enamel": {"type": "coated", "color": {"texture": "dial"}, "roughness": 0.25},
            "ebony": {"type": "coated", "color": linear(0.018, 0.014, 0.012), "roughness": 0.25},
            "crystal": {"type": "glass", "color": "#ffffff", "indexOfRefraction": 1.5},
            "lens": {"type": "glass", "color": "#ffffff", "indexOfRefraction": 1.5, "smoothRefraction": True},
        },
        "meshes": models(*names),
        "lights": [
            {"type": "rectangle", "corners": [[-26, 3, 14], [-26, 26, 14], [-26, 26, -12], [-26, 3, -12]], "color": "#e6eeff", "radiance": 4.5, "twoSided": True},
            {"type": "rectangle", "corners": [[8, 17, 17], [8, 23, 17], [20, 23, 13], [20, 17, 13]], "color": "#ffd6a0", "radiance": 9, "twoSided": True},
            # A white card that the dial is seen by.
            {"type": "rectangle", "corners": [[-7, 20, -30], [-7, 30, -22], [12, 30, -22], [12, 20, -30]], "color": "#fff4e6", "radiance": 2.2, "twoSided": True},
        ],
        "objects": objects,
        "render": {"method": "raytrace", "antialias": 8},
    })


def textures():
    png("dial", 768, 768, dial)
    png("wood", 512, 512, wood)
    png("leather", 256, 256, leather)
    png("brushed", 256, 256, brushed)


if __name__ == "__main__":
    if sys.argv[1:] != ["scene"]:
        textures()
        write_models()
    write_scene()
