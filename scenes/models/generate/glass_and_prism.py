"""scenes/glass-and-prism.json, a wine glass and a prism: python3 scenes/models/generate/glass_and_prism.py"""
import math
import sys

from files import linear, mesh, models, scene
from geometry import Mesh, arc, lathe, spline

LAMP = (-60, 8.0, 15)
PRISM = (-7.5, 0.01, -1.0)


def write_models():
    outer = [(0.0, 0.0), (3.3, 0.0)] + arc(3.3, 0.1, 0.1, -90, 60, 4)
    outer += spline([(3.0, 0.3), (1.2, 0.55), (0.5, 1.1), (0.38, 2.2), (0.36, 5.0), (0.4, 7.2), (0.75, 8.2), (2.2, 9.2), (3.6, 11.0), (4.1, 13.2), (3.95, 15.5), (3.5, 18.0), (3.3, 19.2)], 8)
    rim = arc(3.24, 19.2, 0.06, 0, 180, 6)[1:-1]
    inner = spline([(3.18, 19.2), (3.38, 18.0), (3.83, 15.5), (3.98, 13.2), (3.47, 11.0), (2.05, 9.35), (0.7, 8.75), (0.0, 8.6)], 8)
    lathe(outer + rim + inner, 144).write("wine-glass")
    level = 12.2
    wine = [(r + 0.05 if r > 0.01 else r, y - 0.05) for r, y in inner if y < level]
    top = wine[0][0]
    lathe([(0.0, level), (top * 0.9, level), (top - 0.04, level + 0.03), (top, level + 0.05)] + wine[1:], 144).write("wine")
    m, side, h = Mesh(), 4.6, 7.0
    for y in (0.0, h):
        for k in range(3):
            a = math.radians(-81 + 120 * k)
            m.vertex((side / math.sqrt(3) * math.cos(a), y, side / math.sqrt(3) * math.sin(a)))
    for k in range(3):
        n = (k + 1) % 3
        m.quad(k, k + 3, n + 3, n)
    m.triangles += [(0, 1, 2), (3, 5, 4)]
    m.write("prism")


def plates(gap):
    """Two dark plates between the lamp and the prism, with a slit that the prism is lit through."""
    target, share = (PRISM[0], 3.5, PRISM[2]), 0.5
    c = [a + share * (b - a) for a, b in zip(LAMP, target)]
    d = math.hypot(target[0] - LAMP[0], target[2] - LAMP[2])
    across = (-(target[2] - LAMP[2]) / d, (target[0] - LAMP[0]) / d)
    out = []
    for sign in (-1, 1):
        a, b = sign * gap / 2, sign * 2.6
        ends = [(c[0] + across[0] * s, c[2] + across[1] * s) for s in (a, b)]
        low, high = c[1] - 2.6, c[1] + 2.6
        (xa, za), (xb, zb) = ends
        out.append({"type": "rectangle", "corners": [[xa, low, za], [xa, high, za], [xb, high, zb], [xb, low, zb]], "material": "plate"})
    return out


def write_scene():
    scene("glass-and-prism", "A glass of wine and a prism of flint glass before a wall, in the light of a low lamp: caustics and dispersion.\nThe prism parts colours three times as far as flint glass does.\n"
          "Models: scenes/models/generate/glass_and_prism.py.", {
        "name": "A wine glass and a prism",
        "image": {"width": 1280, "height": 720},
        "camera": {"type": "perspective", "eye": [1.5, 17, -44], "lookAt": [1.5, 7.6, 0], "fieldOfView": 28},
        "shading": {"model": "physical", "background": linear(0.1, 0.115, 0.14)},
        "display": {"exposure": 0.3, "tone": "filmic"},
        "materials": {
            "table": {"type": "matte", "color": linear(0.58, 0.54, 0.48)},
            "wall": {"type": "matte", "color": linear(0.34, 0.39, 0.42)},
            "plate": {"type": "matte", "color": linear(0.03, 0.03, 0.03)},
            "crystal": {"type": "glass", "color": "#ffffff", "indexOfRefraction": 1.52, "smoothRefraction": True},
            "wine": {"type": "glass", "color": "#ffffff", "indexOfRefraction": 1.34, "absorption": [0.05, 0.75, 0.62], "priority": -1, "smoothRefraction": True},
            "flint": {"type": "glass", "color": "#ffffff", "indexOfRefraction": 1.62, "dispersion": 12},
        },
        "meshes": {**models("wine-glass", "wine", crease=60), "prism": {"file": "models/prism.ply", "normals": "flat"}},
        "lights": [
            {"type": "sphere", "center": [-34, 42, 13], "radius": 2.0, "color": "#ffe2c0", "radiance": 400},
            {"type": "spot", "position": list(LAMP), "direction": [PRISM[0] - LAMP[0], 3.4 - LAMP[1], PRISM[2] - LAMP[2]], "angle": 4, "innerAngle": 3.5, "color": "#ffffff", "intensity": 110000},
            {"type": "rectangle", "corners": [[-30, 8, -20], [-30, 34, -20], [-18, 34, -34], [-18, 8, -34]], "color": "#eaf0ff", "radiance": 1.6},
        ],
        "objects": [
            {"name": "table", "type": "rectangle", "corners": [[-60, 0, -60], [-60, 0, 20], [60, 0, 20], [60, 0, -60]], "material": "table"},
            {"name": "wall", "type": "rectangle", "corners": [[-60, 0, 20], [-60, 70, 20], [60, 70, 20], [60, 0, 20]], "material": "wall"},
            mesh("wine-glass", "crystal", scale=0.88, at=(5.0, 0.01, 3)),
            mesh("wine", "wine", scale=0.88, at=(5.0, 0.01, 3)),
            mesh("prism", "flint", at=PRISM),
            *plates(0.35),
        ],
        "render": {"method": "raytrace", "antialias": 8},
    })


if __name__ == "__main__":
    if sys.argv[1:] != ["scene"]:
        write_models()
    write_scene()
