"""How much nearer to the truth pictures come by `render --denoised`: relative squared errors before and after.

    python3 src/bench/scripts/denoised.py SCENE=REFERENCE.pfm[,REFERENCE.pfm...] ... [--jar JAR] [--samples N] [--seeds K] [--options "..."] [--keep FOLDER]

References are linear light: pictures of the scene by many samples, whose mean is compared with; the spread of several is the variance of their mean,
which is subtracted from the errors. A reference made by another program may have its variance beside it, as variance.pfm.
Errors are those of physical_light.py: means of (difference² − variance)/(value² + (0.05 mean)²) over pixels and bands; `bulk` is without the worst 0.1 %.
Needs numpy.
"""
import argparse
import json
import pathlib
import shlex
import subprocess
import sys
import tempfile

import numpy

from physical_light import errors, read_pfm


def reference(files):
    """The mean of pictures and its variance."""
    pictures = [read_pfm(file) for file in files]
    if len(pictures) > 1:
        return numpy.mean(pictures, axis=0), numpy.var(pictures, axis=0, ddof=1) / len(pictures)
    own = files[0].with_name("variance.pfm")
    return pictures[0], read_pfm(own) if own.exists() else numpy.zeros_like(pictures[0])


def render(jar, scene, seed, samples, size, options, folder, name):
    noisy, clean, report = (folder / f"{name}-{seed}{end}" for end in (".pfm", "-denoised.pfm", ".json"))
    command = ["java", "-jar", jar, "render", scene, "-o", noisy, "--denoised", clean, "--report", report, "--samples", str(samples)]
    command += ["--seed", str(seed), "--size", size, "--progress", "none"] + shlex.split(options)
    done = subprocess.run(list(map(str, command)), stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False)
    if done.returncode != 0:
        sys.exit(done.stderr.decode())
    seconds = {phase["name"]: phase["cpuSeconds"] for phase in json.loads(report.read_text())["phases"]}
    return read_pfm(noisy), read_pfm(clean), seconds["denoise"]


def measure(scene, files, chosen, folder):
    truth, own = reference(files)
    height, width, _ = truth.shape
    size = f"{width}x{height}"
    name = scene.parent.name if scene.stem == "scene" else scene.stem
    pictures = [render(chosen.jar, scene, seed, chosen.samples, size, chosen.options, folder, name) for seed in range(1, chosen.seeds + 1)]
    before, after = (errors([p[k] for p in pictures], truth, own) for k in (0, 1))
    print(
        f"| {name} | {size} | {before[0]:.3g} | {after[0]:.3g} | {before[0] / after[0]:.1f} | {before[1] / after[1]:.1f} | "
        f"{before[2] / after[2]:.1f} | {numpy.mean([p[2] for p in pictures]):.2f} |",
        flush=True,
    )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("scenes", nargs="+")
    parser.add_argument("--jar", default="target/enlightenment.jar")
    parser.add_argument("--samples", type=int, default=16)
    parser.add_argument("--seeds", type=int, default=2)
    parser.add_argument("--options", default="")
    parser.add_argument("--keep", type=pathlib.Path, help="where pictures are left")
    chosen = parser.parse_args()
    print("| scene | size | error before | after | ratio | of the bulk | as shown | CPU-seconds |\n|---|---|---|---|---|---|---|---|")
    with tempfile.TemporaryDirectory() as scratch:
        folder = chosen.keep or pathlib.Path(scratch)
        folder.mkdir(parents=True, exist_ok=True)
        for given in chosen.scenes:
            scene, files = given.split("=")
            measure(pathlib.Path(scene), [pathlib.Path(file) for file in files.split(",")], chosen, folder)


if __name__ == "__main__":
    main()
