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
import java.util.Optional;
import java.util.OptionalInt;

/**
 * The frames of an animated scene that was made in code, as {@link SceneFile} has those of a file: the scene's meshes, with their hierarchies, are
 * shared by all of them. Safe for several threads, of which one reads at a time.
 */
public final class SceneFrames {
    private final String name;
    private final String json;
    private final MeshCache meshes = new MeshCache();

    /**
     * The frames of a scene.
     *
     * @param name what problems call the scene
     * @throws enlightenment.scene.SceneException if the scene holds something that the format cannot say, or a track leads to no number of it
     */
    public SceneFrames(Scene scene, String name) {
        this.name = name;
        Map<TriangleMesh, String> names = new IdentityHashMap<>();
        for (SceneObject object : scene.objects()) {
            if (object.shape() instanceof Mesh mesh && !names.containsKey(mesh.triangles())) {
                String unique = "mesh " + names.size();
                names.put(mesh.triangles(), unique);
                meshes.named.put(unique, new LoadedMesh(mesh.triangles(), mesh.origin()));
            }
        }
        json = SceneWriter.toJson(scene, new FileNames() {
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

    /**
     * Makes a frame, counted from 0.
     *
     * @throws enlightenment.scene.SceneException as {@link SceneReader#read(Path, int)}
     */
    public synchronized Scene read(int frame) {
        Problems problems = new Problems(name, SceneReader.remark(OptionalInt.of(frame)));
        try {
            return SceneReader.read(() -> new StringReader(json), Path.of(""), problems, OptionalInt.of(frame), meshes);
        } catch (SceneException e) {
            // Lines of a text that is in no file would lead nowhere.
            throw new SceneException(e.problems().stream()
                    .map(p -> new SceneException.Problem(p.file(), 0, 0, p.pointer(), p.message()))
                    .toList());
        }
    }
}
