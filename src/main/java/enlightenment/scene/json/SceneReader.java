package enlightenment.scene.json;

import enlightenment.geometry.Mesh;
import enlightenment.mesh.TriangleMesh;
import enlightenment.scene.Animation;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.SceneObject;
import enlightenment.scene.json.tree.JsonTree;
import enlightenment.scene.json.tree.Places;
import enlightenment.scene.json.tree.Problems;
import java.io.BufferedReader;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.InputStreamReader;
import java.io.Reader;
import java.io.StringReader;
import java.nio.charset.CodingErrorAction;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Function;

/**
 * Reader of scene files, which are JSON (see {@code docs/guide/scene-format.md}).
 *
 * <p>The reader is strict, and reports all problems of a file at once: each is a {@link SceneException.Problem} with line, column and JSON pointer.
 * Coordinates are read exactly; other numbers become the nearest double. Image files of textures are checked (they exist and have the signature
 * of an image), but not read.
 *
 * <p>All methods are thread-safe.
 *
 */
public final class SceneReader {
    private static final int BYTE_ORDER_MARK = 0xfeff;

    private SceneReader() {}

    /**
     * Reads a file. Tracks of an animated scene are not applied; {@link #read(Path, int)} applies them.
     *
     * @throws SceneException if the file cannot be read or is not a scene
     */
    public static Scene read(Path file) {
        return read(file, OptionalInt.empty(), new MeshCache());
    }

    /**
     * Reads one frame of an animated scene; {@link Frames} reads several with shared meshes. Targets of tracks have their values at the frame, which
     * are as good as exact fractions. If the animation's shutter is open, the scene has its {@linkplain Scene#instants instants}.
     *
     * @param frame the frame, counted from 0
     * @throws SceneException if the file cannot be read or is not a scene, or the scene has no such frame
     */
    public static Scene read(Path file, int frame) {
        return read(file, OptionalInt.of(frame), new MeshCache());
    }

    /**
     * Reads a scene from a text.
     *
     * @param baseFolder the folder that paths of texture files are relative to
     * @param displayName name of the text in problems; may be ""
     * @throws SceneException if the text is not a scene
     */
    public static Scene readString(String json, Path baseFolder, String displayName) {
        return read(
                () -> new StringReader(json),
                baseFolder,
                new Problems(displayName, ""),
                OptionalInt.empty(),
                new MeshCache());
    }

    /**
     * Reads a scene from bytes in memory, for example from a pipe.
     *
     * @param json a text in UTF-8
     * @param baseFolder the folder that paths of texture files are relative to
     * @param displayName name of the text in problems; may be ""
     * @param frame the frame, counted from 0; empty to apply no tracks
     * @throws SceneException if the bytes are not a scene, or the scene has no such frame
     */
    public static Scene readBytes(byte[] json, Path baseFolder, String displayName, OptionalInt frame) {
        Problems problems = new Problems(displayName, remark(frame));
        try {
            return read(() -> decoded(new ByteArrayInputStream(json)), baseFolder, problems, frame, new MeshCache());
        } catch (SceneException e) {
            byte[] start = Arrays.copyOf(json, Math.min(json.length, ForeignFormat.START));
            throw unlessForeign(e, displayName, start, json.length);
        }
    }

    /**
     * Reads a text whose files are in memory, by names; the disk is not accessed. The path of a texture is then its name.
     *
     * @param named the files in memory
     * @param displayName name of the text in problems; may be ""
     * @throws SceneException if the text is not a scene or has an unknown name
     */
    public static Scene readNamed(String json, NamedFiles named, String displayName) {
        Problems problems = new Problems(displayName, "");
        Scene scene = new SceneBinder(problems, Path.of(""), named.contents, named.files)
                .read(() -> new StringReader(json), OptionalInt.empty());
        problems.throwIfAny();
        return scene;
    }

    /**
     * The exception with lines and columns for problems that were found after parsing and have none.
     *
     * @param file the file of the scene; if it has become unreadable or has changed, lines may be missing
     */
    public static SceneException located(SceneException e, Path file) {
        return located(e, () -> decoded(Files.newInputStream(file)));
    }

    /** {@link #located(SceneException, Path)} for a text in memory. */
    public static SceneException located(SceneException e, byte[] json) {
        return located(e, () -> decoded(new ByteArrayInputStream(json)));
    }

    private static SceneException located(SceneException e, JsonTree.Source source) {
        return new SceneException(Places.find(e.problems(), source));
    }

    /** The JSON Schema of scene files (JSON Schema 2020-12), for editors and other programs. It has all methods, those of extensions included. */
    public static String schema() {
        return SceneSchema.text();
    }

    /** @param files meshes that have been read; has those of this scene from now on */
    static Scene read(Path file, OptionalInt frame, MeshCache files) {
        Problems problems = new Problems(file.toString(), remark(frame));
        if (file.toString().isEmpty()) {
            // For Java it is the working folder.
            problems.add(0, 0, "", "the name of the scene file is empty");
        } else if (!Files.exists(file)) {
            problems.add(0, 0, "", "there is no such file");
        } else if (Files.isDirectory(file)) {
            problems.add(0, 0, "", "is a folder; expected a scene file");
        } else if (!Files.isRegularFile(file)) {
            problems.add(0, 0, "", "is not a regular file; expected a scene file");
        } else if (!Files.isReadable(file)) {
            problems.add(0, 0, "", "cannot be read: permission denied");
        }
        problems.throwIfAny();
        try {
            return read(
                    () -> decoded(Files.newInputStream(file)),
                    file.toAbsolutePath().getParent(),
                    problems,
                    frame,
                    files);
        } catch (SceneException e) {
            throw unlessForeign(e, file);
        }
    }

    private static SceneException unlessForeign(SceneException e, Path file) {
        try (InputStream in = Files.newInputStream(file)) {
            return unlessForeign(e, file.toString(), in.readNBytes(ForeignFormat.START), Files.size(file));
        } catch (IOException unreadable) {
            return e;
        }
    }

    /** The exception of a scene; for a file of another program, one that says only so. */
    private static SceneException unlessForeign(SceneException e, String name, byte[] start, long size) {
        return ForeignFormat.of(name, start, size)
                .map(f -> new SceneException(List.of(new SceneException.Problem(name, 0, 0, "", f.refusal()))))
                .orElse(e);
    }

    /** The text behind the messages of a frame's problems. */
    static String remark(OptionalInt frame) {
        return frame.isPresent() ? " (in frame " + frame.getAsInt() + ")" : "";
    }

    /** @param files meshes that have been read; has those of this scene from now on */
    static Scene read(JsonTree.Source source, Path folder, Problems problems, OptionalInt frame, MeshCache files) {
        Scene scene = new SceneBinder(problems, folder, null, files).read(source, frame);
        problems.throwIfAny();
        boolean isBlurred =
                frame.isPresent() && scene.animation().map(Animation::isBlurred).orElse(false);
        return isBlurred ? scene.withInstants(instants(source, folder, problems, scene, frame, files)) : scene;
    }

    /** The scene at the shutter instants of a frame. */
    private static List<Scene> instants(
            JsonTree.Source source, Path folder, Problems problems, Scene scene, OptionalInt frame, MeshCache files) {
        List<Scene> instants = new ArrayList<>();
        for (int i = 0; i < scene.animation().orElseThrow().instants(); i++) {
            Scene instant = new SceneBinder(problems, folder, null, files).read(source, frame, i);
            problems.throwIfAny();
            instants.add(instant);
        }
        return instants;
    }

    /** A reader of strict UTF-8 that skips a byte order mark. */
    private static Reader decoded(InputStream bytes) throws IOException {
        BufferedReader reader = new BufferedReader(
                new InputStreamReader(
                        bytes,
                        StandardCharsets.UTF_8
                                .newDecoder()
                                .onMalformedInput(CodingErrorAction.REPORT)
                                .onUnmappableCharacter(CodingErrorAction.REPORT)),
                1 << 16);
        reader.mark(1);
        try {
            if (reader.read() != BYTE_ORDER_MARK) {
                reader.reset();
            }
        } catch (IOException e) {
            reader.close();
            throw e;
        }
        return reader;
    }

    /**
     * Files of scenes in memory, by their names in the scenes. The meshes read from them are cached here, so that the frames of a film share them.
     * For one thread at a time.
     */
    public static final class NamedFiles {
        final Map<String, byte[]> contents;
        final MeshCache files = new MeshCache();

        /** @param contents the files by their names */
        public NamedFiles(Map<String, byte[]> contents) {
            this.contents = Map.copyOf(contents);
        }
    }

    /**
     * The frames of an animated scene, from a file or from a scene made in code. All frames share the scene's meshes with their hierarchies, which
     * are read on first use: later changes of a mesh file are not noticed. Thread-safe; one thread reads at a time.
     */
    public static final class Frames {
        private final Function<OptionalInt, Scene> scenes;

        private Frames(Function<OptionalInt, Scene> scenes) {
            this.scenes = scenes;
        }

        /** The frames of a scene file, which is not opened yet. */
        public static Frames of(Path file) {
            Objects.requireNonNull(file, "file");
            MeshCache meshes = new MeshCache();
            return new Frames(frame -> SceneReader.read(file, frame, meshes));
        }

        /**
         * The frames of a scene that was made in code.
         *
         * @param name name of the scene in problems
         * @throws SceneException if the format cannot represent the scene, or the target of a track is not a number of it
         */
        public static Frames of(Scene scene, String name) {
            MeshCache meshes = new MeshCache();
            String json = json(scene, meshes);
            return new Frames(frame -> frame.isEmpty() ? scene : frame(json, name, frame, meshes));
        }

        /**
         * The scene without its tracks applied.
         *
         * @throws SceneException as {@link SceneReader#read(Path)}
         */
        public synchronized Scene read() {
            return scenes.apply(OptionalInt.empty());
        }

        /**
         * The scene of a frame, counted from 0.
         *
         * @throws SceneException as {@link SceneReader#read(Path, int)}
         */
        public synchronized Scene read(int frame) {
            return scenes.apply(OptionalInt.of(frame));
        }

        /** The text of a scene, with names of meshes in {@code meshes}. */
        private static String json(Scene scene, MeshCache meshes) {
            Map<TriangleMesh, String> names = new IdentityHashMap<>();
            for (SceneObject object : scene.objects()) {
                if (object.shape() instanceof Mesh mesh && !names.containsKey(mesh.triangles())) {
                    String unique = "mesh " + names.size();
                    names.put(mesh.triangles(), unique);
                    meshes.named.put(unique, new LoadedMesh(mesh.triangles(), mesh.origin()));
                }
            }
            return SceneWriter.toJson(scene, new SceneWriter.FileNames() {
                @Override
                public String of(Path file) {
                    return file.toAbsolutePath().normalize().toString();
                }

                @Override
                public Optional<String> of(TriangleMesh mesh) {
                    return Optional.ofNullable(names.get(mesh));
                }
            });
        }

        private static Scene frame(String json, String name, OptionalInt frame, MeshCache meshes) {
            Problems problems = new Problems(name, SceneReader.remark(frame));
            try {
                return SceneReader.read(() -> new StringReader(json), Path.of(""), problems, frame, meshes);
            } catch (SceneException e) {
                // The user cannot see the lines of this text, as it is in no file.
                throw new SceneException(e.problems().stream()
                        .map(p -> new SceneException.Problem(p.file(), 0, 0, p.pointer(), p.message()))
                        .toList());
            }
        }
    }
}
