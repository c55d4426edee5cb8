"""Compares our pictures of scene files of Mitsuba with those that Mitsuba makes of them.

    python3 src/bench/scripts/mitsuba_pictures.py SCENE.xml... [--assets DIR] [--jar target/enlightenment.jar] [--samples 64]

Both render each file with its own integrator at 96 pixels for the longer side. A line a file: the root mean square of the differences between means of blocks of 8 x 8
pixels, of light up to 4, over the mean of Mitsuba's picture; the ratio of the means; and what our program notes. Below 0.05 is noise and Mitsuba's pixel filter. Needs
numpy and mitsuba; Mitsuba's LLVM variant finds its library by DRJIT_LIBLLVM_PATH.
"""

import argparse
import pathlib
import subprocess
import tempfile

import mitsuba
import numpy
from physical_light import BLOCK, read_pfm

LONGER, BRIGHTEST = 96, 4


def theirs(file, samples):
    scene = mitsuba.load_file(str(file))
    parameters = mitsuba.traverse(scene)
    key = next(k for k in parameters.keys() if k.endswith("film.size"))
    scale = LONGER / max(parameters[key])
    size = [max(1, round(n * scale)) for n in parameters[key]]
    for k in parameters.keys():
        if k.endswith(("film.size", "film.crop_size")):
            parameters[k] = size
    parameters.update()
    return numpy.array(mitsuba.render(scene, spp=samples))[..., :3]


def ours(arguments, file, shape, out):
    command = ["java", "-jar", arguments.jar, "render", str(file), "-o", str(out), "--size", f"{shape[1]}x{shape[0]}", "--method", "raytrace"]
    command += ["--samples", str(arguments.samples), "--progress", "none"]
    if arguments.assets:
        command += ["--assets", str(arguments.assets)]
    run = subprocess.run(command, capture_output=True, text=True)
    if run.returncode != 0:
        return None, run.stderr
    # Rows of PFM files run upwards.
    return read_pfm(out)[::-1], run.stderr


def blocks(picture):
    height, width = (n // BLOCK * BLOCK for n in picture.shape[:2])
    picture = numpy.clip(picture[:height, :width], 0, BRIGHTEST)
    return picture.reshape(height // BLOCK, BLOCK, width // BLOCK, BLOCK, 3).mean((1, 3))


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("files", nargs="+", type=pathlib.Path)
    parser.add_argument("--assets", type=pathlib.Path)
    parser.add_argument("--jar", default="target/enlightenment.jar")
    parser.add_argument("--samples", type=int, default=64)
    arguments = parser.parse_args()
    mitsuba.set_variant("llvm_ad_rgb")
    with tempfile.TemporaryDirectory() as temporary:
        for file in arguments.files:
            try:
                reference = theirs(file, arguments.samples)
            except (RuntimeError, StopIteration) as e:
                print(f"{file}: Mitsuba does not render it: {str(e).strip().splitlines()[-1:]}", flush=True)
                continue
            picture, notes = ours(arguments, file, reference.shape, pathlib.Path(temporary) / "out.pfm")
            if picture is None:
                print(f"{file}: refused", flush=True)
            else:
                error = numpy.sqrt(((blocks(picture) - blocks(reference)) ** 2).mean()) / max(numpy.clip(reference, 0, BRIGHTEST).mean(), 1e-9)
                print(f"{file}: {error:.3f}, mean {picture.mean() / max(reference.mean(), 1e-9):.3f}", flush=True)
            for line in notes.splitlines()[:6]:
                print("    " + line[:200], flush=True)


main()
