package enlightenment.scene.json;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertSame;

import enlightenment.geometry.Mesh;
import enlightenment.mesh.MeshFiles;
import enlightenment.mesh.TestMeshes;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class SceneFramesTest {
    private static final String TEXT =
            """
            {
              "image": {"width": 4, "height": 4},
              "camera": {"type": "perspective", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "up": [0, 1, 0], "fieldOfView": 40},
              "shading": {"model": "physical"},
              "objects": [
                {"type": "mesh", "file": "ball.ply", "normals": "smooth", "transform": [{"translate": [0, 0, 0]}],
                 "material": {"type": "matte", "color": [1, 1, 1]}}
              ],
              "animation": {"frames": 3, "framesPerSecond": 25,
                "tracks": [{"target": "/objects/0/transform/0/translate/0", "keys": {"0": 0, "2": 1}}]}
            }
            """;

    @TempDir
    private Path folder;

    @Test
    void theFramesOfAFilmShareTheirMeshes() throws IOException {
        try (OutputStream out = Files.newOutputStream(folder.resolve("ball.ply"))) {
            MeshFiles.writePly(TestMeshes.icosphere(1), out);
        }
        Path text = Files.writeString(folder.resolve("film.json"), TEXT);
        SceneReader.Frames file = SceneReader.Frames.of(text);
        Mesh still = mesh(file.read());
        Mesh first = mesh(file.read(0));
        Mesh last = mesh(file.read(2));
        assertSame(still.triangles(), first.triangles());
        assertSame(first.triangles(), last.triangles());
        assertNotEquals(first.transform(), last.transform());
        assertEquals(SceneReader.read(text, 2), file.read(2));
    }

    private static Mesh mesh(Scene scene) {
        return (Mesh) scene.objects().get(0).shape();
    }
}
