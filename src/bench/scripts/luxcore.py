"""Renders simple scenes by LuxCore and compares it with a reference and with ours: CPU-seconds of whole processes in turns, and errors.

    python src/bench/scripts/luxcore.py FOLDER [--jar JAR] [--runs K] [--pictures K] [--samples N] [--size WxH] [--engines ...] [--methods ...]

FOLDER is one of physical_light.py's, with a scene of what meshes.py knows, matte or mirror. Round things become 256 x 128 quads (lamps 64 x 32) with the
normals of the thing. One thread, box filter, nothing clamped, roulette from the fifth event, paths of at most --depth events. With 8
pictures or more the mean of each program is compared with the reference, by blocks, as physical_light.py's `agree` does. With --runs 0 the times are those
of the small pictures. Needs numpy and pyluxcore (pip install numpy pyluxcore==2.11.2).
"""
import argparse
import importlib.util
import json
import os
import pathlib
import sys
import tempfile
import time

import numpy

HERE = pathlib.Path(__file__).resolve().parent

ENGINES = {
    "path": ("PATHCPU", "SOBOL"),
    "bidirectional": ("BIDIRCPU", "SOBOL"),
    "metropolis": ("PATHCPU", "METROPOLIS"),
    "bidirectional-metropolis": ("BIDIRCPU", "METROPOLIS"),
}


def sibling(name):
    spec = importlib.util.spec_from_file_location(name, HERE / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def build(pyluxcore, meshes, description):
    scene, props = pyluxcore.Scene(), pyluxcore.Properties()

    def put(key, *values):
        props.Set(pyluxcore.Property(key, list(values)))

    camera = meshes.Camera(description)
    put("scene.camera.type", "perspective")
    put("scene.camera.lookat.orig", *map(float, camera.eye))
    put("scene.camera.lookat.target", *map(float, camera.eye + camera.forward))
    put("scene.camera.up", *map(float, camera.up))
    put("scene.camera.fieldofview", 90.0)
    (x, y), (w, h) = camera.center, camera.half
    # A picture that is seen from the other side: its right is our left. Its films hold everything one row lower than the camera sees it.
    y -= 2 * h / description["image"]["height"]
    put("scene.camera.screenwindow", *map(float, (-x - w, -x + w, y - h, y + h)))
    put("scene.camera.autofocus.enable", False)
    put("scene.camera.cliphither", 0.01)
    for k, (mesh, material, light) in enumerate(meshes.things(description)):
        key = f"scene.materials.material{k}."
        if light:
            put(key + "type", "matte")
            put(key + "kd", 0.0, 0.0, 0.0)
            put(key + "emission", *map(float, light["radiance"]))
            # Otherwise lamps of more than 256 triangles are left to chance.
            put(key + "emission.directlightsampling.type", "ENABLED")
        else:
            put(key + "type", material["type"])
            put(key + ("kd" if material["type"] == "matte" else "kr"), *meshes.linear(material["color"]))
        triangles = [t for a, b, c, d in mesh.quads for t in ((a, b, c), (a, c, d))]
        normals = None if mesh.normals is None else [tuple(map(float, n)) for n in mesh.normals]
        scene.DefineMesh(f"mesh{k}", [tuple(map(float, p)) for p in mesh.points], triangles, normals, None, None, None)
        put(f"scene.objects.thing{k}.shape", f"mesh{k}")
        put(f"scene.objects.thing{k}.material", f"material{k}")
    scene.Parse(props)
    return scene


def child(folder, engine, chosen):
    """In a process of its own, whose time is taken."""
    import pyluxcore

    pyluxcore.Init(lambda message: None)
    description = json.loads((folder / "scene.json").read_text())
    width, height = (int(v) for v in chosen.size.split("x")) if chosen.size else (description["image"][k] for k in ("width", "height"))
    description["image"] = {"width": width, "height": height}
    kind, sampler = ENGINES[engine]
    props = pyluxcore.Properties()
    for key, value in {
        "renderengine.type": kind,
        "sampler.type": sampler,
        "renderengine.seed": chosen.seed,
        "native.threads.count": 1,
        "path.pathdepth.total": chosen.depth,
        "path.pathdepth.diffuse": chosen.depth,
        "path.pathdepth.glossy": chosen.depth,
        "path.pathdepth.specular": chosen.depth,
        "path.russianroulette.depth": 5,
        "path.clamping.variance.maxvalue": 0.0,
        "path.maxdepth": chosen.depth // 2,
        "light.maxdepth": chosen.depth // 2,
        "batch.haltspp": chosen.samples,
        "film.width": width,
        "film.height": height,
        "film.filter.type": "NONE",
        "film.outputs.0.type": "RGB",
        "film.outputs.0.filename": "rgb.exr",
        "film.imagepipelines.0.0.type": "NOP",
    }.items():
        props.Set(pyluxcore.Property(key, value))
    config = pyluxcore.RenderConfig(props, build(pyluxcore, sibling("meshes"), description))
    session = pyluxcore.RenderSession(config)
    session.Start()
    while not session.HasDone():
        time.sleep(0.02)
        session.UpdateStats()
    session.Stop()
    rgb = numpy.zeros((height, width, 3), dtype="f4")
    session.GetFilm().GetOutputFloat(pyluxcore.FilmOutputType.RGB, rgb.reshape(-1), 0)
    with open(chosen.out, "wb") as file:
        file.write(f"PF\n{width} {height}\n-1.0\n".encode() + rgb.tobytes())
    # Its destructors, at the end of Python, may fail.
    os._exit(0)


def program(physical_light, folder, chosen, engine):
    def render(seed, out, size):
        command = [sys.executable, __file__, folder, "--child", engine, "--out", out, "--seed", str(seed)]
        command += ["--samples", str(chosen.samples), "--depth", str(chosen.depth)] + (["--size", size] if size else [])
        return physical_light.run(command)

    return render


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", type=pathlib.Path)
    parser.add_argument("--jar", default="target/enlightenment.jar")
    parser.add_argument("--samples", type=int, default=16)
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--pictures", type=int, default=6)
    parser.add_argument("--size")
    parser.add_argument("--depth", type=int, default=16)
    parser.add_argument("--engines", default="path,bidirectional,metropolis")
    parser.add_argument("--methods", default="raytrace,cluster,bidirectional,metropolis")
    parser.add_argument("--child", help=argparse.SUPPRESS)
    parser.add_argument("--out", help=argparse.SUPPRESS)
    parser.add_argument("--seed", type=int, default=1, help=argparse.SUPPRESS)
    chosen = parser.parse_args()
    if chosen.child:
        child(chosen.folder, chosen.child, chosen)
        return
    physical_light = sibling("physical_light")
    engines = chosen.engines.split(",")
    timed = {f"LuxCore, {e}": (program(physical_light, chosen.folder, chosen, e), f"LuxCore, {e}", True) for e in engines}
    for method in chosen.methods.split(",") if chosen.methods else []:
        timed[method] = physical_light.own_program(chosen.folder, chosen, f"--method {method} --threads 1"), method, False
    with tempfile.TemporaryDirectory() as name:
        pictures = physical_light.compare(chosen.folder, timed, f"LuxCore, {engines[0]}", chosen, pathlib.Path(name))
    # Of fewer pictures the noise of a block is not known well enough.
    for name, drawn in pictures.items() if chosen.pictures >= 8 else []:
        physical_light.same(f"{chosen.folder.name}, {name}", chosen.folder, drawn)


if __name__ == "__main__":
    main()
