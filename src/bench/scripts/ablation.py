"""What a strategy is worth: squared error times processor time of two builds on the same scenes.

    python3 src/bench/scripts/ablation.py WITH.jar WITHOUT.jar [--samples 256] [--seeds 2] [--reference 4096] SCENE.json ...

For each scene a reference is rendered by WITH.jar at its own seed, then both builds in turns at the same seeds. One line a scene:
the ratio WITHOUT / WITH of the mean squared relative error of linear light, the same of what is displayed, and of CPU-seconds.
A ratio above 1 is what the strategy gains. Needs numpy.
"""

import argparse
import pathlib
import resource
import subprocess
import sys
import tempfile

import numpy


def read(path):
    with open(path, "rb") as f:
        f.readline()
        width, height = map(int, f.readline().split())
        scale = float(f.readline())
        data = numpy.frombuffer(f.read(), "<f4" if scale < 0 else ">f4")
    return data.reshape(height, width, 3).astype(float)


def render(jar, scene, size, samples, seed, method, out):
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(
        ["java", "-jar", jar, "render", scene, "--size", size, "--samples", str(samples), "--seed", str(seed)]
        + ["--method", method, "-o", out, "--progress", "none"],
        capture_output=True,
        text=True,
    )
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode:
        sys.exit(done.stderr)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def displayed(light):
    v = numpy.clip(light, 0, 1)
    return numpy.where(v <= 0.0031308, 12.92 * v, 1.055 * v ** (1 / 2.4) - 0.055)


def errors(picture, reference):
    linear = numpy.mean((picture - reference) ** 2 / (reference**2 + 1e-2))
    return linear, numpy.mean((displayed(picture) - displayed(reference)) ** 2)


def main():
    p = argparse.ArgumentParser()
    p.add_argument("jars", nargs=2)
    p.add_argument("scenes", nargs="+")
    p.add_argument("--size", default="128x64")
    p.add_argument("--samples", type=int, default=256)
    p.add_argument("--reference", type=int, default=4096)
    p.add_argument("--seeds", type=int, default=2)
    p.add_argument("--method", default="raytrace")
    a = p.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        out = str(pathlib.Path(folder) / "picture.pfm")
        for scene in a.scenes:
            render(a.jars[0], scene, a.size, a.reference, 1000, a.method, out)
            reference = read(out)
            sums = numpy.zeros((2, 3))
            for seed in range(1, a.seeds + 1):
                for k, jar in enumerate(a.jars):
                    cpu = render(jar, scene, a.size, a.samples, seed, a.method, out)
                    sums[k] += [*errors(read(out), reference), cpu]
            ratio = sums[1] / numpy.where(sums[0] > 0, sums[0], 1)
            print("%-40s linear %.3f  displayed %.3f  cpu %.3f" % (pathlib.Path(scene), *ratio), flush=True)


main()
