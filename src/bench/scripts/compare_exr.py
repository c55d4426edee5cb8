"""Compares what Enlightenment writes with what the OpenEXR library reads of it: python3 src/bench/scripts/compare_exr.py SCENE.json ...

Renders each scene of physical shading as .exr and .pfm, with all further numbers, whole and as a crop. Every number of the EXR file, its
windows and its attributes have to be those of the float maps, bit by bit; with --depth 16 the nearest halves. Needs target/enlightenment.jar,
and pip install OpenEXR numpy.
"""
import pathlib
import subprocess
import sys
import tempfile

import numpy as np
import OpenEXR

LAYERS = {
    "error": "Y",
    "samples": "Y",
    "depth": "Z",
    "normal": "XYZ",
    "position": "XYZ",
    "object": "Y",
    "albedo": "RGB",
    "direct": "RGB",
    "indirect": "RGB",
}
SIZE = (96, 64)
CROP = (17, 9, 40, 33)


def render(scene, out, *options):
    size = f"{SIZE[0]}x{SIZE[1]}"
    command = ["java", "-jar", "target/enlightenment.jar", "render", scene, "-o", out, "--size", size, "--samples", "4"]
    subprocess.run([*map(str, command), "--progress", "none", *options], check=True)


def pfm(path):
    """The components of a float map, from the top."""
    with open(path, "rb") as file:
        kind, size, order = (file.readline().split() for _ in range(3))
        assert kind == [b"PF"] and order == [b"-1.0"]
        width, height = map(int, size)
        return np.frombuffer(file.read(), "<f4").reshape(height, width, 3)[::-1]


def same(name, found, expected):
    if found.dtype != expected.dtype or found.tobytes() != expected.tobytes():
        wrong = found != expected
        sys.exit(f"{name}: {found.dtype}, {wrong.sum()} of {wrong.size} numbers differ")


def compare(folder, scene, crop, depth):
    options = ["--aov", ",".join(LAYERS)] + (["--crop", ",".join(map(str, CROP))] if crop else [])
    render(scene, folder / "a.exr", "--depth", str(depth), *options)
    render(scene, folder / "a.pfm", *options)
    with OpenEXR.File(str(folder / "a.exr"), separate_channels=True) as file:
        header, channels = file.header(), file.channels()
        x, y, width, height = CROP if crop else (0, 0, *SIZE)
        low, high = header["dataWindow"]
        assert (*low, *high) == (x, y, x + width - 1, y + height - 1), header["dataWindow"]
        low, high = header["displayWindow"]
        assert (*low, *high) == (0, 0, SIZE[0] - 1, SIZE[1] - 1), header["displayWindow"]
        assert header["Settings"].startswith("method="), header
        picture = pfm(folder / "a.pfm")
        for c, name in enumerate("RGB"):
            expected = picture[..., c].astype(np.float16 if depth == 16 else np.float32)
            same(name, channels[name].pixels, expected)
        for layer, names in LAYERS.items():
            numbers = pfm(folder / f"a.{layer}.pfm")
            for c, name in enumerate(names):
                same(f"{layer}.{name}", channels[f"{layer}.{name}"].pixels, numbers[..., c])
        assert len(channels) == 3 + sum(map(len, LAYERS.values())), channels.keys()
        print(f"{scene}: {width}x{height}, {depth} bits, {len(channels)} channels agree")


if len(sys.argv) < 2:
    sys.exit(__doc__)
with tempfile.TemporaryDirectory() as name:
    for scene in sys.argv[1:]:
        for crop in (False, True):
            for depth in (32, 16):
                compare(pathlib.Path(name), scene, crop, depth)
