"""scenes/chess.json, a game of chess in which a knight moves: python3 scenes/models/generate/chess.py"""
import math
import sys

from files import linear, mesh, models, scene
from geometry import Mesh, arc, lathe, move, rounded_box, spline, tube


def foot(radius):
    return [(0.0, 0.0), (radius, 0.0), (radius, 0.12)] + arc(radius - 0.09, 0.2, 0.1, -60, 80, 5) + [(radius - 0.16, 0.32)] + arc(radius - 0.2, 0.42, 0.08, -60, 90, 4)


def write_models():
    pawn = foot(0.62) + spline([(0.4, 0.52), (0.24, 0.8), (0.2, 1.15)], 6) + arc(0.25, 1.2, 0.07, -70, 80, 5)
    pawn += [(0.29 * math.cos(math.radians(a)), 1.5 + 0.29 * math.sin(math.radians(a))) for a in range(-55, 90, 9)] + [(0.0, 1.79)]
    lathe(pawn, 64).write("pawn")
    rook = foot(0.7) + spline([(0.5, 0.55), (0.36, 0.9), (0.34, 1.5)], 6) + [(0.4, 1.55), (0.5, 1.65), (0.5, 2.05), (0.36, 2.05), (0.36, 1.85), (0.0, 1.85)]
    castle = lathe(rook, 96)
    for k in range(6):
        a = 2 * math.pi * k / 6
        castle.add(rounded_box(0.14, 0.16, 0.3, 0.02, 2), lambda p, a=a: (math.cos(a) * (p[0] + 0.43) - math.sin(a) * p[2], p[1] + 2.1, math.sin(a) * (p[0] + 0.43) + math.cos(a) * p[2]))
    castle.write("rook")
    bishop = foot(0.7) + spline([(0.46, 0.55), (0.26, 1.0), (0.2, 1.75)], 6) + arc(0.3, 1.82, 0.07, -80, 80, 5) + spline([(0.2, 1.9), (0.34, 2.2), (0.22, 2.6), (0.07, 2.76)], 6)
    bishop += [(0.1 * math.cos(math.radians(a)), 2.84 + 0.1 * math.sin(math.radians(a))) for a in range(-45, 90, 15)] + [(0.0, 2.94)]
    lathe(bishop, 64).write("bishop")
    queen = foot(0.76) + spline([(0.5, 0.55), (0.28, 1.1), (0.22, 2.1)], 7) + arc(0.34, 2.18, 0.08, -80, 80, 5) + spline([(0.24, 2.28), (0.3, 2.6), (0.46, 3.0)], 5) + [(0.4, 3.02), (0.28, 3.05), (0.1, 3.12)]
    queen += [(0.1 * math.cos(math.radians(a)), 3.2 + 0.1 * math.sin(math.radians(a))) for a in range(-45, 90, 15)] + [(0.0, 3.3)]
    crown = lathe(queen, 72)
    for k in range(9):
        a = 2 * math.pi * k / 9
        crown.add(lathe([(0.07 * math.cos(math.radians(b)), 0.07 * math.sin(math.radians(b))) if b % 180 else (0.07, 0) for b in range(-75, 90, 15)], 12), move(0.43 * math.cos(a), 3.03, 0.43 * math.sin(a)))
    crown.write("queen")
    king = foot(0.78) + spline([(0.52, 0.55), (0.3, 1.15), (0.24, 2.25)], 7) + arc(0.36, 2.34, 0.08, -80, 80, 5) + spline([(0.26, 2.44), (0.32, 2.8), (0.42, 3.15)], 5) + [(0.36, 3.2), (0.2, 3.3), (0.0, 3.34)]
    cross = lathe(king, 72)
    cross.add(rounded_box(0.12, 0.5, 0.12, 0.025, 2), move(y=3.55))
    cross.add(rounded_box(0.36, 0.12, 0.12, 0.025, 2), move(y=3.6))
    cross.write("king")
    # The knight: a neck and head as tubes of changing width over a foot, with ears and a mane.
    horse = lathe(foot(0.7) + [(0.45, 0.52), (0.0, 0.54)], 64)
    neck = spline([(0.16, 0.45, 0.0), (0.24, 0.9, 0.0), (0.12, 1.5, 0.0), (-0.02, 2.0, 0.0), (-0.2, 2.22, 0.0), (-0.5, 2.06, 0.0), (-0.8, 1.78, 0.0), (-0.88, 1.7, 0.0)], 8)
    widths = spline([(0.42,), (0.4,), (0.35,), (0.29,), (0.27,), (0.22,), (0.16,), (0.1,)], 8)
    horse.add(tube(neck, [w[0] for w in widths], 28), lambda p: (p[0], p[1], 0.72 * p[2]))
    for z in (-0.11, 0.11):
        horse.add(tube([(-0.06, 2.3, z), (-0.02, 2.5, 1.15 * z), (0.0, 2.64, 1.2 * z)], [0.08, 0.06, 0.012], 12))
    for k in range(9):
        t = k / 8
        horse.add(tube([(0.18 + 0.3 * math.sin(1.9 * t), 2.25 - 1.35 * t, 0.0), (0.36 + 0.3 * math.sin(1.9 * t), 2.17 - 1.42 * t, 0.0)], [0.09, 0.03], 10))
    horse.write("knight")
    rounded_box(17.6, 0.9, 17.6, 0.2, 4).write("chess-frame")
    rounded_box(1.94, 0.08, 1.94, 0.02, 2).write("chess-square")
    lathe([(0.0, 0.0), (0.95, 0.0), (1.0, 0.05), (1.0, 0.42), (0.9, 0.5), (0.8, 0.5), (0.78, 0.42), (0.0, 0.42)], 64).write("clock-bell")
    rounded_box(5.2, 2.9, 1.9, 0.3, 5).write("clock-case")


WHITE = {"a1": "rook", "c1": "bishop", "d1": "queen", "e1": "king", "f1": "bishop", "h1": "rook", "a2": "pawn", "b2": "pawn", "c2": "pawn", "d4": "pawn", "e4": "pawn", "f2": "pawn", "g2": "pawn", "h2": "pawn", "c3": "knight"}
BLACK = {"a8": "rook", "c8": "bishop", "d8": "queen", "e8": "king", "f8": "bishop", "h8": "rook", "a7": "pawn", "b7": "pawn", "c7": "pawn", "d6": "pawn", "e5": "pawn", "f7": "pawn", "g7": "pawn", "h7": "pawn", "f6": "knight", "b8": "knight"}


def place(square):
    return (2 * ("abcdefgh".index(square[0]) - 3.5), 1.0, 2 * (int(square[1]) - 4.5))


def write_scene():
    objects = [
        {"name": "table", "type": "rectangle", "corners": [[-60, 0, -50], [-60, 0, 40], [60, 0, 40], [60, 0, -50]], "material": "table"},
        {"name": "wall", "type": "rectangle", "corners": [[-90, -40, 62], [-90, 70, 62], [90, 70, 62], [90, -40, 62]], "material": "wall"},
        mesh("chess-frame", "frame", at=(0, 0.46, 0)),
    ]
    for file in "abcdefgh":
        for rank in range(1, 9):
            x, y, z = place(f"{file}{rank}")
            objects.append(mesh("chess-square", "maple" if ("abcdefgh".index(file) + rank) % 2 == 0 else "walnut", at=(x, 0.93, z)))
    for side, material, turn in ((WHITE, "boxwood", 90), (BLACK, "ebony", -90)):
        for square, name in side.items():
            objects.append(mesh(name, material, rotate=[0, turn, 0], at=place(square)))
    x, y, z = place("g1")
    fx, _, fz = place("f3")
    objects.append({"name": "moving knight", "type": "mesh", "mesh": "knight", "material": "boxwood",
                    "transform": [{"rotate": [0, 90, 0]}, {"rotate": [0, 0, 8]}, {"translate": [x, 2.6, z]}]})
    objects += [mesh("clock-case", "frame", rotate=[0, -55, 0], at=(5.0, 1.5, 13.4))]
    for k, (x, z) in enumerate(((-11.6, 5.2), (-12.8, 3.4), (-11.2, 2.0))):
        objects.append({"type": "mesh", "mesh": "pawn", "material": "ebony" if k else "boxwood", "transform": [{"rotate": [90, 0, 0]}, {"rotate": [0, 70 * k + 20, 0]}, {"translate": [x, 0.62, z]}]})
    moving = len(objects) - 5
    scene("chess", "A game of chess while the white knight moves: what moves while the shutter is open is blurred.\n"
          "Render it with --frame 3. Models: scenes/models/generate/chess.py.", {
        "name": "Chess",
        "image": {"width": 1280, "height": 720},
        "camera": {"type": "perspective", "eye": [12.5, 11.5, -24], "lookAt": [0.9, 1.3, -2.4], "fieldOfView": 24},
        "shading": {"model": "physical", "background": linear(0.16, 0.16, 0.17)},
        "display": {"exposure": 0.4, "tone": "filmic"},
        "animation": {"frames": 8, "framesPerSecond": 24, "shutter": 0.8, "instants": 24, "tracks": [
            {"target": f"/objects/{moving}/transform/2/translate/0", "keys": {"0": 5.0, "7": fx}, "easing": "smooth"},
            {"target": f"/objects/{moving}/transform/2/translate/2", "keys": {"0": -7.0, "7": fz}, "easing": "smooth"},
            {"target": f"/objects/{moving}/transform/2/translate/1", "keys": {"0": 2.2, "3": 3.3, "7": 2.4}},
        ]},
        "materials": {
            "table": {"type": "coated", "color": linear(0.10, 0.075, 0.06), "roughness": 0.4},
            "wall": {"type": "matte", "color": linear(0.20, 0.13, 0.10)},
            "frame": {"type": "coated", "color": linear(0.10, 0.035, 0.018), "roughness": 0.28},
            "maple": {"type": "coated", "color": linear(0.62, 0.46, 0.28), "roughness": 0.3},
            "walnut": {"type": "coated", "color": linear(0.13, 0.06, 0.03), "roughness": 0.3},
            "boxwood": {"type": "coated", "color": linear(0.66, 0.47, 0.24), "roughness": 0.3},
            "ebony": {"type": "coated", "color": linear(0.022, 0.018, 0.016), "roughness": 0.27},
        },
        "meshes": models("pawn", "rook", "knight", "bishop", "queen", "king", "chess-frame", "chess-square", "clock-case", crease=45),
        "lights": [
            {"type": "rectangle", "corners": [[-24, 6, 18], [-24, 26, 18], [-24, 26, -10], [-24, 6, -10]], "color": "#ffeeda", "radiance": 5},
            {"type": "rectangle", "corners": [[8, 16, 22], [8, 24, 22], [22, 24, 16], [22, 16, 16]], "color": "#cfe0ff", "radiance": 4.5},
        ],
        "objects": objects,
        "render": {"method": "raytrace", "antialias": 8},
    })


if __name__ == "__main__":
    if sys.argv[1:] != ["scene"]:
        write_models()
    write_scene()
