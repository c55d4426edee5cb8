package enlightenment.method;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.film.FilmTile;
import enlightenment.film.TilePasses;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** A tile of fire and ice, with edges, shadows, mirrors and glass. */
class RayTracePassesTest {
    private static final Scene SCENE = SceneReader.read(Path.of("scenes/fire-and-ice.json"));
    private static final RenderSettings SETTINGS = RenderSettings.of(SCENE).withSize(80, 40);
    private static final CompiledScene COMPILED = SceneCompiler.compile(SCENE, SETTINGS);

    private static RayTraceMethod method(double samples) {
        return RayTraceMethod.of(COMPILED, SETTINGS, new RayCounters(COMPILED.kindNames.size()), samples);
    }

    private static FilmTile tile() {
        return new FilmTile(37, 16, 9, 8);
    }

    private static void checkSame(FilmTile a, FilmTile b) {
        for (int y = a.y; y < a.y + a.height; y++) {
            for (int x = a.x; x < a.x + a.width; x++) {
                for (int c = 0; c < 3; c++) {
                    assertEquals(a.mean(x, y, c), b.mean(x, y, c));
                }
                assertEquals(a.halves(x, y), b.halves(x, y));
                assertEquals(a.quarters(x, y), b.quarters(x, y));
                assertEquals(a.count(x, y), b.count(x, y));
            }
        }
    }

    @ParameterizedTest
    @CsvSource({"4, 4", "11.7, 4", "11.7, 8", "32, 16"})
    void passesTakeTheSamplesOfTheUndividedTile(double samples, int passes) {
        FilmTile whole = tile();
        method(samples).render(whole);
        FilmTile merged = tile();
        method(samples).renderAll(merged, passes);
        boolean noise = false;
        for (int y = whole.y; y < whole.y + whole.height; y++) {
            for (int x = whole.x; x < whole.x + whole.width; x++) {
                assertEquals(whole.count(x, y), merged.count(x, y));
                for (int c = 0; c < 3; c++) {
                    assertEquals(whole.mean(x, y, c), merged.mean(x, y, c), Math.ulp(whole.mean(x, y, c)));
                }
                // Sums of quarters are rounded once here and with each sample there; their differences are as far off.
                assertEquals(whole.halves(x, y), merged.halves(x, y), 1e-6 * whole.halves(x, y) + 1e-15);
                assertEquals(whole.quarters(x, y), merged.quarters(x, y), 1e-6 * whole.quarters(x, y) + 1e-15);
                noise |= whole.quarters(x, y) > 0;
            }
        }
        assertTrue(noise);
    }

    @Test
    void passesMadeByOthersInAnotherOrderGiveTheSameBits() {
        FilmTile expected = tile();
        method(20).renderAll(expected, 16);
        TilePasses all = new TilePasses(expected.x, expected.y, expected.width, expected.height, 16);
        for (int k = 0; k < 16; k++) {
            int pass = (7 * k + 5) % 16;
            FilmTile one = tile();
            method(20).render(one, pass, 16);
            all.add(pass, one);
        }
        FilmTile tile = tile();
        all.into(tile);
        checkSame(expected, tile);
    }

    @Test
    void aPixelIsTheSameInPassesOfEveryTile() {
        FilmTile expected = tile();
        method(8).renderAll(expected, 4);
        FilmTile narrow = new FilmTile(40, 18, 2, 3);
        method(8).renderAll(narrow, 4);
        for (int y = 18; y < 21; y++) {
            for (int x = 40; x < 42; x++) {
                assertEquals(expected.mean(x, y, 1), narrow.mean(x, y, 1));
                assertEquals(expected.halves(x, y), narrow.halves(x, y));
            }
        }
    }

    @ParameterizedTest
    @ValueSource(ints = {0, 2, 5, 12, 16})
    void morePassesThanSamplesAndOddNumbersAreRefused(int passes) {
        assertThrows(IllegalArgumentException.class, () -> method(15).render(tile(), 0, passes));
    }
}
