"""Renders simple scenes by Cycles (Blender) and compares it with a reference and with ours: CPU-seconds of whole processes in turns, and errors.

    python src/bench/scripts/peer_cycles.py FOLDER... [--jar JAR] [--runs K] [--pictures K] [--samples N] [--size WxH] [--threads 1,2] [--methods raytrace,cluster]

FOLDER is one of physical_light.py's, with a scene of what meshes.py knows, matte, mirror and glass. Spheres are meshes of 256 x 128 quads with the normals
of the sphere, lamps glowing meshes (of 64 x 32 quads where round) that are sampled from their front. Box filter, no denoiser, no adaptive sampling, no
clamping, no blurred gloss, 1,024 bounces of every kind at most, roulette and light tree as is Cycles' default; --guided asks for path guiding, too.
Blender's add-on is a module named cycles, which this file must not be. Needs Python 3.11, numpy and bpy (pip install numpy bpy==4.2.0).
"""
import argparse
import importlib.util
import json
import pathlib
import sys
import tempfile

import numpy

HERE = pathlib.Path(__file__).resolve().parent


def sibling(name):
    spec = importlib.util.spec_from_file_location(name, HERE / f"{name}.py")
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


def surface(bpy, name, material, light):
    made = bpy.data.materials.new(name)
    made.use_nodes = True
    tree = made.node_tree
    tree.nodes.clear()
    out = tree.nodes.new("ShaderNodeOutputMaterial")

    def put(kind, **values):
        node = tree.nodes.new(kind)
        for key, value in values.items():
            node.inputs[key].default_value = value
        return node

    if light:
        node = put("ShaderNodeEmission", Color=(*map(float, light["radiance"]), 1))
        made.cycles.emission_sampling = "FRONT"
        if light["type"] == "rectangle":
            # Of one side.
            seen, flip = put("ShaderNodeNewGeometry"), put("ShaderNodeMath")
            flip.operation = "SUBTRACT"
            flip.inputs[0].default_value = 1
            tree.links.new(seen.outputs["Backfacing"], flip.inputs[1])
            tree.links.new(flip.outputs[0], node.inputs["Strength"])
        else:
            node.inputs["Strength"].default_value = 1
    else:
        color = (*map(float, material["color"]["linear"]), 1)
        if material["type"] == "matte":
            node = put("ShaderNodeBsdfDiffuse", Color=color, Roughness=0)
        elif material["type"] == "mirror":
            node = put("ShaderNodeBsdfAnisotropic", Color=color, Roughness=0)
        elif material["type"] == "glass":
            node = put("ShaderNodeBsdfGlass", Color=color, Roughness=0, IOR=material["indexOfRefraction"])
        else:
            sys.exit(f"no such material here: {material['type']}")
    tree.links.new(node.outputs[0], out.inputs["Surface"])
    return made


def build(bpy, meshes, description, width, height):
    import mathutils

    for k, (mesh, material, light) in enumerate(meshes.things(description)):
        data = bpy.data.meshes.new(f"mesh{k}")
        data.from_pydata(mesh.points.tolist(), [], mesh.quads)
        if mesh.normals is not None:
            data.polygons.foreach_set("use_smooth", [True] * len(mesh.quads))
            data.normals_split_custom_set_from_vertices([tuple(n) for n in mesh.normals])
        data.materials.append(surface(bpy, f"material{k}", material, light))
        bpy.context.scene.collection.objects.link(bpy.data.objects.new(f"thing{k}", data))
    camera = meshes.Camera(description)
    # A camera looks along its own -z; our pictures are seen from the other side.
    right = numpy.cross(camera.forward, camera.up)
    matrix = numpy.eye(4)
    matrix[:3, 0], matrix[:3, 1], matrix[:3, 2], matrix[:3, 3] = right, camera.up, -camera.forward, camera.eye
    data = bpy.data.cameras.new("camera")
    data.sensor_fit, data.sensor_width = "HORIZONTAL", 36
    half = camera.half[1] * width / height
    data.lens = 36 / (2 * half)
    data.shift_x, data.shift_y = -camera.center[0] / (2 * half), camera.center[1] / (2 * half)
    data.clip_start, data.clip_end = 0.01, 1000
    seen = bpy.data.objects.new("camera", data)
    seen.matrix_world = mathutils.Matrix(matrix.tolist())
    bpy.context.scene.collection.objects.link(seen)
    bpy.context.scene.camera = seen
    world = bpy.data.worlds.new("surroundings")
    world.use_nodes = True
    background = description["shading"].get("background", {"linear": [0, 0, 0]})["linear"]
    world.node_tree.nodes["Background"].inputs["Color"].default_value = (*map(float, background), 1)
    world.node_tree.nodes["Background"].inputs["Strength"].default_value = 1
    bpy.context.scene.world = world


def child(folder, chosen):
    """In a process of its own, whose time is taken."""
    import bpy

    meshes = sibling("meshes")
    description = json.loads((folder / "scene.json").read_text())
    width, height = (int(v) for v in chosen.size.split("x")) if chosen.size else (description["image"][k] for k in ("width", "height"))
    bpy.ops.wm.read_homefile(use_empty=True)
    build(bpy, meshes, description, width, height)
    scene = bpy.context.scene
    scene.render.engine = "CYCLES"
    wanted = {
        "device": "CPU",
        "samples": chosen.samples,
        "seed": chosen.seed,
        "use_denoising": False,
        "use_adaptive_sampling": False,
        "use_guiding": chosen.guided,
        "sample_clamp_direct": 0,
        "sample_clamp_indirect": 0,
        "blur_glossy": 0,
        "caustics_reflective": True,
        "caustics_refractive": True,
        "pixel_filter_type": "BOX",
        "use_auto_tile": False,
    }
    for kind in ("max", "diffuse", "glossy", "transmission", "volume", "transparent_max"):
        wanted[f"{kind}_bounces"] = 1024
    for key, value in wanted.items():
        setattr(scene.cycles, key, value)
    scene.render.threads_mode, scene.render.threads = "FIXED", chosen.thread
    scene.render.resolution_x, scene.render.resolution_y, scene.render.resolution_percentage = width, height, 100
    scene.render.image_settings.file_format = "OPEN_EXR"
    scene.render.image_settings.color_depth = "32"
    scene.render.image_settings.exr_codec = "NONE"
    scene.render.filepath = str(chosen.out) + ".exr"
    bpy.ops.render.render(write_still=True)
    image = bpy.data.images.load(scene.render.filepath)
    image.colorspace_settings.name = "Non-Color"
    values = numpy.empty(width * height * image.channels, "f4")
    image.pixels.foreach_get(values)
    rgb = numpy.ascontiguousarray(values.reshape(height, width, image.channels)[:, :, :3])
    with open(chosen.out, "wb") as file:
        file.write(f"PF\n{width} {height}\n-1.0\n".encode() + rgb.astype("<f4").tobytes())


def program(physical_light, folder, chosen, threads, guided):
    def render(seed, out, size):
        command = [sys.executable, __file__, folder, "--child", "--seed", str(seed), "--out", out]
        command += ["--samples", str(chosen.samples), "--thread", str(threads)] + (["--size", size] if size else []) + (["--guided"] if guided else [])
        return physical_light.run(command)

    return render


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=pathlib.Path)
    parser.add_argument("--jar", default="target/enlightenment.jar")
    parser.add_argument("--runs", type=int, default=3)
    parser.add_argument("--pictures", type=int, default=6)
    parser.add_argument("--samples", type=int, default=16)
    parser.add_argument("--size")
    parser.add_argument("--threads", default="1,2")
    parser.add_argument("--methods", default="raytrace,cluster")
    parser.add_argument("--guided", action="store_true")
    parser.add_argument("--child", action="store_true", help=argparse.SUPPRESS)
    parser.add_argument("--out", type=pathlib.Path, help=argparse.SUPPRESS)
    parser.add_argument("--seed", type=int, default=1, help=argparse.SUPPRESS)
    parser.add_argument("--thread", type=int, default=1, help=argparse.SUPPRESS)
    chosen = parser.parse_args()
    if chosen.child:
        child(chosen.folders[0], chosen)
        return
    physical_light = sibling("physical_light")
    for folder in chosen.folders:
        with tempfile.TemporaryDirectory() as name:
            threads = [int(t) for t in chosen.threads.split(",")]
            timed = {}
            for guided in [False, True] if chosen.guided else [False]:
                kind = "Cycles, guided" if guided else "Cycles"
                for t in threads:
                    timed[f"{kind}, threads: {t}"] = program(physical_light, folder, chosen, t, guided), kind, True
            for method in chosen.methods.split(","):
                for t in threads:
                    timed[f"{method}, threads: {t}"] = physical_light.own_program(folder, chosen, f"--method {method} --threads {t}"), method, False
            physical_light.compare(folder, timed, f"Cycles, threads: {threads[0]}", chosen, pathlib.Path(name))


if __name__ == "__main__":
    main()
