package enlightenment.importer;

import enlightenment.file.FileFailure;
import enlightenment.file.InputFile;
import enlightenment.importer.gltf.GltfReader;
import enlightenment.importer.mitsuba.MitsubaReader;
import enlightenment.importer.model.ModelReader;
import enlightenment.importer.pbrt.PbrtReader;
import enlightenment.importer.support.ExtractedFiles;
import enlightenment.importer.support.ImportDraft;
import enlightenment.importer.support.ImportFailure;
import enlightenment.importer.support.NamedChoice;
import enlightenment.math.InvalidValueException;
import enlightenment.nff.NffReader;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.Objects;
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
 *
 * <p>All methods may be called by several threads at once.
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
    public static Result read(Path file, ImportOptions options) throws IOException {
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
            return nff(file, options);
        }
        try {
            ImportDraft draft = draft(file, format, options);
            Scene scene = new DraftFinish(draft, options).scene(name(file));
            return new Result(scene, draft.notes().list());
        } catch (InvalidValueException e) {
            throw ImportFailure.at(file, 0, e.getMessage());
        } catch (IOException e) {
            throw new SceneException(List.of(new SceneException.Problem("", 0, 0, "", FileFailure.described(e))));
        }
    }

    private static ImportDraft draft(Path file, Format format, ImportOptions options) throws IOException {
        return switch (format) {
            case GLTF ->
                GltfReader.read(
                        file,
                        options.extracted(),
                        NamedChoice.camera(options.camera()),
                        NamedChoice.animation(options.animation()),
                        options.framesPerSecond());
            case MITSUBA ->
                withoutAnimation(
                        file,
                        MitsubaReader.read(
                                file, new ExtractedFiles(options.extracted()), NamedChoice.camera(options.camera())),
                        options);
            case PBRT -> withOneCamera(file, PbrtReader.read(file, new ExtractedFiles(options.extracted())), options);
            default -> withOneCamera(file, ModelReader.read(file), options);
        };
    }

    /** Refuses the choice of another camera than the only one that the format can have. */
    private static ImportDraft withOneCamera(Path file, ImportDraft draft, ImportOptions options) {
        requireCamera(file, draft.camera(), options);
        return withoutAnimation(file, draft, options);
    }

    /** Refuses the choice of an animation in a format that has none. */
    private static ImportDraft withoutAnimation(Path file, ImportDraft draft, ImportOptions options) {
        requireOnly(file, NamedChoice.animation(options.animation()), Optional.empty());
        return draft;
    }

    private static void requireCamera(Path file, Optional<?> camera, ImportOptions options) {
        requireOnly(file, NamedChoice.camera(options.camera()), camera);
    }

    private static void requireOnly(Path file, NamedChoice choice, Optional<?> only) {
        try {
            choice.requireIn(only);
        } catch (IOException e) {
            throw ImportFailure.at(file, 0, e.getMessage());
        }
    }

    /** NFF has a camera, lights and classic shading, none of which can be chosen otherwise. */
    private static Result nff(Path file, ImportOptions options) throws IOException {
        if (options.up().isPresent()
                || options.orbit().isPresent()
                || options.backdrop().isPresent()) {
            throw ImportFailure.at(
                    file,
                    0,
                    "is an NFF file, whose view and surroundings are its own: axis, view and background have no meaning");
        }
        NffReader.Result nff = NffReader.read(file);
        requireCamera(file, Optional.of(nff.scene().camera()), options);
        requireOnly(file, NamedChoice.animation(options.animation()), Optional.empty());
        return new Result(nff.scene(), nff.notes());
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

    /**
     * What a foreign file became.
     *
     * @param scene the scene, with physical shading
     * @param notes what the file says but the scene does not, or not quite: in plain words that begin with the places in the file, fit to be shown
     */
    public record Result(Scene scene, List<String> notes) {
        /** Copies the notes. */
        public Result {
            Objects.requireNonNull(scene, "scene");
            notes = List.copyOf(notes);
        }
    }
}
