"""Renders a simple scene by LuxCore and compares it with a reference: CPU-seconds of the whole process and errors, as physical_light.py has them.

    python3 src/bench/scripts/luxcore.py FOLDER [--samples N] [--seeds K] [--depth D] [--engines path,bidirectional,metropolis]

FOLDER has scene.json (a window camera that looks along +z, spheres and rectangles, matte or mirror, spherical lights), reference.pfm and
variance.pfm. Spheres become 256 x 128 quads (lamps 64 x 32) with the normals of the sphere. One thread, box filter, nothing clamped, roulette from the
fifth event. Needs numpy and pyluxcore (pip install numpy pyluxcore).
"""
import argparse
import importlib.util
import json
import math
import os
import pathlib
import statistics
import subprocess
import sys
import tempfile
import time

import numpy

HERE = pathlib.Path(__file__).resolve().parent
SPEC = importlib.util.spec_from_file_location("physical_light", HERE / "physical_light.py")
physical_light = importlib.util.module_from_spec(SPEC)
SPEC.loader.exec_module(physical_light)

ENGINES = {
    "path": ("PATHCPU", "SOBOL"),
    "bidirectional": ("BIDIRCPU", "SOBOL"),
    "metropolis": ("PATHCPU", "METROPOLIS"),
    "bidirectional metropolis": ("BIDIRCPU", "METROPOLIS"),
}


def sphere(center, radius, across, down):
    points, normals, triangles = [], [], []
    for j in range(down + 1):
        for i in range(across + 1):
            t, p = math.pi * j / down, 2 * math.pi * i / across
            n = (math.sin(t) * math.cos(p), math.cos(t), math.sin(t) * math.sin(p))
            normals.append(n)
            points.append(tuple(c + radius * k for c, k in zip(center, n)))
    for j in range(down):
        for i in range(across):
            a, b = j * (across + 1) + i, (j + 1) * (across + 1) + i
            triangles += [(a, a + 1, b), (b, a + 1, b + 1)]
    return points, triangles, normals


def build(pyluxcore, description):
    scene, props = pyluxcore.Scene(), pyluxcore.Properties()

    def put(key, *values):
        props.Set(pyluxcore.Property(key, list(values)))

    camera = description["camera"]
    eye, left, top = camera["eye"], camera["lowerLeft"], camera["upperRight"]
    distance = left[2] - eye[2]
    put("scene.camera.type", "perspective")
    put("scene.camera.lookat.orig", *map(float, eye))
    put("scene.camera.lookat.target", float(eye[0]), float(eye[1]), float(left[2]))
    put("scene.camera.up", 0.0, 1.0, 0.0)
    put("scene.camera.fieldofview", math.degrees(2 * math.atan(1 / distance)))
    put("scene.camera.screenwindow", float(left[0] - eye[0]), float(top[0] - eye[0]), float(left[1] - eye[1]), float(top[1] - eye[1]))
    put("scene.camera.autofocus.enable", False)
    put("scene.camera.cliphither", float(distance))
    for name, m in description["materials"].items():
        key = f"scene.materials.{name.replace(' ', '_')}."
        put(key + "type", m["type"])
        put(key + ("kd" if m["type"] == "matte" else "kr"), *map(float, m["color"]["linear"]))
    things = [(o, o["material"].replace(" ", "_")) for o in description["objects"]]
    for k, light in enumerate(description["lights"]):
        key = f"scene.materials.light{k}."
        put(key + "type", "matte")
        put(key + "kd", 0.0, 0.0, 0.0)
        put(key + "emission", *map(float, light["radiance"]))
        # Otherwise lamps of more than 256 triangles are left to chance.
        put(key + "emission.directlightsampling.type", "ENABLED")
        things.append((light, f"light{k}"))
    for k, (thing, material) in enumerate(things):
        if thing["type"] == "sphere":
            fine = (64, 32) if material.startswith("light") else (256, 128)
            points, triangles, normals = sphere(thing["center"], thing["radius"], *fine)
        else:
            points, triangles, normals = [tuple(map(float, c)) for c in thing["corners"]], [(0, 1, 2), (0, 2, 3)], None
        scene.DefineMesh(f"mesh{k}", points, triangles, normals, None, None, None)
        put(f"scene.objects.thing{k}.shape", f"mesh{k}")
        put(f"scene.objects.thing{k}.material", material)
    scene.Parse(props)
    return scene


def child(folder, engine, samples, seed, depth, out):
    """In a process of its own, whose time is taken."""
    import pyluxcore

    pyluxcore.Init(lambda message: None)
    description = json.loads((folder / "scene.json").read_text())
    width, height = description["image"]["width"], description["image"]["height"]
    kind, sampler = ENGINES[engine]
    props = pyluxcore.Properties()
    for key, value in {
        "renderengine.type": kind,
        "sampler.type": sampler,
        "renderengine.seed": seed,
        "native.threads.count": 1,
        "path.pathdepth.total": depth,
        "path.pathdepth.diffuse": depth,
        "path.pathdepth.glossy": depth,
        "path.pathdepth.specular": depth,
        "path.russianroulette.depth": 5,
        "path.clamping.variance.maxvalue": 0.0,
        "path.maxdepth": depth // 2,
        "light.maxdepth": depth // 2,
        "batch.haltspp": samples,
        "film.width": width,
        "film.height": height,
        "film.filter.type": "NONE",
        "film.outputs.0.type": "RGB",
        "film.outputs.0.filename": "rgb.exr",
        "film.imagepipelines.0.0.type": "NOP",
    }.items():
        props.Set(pyluxcore.Property(key, value))
    config = pyluxcore.RenderConfig(props, build(pyluxcore, description))
    session = pyluxcore.RenderSession(config)
    session.Start()
    while not session.HasDone():
        time.sleep(0.02)
        session.UpdateStats()
    session.Stop()
    rgb = numpy.zeros((height, width, 3), dtype="f4")
    session.GetFilm().GetOutputFloat(pyluxcore.FilmOutputType.RGB, rgb.reshape(-1), 0)
    with open(out, "wb") as file:
        file.write(f"PF\n{width} {height}\n-1.0\n".encode() + rgb.tobytes())
    # Its destructors, at the end of Python, may fail.
    os._exit(0)


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--samples", type=int, default=16)
    parser.add_argument("--seeds", type=int, default=2)
    parser.add_argument("--depth", type=int, default=16)
    parser.add_argument("--engines", default="path,bidirectional,metropolis")
    parser.add_argument("--child")
    parser.add_argument("--out")
    parser.add_argument("--seed", type=int, default=1)
    chosen = parser.parse_args()
    if chosen.child:
        child(chosen.folder, chosen.child, chosen.samples, chosen.seed, chosen.depth, chosen.out)
        return
    reference = physical_light.read_pfm(chosen.folder / "reference.pfm")
    own = physical_light.read_pfm(chosen.folder / "variance.pfm")
    for engine in chosen.engines.split(","):
        seconds, pictures = [], []
        with tempfile.TemporaryDirectory() as name:
            for seed in range(1, chosen.seeds + 1):
                out = pathlib.Path(name) / "lux.pfm"
                command = [sys.executable, __file__, str(chosen.folder), "--child", engine, "--out", str(out), "--seed", str(seed)]
                command += ["--samples", str(chosen.samples), "--depth", str(chosen.depth)]
                seconds.append(physical_light.run(command))
                # A window that is seen from the other side.
                pictures.append(physical_light.read_pfm(out)[:, ::-1])
        whole, bulk, shown = physical_light.errors(pictures, reference, own)
        mean = numpy.mean(pictures) / reference.mean()
        print(
            f"{engine:25} {statistics.median(seconds):6.1f} CPU-s  relative variance {whole:.5f} (bulk {bulk:.5f}), "
            f"displayed RMSE {math.sqrt(max(shown, 0)):.5f}; mean brightness {mean:.4f} of the reference's",
            flush=True,
        )


if __name__ == "__main__":
    main()
