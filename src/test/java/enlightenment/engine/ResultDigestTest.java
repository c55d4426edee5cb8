package enlightenment.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import enlightenment.file.ContentHash;
import enlightenment.render.TestScenes;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import org.junit.jupiter.api.Test;

/** Results are compared by all that the picture is made of: devices count other tests of primitives for the same pixels. */
class ResultDigestTest {
    private static final Scene SCENE = TestScenes.whiteFireAndIce().size(12, 8).build();
    private static final DividedRender RENDER =
            DividedRender.prepare(SCENE, RenderSettings.of(SCENE).withAntialias(2), () -> false);

    private final FilmAssembly film = RENDER.assembly();
    private final byte[] result = RENDER.maker().make(0);
    private final int kinds = RENDER.outline().kinds().size();

    private ContentHash changed(int at) {
        byte[] other = result.clone();
        other[at] ^= 1;
        return film.digest(0, other);
    }

    /** Rays of surveys, lost samples and whether samples are differences are parts of the picture's report, the same by any device. */
    @Test
    void everyByteButThoseOfCountersCounts() {
        ContentHash own = film.digest(0, result);
        int counters = 0;
        for (int i = 0; i < result.length; i++) {
            byte[] other = result.clone();
            other[i] ^= 1;
            boolean isCounter = i < ResultHeader.length(kinds)
                    && ResultHeader.surveyRays(other) == ResultHeader.surveyRays(result)
                    && ResultHeader.lostSamples(other, kinds) == ResultHeader.lostSamples(result, kinds)
                    && ResultHeader.samplesAreDifferences(other, kinds)
                            == ResultHeader.samplesAreDifferences(result, kinds);
            counters += isCounter ? 1 : 0;
            if (isCounter) {
                assertEquals(own, changed(i), "byte " + i);
            } else {
                assertNotEquals(own, changed(i), "byte " + i);
            }
        }
        // Ten that every render has, and tests and hits of each kind of primitive.
        assertEquals(8 * (10 + 2 * kinds), counters);
    }

    @Test
    void aGroupIsComparedByEachOfItsResults() {
        assertEquals(film.digest(0, result), ResultCheck.of(RENDER.outline()).digest(result));
    }
}
