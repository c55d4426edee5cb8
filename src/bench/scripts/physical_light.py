"""Compares pictures of physical light with references made by another renderer, and races Mitsuba 3 for them.

    python3 src/bench/scripts/physical_light.py agree FOLDER... [--jar JAR] [--seeds K] [--samples N] [--options "..."]
    python3 src/bench/scripts/physical_light.py kept FOLDER... [--jar JAR] [--seeds K] [--error E] [--options "..."]
    python3 src/bench/scripts/physical_light.py reference FOLDER --scene SCENE [--jar JAR] [--seeds K] [--samples N] [--size WxH] [--options "..."]
    python3 src/bench/scripts/physical_light.py race FOLDER... [--jar JAR] [--runs K] [--pictures K] [--samples N] [--size WxH] [--methods ...] [--peers ...]

FOLDER has scene.json, reference.pfm, variance.pfm (linear, rows from the bottom) and, for `race`, scene.xml of Mitsuba 3. Where there is no scene.json, ours reads
scene.xml as well: a copy of the folder, with paths of any length and pixels that are boxes, as the references have.
`agree` renders K seeds and compares the means of blocks of 8 x 8 pixels with the reference: docs/notes/physical-light.md says by which rule.
`kept` renders K seeds with `--error E` and counts in how many the displayed error against the reference is no larger.
`reference` makes a folder: the mean of K seeds by ours; a scene.xml beside SCENE comes with it, at that size.
`race` gives CPU-seconds of whole processes, in turns, and errors against the reference, its own variance subtracted, as a table; with --runs 0 the
times are those of the small pictures.
Where scene.xml names the metal of hcconductor.py, Mitsuba's time is that of the faster of this plug-in and its own `roughconductor`.
JAR is the jar, for `java -jar`, or the launcher of the application.
Needs numpy; `race` also mitsuba (pip install numpy mitsuba; Debian's libllvm19 for its variant llvm_ad_rgb).
"""
import argparse
import json
import math
import pathlib
import re
import resource
import shlex
import shutil
import statistics
import subprocess
import sys
import tempfile

import numpy

HERE = pathlib.Path(__file__).resolve().parent
BLOCK = 8
METAL = "hcconductor"


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
    scene = folder / "scene.json"
    return run(
        program + ["render", scene if scene.exists() else folder / "scene.xml", "-o", out, "--seed", str(seed), "--progress", "none"]
        + antialias + sizes + shlex.split(options)
    )


def resized(xml, size):
    """A scene of Mitsuba's at this size; None is its own."""
    if not size:
        return xml
    width, height = size.split("x")
    xml = re.sub(r'(<default name="resx" value=)"\d+"', rf'\1"{width}"', xml)
    xml = re.sub(r'(<default name="resy" value=)"\d+"', rf'\1"{height}"', xml)
    xml = re.sub(r'(name="width" value=)"\d+"', rf'\1"{width}"', xml)
    return re.sub(r'(name="height" value=)"\d+"', rf'\1"{height}"', xml)


def mitsuba(variant, folder, seed, out, samples, size, scratch, built_in=False):
    """Mitsuba's path tracer with roulette from the fifth bounce, as is its default; on request with its own rough metal instead of our plug-in."""
    text = (folder / "scene.xml").read_text()
    if built_in:
        text = text.replace(f'<bsdf type="{METAL}">', '<bsdf type="roughconductor"><string name="distribution" value="ggx"/>')
        text = re.sub(r'<vector (name="(?:eta|k)")', r"<rgb \1", text)
    text = re.sub(r'(name="rr_depth" value=)"\d+"', r'\1"5"', text)
    text = re.sub(r'(name="spp" value=)"\d+"', rf'\1"{samples}"', text)
    text = re.sub(r'(name="seed" value=)"\d+"', rf'\1"{seed}"', text, count=1)
    # What a scene refers to lies beside it.
    scene = (folder if is_scene_of_files(folder) else scratch) / "raced.xml"
    scene.write_text(resized(text, size))
    return run([sys.executable, HERE / "peer_mitsuba.py", variant, scene, out])


def is_scene_of_files(folder):
    return not (folder / "scene.json").exists()


def copied(folder, scratch):
    """A scene of files at the size of its reference, in a folder that may be written to."""
    copy = scratch / folder.name
    shutil.copytree(folder, copy, copy_function=shutil.copyfile)
    for made in (copy, *copy.rglob("*")):
        made.chmod(0o755 if made.is_dir() else 0o644)
    height, width, _ = read_pfm(folder / "reference.pfm").shape
    text = re.sub(r'(name="max_depth" value=)"[^"]*"', r'\1"-1"', (folder / "scene.xml").read_text())
    text = re.sub(r'<rfilter type="[^"]*"/>', '<rfilter type="box"/>', text)
    text = re.sub(r'(<integer name="sample_count"[^>]*/>)', r'\1<integer name="seed" value="0"/>', text)
    (copy / "scene.xml").write_text(resized(text, f"{width}x{height}"))
    return copy


def agree(folder, jar, seeds, samples, options, scratch):
    pictures = []
    for seed in range(1, seeds + 1):
        out = scratch / "a.pfm"
        ours(jar, folder, seed, out, samples, options)
        pictures.append(read_pfm(out))
    return same(folder.name, folder, pictures)


def reference(folder, scene, chosen, scratch):
    """Makes a folder with the mean of pictures by ours, and the variance of that mean."""
    folder.mkdir(parents=True, exist_ok=True)
    text = scene.read_text()
    if chosen.size:
        described = json.loads(text)
        described["image"] = dict(zip(("width", "height"), map(int, chosen.size.split("x"))))
        text = json.dumps(described, indent=1)
    (folder / "scene.json").write_text(text)
    partner = scene.with_name("scene.xml")
    if partner.exists():
        (folder / "scene.xml").write_text(resized(partner.read_text(), chosen.size))
    count, total, squares = chosen.seeds, 0, 0
    for seed in range(1001, 1001 + count):
        out = scratch / "r.pfm"
        ours(chosen.jar, folder, seed, out, chosen.samples or 64, chosen.options)
        picture = read_pfm(out)
        total, squares = total + picture, squares + picture**2
    mean = total / count
    for name, values in ("reference", mean), ("variance", numpy.maximum(squares / count - mean**2, 0) / (count - 1)):
        height, width, _ = values.shape
        with open(folder / f"{name}.pfm", "wb") as file:
            file.write(f"PF\n{width} {height}\n-1.0\n".encode() + values.astype("<f4").tobytes())


def student(level, degrees):
    """What the size of Student's t with so many degrees of freedom exceeds with this probability."""
    # In t = tan(a) sqrt(degrees) the density is a power of the cosine, on a finite range.
    angles = numpy.linspace(0, math.pi / 2, 200_001)
    density = numpy.cos(angles) ** (degrees - 1)
    tails = numpy.cumsum(density[::-1])[::-1]
    return math.tan(angles[numpy.searchsorted(-tails, -level * tails[0])]) * math.sqrt(degrees)


def same(label, folder, pictures):
    """Whether the mean of pictures is the reference, by the rule of docs/notes/physical-light.md."""
    reference, own = read_pfm(folder / "reference.pfm"), read_pfm(folder / "variance.pfm")
    seeds = len(pictures)
    mean = numpy.mean(pictures, axis=0)
    difference = mean - reference
    height, width, bands = reference.shape
    rows, columns = height // BLOCK, width // BLOCK

    def blocks(values, power):
        cut = values[: rows * BLOCK, : columns * BLOCK].reshape(rows, BLOCK, columns, BLOCK, bands)
        return cut.sum(axis=(1, 3)) / BLOCK ** (2 * power)

    # Pixels of one picture may share paths (cluster): only pictures are independent of each other.
    variance = numpy.var([blocks(picture, 1) for picture in pictures], axis=0, ddof=1) / seeds
    deviation = numpy.sqrt(variance + blocks(own, 2))
    # Floats of the other renderer: no block is known to better than a ten-thousandth of the picture.
    floor = 1e-4 * reference.mean()
    z = numpy.abs(blocks(difference, 1)) / numpy.maximum(deviation, floor)
    tests = z.size
    # Šidák's level for all tests together at 1 %, two-sided.
    limit = student(1 - (1 - 0.01) ** (1 / tests), seeds - 1)
    share = float((z <= limit).mean())
    total = difference.mean(axis=(0, 1))
    means = numpy.var([picture.mean(axis=(0, 1)) for picture in pictures], axis=0, ddof=1) / seeds
    sigma = numpy.sqrt(means + own.sum(axis=(0, 1)) / (height * width) ** 2)
    relative = float(numpy.abs(total).max() / reference.mean())
    # As seldom as 4 standard deviations that are known.
    far = student(2 - 2 * statistics.NormalDist().cdf(4), seeds - 1)
    passed = share >= 0.9975 and (relative <= 1e-3 or bool((numpy.abs(total) <= far * sigma).all()))
    print(
        f"{label}: {share:.4%} of {tests} block means within {limit:.2f} sigma (99.75 % needed), largest {z.max():.1f}; "
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


def own_program(folder, chosen, options):
    return lambda seed, out, size: ours(chosen.jar, folder, seed, out, chosen.samples, options, size)


def racers(folder, chosen, scratch):
    """What is timed: programs, the name under which their errors stand, and whether their pictures are seen from the other side."""

    def peer(variant, built_in=False):
        return lambda seed, out, size: mitsuba(variant, folder, seed, out, chosen.samples, size, scratch, built_in)

    # A window is seen from the other side than Mitsuba's cameras.
    mirrored = not is_scene_of_files(folder)
    timed = {m: (own_program(folder, chosen, f"--method {m} {chosen.options}"), m, False) for m in chosen.methods.split(",")}
    if "scalar" in chosen.peers:
        timed["mitsuba scalar"] = peer("scalar_rgb"), "mitsuba scalar", mirrored
    timed["mitsuba llvm"] = peer("llvm_ad_rgb"), "mitsuba llvm", mirrored
    if METAL in (folder / "scene.xml").read_text():
        # Mitsuba's own metal masks otherwise: its errors mean nothing here, its time does. Python's calls for each bounce make the plug-in hopeless
        # in the scalar variant, whose errors are therefore taken with it and whose time without.
        if "scalar" in chosen.peers:
            timed["mitsuba scalar, its own metal"] = peer("scalar_rgb", True), "mitsuba scalar", mirrored
        timed["mitsuba llvm, its own metal"] = peer("llvm_ad_rgb", True), None, True
    return timed


def usual_size(folder):
    if is_scene_of_files(folder):
        return "320x180" if read_pfm(folder / "reference.pfm").shape[0] < 128 else "512x512"
    return "800x400" if json.loads((folder / "scene.json").read_text())["camera"]["type"] == "window" else "512x512"


def compare(folder, timed, partner, chosen, scratch, without=()):
    """Prints a table of errors and of times in turns, with --runs 0 those of the pictures whose errors are taken; `without`: programs too slow to be timed."""
    reference, own = read_pfm(folder / "reference.pfm"), read_pfm(folder / "variance.pfm")
    small, size = chosen.runs == 0, chosen.size or usual_size(folder)
    seconds, pictures = {name: [] for name in timed}, {}
    for seed in range(1, chosen.pictures + 1):
        drawn = set()
        for name, (program, figure, mirrored) in timed.items():
            # What differs in threads alone is drawn once where it is not timed.
            if (figure is None or figure in drawn) and not small:
                continue
            out = scratch / "error.pfm"
            spent = program(seed, out, None)
            if small and name not in without:
                seconds[name].append(spent)
            if figure and figure not in drawn:
                drawn.add(figure)
                pictures.setdefault(figure, []).append(read_pfm(out)[:, ::-1] if mirrored else read_pfm(out))
    figures = {f: (*errors(p, reference, own), numpy.mean(p) / reference.mean()) for f, p in pictures.items()}
    for k in range(chosen.runs):
        for name, (program, _, _) in timed.items():
            if name not in without:
                seconds[name].append(program(k + 1, scratch / "timed.pfm", size))
    # The partner's time of each turn is that of its faster way, where it has two.
    partners = [min(times) for times in zip(*(seconds[n] for n in timed if n == partner or n.startswith(partner + ", its own")))]
    height, width, _ = reference.shape
    turns, size = (chosen.pictures, f"{width}x{height}") if small else (chosen.runs, size)
    print(
        f"{folder.name}: {chosen.samples} samples per pixel; CPU-seconds at {size}, medians of {turns} in turns; ratio: to those of {partner} in "
        f"the same turn, median; errors at {width}x{height}, {chosen.pictures} seeds; gain: times less squared error x CPU than {partner}\n"
        "| program | CPU-s | ratio | relative variance (bulk) | gain (bulk) | displayed RMSE | gain | mean / reference's |\n|---|---|---|---|---|---|---|---|"
    )
    for name, (_, figure, _) in timed.items():
        ratio = statistics.median(s / p for s, p in zip(seconds[name], partners)) if seconds[name] else None
        cpu = f"{statistics.median(seconds[name]):.2f} | {ratio:.2f}" if ratio else "| "
        print(f"| {name} | {cpu} | " + (row(figures[figure], figures[timed[partner][1]], ratio) if figure else "| | | | |"), flush=True)
    return pictures


def race(folder, chosen, scratch):
    # A Python plug-in for each bounce of each path: minutes.
    slow = {"mitsuba scalar"} if METAL in (folder / "scene.xml").read_text() else set()
    compare(folder, racers(folder, chosen, scratch), "mitsuba llvm", chosen, scratch, slow)


def row(figures, partner, ratio):
    """Cells with a program's errors and, where its share of the partner's time is known, how many times less squared error x CPU it has."""
    whole, bulk, shown, mean = figures
    gains = ["", "", ""] if ratio is None else [f"{p / max(f * ratio, 1e-30):.3g}" for p, f in zip(partner, figures)]
    return f"{whole:.3g} ({bulk:.3g}) | {gains[0]} ({gains[1]}) | {math.sqrt(max(shown, 0)):.4f} | {gains[2]} | {mean:.4f} |"


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("what", choices=["agree", "kept", "reference", "race"])
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("--jar", default="target/enlightenment.jar")
    parser.add_argument("--seeds", type=int, default=16)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--samples", type=int)
    parser.add_argument("--error", type=float, default=0.02)
    parser.add_argument("--scene", type=pathlib.Path)
    parser.add_argument("--pictures", type=int, default=6)
    parser.add_argument("--methods", default="raytrace,cluster")
    parser.add_argument("--peers", default="scalar,llvm", help="variants of Mitsuba; llvm always is")
    parser.add_argument("--size", help="of the timed pictures: 512x512, for a window camera 800x400; of a reference that is made: the scene's")
    parser.add_argument("--options", default="")
    chosen = parser.parse_args()
    ok = True
    with tempfile.TemporaryDirectory() as name:
        for given in chosen.folders:
            folder = copied(given, pathlib.Path(name)) if chosen.what != "reference" and is_scene_of_files(given) else given
            if chosen.what == "agree":
                ok &= agree(folder, chosen.jar, chosen.seeds, chosen.samples or 64, chosen.options, pathlib.Path(name))
            elif chosen.what == "kept":
                ok &= kept(folder, chosen.jar, chosen.seeds, chosen.error, chosen.options, pathlib.Path(name))
            elif chosen.what == "reference":
                reference(folder, chosen.scene, chosen, pathlib.Path(name))
            else:
                chosen.samples = chosen.samples or 16
                race(folder, chosen, pathlib.Path(name))
    sys.exit(0 if ok else 1)


if __name__ == "__main__":
    main()
