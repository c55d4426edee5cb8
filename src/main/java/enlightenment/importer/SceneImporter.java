package enlightenment.importer;

import enlightenment.camera.Camera;
import enlightenment.file.FileFailure;
import enlightenment.file.InputFile;
import enlightenment.importer.gltf.GltfReader;
import enlightenment.importer.mitsuba.MitsubaReader;
import enlightenment.importer.model.ModelReader;
import enlightenment.importer.pbrt.PbrtReader;
import enlightenment.importer.support.ExtractedFiles;
import enlightenment.importer.support.ImportDraft;
import enlightenment.importer.support.ImportFailure;
import enlightenment.math.InvalidValueException;
import enlightenment.nff.NffReader;
import enlightenment.scene.Display;
import enlightenment.scene.PhysicalShading;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneBuilder;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Optional;
import java.util.TreeSet;

/**
 * Reads scenes and models of other programs: by the end of the name models ({@code .ply}, {@code .obj}, {@code .stl}, {@code .serialized}), scenes
 * of Mitsuba ({@code .xml}), of pbrt-v4 ({@code .pbrt}) and in glTF 2.0 ({@code .gltf}, {@code .glb}), and Eric Haines' NFF ({@code .nff}).
 *
 * <p>A file without a camera is seen from three quarters, a file without light stands in a studio: on a ground that catches its shadow, under a
 * soft light. That lights a file, too, whose lights are all left out; a note says so.
 *
 * <p>Files are not trusted: files that they name must lie in their folder or below it, and what is broken is refused with its place.
 */
public final class SceneImporter {
    private static final Map<String, Format> FORMATS = Map.of(
            "ply", Format.MODEL,
            "obj", Format.MODEL,
            "stl", Format.MODEL,
            "serialized", Format.MODEL,
            "gltf", Format.GLTF,
            "glb", Format.GLTF,
            "xml", Format.MITSUBA,
            "pbrt", Format.PBRT,
            "nff", Format.NFF);

    /** Bytes that show whether a file is JSON. */
    private static final int START = 256;

    private enum Format {
        MODEL,
        GLTF,
        MITSUBA,
        PBRT,
        NFF
    }

    private SceneImporter() {}

    /**
     * Whether the end of the file's name is one of a format that is read here, and its content is no JSON, which only glTF may be: what is a scene file
     * is one whatever its name.
     */
    public static boolean reads(Path file) {
        Format format = FORMATS.get(ending(file));
        if (format == null) {
            return false;
        }
        try {
            String start = new String(InputFile.start(file, START), StandardCharsets.ISO_8859_1).stripLeading();
            boolean isJson = start.startsWith("{");
            return !isJson
                    || format == Format.GLTF
                            && new String(InputFile.bytes(file), StandardCharsets.ISO_8859_1).contains("\"asset\"");
        } catch (IOException e) {
            // Who reads it will say what is wrong with it.
            return true;
        }
    }

    /**
     * Reads a file.
     *
     * @throws SceneException if it cannot be used: lists the problems with file and place
     * @throws IOException if it cannot be read
     */
    public static ImportedScene read(Path file, ImportOptions options) throws IOException {
        InputFile.requireEnd(file);
        // Folders and what is not there are refused.
        InputFile.start(file, 1);
        Format format = FORMATS.get(ending(file));
        if (format == null) {
            throw ImportFailure.at(
                    file,
                    0,
                    "is of no format that can be imported: " + String.join(", ", new TreeSet<>(FORMATS.keySet())));
        }
        if (format == Format.NFF) {
            NffReader.Result nff = NffReader.read(file);
            return new ImportedScene(nff.scene(), nff.notes());
        }
        try {
            ImportDraft draft = draft(file, format, options);
            return new ImportedScene(
                    finished(draft, name(file), options), draft.notes().list());
        } catch (InvalidValueException e) {
            throw ImportFailure.at(file, 0, e.getMessage());
        } catch (IOException e) {
            throw new SceneException(List.of(new SceneException.Problem("", 0, 0, "", FileFailure.described(e))));
        }
    }

    private static ImportDraft draft(Path file, Format format, ImportOptions options) throws IOException {
        return switch (format) {
            case GLTF -> GltfReader.read(file, options.extracted(), options.camera());
            case MITSUBA -> MitsubaReader.read(file, new ExtractedFiles(options.extracted()));
            case PBRT -> PbrtReader.read(file, new ExtractedFiles(options.extracted()));
            default -> ModelReader.read(file);
        };
    }

    private static Scene finished(ImportDraft draft, String name, ImportOptions options) {
        if (draft.objects().isEmpty()) {
            throw new InvalidValueException("objects", "there is nothing to be seen in the file");
        }
        int width = draft.width() == 0 ? Studio.WIDTH : draft.width();
        int height = draft.height() == 0 ? Studio.HEIGHT : draft.height();
        boolean isUpZ = options.up().map(u -> u == ImportOptions.Up.Z).orElse(draft.isUpZ());
        boolean isModel = draft.camera().isEmpty() && !draft.isLit();
        Studio studio = new Studio(draft.objects(), isUpZ, (double) width / height);
        Camera camera = draft.camera().orElseGet(studio::camera);
        if (!draft.isLit()) {
            studio.light(draft, isModel);
            if (draft.leavesOutLights()) {
                draft.notes().add("", "all lights of the file are left out: a soft light stands in for them");
            }
        }
        SceneBuilder scene = Scene.builder()
                .name(name)
                .size(width, height)
                .camera(camera)
                .shading(new PhysicalShading(draft.maxBounces(), draft.background(), Optional.empty()))
                .display(new Display(draft.exposure(), Display.DEFAULT.tone()));
        draft.materials().forEach(scene::material);
        draft.lights().forEach(scene::light);
        draft.objects().forEach(scene::object);
        draft.animation().ifPresent(scene::animation);
        return scene.build();
    }

    private static String name(Path file) {
        String name = file.getFileName().toString();
        int dot = name.lastIndexOf('.');
        return dot > 0 ? name.substring(0, dot) : name;
    }

    private static String ending(Path file) {
        String name = file.toString();
        return name.substring(name.lastIndexOf('.') + 1).toLowerCase(Locale.ROOT);
    }
}
