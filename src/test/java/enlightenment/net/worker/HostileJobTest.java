package enlightenment.net.worker;

import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotNull;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.engine.DividedRender;
import enlightenment.file.ContentHash;
import enlightenment.job.Build;
import enlightenment.net.job.FilmContent;
import enlightenment.net.job.JobContent;
import enlightenment.render.TestScenes;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.io.IOException;
import java.util.Arrays;
import java.util.Map;
import java.util.Random;
import org.junit.jupiter.api.Test;

/** Whatever a job's document has for bytes, a worker takes it or says why not. */
class HostileJobTest {
    private static final Scene SCENE = TestScenes.whiteFireAndIce().build();
    private static final RenderSettings SETTINGS =
            RenderSettings.of(SCENE).withSize(32, 18).withThreads(1);
    private static final DividedRender RENDER = DividedRender.prepare(SCENE, SETTINGS, () -> false);
    private static final int TILES = RENDER.units();

    private static byte[] picture() {
        JobContent job = JobContent.of(SCENE, RENDER.outline(), Build.number());
        return job.content(job.hash());
    }

    private static byte[] film() {
        FilmContent film = new FilmContent(Build.number());
        film.add(SCENE, RENDER.outline(), 1);
        JobContent job = film.content();
        return job.content(job.hash());
    }

    /** Fails with anything but an {@link IOException} that says something. */
    private static void take(byte[] document, String what) {
        try {
            WorkerUnits.of(document, Map.of(), TILES, Build.number(), 1);
        } catch (IOException e) {
            assertNotNull(e.getMessage(), what);
            assertFalse(e.getMessage().isBlank(), what);
            assertFalse(e.getMessage().contains("java."), what + ": " + e.getMessage());
        } catch (RuntimeException | Error e) {
            throw new AssertionError(what, e);
        }
    }

    @Test
    void randomBytesAreNoJob() {
        Random random = new Random(5);
        for (int n = 0; n < 2_000; n++) {
            byte[] noise = new byte[n < 500 ? n : 500];
            random.nextBytes(noise);
            String message = assertThrows(
                            IOException.class, () -> WorkerUnits.of(noise, Map.of(), TILES, Build.number(), 1))
                    .getMessage();
            assertTrue(message != null && message.contains("job"), "" + message);
        }
    }

    @Test
    void aJobThatIsCutAnywhereIsRefusedInWords() {
        for (byte[] whole : new byte[][] {picture(), film()}) {
            for (int length = 0; length < whole.length; length += length < 600 ? 1 : 97) {
                take(Arrays.copyOf(whole, length), "cut after " + length);
            }
        }
    }

    @Test
    void aJobWithBytesOfOtherValuesIsTakenOrRefusedInWords() {
        Random random = new Random(7);
        for (byte[] whole : new byte[][] {picture(), film()}) {
            for (int n = 0; n < 1_500; n++) {
                byte[] changed = whole.clone();
                int at = random.nextInt(Math.min(changed.length, 500));
                byte[] values = {0, -1, 1, 127, (byte) 128, (byte) random.nextInt()};
                int width = 1 << random.nextInt(3);
                for (int i = at; i < Math.min(at + width, changed.length); i++) {
                    changed[i] = values[n % values.length];
                }
                take(changed, "change " + n + " at " + at);
            }
        }
    }

    @Test
    void theJobsHashTellsThemApart() {
        assertFalse(ContentHash.of(picture()).equals(ContentHash.of(film())));
    }
}
