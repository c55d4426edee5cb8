package enlightenment.film;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayCurve;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Films of pixels' own samples with light that paths have splatted over them. */
class SplattedFilmTest {
    private static final int SIDE = PathPicture.SIDE;
    private static final int UNITS = 32;
    private static final DisplayCurve CURVE = DisplayCurve.SRGB;

    /** What is splatted: as much everywhere, in the mean. */
    private static final double MEAN = 0.2;

    private static List<SplatSums> units(int pathsPerUnit, SplatScale scale, long seed) {
        SplatBatch batch = new SplatBatch(0, 0, SIDE, SIDE, scale);
        SplittableRandom random = new SplittableRandom(seed);
        List<SplatSums> units = new ArrayList<>();
        for (int u = 0; u < UNITS; u++) {
            batch.begin(pathsPerUnit);
            for (int p = 0; p < pathsPerUnit; p++) {
                batch.add(SIDE * random.nextDouble(), SIDE * random.nextDouble(), MEAN, MEAN, MEAN);
            }
            units.add(batch.sums());
        }
        return units;
    }

    private static SplatFilm splats(int pathsPerUnit, long seed, List<Integer> order) {
        SplatScale scale = SplatScale.of(MEAN, (long) UNITS * pathsPerUnit, SIDE * SIDE);
        List<SplatSums> units = units(pathsPerUnit, scale, seed);
        SplatFilm film = new SplatFilm(0, 0, SIDE, SIDE, SIDE * SIDE, scale, CURVE);
        order.forEach(u -> film.add(u, units.get(u)));
        return film;
    }

    private static List<Integer> inOrder() {
        List<Integer> order = new ArrayList<>();
        for (int u = 0; u < UNITS; u++) {
            order.add(u);
        }
        return order;
    }

    @Test
    void meansAreSumsAndTheOrderOfUnitsChangesNoBit() {
        Film film = PathPicture.of(PathPicture.Kind.EXPONENTIAL, 0.5, 8, CURVE, 1).film;
        List<Integer> order = inOrder();
        SplatFilm splats = splats(500, 2, order);
        Film sum = film.plus(splats);
        for (int i = 0; i < SIDE * SIDE; i++) {
            int x = i % SIDE;
            int y = i / SIDE;
            assertEquals(film.component(x, y, 1) + splats.component(x, y, 1), sum.component(x, y, 1));
            assertEquals(film.count(x, y), sum.count(x, y));
        }
        Collections.shuffle(order, new Random(3));
        Film shuffled = film.plus(splats(500, 2, order));
        assertArrayEquals(sum.toImage().toArray(), shuffled.toImage().toArray());
        assertArrayEquals(sum.error().variances(), shuffled.error().variances());
        assertEquals(sum.error().high(), shuffled.error().high());
        assertEquals(sum.error().linear(), shuffled.error().linear());
    }

    @Test
    void withoutPathsItIsTheFilmItself() {
        Film film = PathPicture.of(PathPicture.Kind.HEAVY, 0.5, 4, CURVE, 1).film;
        SplatFilm nothing = new SplatFilm(0, 0, SIDE, SIDE, SIDE * SIDE, new SplatScale(30), CURVE);
        assertArrayEquals(film.toImage().toArray(), film.plus(nothing).toImage().toArray());
        assertEquals(film.error().rmse(), film.plus(nothing).error().rmse());
    }

    @Test
    void pixelsThatAreNotFinishedStayBlack() {
        Film film = new Film(0, 0, SIDE, SIDE, CURVE);
        assertEquals(0, film.plus(splats(100, 1, inOrder())).component(3, 4, 0));
    }

    /** Neither part tells the error of the sum: where there is more light the screen shows less of the other's noise. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3, 4, 6, 16})
    void theErrorIsThatOfTheSum(int samples) {
        int inside = 0;
        double told = 0;
        double found = 0;
        int seeds = 10;
        for (int seed = 0; seed < seeds; seed++) {
            PathPicture picture = PathPicture.of(PathPicture.Kind.EXPONENTIAL, 0.3, samples, CURVE, seed);
            Film sum = picture.film.plus(splats(300, seed, inOrder()));
            double error = 0;
            for (int i = 0; i < SIDE * SIDE; i++) {
                double d = CURVE.of(sum.component(i % SIDE, i / SIDE, 0)) - CURVE.of(picture.truth[i] + MEAN);
                error += d * d / (SIDE * SIDE);
            }
            ErrorEstimate estimate = sum.error();
            inside += estimate.low() <= Math.sqrt(error) && Math.sqrt(error) <= estimate.high() ? 1 : 0;
            told += estimate.rmse() * estimate.rmse() / seeds;
            found += error / seeds;
        }
        int all = inside;
        assertTrue(all >= seeds - 1, () -> all + " of " + seeds + " inside");
        // Runs of Sobol points that are no powers of two differ by more than their means err.
        assertEquals(1, Math.sqrt(told / found), samples < 4 || Integer.bitCount(samples) > 1 ? 0.25 : 0.1);
    }

    /** Paths are of four groups however few samples there are beside them: of black pixels, which tell nothing, all is by paths. */
    @ParameterizedTest
    @ValueSource(ints = {1, 2, 3})
    void theErrorOfFewPathsIsToldBesideFewSamplesAsBesideFour(int samples) {
        // One path for three pixels: most are black still, and what is not so shows much less of its noise than there
        // is.
        SplatFilm splats = splats(SIDE * SIDE / 3 / UNITS, 1, inOrder());
        ErrorEstimate few = black(samples).plus(splats).error();
        ErrorEstimate four = black(4).plus(splats).error();
        assertEquals(1, few.rmse() / four.rmse(), 1e-5);
        assertTrue(few.high() > CURVE.of(MEAN), few.high() + " where all that is missing is " + CURVE.of(MEAN));
        assertTrue(few.linear().orElseThrow().hasHeavyTail());
    }

    private static Film black(int samples) {
        FilmTile tile = new FilmTile(0, 0, SIDE, SIDE, CURVE);
        SampleSpread spread = new SampleSpread();
        for (int i = 0; i < SIDE * SIDE; i++) {
            spread.begin(samples);
            for (int s = 0; s < samples; s++) {
                tile.add(i % SIDE, i / SIDE, 0, 0, 0);
                spread.at(0.25 + 0.5 * s / samples, 0.5);
                spread.add(0, 0, 0);
            }
            tile.spread(i % SIDE, i / SIDE, spread);
        }
        Film film = new Film(0, 0, SIDE, SIDE, CURVE);
        film.put(tile);
        return film;
    }
}
