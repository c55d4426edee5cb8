"""Compares our pictures of Mitsuba's scenes with Mitsuba's own.

    python3 src/bench/scripts/mitsuba_agree.py FOLDER... [--jar target/enlightenment.jar] [--samples 256] [--seeds 4] [--methods raytrace,bidirectional]

Each folder holds scene.xml, reference.pfm and variance.pfm (the variance of the reference's mean). The scene is read as it is, but for its `max_depth`, since
references have unbounded depth; several seeds give the variance of our mean. A line a method: the ratio of the means, which must be within 1 % of 1, and the share of
blocks of 8 x 8 pixels whose luminances differ by at most 6 standard deviations, which must be at least 98.5 %. A folder that is absent is skipped. Needs numpy.
"""

import argparse
import pathlib
import re
import subprocess
import sys
import tempfile

import numpy

BLOCK = 8


def read(path):
    with open(path, "rb") as f:
        f.readline()
        width, height = map(int, f.readline().split())
        scale = float(f.readline())
        data = numpy.frombuffer(f.read(), "<f4" if scale < 0 else ">f4")
    return data.reshape(height, width, 3).astype(float)


def blocks(picture):
    height, width = (n // BLOCK * BLOCK for n in picture.shape[:2])
    return picture[:height, :width].reshape(height // BLOCK, BLOCK, width // BLOCK, BLOCK, 3).mean((1, 3, 4))


def render(arguments, scene, size, method, seed, out):
    command = ["java", "-jar", arguments.jar, "render", str(scene), "-o", str(out), "--progress", "none", "--size", size]
    command += ["--samples", str(arguments.samples), "--seed", str(seed), "--method", method]
    subprocess.run(command, check=True, stderr=subprocess.DEVNULL)
    return read(out)


def agree(arguments, folder, method):
    reference = read(folder / "reference.pfm")
    size = f"{reference.shape[1]}x{reference.shape[0]}"
    text = re.sub(r'(<integer name="max_depth" value=)"[^"]*"', r'\1"-1"', (folder / "scene.xml").read_text())
    # Files must lie in the scene's folder: a copy of all of it.
    with tempfile.TemporaryDirectory() as temporary:
        copy = pathlib.Path(temporary) / "scene"
        subprocess.run(["cp", "-r", str(folder), str(copy)], check=True)
        (copy / "scene.xml").write_text(text)
        out = pathlib.Path(temporary) / "out.pfm"
        ours = numpy.array([render(arguments, copy / "scene.xml", size, method, k + 1, out) for k in range(arguments.seeds)])
    each = numpy.array([blocks(p) for p in ours])
    variance = each.var(0, ddof=1) / arguments.seeds
    # Pixels of the reference are independent; its bands are not, so that their deviations add up.
    deviation = numpy.sqrt(numpy.maximum(read(folder / "variance.pfm"), 0)).mean(2)
    height, width = (n // BLOCK * BLOCK for n in deviation.shape)
    theirs = (deviation[:height, :width] ** 2).reshape(height // BLOCK, BLOCK, width // BLOCK, BLOCK).sum((1, 3)) / BLOCK**4
    z = numpy.abs(each.mean(0) - blocks(reference)) / numpy.sqrt(variance + theirs)
    ratio = ours.mean() / reference.mean()
    share = (z <= 6).mean()
    good = abs(ratio - 1) <= 0.01 and share >= 0.985
    print(f"{folder.name:14} {method:14} mean {ratio:.4f}  |z| <= 6 in {100 * share:.1f} % of {z.size} blocks, largest {z.max():.1f}  {'agrees' if good else 'DIFFERS'}", flush=True)
    return good


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("--jar", default="target/enlightenment.jar")
    parser.add_argument("--samples", type=int, default=256)
    parser.add_argument("--seeds", type=int, default=4)
    parser.add_argument("--methods", default="raytrace,bidirectional")
    arguments = parser.parse_args()
    good = True
    for folder in arguments.folders:
        if not (folder / "reference.pfm").exists():
            print(f"{folder}: skipped: there is no reference.pfm")
            continue
        for method in arguments.methods.split(","):
            good &= agree(arguments, folder, method)
    sys.exit(0 if good else 1)


main()
