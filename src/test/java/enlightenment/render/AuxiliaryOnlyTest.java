package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.math.InvalidValueException;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.EnumSet;
import java.util.Map;
import java.util.Set;
import java.util.concurrent.CancellationException;
import org.junit.jupiter.api.Test;

/** What pixels show beside their colours, without a picture. */
class AuxiliaryOnlyTest {
    private static final Set<RenderResult.Auxiliary> RAYS = EnumSet.of(
            RenderResult.Auxiliary.DEPTH,
            RenderResult.Auxiliary.NORMAL,
            RenderResult.Auxiliary.POSITION,
            RenderResult.Auxiliary.OBJECT);

    private static RenderRequest of(String scene) {
        Scene read = SceneReader.read(Path.of("scenes", scene));
        RenderSettings usual = RenderSettings.of(read);
        return RenderRequest.of(
                read, usual.withSize(24, 24).withBudget(usual.budget().withSamples(1)));
    }

    @Test
    void itIsWhatARenderFindsBesideItsPicture() {
        EnumSet<RenderResult.Auxiliary> kinds = EnumSet.copyOf(RAYS);
        kinds.add(RenderResult.Auxiliary.ALBEDO);
        RenderRequest request = of("cornell-box.json").withAuxiliary(kinds);
        Map<RenderResult.Auxiliary, Image> beside = Renderer.render(request).auxiliary();
        Map<RenderResult.Auxiliary, Image> alone = Renderer.auxiliary(request);
        assertEquals(kinds, alone.keySet());
        for (RenderResult.Auxiliary kind : RAYS) {
            assertArrayEquals(beside.get(kind).toArray(), alone.get(kind).toArray(), kind.word());
        }
        // The walls' colours have no noise: only pixels on an edge depend on the samples.
        float[] a = beside.get(RenderResult.Auxiliary.ALBEDO).toArray();
        float[] b = alone.get(RenderResult.Auxiliary.ALBEDO).toArray();
        int alike = 0;
        for (int i = 0; i < a.length; i++) {
            alike += a[i] == b[i] ? 1 : 0;
        }
        assertTrue(alike > 0.8 * a.length, alike + " of " + a.length);
    }

    @Test
    void whatTakesAPictureIsRefused() {
        for (RenderResult.Auxiliary kind : new RenderResult.Auxiliary[] {
            RenderResult.Auxiliary.ERROR, RenderResult.Auxiliary.SAMPLES, RenderResult.Auxiliary.INDIRECT
        }) {
            RenderRequest request = of("cornell-box.json").withAuxiliary(kind);
            assertEquals(
                    "auxiliary",
                    assertThrows(InvalidValueException.class, () -> Renderer.auxiliary(request))
                            .key());
        }
        RenderRequest classic = of("fire-and-ice.json").withAuxiliary(RenderResult.Auxiliary.ALBEDO);
        assertThrows(InvalidValueException.class, () -> Renderer.auxiliary(classic));
    }

    @Test
    void itCanBeStopped() {
        RenderRequest request = of("cornell-box.json")
                .withAuxiliary(RenderResult.Auxiliary.DEPTH)
                .withCancelled(() -> true);
        assertThrows(CancellationException.class, () -> Renderer.auxiliary(request));
    }
}
