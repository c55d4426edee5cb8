package enlightenment.net;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.render.Renderer;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The status page of a server shows the whole picture before the first tile is there. */
@Timeout(600)
class ServedPreviewTest {
    private static double distance(float[] a, float[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += (a[i] - b[i]) * (a[i] - b[i]);
        }
        return Math.sqrt(sum);
    }

    @Test
    void thePictureIsCoarseAtFirstAndThatOfOneProcessAtLast() throws Exception {
        float[] whole = Renderer.render(Farm.SCENE, Farm.SETTINGS).toArray();
        try (Farm farm = new Farm(Farm.options().statusPort(0)).begin()) {
            Image first = farm.server.round().image().orElseThrow();
            double black = distance(new float[whole.length], whole);
            assertTrue(distance(first.toArray(), whole) < 0.6 * black, "it shows little of the scene");
            farm.join(Farm.worker(1));
            Farm.until(() -> farm.server.round().snapshot().finished(), "it is done");
            assertArrayEquals(whole, farm.server.round().image().orElseThrow().toArray());
        }
    }

    @Test
    void withoutAPageNothingIsRenderedForIt() throws Exception {
        try (Farm farm = new Farm(Farm.options()).begin()) {
            float[] first = farm.server.round().image().orElseThrow().toArray();
            assertArrayEquals(new float[first.length], first);
        }
    }
}
