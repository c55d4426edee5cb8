package enlightenment.scene.json;

import enlightenment.geometry.Mesh;
import enlightenment.mesh.TriangleMesh;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.SceneObject;
import java.io.StringReader;
import java.nio.file.Path;
import java.util.IdentityHashMap;
import java.util.Map;
import java.util.Objects;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.function.Function;

/**
 * The frames of an animated scene, one by one: of a file, or of a scene that was made in code. All frames share the scene's meshes, with their
 * hierarchies, which are read when they are first met: a mesh file that changes meanwhile is not noticed. Safe for several threads, of which one
 * reads at a time.
 */
public final class SceneFrames {
    private final Function<OptionalInt, Scene> scenes;

    private SceneFrames(Function<OptionalInt, Scene> scenes) {
        this.scenes = scenes;
    }

    /** The frames of a scene file; it is not looked at yet. */
    public static SceneFrames of(Path file) {
        Objects.requireNonNull(file, "file");
        MeshCache meshes = new MeshCache();
        return new SceneFrames(frame -> SceneReader.read(file, frame, meshes));
    }

    /**
     * The frames of a scene that was made in code.
     *
     * @param name what problems call the scene
     * @throws SceneException if the scene holds something that the format cannot say, or a track leads to no number of it
     */
    public static SceneFrames of(Scene scene, String name) {
        MeshCache meshes = new MeshCache();
        String json = json(scene, meshes);
        return new SceneFrames(frame -> frame.isEmpty() ? scene : frame(json, name, frame, meshes));
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
     * Makes a frame, counted from 0.
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
