"""Measures how well `--method auto` chooses: squared error times CPU-seconds of each fixed method and of auto, its pilot included.

    python3 src/bench/scripts/auto.py race --data FOLDER [--jar JAR] [--samples N] [--seeds K] [--scenes NAME...] [--pixels N] [--work FOLDER]
    python3 src/bench/scripts/auto.py costs --work FOLDER

`race` renders pictures of at most N pixels of scenes of this repository and of those below FOLDER (reference/*, scenes/*: folders with reference.pfm
and scene.json or scene.xml) by every method that can, with K seeds each, and prints the table of docs/notes/methods.md. Scenes without a
reference.pfm get one by a long render of the method that is named here. The error is that of light, relative: squares over
m^2 + (0.05 M)^2, with m the pixel and M the picture's mean, as `relativeError` of reports; a second table leaves out the thousandth of
pixels with the largest errors, as a few bright dots may outweigh all the rest (and objects that a method cannot see). CPU-seconds are user and system time of the
whole process, less those of the same program for a picture of one pixel (start-up, reading the scene).
Every run is kept as a line in WORK/runs.csv, and is not measured again: remove the file to begin anew.
`costs` compares the costs by which auto chooses with the processor time of the same renders, from the reports that `race` leaves in WORK.
Needs numpy.
"""
import argparse
import csv
import json
import math
import pathlib
import resource
import subprocess
import sys

import numpy

from physical_light import copied, read_pfm

REPOSITORY = pathlib.Path(__file__).resolve().parents[3]
FIXED = ["raytrace", "cluster", "light", "bidirectional", "bidirectional-cluster", "metropolis"]
# Scenes of the repository: size, and what makes the reference.
OWN = {
    "lamp-room": ("96x48", "bidirectional"),
    "door-ajar": ("96x64", "bidirectional"),
    "glass-physical": ("96x48", "raytrace"),
    "caustics": ("96x64", "raytrace"),
    "cornell-box": ("64x64", "cluster"),
    "metals": ("96x48", "raytrace"),
}
REFERENCE_SAMPLES = 1024


def cpu(command):
    """User and system seconds of a process; None if it fails."""
    before = resource.getrusage(resource.RUSAGE_CHILDREN)
    done = subprocess.run(command, stdout=subprocess.DEVNULL, stderr=subprocess.PIPE, check=False)
    after = resource.getrusage(resource.RUSAGE_CHILDREN)
    if done.returncode != 0:
        print(done.stderr.decode().strip().splitlines()[-1], file=sys.stderr)
        return None
    return after.ru_utime + after.ru_stime - before.ru_utime - before.ru_stime


def render(jar, scene, size, method, samples, seed, out, report=None):
    options = ["--report", report] if report else []
    return cpu(
        ["java", "-jar", jar, "render", scene, "-o", out, "--size", size, "--method", method, "--samples", str(samples)]
        + ["--seed", str(seed), "--progress", "none", "--threads", "2"] + options
    )


def shrunk(picture, factor):
    height, width, bands = picture.shape
    return picture.reshape(height // factor, factor, width // factor, factor, bands).mean(axis=(1, 3))


def relative(picture, reference):
    """The error of all pixels, and of all but the thousandth with the largest ones."""
    mean = reference.mean(axis=(0, 1))
    errors = numpy.sort(((picture - reference) ** 2 / (reference**2 + (0.05 * mean) ** 2)).mean(axis=2).ravel())
    return float(errors.mean()), float(errors[: len(errors) - math.ceil(len(errors) / 1000)].mean())


def given(folder, work, most):
    """Scene file, size and reference of a folder with a reference.pfm, made smaller."""
    reference = read_pfm(folder / "reference.pfm")
    height, width, _ = reference.shape
    factor = 1
    while width * height > most * factor**2 or width % factor or height % factor:
        factor += 1
    scene = folder / "scene.json"
    if not scene.exists():
        # Boxes for pixels and paths of any length, as the references have.
        copy = work / folder.name
        if not copy.exists():
            copied(folder, work)
        scene = copy / "scene.xml"
    return scene, f"{width // factor}x{height // factor}", shrunk(reference, factor)


def own(name, jar, work, most):
    size, by = OWN[name]
    width, height = map(int, size.split("x"))
    factor = max(math.isqrt(most // (width * height)), 1)
    size = f"{factor * width}x{factor * height}"
    scene = REPOSITORY / "scenes" / f"{name}.json"
    file = work / f"{name}-reference.pfm"
    if not file.exists():
        render(jar, scene, size, by, REFERENCE_SAMPLES, 4711, file)
    return scene, size, read_pfm(file)


def scenes(chosen, work):
    for name in OWN:
        yield name, lambda name=name: own(name, chosen.jar, work, chosen.pixels)
    for folder in sorted(chosen.data.glob("reference/*/")) + sorted(chosen.data.glob("scenes/*/")):
        if (folder / "reference.pfm").exists():
            is_classic = (folder / "scene.json").exists() and '"physical"' not in (folder / "scene.json").read_text()
            if not is_classic:
                yield folder.name, lambda folder=folder: given(folder, work, chosen.pixels)


def known(file):
    if not file.exists():
        return {}
    with open(file) as lines:
        return {(r["scene"], r["method"], r["samples"], r["seed"]): (r["error"], r["trimmed"], r["cpu"]) for r in csv.DictReader(lines)}


def race(chosen):
    work = chosen.work
    work.mkdir(parents=True, exist_ok=True)
    file = work / "runs.csv"
    runs = known(file)
    table = {}
    for name, prepare in scenes(chosen, work):
        if chosen.scenes and name not in chosen.scenes:
            continue
        scene, size, reference = prepare()
        for method in chosen.methods:
            for seed in range(0, chosen.seeds + 1):
                key = (name, method, str(chosen.samples), str(seed))
                if key not in runs:
                    out = work / "picture.pfm"
                    tiny = seed == 0
                    report = None if tiny else work / f"{name}-{method}-{chosen.samples}-{seed}.json"
                    if tiny and method != "raytrace":
                        continue
                    seconds = render(
                        chosen.jar, scene, "1x1" if tiny else size, method, 1 if tiny else chosen.samples, seed, out, report)
                    if tiny:
                        runs[key] = (0, 0, seconds)
                    elif seconds is None:
                        runs[key] = (math.nan, math.nan, math.nan)
                    else:
                        runs[key] = (*relative(read_pfm(out), reference), seconds)
                    is_new = not file.exists()
                    with open(file, "a") as lines:
                        writer = csv.writer(lines)
                        if is_new:
                            writer.writerow(["scene", "method", "samples", "seed", "error", "trimmed", "cpu"])
                        writer.writerow(list(key) + list(runs[key]))
        start = float(runs[(name, "raytrace", str(chosen.samples), "0")][2])
        row = {}
        for method in chosen.methods:
            of = [tuple(map(float, runs[(name, method, str(chosen.samples), str(s))])) for s in range(1, chosen.seeds + 1)]
            seconds = sum(max(t - start, 0.01) for _, _, t in of) / len(of)
            row[method] = [seconds * sum(run[which] for run in of) / len(of) for which in (0, 1)]
        table[name] = row
    for which, title in enumerate(["All pixels", "Without the thousandth of pixels with the largest errors"]):
        print(f"\n{title}:\n")
        print_table({name: {m: w[which] for m, w in row.items()} for name, row in table.items()}, chosen.methods, work, chosen.samples)


def chose(work, name, samples):
    file = work / f"{name}-auto-{samples}-1.json"
    return json.loads(file.read_text())["settings"]["method"] if file.exists() else ""


def print_table(table, methods, work, samples):
    """Efficiency of each method relative to the best fixed one: 1 is the best, 0.5 takes twice as long for the same error."""
    print("| scene | " + " | ".join(f"`{m}`" for m in methods) + " | auto chose |")
    print("|---|" + "---|" * (len(methods) + 1))
    shares = {m: [] for m in methods}
    for name, work_of in table.items():
        best = min(w for m, w in work_of.items() if m in FIXED and not math.isnan(w))
        cells = []
        for m in methods:
            share = 0 if math.isnan(work_of[m]) else best / work_of[m]
            shares[m].append(share)
            cells.append("–" if share == 0 else f"{share:.2f}")
        print(f"| {name} | " + " | ".join(cells) + f" | {chose(work, name, samples)} |")
    means = [math.exp(sum(math.log(max(s, 0.001)) for s in shares[m]) / len(shares[m])) for m in methods]
    print("| geometric mean | " + " | ".join(f"{m:.2f}" for m in means) + " | |")


# PilotCosts.java: nanoseconds of a camera sample and of a surface that is met; then of a shadow ray and of a test.
TABLE = {"raytrace": (500, 1500), "cluster": (500, 1200), "light": (300, 900), "bidirectional": (1500, 1650), "metropolis": (500, 2000),
         "bidirectional-cluster": (1500, 1200)}
SHADOW_RAY, TEST = 200, 6


def costs(chosen):
    """Processor time and cost by the table, both relative to raytrace's, of the render phases that `race` reported."""
    print("| scene | method | measured | by the table | off by a factor of |\n|---|---|---|---|---|")
    for file in sorted(chosen.work.glob(f"*-raytrace-{chosen.samples}-1.json")):
        name = file.name.removesuffix(f"-raytrace-{chosen.samples}-1.json")
        base = cost_of(file, "raytrace")
        for method in FIXED[1:]:
            other = file.with_name(f"{name}-{method}-{chosen.samples}-1.json")
            if other.exists():
                measured, told = (a / b for a, b in zip(cost_of(other, method), base))
                print(f"| {name} | `{method}` | {measured:.2f} | {told:.2f} | {max(measured / told, told / measured):.2f} |")


def cost_of(file, method):
    report = json.loads(file.read_text())
    seconds = sum(p["cpuSeconds"] for p in report["phases"] if p["name"] == "render")
    sample, hit = TABLE[method]
    rays = report["rays"]
    return seconds, (
        sample * rays["camera"] + hit * sum(report["hits"].values()) + SHADOW_RAY * rays["shadow"] + TEST * sum(report["tests"].values()))


def parsed():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("task", choices=["race", "costs"])
    parser.add_argument("--data", type=pathlib.Path, default=pathlib.Path("data"))
    parser.add_argument("--jar", default=str(REPOSITORY / "target" / "enlightenment.jar"))
    parser.add_argument("--samples", type=int, default=64)
    parser.add_argument("--seeds", type=int, default=1)
    parser.add_argument("--pixels", type=int, default=96 * 96, help="at most")
    parser.add_argument("--scenes", nargs="*", default=[])
    parser.add_argument("--methods", nargs="*", default=FIXED + ["auto"])
    parser.add_argument("--work", type=pathlib.Path, default=pathlib.Path("target/auto"))
    return parser.parse_args()


if __name__ == "__main__":
    arguments = parsed()
    race(arguments) if arguments.task == "race" else costs(arguments)
