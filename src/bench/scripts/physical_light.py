"""Compares pictures of physical light with references made by another renderer, and races Mitsuba 3 for them.

    python3 src/bench/scripts/physical_light.py agree FOLDER... [--jar JAR] [--seeds K] [--samples N] [--options "..."]
    python3 src/bench/scripts/physical_light.py kept FOLDER... [--jar JAR] [--seeds K] [--error E] [--options "..."]
    python3 src/bench/scripts/physical_light.py race FOLDER... [--jar JAR] [--runs K] [--samples N] [--size WxH]

FOLDER has scene.json, reference.pfm, variance.pfm (linear, rows from the bottom) and, for `race`, scene.xml of Mitsuba 3.
`agree` renders K seeds and compares the means of blocks of 8 x 8 pixels with the reference: docs/physical-light.md says by which rule.
`kept` renders K seeds with `--error E` and counts in how many the displayed error against the reference is no larger.
`race` gives CPU-seconds of whole processes, in turns, and errors against the reference, its own variance subtracted.
JAR is the jar, for `java -jar`, or the launcher of the application.
Needs numpy; `race` also mitsuba (pip install numpy mitsuba; Debian's libllvm19 for its variant llvm_ad_rgb).
"""
import argparse
import math
import pathlib
import re
import resource
import shlex
import statistics
import subprocess
import sys
import tempfile

import numpy

HERE = pathlib.Path(__file__).resolve().parent
BLOCK = 8


def read_pfm(path):
    with open(path, "rb") as file:
        kind, size, scale = file.readline().strip(), file.readline().split(), float(file.readline())
        width, height = int(size[0]), int(size[1])
        data = numpy.frombuffer(file.read(), "<f4" if scale < 0 else ">f4")
        bands = 3 if kind == b"PF" else 1
        return data[: width * height * bands].reshape(height, width, bands).astype(float)


def run(command):
    """User and system seconds of a process and its children."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False)
    if done.returncode != 0:
        sys.exit(" ".join(map(str, command)) + "\n" + done.stderr.decode())
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def ours(jar, folder, seed, out, samples, options, size=None):
    antialias = ["--samples", str(samples)]
    sizes = ["--size", size] if size else []
    program = ["java", "-jar", jar] if str(jar).endswith(".jar") else [jar]
    return run(
        program + ["render", folder / "scene.json", "-o", out, "--seed", str(seed), "--progress", "none"]
        + antialias + sizes + shlex.split(options)
    )


def mitsuba(variant, folder, seed, out, samples, size, scratch):
    """Mitsuba's path tracer with roulette from the fifth bounce, as is its default."""
    text = (folder / "scene.xml").read_text()
    text = re.sub(r'(name="rr_depth" value=)"\d+"', r'\1"5"', text)
    text = re.sub(r'(name="spp" value=)"\d+"', rf'\1"{samples}"', text)
    text = re.sub(r'(name="seed" value=)"\d+"', rf'\1"{seed}"', text, count=1)
    if size:
        width, height = size.split("x")
        text = re.sub(r'(name="width" value=)"\d+"', rf'\1"{width}"', text)
        text = re.sub(r'(name="height" value=)"\d+"', rf'\1"{height}"', text)
    scene = scratch / "scene.xml"
    scene.write_text(text)
    return run([sys.executable, HERE / "peer_mitsuba.py", variant, scene, out])


def agree(folder, jar, seeds, samples, options, scratch):
    reference, own = read_pfm(folder / "reference.pfm"), read_pfm(folder / "variance.pfm")
    pictures = []
    for seed in range(1, seeds + 1):
        out = scratch / "a.pfm"
        ours(jar, folder, seed, out, samples, options)
        pictures.append(read_pfm(out))
    mean = numpy.mean(pictures, axis=0)
    variance = numpy.var(pictures, axis=0, ddof=1) / seeds
    difference = mean - reference
    height, width, bands = reference.shape
    rows, columns = height // BLOCK, width // BLOCK

    def blocks(values, power):
        cut = values[: rows * BLOCK, : columns * BLOCK].reshape(rows, BLOCK, columns, BLOCK, bands)
        return cut.sum(axis=(1, 3)) / BLOCK ** (2 * power)

    deviation = numpy.sqrt(blocks(variance, 2) + blocks(own, 2))
    # Floats of the other renderer: no block is known to better than a ten-thousandth of the picture.
    floor = 1e-4 * reference.mean()
    z = numpy.abs(blocks(difference, 1)) / numpy.maximum(deviation, floor)
    tests = z.size
    # Šidák's level for all tests together at 1 %, two-sided, Student's distribution of few seeds left out of account.
    level = 1 - (1 - 0.01) ** (1 / tests)
    limit = statistics.NormalDist().inv_cdf(1 - level / 2)
    share = float((z <= limit).mean())
    total = difference.mean(axis=(0, 1))
    sigma = numpy.sqrt((variance + own).sum(axis=(0, 1))) / (height * width)
    relative = float(numpy.abs(total).max() / reference.mean())
    passed = share >= 0.9975 and (relative <= 1e-3 or bool((numpy.abs(total) <= 4 * sigma).all()))
    print(
        f"{folder.name}: {share:.4%} of {tests} block means within {limit:.2f} sigma (99.75 % needed), largest {z.max():.1f}; "
        f"picture mean off by {relative:.4%} ({numpy.abs(total / sigma).max():.1f} sigma): {'agrees' if passed else 'DIFFERS'}"
    )
    worst = numpy.argwhere(z > limit)
    for row, column, band in worst[:8]:
        print(
            f"   block column {column}, row {rows - 1 - row} from the top, band {'RGB'[band]}: {z[row, column, band]:.1f} sigma, "
            f"{blocks(mean, 1)[row, column, band]:.5f} against {blocks(reference, 1)[row, column, band]:.5f}"
        )
    return passed


def errors(pictures, reference, own):
    """Relative variance, the same without the worst 0.1 % of values, and displayed variance: means over pictures."""
    scale = reference**2 + (0.05 * reference.mean(axis=(0, 1))) ** 2
    display = lambda v: encode(numpy.clip(v, 0, 1))
    whole, bulk, shown = [], [], []
    slope = derivative(reference)
    for picture in pictures:
        squares = ((picture - reference) ** 2 - own) / scale
        whole.append(squares.mean())
        bulk.append(numpy.sort(squares, axis=None)[: int(squares.size * 0.999)].mean())
        shown.append((((display(picture) - display(reference)) ** 2) - own * slope**2).mean())
    return numpy.mean(whole), numpy.mean(bulk), numpy.mean(shown)


def kept(folder, jar, seeds, error, options, scratch):
    reference, own = read_pfm(folder / "reference.pfm"), read_pfm(folder / "variance.pfm")
    true, seconds = [], []
    for seed in range(1, seeds + 1):
        out = scratch / "k.pfm"
        command = ["java", "-jar", jar, "render", folder / "scene.json", "-o", out, "--seed", str(seed), "--progress", "none"]
        seconds.append(run(command + ["--error", str(error)] + shlex.split(options)))
        true.append(math.sqrt(max(errors([read_pfm(out)], reference, own)[2], 0)))
    count = sum(t <= error for t in true)
    print(
        f"{folder.name} --error {error} {options}: {count} of {seeds} kept; true displayed error {min(true):.4f} to {max(true):.4f}, "
        f"median {statistics.median(true):.4f}; CPU-seconds {statistics.median(seconds):.1f}"
    )
    return count >= 0.95 * seeds


def encode(v):
    return numpy.where(v <= 0.0031308, 12.92 * v, 1.055 * numpy.maximum(v, 1e-12) ** (1 / 2.4) - 0.055)


def derivative(v):
    inner = numpy.where(v <= 0.0031308, 12.92, 1.055 / 2.4 * numpy.maximum(v, 0.0031308) ** (1 / 2.4 - 1))
    return numpy.where((v > 0) & (v < 1), inner, 0)


def race(folder, jar, runs, samples, size, scratch):
    reference, own = read_pfm(folder / "reference.pfm"), read_pfm(folder / "variance.pfm")
    programs = {
        "raytrace": lambda seed, out, size: ours(jar, folder, seed, out, samples, "--method raytrace", size),
        "cluster": lambda seed, out, size: ours(jar, folder, seed, out, samples, "--method cluster", size),
        "mitsuba scalar": lambda seed, out, size: mitsuba("scalar_rgb", folder, seed, out, samples, size, scratch),
        "mitsuba llvm": lambda seed, out, size: mitsuba("llvm_ad_rgb", folder, seed, out, samples, size, scratch),
    }
    seconds = {name: [] for name in programs}
    for k in range(runs):
        for name, program in programs.items():
            seconds[name].append(program(k + 1, scratch / "timed.pfm", size))
    print(f"{folder.name}: {samples} samples per pixel; CPU-seconds at {size}, median of {runs} in turns; errors at the reference's size")
    figures = {}
    for name, program in programs.items():
        pictures = []
        for seed in range(1, 2 * runs + 1):
            out = scratch / "error.pfm"
            program(seed, out, None)
            picture = read_pfm(out)
            pictures.append(picture[:, ::-1] if name.startswith("mitsuba") else picture)
        figures[name] = errors(pictures, reference, own)
    partner = figures["mitsuba llvm"], statistics.median(seconds["mitsuba llvm"])
    for name, (whole, bulk, shown) in figures.items():
        cpu = statistics.median(seconds[name])
        gain = [p * partner[1] / max(f * cpu, 1e-30) for p, f in zip(partner[0], (whole, bulk, shown))]
        print(
            f"   {name:15} {cpu:6.2f} s  relative variance {whole:.5f} (bulk {bulk:.5f}), displayed RMSE {math.sqrt(max(shown, 0)):.5f};"
            f"  times less error x CPU than llvm: {gain[0]:.2f} (bulk {gain[1]:.2f}), displayed {gain[2]:.2f}"
        )


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["agree", "kept", "race"])
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("--jar", default="target/enlightenment.jar")
    parser.add_argument("--seeds", type=int, default=16)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--samples", type=int)
    parser.add_argument("--error", type=float, default=0.02)
    parser.add_argument("--size", default="512x512")
    parser.add_argument("--options", default="")
    chosen = parser.parse_args()
    ok = True
    with tempfile.TemporaryDirectory() as name:
        for folder in chosen.folders:
            if chosen.what == "agree":
                ok &= agree(folder, chosen.jar, chosen.seeds, chosen.samples or 64, chosen.options, pathlib.Path(name))
            elif chosen.what == "kept":
                ok &= kept(folder, chosen.jar, chosen.seeds, chosen.error, chosen.options, pathlib.Path(name))
            else:
                race(folder, chosen.jar, chosen.runs, chosen.samples or 16, chosen.size, pathlib.Path(name))
    sys.exit(0 if ok else 1)


if __name__ == "__main__":
    main()
