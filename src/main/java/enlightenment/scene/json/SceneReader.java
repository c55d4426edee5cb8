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
 * Reads scene files, which are JSON (see {@code docs/guide/scene-format.md}).
 *
 * <p>The reader is strict, and tells all that is wrong with a file at once: whatever it cannot take as it stands becomes
 * a {@link SceneException.Problem} with line, column and JSON pointer. Coordinates are read exactly; other numbers become
 * the nearest double. Image files of textures are looked at (they exist and begin like an image), not read.
 *
 * <p>All methods may be called by several threads at once.
 *
 */
public final class SceneReader {
    private static final int BYTE_ORDER_MARK = 0xfeff;

    private SceneReader() {}

    /**
     * Reads a file. An animated scene is as its file's own numbers say; see {@link #read(Path, int)}.
     *
     * @throws SceneException if the file cannot be read or is not a scene
     */
    public static Scene read(Path file) {
        return read(file, OptionalInt.empty(), new MeshCache());
    }

    /**
     * Reads one frame of an animated scene, of which {@link Frames} makes many: the numbers that its tracks lead to are replaced by those of the frame,
     * which are as good as exact fractions. If the animation's shutter is open, the scene has its {@linkplain Scene#instants instants}.
     *
     * @param frame the frame, counted from 0
     * @throws SceneException if the file cannot be read or is not a scene, or the scene has no such frame
     */
    public static Scene read(Path file, int frame) {
        return read(file, OptionalInt.of(frame), new MeshCache());
    }

    /**
     * Reads a text.
     *
     * @param baseFolder what paths of texture files are relative to
     * @param displayName what problems call the text; may be ""
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
     * Reads a file's bytes that are here already, for example from a pipe.
     *
     * @param json a text in UTF-8
     * @param baseFolder what paths of texture files are relative to
     * @param displayName what problems call the text; may be ""
     * @param frame the frame, counted from 0; empty for the scene as its own numbers say
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
     * Reads a text whose files are called by names and lie somewhere else than on the disk: no file is looked at. A texture's path is
     * then its name.
     *
     * @param named the files that there are
     * @param displayName what problems call the text; may be ""
     * @throws SceneException if the text is not a scene or has a name that there is not
     */
    public static Scene readNamed(String json, NamedFiles named, String displayName) {
        Problems problems = new Problems(displayName, "");
        Scene scene = new SceneBinder(problems, Path.of(""), named.contents, named.files)
                .read(() -> new StringReader(json), OptionalInt.empty());
        problems.throwIfAny();
        return scene;
    }

    /**
     * The exception with lines and columns for problems that have none. They were found when the scene was put together.
     *
     * @param file where the scene was read from; if it cannot be read any more, or is another scene meanwhile, lines may be missing
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

    /** The JSON Schema of scene files (JSON Schema 2020-12), for editors and other programs, with all methods that there are. */
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

    /** What was wrong with a scene; of what is a file of another program, only that. */
    private static SceneException unlessForeign(SceneException e, String name, byte[] start, long size) {
        return ForeignFormat.of(name, start, size)
                .map(f -> new SceneException(List.of(new SceneException.Problem(name, 0, 0, "", f.refusal()))))
                .orElse(e);
    }

    /** What problems of a frame say behind their messages. */
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

    /** The scene at the moments that the picture of a frame is made of. */
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

    /** A reader that refuses what is not UTF-8, and skips the mark that some editors begin files with. */
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
     * The files of scenes that are in memory instead of on a disk, by the names that the scenes call them. Meshes that have been read from them are
     * kept for as long as this is: the frames of a film share them. For one thread at a time.
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
     * The frames of an animated scene, one by one: of a file, or of a scene that was made in code. All frames share the scene's meshes, with their
     * hierarchies, which are read when they are first met: a mesh file that changes meanwhile is not noticed. Safe for several threads, of which one
     * reads at a time.
     */
    public static final class Frames {
        private final Function<OptionalInt, Scene> scenes;

        private Frames(Function<OptionalInt, Scene> scenes) {
            this.scenes = scenes;
        }

        /** The frames of a scene file; it is not looked at yet. */
        public static Frames of(Path file) {
            Objects.requireNonNull(file, "file");
            MeshCache meshes = new MeshCache();
            return new Frames(frame -> SceneReader.read(file, frame, meshes));
        }

        /**
         * The frames of a scene that was made in code.
         *
         * @param name what problems call the scene
         * @throws SceneException if the scene holds something that the format cannot say, or a track leads to no number of it
         */
        public static Frames of(Scene scene, String name) {
            MeshCache meshes = new MeshCache();
            String json = json(scene, meshes);
            return new Frames(frame -> frame.isEmpty() ? scene : frame(json, name, frame, meshes));
        }

        /**
         * The scene as its own numbers say, at no frame.
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

        /** The text of a scene, which calls its meshes by names. */
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
                // Lines of a text that is in no file would lead nowhere.
                throw new SceneException(e.problems().stream()
                        .map(p -> new SceneException.Problem(p.file(), 0, 0, p.pointer(), p.message()))
                        .toList());
            }
        }
    }
}
