package enlightenment.view;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import enlightenment.image.Image;
import enlightenment.image.ImageFiles;
import enlightenment.render.Film;
import enlightenment.render.RenderRequest;
import enlightenment.render.RenderResult;
import enlightenment.render.Renderer;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.view.frame.PassPlan;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ScenePreparationTest {
    private static final String SCENE =
            """
            {
              "image": { "width": 24, "height": 16 },
              "camera": { "type": "perspective", "eye": [0, 0, -5], "lookAt": [0, 0, 0], "fieldOfView": 40 },
              "shading": { "model": "physical" },
              "lights": [ { "type": "sphere", "center": [2, 3, -2], "radius": 0.5, "color": "#ffffff", "power": 100 } ],
              "objects": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1, "name": "ball",
                             "material": { "type": "matte", "color": { "texture": "a" } } } ],
              "textures": { "a": { "file": "a.png" } }
            }
            """;

    @TempDir
    private Path folder;

    private Scene scene;
    private Film film;
    private final ScenePreparation preparation = new ScenePreparation();

    @BeforeEach
    void read() throws Exception {
        // Preparing it asks whether it is cancelled between images.
        ImageFiles.writePng(new Image(1, 1, new float[] {1, 0.5f, 0.2f}), folder.resolve("a.png"));
        scene = SceneReader.read(Files.writeString(folder.resolve("scene.json"), SCENE));
        film = Film.of(1, 1, frame -> scene);
    }

    private Shot shot(long generation) {
        return new Shot(generation, scene, film, new ViewSize(24, 16));
    }

    private static RenderSettings settings(Shot shot, int shrink) {
        return shot.settings(new PassPlan(shrink, 0, 2, 0), 1);
    }

    private RenderRequest prepare(Shot shot, int shrink) {
        return preparation.request(shot, settings(shot, shrink), () -> false);
    }

    /** Preparing would be cancelled at once: what is known is given in spite of that. */
    private void known(Shot shot, int shrink) {
        RenderRequest request = preparation.request(shot, settings(shot, shrink), () -> true);
        assertEquals(24 / shrink, request.settings().width());
    }

    private void unknown(Shot shot, int shrink) {
        assertThrows(CancellationException.class, () -> preparation.request(shot, settings(shot, shrink), () -> true));
    }

    @Test
    void twoSizesOfAShotAreKept() {
        prepare(shot(1), 1);
        prepare(shot(1), 4);
        known(shot(1), 1);
        known(shot(1), 4);
        prepare(shot(1), 2);
        known(shot(1), 2);
        known(shot(1), 4);
        unknown(shot(1), 1);
    }

    @Test
    void anotherShotHasNothingOfTheOneBefore() {
        prepare(shot(1), 1);
        unknown(shot(2), 1);
        prepare(shot(2), 1);
        // What is late does not take the place of what is wanted now.
        prepare(shot(1), 1);
        known(shot(2), 1);
        unknown(shot(1), 1);
    }

    @Test
    void layersOfAPreparedSceneAreThoseOfTheScene() {
        Set<RenderResult.Auxiliary> kinds = EnumSet.of(
                RenderResult.Auxiliary.ALBEDO,
                RenderResult.Auxiliary.DEPTH,
                RenderResult.Auxiliary.NORMAL,
                RenderResult.Auxiliary.OBJECT);
        prepare(shot(1), 1);
        Map<RenderResult.Auxiliary, Image> prepared = Renderer.auxiliary(
                preparation.request(shot(1), settings(shot(1), 1), () -> false).withAuxiliary(kinds));
        Map<RenderResult.Auxiliary, Image> fresh =
                Renderer.auxiliary(RenderRequest.of(scene, settings(shot(1), 1)).withAuxiliary(kinds));
        assertEquals(kinds, prepared.keySet());
        for (RenderResult.Auxiliary kind : kinds) {
            assertArrayEquals(fresh.get(kind).toArray(), prepared.get(kind).toArray(), kind.word());
        }
    }
}
