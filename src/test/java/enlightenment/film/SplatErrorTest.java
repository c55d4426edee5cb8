package enlightenment.film;

import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.DisplayCurve;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.api.Test;

/** Paths that reach the film with a known density give the picture that follows from it, within the error that it tells of itself. */
class SplatErrorTest {
    private static final int WIDTH = 24;
    private static final int HEIGHT = 16;
    private static final int UNITS = 10;

    /** A way to reach the film. */
    interface Paths {
        void trace(SplittableRandom random, SplatBatch out);
    }

    /** The mean of the picture over a part of its unit square. */
    interface Truth {
        double mean(double x0, double x1, double y0, double y1);
    }

    private record Case(Paths paths, Truth truth) {}

    private static void add(SplatBatch out, double x, double y, double v) {
        out.add(WIDTH * x, HEIGHT * y, v, v, v);
    }

    private static Map<String, Case> cases() {
        Map<String, Case> all = new LinkedHashMap<>();
        all.put("even", new Case((r, out) -> add(out, r.nextDouble(), r.nextDouble(), 1), (a, b, c, d) -> 1));
        // The density of u² is 1/(2 √x).
        all.put(
                "dense at the left",
                new Case(
                        (r, out) -> {
                            double u = r.nextDouble();
                            add(out, u * u, r.nextDouble(), 1);
                        },
                        (a, b, c, d) -> (Math.sqrt(b) - Math.sqrt(a)) / (b - a)));
        all.put(
                "the same picture by even points",
                new Case(
                        (r, out) -> {
                            double x = 1 - r.nextDouble();
                            add(out, x, r.nextDouble(), 0.5 / Math.sqrt(x));
                        },
                        (a, b, c, d) -> (Math.sqrt(b) - Math.sqrt(a)) / (b - a)));
        all.put(
                "a product",
                new Case(
                        (r, out) -> {
                            double x = r.nextDouble();
                            double y = r.nextDouble();
                            add(out, x, y, x * y);
                        },
                        (a, b, c, d) -> (a + b) * (c + d) / 4));
        // One path in 50 brings 25.5 instead of a half.
        all.put(
                "rare bright paths",
                new Case(
                        (r, out) -> add(out, r.nextDouble(), r.nextDouble(), r.nextInt(50) == 0 ? 25.5 : 0.5),
                        (a, b, c, d) -> 1));
        all.put(
                "a lit corner",
                new Case(
                        (r, out) -> add(out, r.nextDouble() / 12, r.nextDouble() / 8, 1),
                        (a, b, c, d) -> b < 0.1 && d < 0.15 ? 96 : 0));
        all.put(
                "paths that reach three points each, or none",
                new Case(
                        (r, out) -> {
                            double x = r.nextDouble();
                            double y = r.nextDouble();
                            if (r.nextBoolean()) {
                                add(out, x, y, 1);
                                add(out, x + 0.04 - (x + 0.04 >= 1 ? 1 : 0), y, 0.5);
                                add(out, x, y, 0.5);
                            }
                        },
                        (a, b, c, d) -> 1));
        all.put(
                "three bands of their own",
                new Case(
                        (r, out) -> out.add(
                                WIDTH * r.nextDouble(),
                                HEIGHT * r.nextDouble(),
                                2 * r.nextDouble(),
                                2 * r.nextDouble(),
                                2 * r.nextDouble()),
                        (a, b, c, d) -> 1));
        return all;
    }

    private static SplatFilm rendered(Paths paths, int perUnit, long seed) {
        SplatScale scale = SplatScale.of(1, (long) UNITS * perUnit, WIDTH * HEIGHT);
        SplatFilm film = new SplatFilm(0, 0, WIDTH, HEIGHT, WIDTH * HEIGHT, scale, DisplayCurve.SRGB);
        SplatBatch batch = new SplatBatch(0, 0, WIDTH, HEIGHT, scale);
        SplittableRandom random = new SplittableRandom(seed);
        for (int u = 0; u < UNITS; u++) {
            batch.begin(perUnit);
            for (int p = 0; p < perUnit; p++) {
                paths.trace(random, batch);
            }
            film.add(u, batch.sums());
        }
        return film;
    }

    private static double error(SplatFilm film, Truth truth) {
        double sum = 0;
        for (int y = 0; y < HEIGHT; y++) {
            for (int x = 0; x < WIDTH; x++) {
                double mean =
                        truth.mean((double) x / WIDTH, (x + 1.0) / WIDTH, (double) y / HEIGHT, (y + 1.0) / HEIGHT);
                for (int c = 0; c < 3; c++) {
                    double d = film.component(x, y, c) - mean;
                    sum += d * d;
                }
            }
        }
        return Math.sqrt(sum / (3 * WIDTH * HEIGHT));
    }

    /**
     * @param numbers of paths per unit
     * @param off by what factor the estimate may differ from the error, in the middle of all pictures
     */
    private static void check(int[] numbers, int pictures, double leastOfEach, double off) {
        StringBuilder table = new StringBuilder();
        boolean each = true;
        int all = 0;
        int cells = 0;
        for (Map.Entry<String, Case> e : cases().entrySet()) {
            table.append(String.format("%n%-44s", e.getKey()));
            for (int n : numbers) {
                int held = 0;
                List<Double> ratios = new ArrayList<>();
                double width = 0;
                for (int k = 0; k < pictures; k++) {
                    SplatFilm film = rendered(e.getValue().paths, n, 1000L * n + k);
                    double error = error(film, e.getValue().truth);
                    ErrorEstimate told = film.error();
                    held += error >= told.low() && error <= told.high() ? 1 : 0;
                    ratios.add(told.rmse() / error);
                    width += Math.log(told.high() / told.low()) / 2 / pictures;
                }
                ratios.sort(null);
                double middle = ratios.get(pictures / 2);
                table.append(String.format(" %6d: %3d (%.2f, ×÷%.2f)", n, held, middle, Math.exp(width)));
                // The estimate itself is about right, not only wide enough.
                each &= held >= leastOfEach * pictures && middle > 1 / off && middle < off;
                all += held;
                cells++;
            }
        }
        assertTrue(each && all >= 0.95 * cells * pictures, all + " of " + cells * pictures + " held" + table);
    }

    @Test
    void thePictureIsRightAndItsErrorIsAsItSays() {
        // 20 pictures of 95 %: 16 or fewer are held with a probability of 1.6 %. The error of four pixels is that of
        // few numbers.
        check(new int[] {10, 400}, 20, 0.85, 1.4);
    }

    @Test
    @Tag("full")
    void thePictureIsRightAndItsErrorIsAsItSaysOfVeryManyPictures() {
        // The lit corner has four pixels, whose errors cancel: their number, too, is guessed by what three contrasts
        // tell.
        check(new int[] {1, 4, 10, 40, 400, 4000}, 400, 0.88, 1.2);
    }
}
