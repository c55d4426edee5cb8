"""scenes/panorama.json, all around in the paper's room: python3 scenes/models/generate/panorama.py"""
from files import SCENES


def write_scene():
    """The scene of fire-and-ice-physical.json with another camera and size, and a wall where the viewer stood; the rest stays as it is written there."""
    lines = (SCENES / "fire-and-ice-physical.json").read_text(encoding="utf-8").split("\n")
    opening = next(k for k, line in enumerate(lines) if line.startswith('  "camera"'))
    closing = lines.index("  },", opening)
    while lines[opening - 1].lstrip().startswith("//"):
        opening -= 1
    lines[opening : closing + 1] = ['  "camera": { "type": "panorama", "eye": [0, 1.1, 2.1], "lookAt": [2.8, 1.1, 8] },']
    for k, line in enumerate(lines):
        if line.startswith('  "name"'):
            lines[k] = '  "name": "The paper\'s room all around",'
        elif line.startswith('  "image"'):
            lines[k] = '  "image": { "width": 1440, "height": 720 },'
        elif line.startswith('  "display"'):
            lines[k] = '  "display": { "exposure": 0.8, "tone": "filmic" },'
    wall = ['    {', '      "name": "wall behind the viewer",', '      "type": "rectangle",', '      "corners": [[6, -6, -2], [6, 6, -2], [-6, 6, -2], [-6, -6, -2]],', '      "material": "back wall"', '    },']
    objects = lines.index('  "objects": [')
    lines[objects + 1 : objects + 1] = wall
    start = lines.index("{")
    head = "// The room of fire-and-ice-physical.json, all around: 360 by 180 degrees from between its balls.\n// Script: scenes/models/generate/panorama.py."
    (SCENES / "panorama.json").write_text("\n".join([head, *lines[start:]]), encoding="utf-8")


if __name__ == "__main__":
    write_scene()
