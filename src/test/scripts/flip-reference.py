#!/usr/bin/env python3
"""Makes what FlipReferenceTest compares with: values of FLIP by the reference implementation of its authors.

In a virtual environment outside the repository:
    pip install flip-evaluator==1.7 numpy pillow
    python src/test/scripts/flip-reference.py src/test/resources/enlightenment/image/flip/flip

Writes the made-up pairs of pictures (NAME-a.png, NAME-b.png) and reference.txt. The pair "scene" has to be there:
    enlightenment render scenes/glass.json -o scene-a.png --size 64x48 --antialias 1 --shadow-samples 1
    enlightenment render scenes/glass.json -o scene-b.png --size 64x48 --antialias 6 --shadow-samples 20
"""
import importlib.metadata
import math
import pathlib
import sys

import flip_evaluator
import numpy
from PIL import Image

WIDTH, HEIGHT = 64, 48
DENSITIES = [3840 * math.pi / 180, 20.0, 150.0]
PIXELS = [(0, 0), (63, 47), (63, 0), (31, 24), (32, 24), (30, 10), (5, 40), (47, 17)]


def pairs():
    """Pictures as integers 0..255, (name, a, b)."""
    y, x = numpy.mgrid[0:HEIGHT, 0:WIDTH]
    edge = numpy.stack([numpy.where(x + y // 3 < 36, 200, 40)] * 3, axis=2)
    shifted = numpy.stack([numpy.where(x + y // 3 < 38, 200, 40)] * 3, axis=2)
    yield "edge", edge, shifted
    ramp = numpy.stack([4 * x, 5 * y, 255 - 2 * x - 2 * y], axis=2)
    noise = numpy.random.RandomState(1).randint(-40, 41, ramp.shape)
    yield "noise", numpy.clip(ramp + noise, 0, 255), ramp
    flat = numpy.empty((HEIGHT, WIDTH, 3), int)
    flat[:] = (120, 90, 60)
    yield "shift", flat, flat + (0, 12, -8)
    yield "equal", ramp, ramp
    yield "extreme", numpy.where(x[..., None] % 7 < 3, (0, 255, 0), (0, 0, 0)), numpy.zeros_like(ramp) + (0, 0, 255)


def main():
    folder = pathlib.Path(sys.argv[1])
    names = ["scene"]
    for name, a, b in pairs():
        names.append(name)
        for which, pixels in ("a", a), ("b", b):
            Image.fromarray(pixels.astype(numpy.uint8)).save(folder / f"{name}-{which}.png", optimize=True)
    version = importlib.metadata.version("flip-evaluator")
    lines = [
        f"# FLIP (LDR) of NAME-a.png against NAME-b.png by flip-evaluator {version} (PyPI), the reference implementation,",
        "# made by src/test/scripts/flip-reference.py. Name, pixels per degree, mean, then column,row=error of some pixels.",
    ]
    for name in names:
        for density in DENSITIES:
            error, mean, _ = flip_evaluator.evaluate(
                str(folder / f"{name}-b.png"), str(folder / f"{name}-a.png"), "LDR",
                applyMagma=False, parameters={"ppd": density})
            error = numpy.squeeze(error)
            values = " ".join(f"{x},{y}={float(error[y, x]):.8g}" for x, y in PIXELS)
            lines.append(f"{name} {density!r} {float(mean):.8g} {values}")
    (folder / "reference.txt").write_text("\n".join(lines) + "\n")


main()
