package enlightenment.method;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.film.FilmTile;
import enlightenment.render.TestScenes;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.world.CompiledScene;
import enlightenment.world.SceneCompiler;
import enlightenment.world.parts.RayCounters;
import java.util.HashSet;
import java.util.List;
import java.util.Set;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class SpreadPlacesTest {
    @ParameterizedTest
    @CsvSource({"100, 50, 320", "100, 50, 1", "25, 13, 40", "1, 512, 30", "512, 1, 30", "7, 3, 10", "3, 3, 100"})
    void thereAreAboutSoManyDifferentPlacesOrAll(int columns, int rows, int count) {
        List<int[]> places = SpreadPlaces.of(columns, rows, count);
        Set<Integer> different = new HashSet<>();
        for (int[] place : places) {
            assertTrue(place[0] >= 0 && place[0] < columns && place[1] >= 0 && place[1] < rows);
            different.add(place[1] * columns + place[0]);
        }
        assertEquals(places.size(), different.size());
        int wanted = Math.min(count, columns * rows);
        // A lattice of low discrepancy misses by a few, not by √count.
        assertEquals(wanted, places.size(), count >= columns * rows ? 0 : 5);
    }

    @Test
    void everyPartHasItsShareOfThem() {
        int[] parts = new int[16];
        for (int[] place : SpreadPlaces.of(80, 80, 800)) {
            parts[place[1] / 20 * 4 + place[0] / 20]++;
        }
        for (int part : parts) {
            assertEquals(50, part, 5);
        }
    }

    @Test
    void thresholdsLieEvenlyInTheirRange() {
        int[] tenths = new int[10];
        for (int y = 1000; y < 1032; y++) {
            for (int x = 4000; x < 4032; x++) {
                double t = Dither.at(x, y);
                assertTrue(t >= 0 && t < 1);
                tenths[(int) (10 * t)]++;
            }
        }
        for (int n : tenths) {
            assertEquals(102.4, n, 6);
        }
    }

    @ParameterizedTest
    @ValueSource(doubles = {1, 1.3, 2, 2.75, 4, 5.5, 6, 13.9})
    void raytraceTakesSoManySamplesInTheMeanAndPowersOfTwoInEachPixel(double samples) {
        Scene scene = TestScenes.whiteFireAndIce().size(64, 64).build();
        RenderSettings settings = RenderSettings.of(scene).with(new BuiltInMethod.RayTraceSettings(1));
        CompiledScene compiled = SceneCompiler.compile(scene, settings);
        FilmTile tile = new FilmTile(0, 0, 64, 64);
        RayTraceMethod.of(compiled, settings, new RayCounters(compiled.kindNames.size()), samples)
                .render(tile);
        long sum = 0;
        int low = Integer.highestOneBit((int) samples);
        for (int k = 0; k < 64 * 64; k++) {
            int n = tile.count(k % 64, k / 64);
            assertTrue(n == low || n == 2 * low, n + " samples");
            sum += n;
        }
        assertEquals(samples, sum / 4096.0, low * 10.0 / 4096);
    }
}
