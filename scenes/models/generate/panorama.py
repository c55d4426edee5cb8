"""scenes/panorama.json, all around in the lamp room: python3 scenes/models/generate/panorama.py"""
from files import SCENES


def write_scene():
    """The scene of lamp-room.json with another camera and size; the rest stays as it is written there."""
    lines = (SCENES / "lamp-room.json").read_text(encoding="utf-8").split("\n")
    for k, line in enumerate(lines):
        if line.startswith('  "name"'):
            lines[k] = '  "name": "Panorama of the lamp room",'
        elif line.startswith('  "image"'):
            lines[k] = '  "image": { "width": 1440, "height": 720 },'
        elif line.startswith('  "camera"'):
            lines[k] = '  "camera": { "type": "panorama", "eye": [0.2, 1.5, -1.9], "lookAt": [0, 1.45, 0] },'
    start = next(k for k, line in enumerate(lines) if line == "{")
    head = "// The room of lamp-room.json, all around: 360 by 180 degrees from its middle.\n// Script: scenes/models/generate/panorama.py."
    (SCENES / "panorama.json").write_text("\n".join([head, *lines[start:]]), encoding="utf-8")


if __name__ == "__main__":
    write_scene()
