package enlightenment.job;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import enlightenment.camera.Camera;
import enlightenment.color.Rgb;
import enlightenment.file.ContentHash;
import enlightenment.light.Emission;
import enlightenment.light.Light;
import enlightenment.math.ExactPoint;
import enlightenment.math.Vec3;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.Shading;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** IES files go with a scene by their contents. */
class SceneDocumentTest {
    private static final String LAMP = "TILT=NONE\n1 1 1 2 1 1 2 0 0 0 1 1 9\n0 90 0 8 4\n";

    @TempDir
    Path folder;

    private static Scene scene(Path file) {
        return Scene.builder()
                .camera(new Camera.Isometric(ExactPoint.ORIGIN, 4))
                .shading(Shading.Physical.DEFAULT)
                .light(new Light.Ies(ExactPoint.ORIGIN, file, Vec3.X, 0, Rgb.WHITE, Emission.intensity(Rgb.WHITE)))
                .build();
    }

    private Path file(String name, String text) throws IOException {
        return Files.writeString(folder.resolve(name), text);
    }

    @Test
    void anIesFileGoesAsItIsUnderItsHash() throws IOException {
        SceneDocument document = SceneDocument.of(scene(file("a.ies", LAMP)));
        byte[] content = LAMP.getBytes(StandardCharsets.UTF_8);
        assertEquals(1, document.images().size());
        assertArrayEquals(content, document.images().get(ContentHash.of(content)));
    }

    @Test
    void theContentOfAnIesFileCountsAndNotItsName() throws IOException {
        ContentHash one = SceneDocument.of(scene(file("a.ies", LAMP))).hash();
        assertEquals(one, SceneDocument.of(scene(file("b.ies", LAMP))).hash());
        assertNotEquals(
                one,
                SceneDocument.of(scene(file("c.ies", LAMP.replace("8 4", "8 5"))))
                        .hash());
    }

    @Test
    void aMissingIesFileIsNamedAtItsLight() {
        Scene scene = scene(folder.resolve("none.ies"));
        SceneException e = assertThrows(SceneException.class, () -> SceneDocument.of(scene));
        assertEquals("/lights/0/file", e.problems().get(0).pointer());
    }
}
