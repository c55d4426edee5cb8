"""Scene files and textures of the gallery: JSON that people can read, and PNG. Standard library only."""
import json
import struct
import zlib
from pathlib import Path

SCENES = Path(__file__).resolve().parent.parent.parent
TEXTURES = SCENES.parent / "textures"


def png(name, width, height, at):
    """Writes textures/NAME.png of 8-bit RGB; at(x, y) gives three components in 0..1, or one for grey."""
    grey = not isinstance(at(0, 0), tuple)
    rows = bytearray()
    for y in range(height):
        rows.append(0)
        for x in range(width):
            c = at(x, y)
            for k in (c,) if grey else c:
                rows.append(max(0, min(255, round(255 * k))))

    def chunk(kind, data):
        return struct.pack(">I", len(data)) + kind + data + struct.pack(">I", zlib.crc32(kind + data))

    head = struct.pack(">IIBBBBB", width, height, 8, 0 if grey else 2, 0, 0, 0)
    with open(TEXTURES / f"{name}.png", "wb") as f:
        f.write(b"\x89PNG\r\n\x1a\n" + chunk(b"IHDR", head))
        f.write(chunk(b"IDAT", zlib.compress(bytes(rows), 9)) + chunk(b"IEND", b""))


def rounded(value):
    """Numbers with six digits: more are not seen."""
    if isinstance(value, float):
        short = float(f"{value:.6g}")
        return int(short) if short == int(short) and abs(short) < 1e9 else short
    if isinstance(value, (list, tuple)):
        return [rounded(v) for v in value]
    if isinstance(value, dict):
        return {k: rounded(v) for k, v in value.items()}
    return value


def line(value):
    return json.dumps(rounded(value), ensure_ascii=False)


def scene(name, comment, parts):
    """Writes scenes/NAME.json: one line for each entry of its objects and arrays."""
    out = [f"// {text}" for text in comment.strip().split("\n")] + ["{", '  "$schema": "../docs/scene.schema.json",']
    entries = []
    for key, value in parts.items():
        if key in ("objects", "lights") and value:
            body = ",\n".join("    " + line(v) for v in value)
            entries.append(f'  "{key}": [\n{body}\n  ]')
        elif key == "groups":
            groups = []
            for group, members in value.items():
                body = ",\n".join("      " + line(v) for v in members)
                groups.append(f"    {json.dumps(group)}: [\n{body}\n    ]")
            entries.append('  "groups": {\n' + ",\n".join(groups) + "\n  }")
        elif key in ("materials", "textures", "meshes"):
            body = ",\n".join(f"    {json.dumps(k)}: {line(v)}" for k, v in value.items())
            entries.append(f'  "{key}": {{\n{body}\n  }}')
        else:
            entries.append(f'  "{key}": {line(value)}')
    text = "\n".join(out) + "\n" + ",\n".join(entries) + "\n}\n"
    (SCENES / f"{name}.json").write_text(text, encoding="utf-8")


def linear(r, g, b):
    """A colour proportional to light."""
    return {"linear": [r, g, b]}


def mesh(name, material, scale=None, rotate=None, at=None):
    """An object that places a mesh of the scene."""
    steps = []
    if scale is not None:
        steps.append({"scale": scale})
    if rotate is not None:
        steps.append({"rotate": rotate})
    if at is not None:
        steps.append({"translate": list(at)})
    out = {"type": "mesh", "mesh": name, "material": material}
    if steps:
        out["transform"] = steps
    return out


def models(*names, crease=40):
    """The meshes of these names, smooth but for edges sharper than crease degrees."""
    return {n: {"file": f"models/{n}.ply", "normals": "smooth", "crease": crease} for n in names}
