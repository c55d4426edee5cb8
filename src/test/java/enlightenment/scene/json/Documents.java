package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.SceneException.Problem;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;

/** Documents for tests: one that has everything, edits of it, and the shipped scenes beside stand-ins for their images. */
final class Documents {
    static final byte[] PNG_START = {(byte) 0x89, 'P', 'N', 'G', '\r', '\n', 0x1a, '\n'};

    /** A right scene with every part, every type and every key but {@code $schema}. */
    static final String EVERYTHING =
            """
            {
              "name": "everything",
              "image": { "width": 40, "height": 20 },
              "camera": { "type": "window", "eye": [0, 1, -3], "lowerLeft": [-3, 0, 0], "upperLeft": [-3, 3, 0],
                "upperRight": [3, 3, 0], "lowerRight": [3, 0, 0], "pupilRadius": 0.5 },
              "shading": { "model": "classic", "ambient": 0.25, "shadow": 0.75, "background": "#102030", "maxBounces": 7 },
              "display": { "exposure": -0.5, "tone": "filmic" },
              "meshes": { "gem": { "file": "gem.obj", "part": "upper", "normals": "smooth", "crease": 40 } },
              "textures": {
                "ice": { "type": "file", "file": "ice.png", "filter": "nearest", "encoding": "linear" },
                "checks": { "type": "checker", "colors": ["#ffffff", [0, 0.5, 1]], "scale": 8 },
                "plain": { "type": "color", "color": "#0000ff" }
              },
              "materials": {
                "ice": { "type": "matte", "color": { "texture": "ice" }, "receivesShadows": false },
                "chrome": { "type": "mirror", "color": [0.1, 0.2, 0.3], "radiance": 0.5, "receivesShadows": true },
                "glass": { "type": "glass", "color": "#fefefe", "indexOfRefraction": 1.5, "transparency": 0.875,
                  "priority": -2, "roughness": {"texture": "checks", "channel": "red", "factor": 0.25}, "absorption": [0.5, 0, 2], "multipleScattering": false,
                  "dispersion": 36.5, "receivesShadows": true }, "lens": { "type": "glass", "color": "#fefefe", "indexOfRefraction": 1.8125, "smoothRefraction": true },
                "ember": { "type": "matte", "color": { "linear": [0.25, 0.5, 1] }, "roughness": 0.625, "radiance": [4, 2, 0], "radianceMap": {"texture": "checks"}, "radianceSide": "front", "ultraviolet": 2.5 },
                "copper": { "type": "glossy", "color": "#ffeeff", "roughness": 0.375, "eta": [0.2, 0.92, 1.1], "k": [3.91, 2.45, 2.14],
                  "multipleScattering": false, "radiance": 1.5, "ultraviolet": 0.25 }, "enamel": { "type": "principled", "color": "#112131", "metallic": {"texture": "ice", "channel": "blue"}, "roughness": {"texture": "checks", "factor": 0.75}, "indexOfRefraction": 1.625, "specular": 0.5, "clearcoat": 0.25, "clearcoatRoughness": {"texture": "ice", "channel": "green", "factor": 0.125}, "sheen": 0.4375, "sheenTint": 0.3125, "radiance": 0.0625, "ultraviolet": 3 }, "varnish": { "type": "coated", "color": "#804020", "roughness": 0.6875, "indexOfRefraction": 1.75, "nonlinear": true, "radiance": 0.375, "ultraviolet": 0.125 },
                "wax": { "type": "scattering", "color": "#f0e0c0", "meanFreePath": [0.3, 0.2, 0.1], "anisotropy": 0.375,
                  "indexOfRefraction": 1.44, "roughness": 0.125, "priority": 3 },
                "milk": { "type": "scattering", "scatteringCoefficient": [6, 5, 4], "absorptionCoefficient": 0.125 },
                "marker": { "type": "fluorescent", "color": [0.5, 0.25, 0], "absorption": [320, 450], "emission": [500, 600.5],
                  "yield": 0.875, "radiance": 0.5, "ultraviolet": 0.75 }, "leaf": { "type": "mask", "of": { "type": "matte", "color": "#306020" }, "map": {"texture": "ice"} }, "rust": { "type": "mix", "materials": ["leaf", { "type": "matte", "color": "#c0c0c0" }], "weight": 0.5625 }, "grooves": { "type": "normalMap", "of": "rust", "map": {"texture": "plain"} }, "hammered": { "type": "bump", "of": "grooves", "map": {"texture":  "ice"}, "height": -0.0625 }
              },
              "groups": {
                "pair": [
                  { "name": "one", "type": "sphere", "center": [0, 0, 0], "radius": 0.5, "material": "ice" },
                  { "name": "other", "type": "mesh", "mesh": "gem", "transform": [{ "translate": [1, 0, 0] }], "material": "chrome" }
                ]
              },
              "lights": [
                { "type": "sphere", "center": [0, 1, 1], "radius": 0.15, "color": "#ffffff", "radiance": [200, 150, 100], "ultraviolet": 7 },
                { "type": "rectangle", "corners": [[0, 9, 0], [0, 9, 1], [1, 9, 1], [1, 9, 0]], "color": "#ffffee", "twoSided": false, "power": 40 },
                { "type": "point", "position": [0, 5, 5], "color": [1, 1, 1], "intensity": 3 }
              ],
              "objects": [
                { "name": "ball", "type": "sphere", "center": [-2, 1.10, 4], "radius": 1.5, "rotation": 200, "material": "ice" },
                { "name": "wall", "type": "rectangle", "corners": [[-6, -6, 8], [-6, 6, 8], [6, 6, 8], [6, -6, 8]], "material": "chrome" },
                { "name": "dish", "type": "disk", "center": [0, 0, 5], "normal": [0, 2, 0], "radius": 2.5, "material": "glass" },
                { "name": "rod", "type": "cylinder", "base": [1, 0, 0], "top": [1, 2, 0], "radius": 0.3, "capped": false, "material": { "type": "matte", "color": { "texture": "checks" } } },
                { "name": "hat", "type": "cone", "base": [2, 0, 0], "apex": [2, 3, 0], "radius": 0.7, "topRadius": 0.1, "capped": false, "material": "ice" },
                { "name": "die", "type": "cube", "center": [3, 0, 3], "radius": 1.25, "rotation": [10, 20, 30], "faces": ["ice", "ice", "chrome", "chrome", "glass", { "type": "matte", "color": "#010203" }], "material": "ice" },
                { "name": "brick", "type": "box", "min": [0, 0, 7], "max": [1, 2, 8], "material": "ice" },
                { "name": "ring", "type": "torus", "center": [0, 4, 4], "axis": [0, 0, 1], "majorRadius": 1.75, "minorRadius": 0.35, "material": "chrome" },
                { "name": "sail", "type": "triangle", "vertices": [[0, 0, 9], [1, 0, 9], [0, 1, 9]], "material": "ice" },
                { "name": "gem", "type": "mesh", "mesh": "gem", "transform": [{ "scale": 0.5 }, { "rotate": [0, 45, 0] },
                  { "translate": [0.1, 2, 3] }], "material": "glass" },
                { "name": "stone", "type": "mesh", "file": "gem.obj", "part": "lower", "normals": "smooth", "crease": 30,
                  "transform": [{ "scale": [1, 2, 3] }, { "axis": [0, 1, 1], "angle": 30 },
                  { "matrix": [1, 0, 0, 5.5, 0, 0, -1, 0.1, 0, 1, 0, 7] }], "material": "ice" },
                { "name": "pair", "type": "group", "group": "pair", "transform": [{ "translate": [4, 0.1, 9] }] }
              ],
              "render": { "method": "cluster", "antialias": 3, "shadowSamples": 7, "seed": 99 },
              "animation": { "frames": 11, "framesPerSecond": 25,
                "tracks": [{ "target": "/objects/0/center/1", "keys": { "0": 1, "10": 2 } }] }
            }
            """;

    /** An octahedron, closed, whose upper and lower half are parts. */
    static final String GEM =
            """
            v 1 0 0
            v 0 0 1
            v -1 0 0
            v 0 0 -1
            v 0 1 0
            v 0 -1 0
            usemtl upper
            f 1 5 2
            f 2 5 3
            f 3 5 4
            f 4 5 1
            usemtl lower
            f 2 6 1
            f 3 6 2
            f 4 6 3
            f 1 6 4
            """;

    private Documents() {}

    /** {@link #EVERYTHING} with one part of its text, which must occur exactly once, replaced. */
    static String edited(String part, String replacement) {
        int at = EVERYTHING.indexOf(part);
        if (at < 0 || EVERYTHING.indexOf(part, at + 1) >= 0) {
            throw new IllegalArgumentException("not exactly once in the document: " + part);
        }
        return EVERYTHING.replace(part, replacement);
    }

    /** A scene of nothing but these objects. */
    static String withObjects(String objects) {
        return "{\"image\": {\"width\": 4, \"height\": 2}, \"camera\": {\"type\": \"isometric\", \"lookAt\": [0, 0, 0],"
                + " \"height\": 5}, \"objects\": [" + objects + "]}";
    }

    /** Puts what begins like an image, a mesh, and the intensities of a lamp where {@link #EVERYTHING} looks for them. */
    static Path withImage(Path folder) {
        try {
            Files.write(folder.resolve("ice.png"), PNG_START);
            Files.writeString(folder.resolve("gem.obj"), GEM);
            Files.writeString(
                    folder.resolve("lamp.ies"),
                    "IESNA:LM-63-2002\nTILT=NONE\n1 -1 2 2 1 1 2 0 0 0 1 1 9\n0 90 0 8 4\n");
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
        return folder;
    }

    static Scene read(String json, Path folder) {
        return SceneReader.readString(json, folder, "scene.json");
    }

    static List<Problem> problems(String json, Path folder) {
        return assertThrows(SceneException.class, () -> read(json, folder)).problems();
    }

    /** The one problem of a document that has one. */
    static Problem problem(String json, Path folder) {
        List<Problem> problems = problems(json, folder);
        assertEquals(1, problems.size(), () -> problems.toString());
        return problems.get(0);
    }

    static Path projectFolder() {
        return Path.of(System.getProperty("project.directory"));
    }

    /** The files in {@code scenes}. */
    static List<String> shippedNames() {
        try (var files = Files.list(projectFolder().resolve("scenes"))) {
            return files.map(f -> f.getFileName().toString())
                    .filter(n -> n.endsWith(".json"))
                    .sorted()
                    .toList();
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }

    /** The folders in {@code scenes}, of files that scenes name. */
    private static final List<String> FOLDERS = List.of("meshes", "luminaires", "models");

    private static List<Path> shippedFiles(String folder) throws IOException {
        try (var files = Files.list(projectFolder().resolve("scenes").resolve(folder))) {
            return files.filter(Files::isRegularFile).toList();
        }
    }

    private static List<String> shippedImages() throws IOException {
        try (var files = Files.list(projectFolder().resolve("textures"))) {
            return files.map(f -> f.getFileName().toString())
                    .filter(n -> n.endsWith(".png"))
                    .toList();
        }
    }

    /** Copies the shipped scenes to {@code folder/scenes}, with images of no content in {@code folder/textures}. */
    static Path shippedScenes(Path folder) {
        try {
            Path scenes = Files.createDirectories(folder.resolve("scenes"));
            Path textures = Files.createDirectories(folder.resolve("textures"));
            for (String image : shippedImages()) {
                Files.write(textures.resolve(image), PNG_START);
            }
            for (String of : FOLDERS) {
                Path copies = Files.createDirectories(scenes.resolve(of));
                for (Path file : shippedFiles(of)) {
                    Files.copy(file, copies.resolve(file.getFileName()));
                }
            }
            for (String name : shippedNames()) {
                Files.copy(projectFolder().resolve("scenes").resolve(name), scenes.resolve(name));
            }
            return scenes;
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}
