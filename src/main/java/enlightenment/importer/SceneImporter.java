package enlightenment.importer;

import enlightenment.check.Check;
import enlightenment.check.Radiance;
import enlightenment.color.Rgb;
import enlightenment.file.FileFailure;
import enlightenment.file.InputFile;
import enlightenment.importer.gltf.GltfReader;
import enlightenment.importer.mitsuba.MitsubaReader;
import enlightenment.importer.model.ModelReader;
import enlightenment.importer.pbrt.PbrtReader;
import enlightenment.importer.support.ExtractedFiles;
import enlightenment.importer.support.ImportDraft;
import enlightenment.importer.support.ImportFailure;
import enlightenment.importer.support.InputFolder;
import enlightenment.importer.support.NamedChoice;
import enlightenment.math.InvalidValueException;
import enlightenment.math.Vec3;
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
 * Reads scenes and models of other programs: glTF, pbrt, Mitsuba, OBJ, PLY, STL and NFF. The end of a name says what a file is: models ({@code
 * .ply}, {@code .obj}, {@code .stl}, {@code .serialized}), scenes of Mitsuba ({@code .xml}), of pbrt-v4 ({@code .pbrt}) and in glTF 2.0 ({@code
 * .gltf}, {@code .glb}), and Eric Haines' NFF ({@code .nff}).
 *
 * <p>A file without a camera is seen from three quarters, a file without light stands in a studio: on a ground that catches its shadow, under a
 * soft light. That lights a file, too, whose lights are all left out; a note says so.
 *
 * <p>Files are not trusted: files that they name must lie in or below their folder, or one that the options name, and what is broken is refused with
 * its place.
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
    public static Result read(Path file, Options options) throws IOException {
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

    private static ImportDraft draft(Path file, Format format, Options options) throws IOException {
        InputFolder folder = new InputFolder(file, options.assets());
        return switch (format) {
            case GLTF ->
                GltfReader.read(
                        folder,
                        options.extracted(),
                        NamedChoice.camera(options.camera()),
                        NamedChoice.animation(options.animation()),
                        options.framesPerSecond());
            case MITSUBA ->
                withoutAnimation(
                        file,
                        MitsubaReader.read(
                                folder, new ExtractedFiles(options.extracted()), NamedChoice.camera(options.camera())),
                        options);
            case PBRT -> withOneCamera(file, PbrtReader.read(folder, new ExtractedFiles(options.extracted())), options);
            default -> withOneCamera(file, ModelReader.read(folder), options);
        };
    }

    /** Refuses the choice of another camera than the only one that the format can have. */
    private static ImportDraft withOneCamera(Path file, ImportDraft draft, Options options) {
        requireCamera(file, draft.camera(), options);
        return withoutAnimation(file, draft, options);
    }

    /** Refuses the choice of an animation in a format that has none. */
    private static ImportDraft withoutAnimation(Path file, ImportDraft draft, Options options) {
        requireOnly(file, NamedChoice.animation(options.animation()), Optional.empty());
        return draft;
    }

    private static void requireCamera(Path file, Optional<?> camera, Options options) {
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
    private static Result nff(Path file, Options options) throws IOException {
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

    /**
     * Choices for reading files of other programs.
     *
     * @param extracted the folder that pictures are written to which the file holds inside, such as those of a GLB; made when it is needed. Scenes name
     *     them there, so they must stay as long as the scene is used. Empty for a temporary one that goes when the process ends
     * @param up the axis that points upwards for views and light that the file lacks; empty for z in STL files and y in others
     * @param camera the camera of the file: its number in the file's order, from 0, or its name, of which the first counts; empty for the first camera
     * @param orbit the view of the whole model from outside, in place of the file's camera; empty for the camera, and the usual view where there is none
     * @param backdrop the surroundings; empty for those of the file, and the studio's where nothing shines
     * @param framesPerSecond how many frames a second of a file's animation has, greater than 0 and finite; 24 as a film
     * @param animation the animation of the file: its number in the file's order, from 0, or its name, of which the first counts; empty for the first
     *     animation
     * @param assets a folder that files which the file names may lie in or below, beside its own; empty for none
     */
    public record Options(
            Optional<Path> extracted,
            Optional<Up> up,
            Optional<String> camera,
            Optional<Orbit> orbit,
            Optional<Backdrop> backdrop,
            double framesPerSecond,
            Optional<String> animation,
            Optional<Path> assets) {
        /** The usual choices. */
        public static final Options DEFAULT = new Options(
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                Optional.empty(),
                24,
                Optional.empty(),
                Optional.empty());

        /** An axis that points upwards, with the front of a model that stands on it. */
        public enum Up {
            X(Vec3.X, Vec3.Z),
            Y(Vec3.Y, Vec3.Z),
            Z(Vec3.Z, new Vec3(0, -1, 0)),
            MINUS_X(new Vec3(-1, 0, 0), Vec3.Z),
            MINUS_Y(new Vec3(0, -1, 0), new Vec3(0, 0, -1)),
            MINUS_Z(new Vec3(0, 0, -1), Vec3.Y);

            private final Vec3 axis;
            private final Vec3 front;

            Up(Vec3 axis, Vec3 front) {
                this.axis = axis;
                this.front = front;
            }

            /** The unit vector upwards. */
            public Vec3 axis() {
                return axis;
            }

            /** The unit vector to which models face: +z where y points upwards (glTF 2.0, section 3.4), −y where z does. */
            public Vec3 front() {
                return front;
            }

            /** The unit vector to the right of the picture seen from the front: axis × front. */
            public Vec3 right() {
                return axis.cross(front);
            }
        }

        /**
         * A view towards the middle of the model.
         *
         * @param azimuth of the eye, degrees from the front of the model to the right, −360..360
         * @param elevation of the eye above the horizon, degrees, −90..90
         */
        public record Orbit(double azimuth, double elevation) {
            /** The usual view: three quarters, and somewhat from above. */
            public static final Orbit USUAL = new Orbit(35, 22);

            /** @throws enlightenment.math.InvalidValueException for an angle out of range */
            public Orbit {
                Check.range("azimuth", azimuth, -360, 360);
                Check.range("elevation", elevation, -90, 90);
            }
        }

        /** @throws enlightenment.math.InvalidValueException (key {@code framesPerSecond}) if it is not greater than 0 and finite */
        public Options {
            Check.positive("framesPerSecond", framesPerSecond);
            Objects.requireNonNull(extracted, "extracted");
            Objects.requireNonNull(up, "up");
            Objects.requireNonNull(camera, "camera");
            Objects.requireNonNull(orbit, "orbit");
            Objects.requireNonNull(backdrop, "backdrop");
            Objects.requireNonNull(animation, "animation");
            Objects.requireNonNull(assets, "assets");
        }

        /** These choices with a folder for pictures. */
        public Options withExtracted(Path folder) {
            return new Options(Optional.of(folder), up, camera, orbit, backdrop, framesPerSecond, animation, assets);
        }

        /** These choices with an axis upwards. */
        public Options withUp(Up value) {
            return new Options(
                    extracted, Optional.of(value), camera, orbit, backdrop, framesPerSecond, animation, assets);
        }

        /** These choices with a camera of the file, by its number or name. */
        public Options withCamera(String value) {
            return new Options(extracted, up, Optional.of(value), orbit, backdrop, framesPerSecond, animation, assets);
        }

        /** These choices with a view from outside. */
        public Options withOrbit(Orbit value) {
            return new Options(extracted, up, camera, Optional.of(value), backdrop, framesPerSecond, animation, assets);
        }

        /** These choices with other surroundings. */
        public Options withBackdrop(Backdrop value) {
            return new Options(extracted, up, camera, orbit, Optional.of(value), framesPerSecond, animation, assets);
        }

        /** These choices with another number of frames in a second. */
        public Options withFramesPerSecond(double value) {
            return new Options(extracted, up, camera, orbit, backdrop, value, animation, assets);
        }

        /** These choices with an animation of the file, by its number or name. */
        public Options withAnimation(String value) {
            return new Options(extracted, up, camera, orbit, backdrop, framesPerSecond, Optional.of(value), assets);
        }

        /** These choices with a folder of files that the file may name. */
        public Options withAssets(Path folder) {
            return new Options(extracted, up, camera, orbit, backdrop, framesPerSecond, animation, Optional.of(folder));
        }

        /** The surroundings that replace those of a file, or stand in for them where it has none. */
        public sealed interface Backdrop permits Backdrop.Studio, Backdrop.Sky, Backdrop.Constant {
            /** Soft grey light from everywhere, as around models without a camera and light. */
            record Studio() implements Backdrop {}

            /** A clear sky with its sun; up must be y. Its radiance is that of {@link enlightenment.scene.Shading.Background.Sky}. */
            record Sky() implements Backdrop {}

            /**
             * One radiance from everywhere.
             *
             * @param radiance linear, in the unit of lights; 1 is shown as white without an exposure
             */
            record Constant(Rgb radiance) implements Backdrop {
                /** @throws enlightenment.math.InvalidValueException (key {@code radiance}) if it is beyond the range of lights */
                public Constant {
                    Radiance.check("radiance", radiance.max());
                }
            }
        }
    }
}
