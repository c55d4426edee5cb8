package enlightenment.physical;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.color.Color;
import enlightenment.image.Image;
import enlightenment.render.Film;
import enlightenment.render.RenderRequest;
import enlightenment.render.Renderer;
import enlightenment.render.Welch;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.List;
import java.util.stream.IntStream;

/** Linear pictures through the public interface. */
final class Rendered {
    private Rendered() {}

    /** Pictures of a scene with one seed after the other. */
    static List<Image> seeds(Scene scene, RenderSettings settings, int first, int count) {
        // A film makes tables of materials once for all of them.
        Film film = Film.of(1, 1, frame -> scene);
        return IntStream.range(first, first + count)
                .parallel()
                .mapToObj(seed -> film.render(
                                RenderRequest.of(scene, settings.withThreads(1).withSeed(seed)))
                        .image())
                .toList();
    }

    static List<Image> seeds(Scene scene, int antialias, int first, int count) {
        return seeds(scene, RenderSettings.of(scene).withAntialias(antialias), first, count);
    }

    /** A picture of so many times the scene's width and height. */
    static Image zoomed(Scene scene, int zoom, double samples, BuiltInMethod method, long seed) {
        return Renderer.render(
                scene,
                RenderSettings.of(scene)
                        .withSize(scene.width() * zoom, scene.height() * zoom)
                        .withMethod(method)
                        .withSeed(seed)
                        .withBudget(RenderSettings.Budget.NONE.withSamples(samples)));
    }

    /** A band's mean over a part of each picture. */
    static double[] means(List<Image> pictures, int left, int top, int right, int bottom, int band) {
        return pictures.stream()
                .mapToDouble(image -> {
                    assertEquals(Color.Encoding.LINEAR, image.encoding());
                    double sum = 0;
                    for (int y = top; y < bottom; y++) {
                        for (int x = left; x < right; x++) {
                            assertTrue(image.component(x, y, band) >= 0, "negative or not a number");
                            sum += image.component(x, y, band);
                        }
                    }
                    return sum / ((right - left) * (bottom - top));
                })
                .toArray();
    }

    /**
     * Compares four parts of 8 × 8 pixels of pictures, band by band.
     *
     * @param tests how many such comparisons the whole test makes, of which one in a hundred may fail by chance
     */
    static void assertPartsAgree(List<Image> expected, List<Image> actual, int tests) {
        for (int part = 0; part < 4; part++) {
            int x = part % 2 * 8;
            int y = part / 2 * 8;
            for (int band = 0; band < 3; band++) {
                double[] a = means(expected, x, y, x + 8, y + 8, band);
                double[] b = means(actual, x, y, x + 8, y + 8, band);
                String told =
                        "part " + part + ", band " + band + ": " + Statistics.of(b) + " instead of " + Statistics.of(a);
                assertTrue(Welch.of(a, b).probability() >= Welch.sidak(0.01, tests), told);
            }
        }
    }

    /** The mean of the red band over one picture. */
    static double mean(Scene scene, RenderSettings settings) {
        return means(List.of(Renderer.render(scene, settings)), 0, 0, scene.width(), scene.height(), 0)[0];
    }

    /** Fails unless contact shows what a thin gap does: the means of two renders of the same seed, which differ by less than their noise. */
    static void assertContactIsLimit(double gap, double contact, double relative) {
        assertEquals(1, contact / gap, relative);
    }
}
