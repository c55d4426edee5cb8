package enlightenment.physical;

import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.render.Welch;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.junit.jupiter.api.Tag;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * The renderer and the naive path tracer make the same picture: Welch's test on the means of the four quarters and of the whole in
 * each band, at 1 % for all comparisons of all scenes together by Šidák's formula.
 */
class NaivePartnerTest {
    private static final int HALF = 8;

    /** Pictures are floats, and the naive tracer starts its rays 1e-7 beside surfaces. */
    private static final double ROUNDING = 1e-6;

    private static final Map<String, Scene> SCENES = PartnerScenes.all();

    /** Not that in which nobody else finds what a pane reflects of a point light onto what is seen through the pane. */
    static Stream<String> scenes() {
        return SCENES.keySet().stream().filter(name -> !name.equals("point light behind a pane"));
    }

    /** The naive tracer's standard errors are 1 to 5 % here; what is wrong by a sixth of the light of a part is found. */
    @ParameterizedTest
    @ValueSource(
            strings = {
                "at most 2",
                "background and lights",
                "ball of wax",
                "checkered metal, mirror and glass",
                "coated",
                "coated, mirror and glass",
                "checkered glass and clear coat",
                "checkered roughness",
                "principled",
                "glowing disk and triangle",
                "glowing tubes",
                "fog with a mirror and glass",
                "half of glass",
                "half of glass, half of metal or of lacquer",
                "half of rough glass, half of plastic",
                "lights of all kinds",
                "many lights of all kinds",
                "metals",
                "hidden cube that refracts smoothly",
                "meshes that refract smoothly",
                "meshes whose normals are bent",
                "milk in glass",
                "nested glass",
                "pane",
                "rough glass",
                "smooth meshes of matte, mirror and glass",
                "smooth meshes of metal and coats",
                "rough jade",
                "fog that only absorbs",
                "rough matte",
                "under water by a panel",
                "window",
                "within a light"
            })
    void bothMakeTheSamePicture(String name) {
        compare(SCENES.get(name), 2, 8, 3_000);
    }

    @Tag("full")
    @ParameterizedTest
    @MethodSource("scenes")
    void bothMakeTheSamePictureWithManyPaths(String name) {
        compare(SCENES.get(name), 12, 32, 1_000_000);
    }

    static void compare(Scene scene, int antialias, int seeds, int pathsOfQuarter) {
        RenderSettings settings = RenderSettings.of(scene).withAntialias(antialias);
        compare(scene, settings, new NaiveTracer(scene), seeds, pathsOfQuarter);
    }

    /** Compares pictures of some settings with the paths of a tracer. */
    static void compare(Scene scene, RenderSettings settings, NaiveTracer tracer, int seeds, int pathsOfQuarter) {
        List<Image> pictures = Rendered.seeds(scene, settings, 1, seeds);
        List<double[]> ours = new ArrayList<>();
        List<double[]> naive = new ArrayList<>();
        for (int quarter = 0; quarter < 4; quarter++) {
            int x = quarter % 2 * HALF;
            int y = quarter / 2 * HALF;
            naive.addAll(List.of(tracer.means(x, y, x + HALF, y + HALF, pathsOfQuarter, 7919L * quarter)));
            for (int band = 0; band < 3; band++) {
                ours.add(Rendered.means(pictures, x, y, x + HALF, y + HALF, band));
            }
        }
        addWhole(ours);
        addWhole(naive);
        assertSame(scene.name(), ours, naive);
    }

    /** After four times three bands, the means of the quarters. */
    private static void addWhole(List<double[]> means) {
        for (int band = 0; band < 3; band++) {
            double[] whole = new double[means.get(0).length];
            for (int quarter = 0; quarter < 4; quarter++) {
                double[] part = means.get(3 * quarter + band);
                for (int k = 0; k < whole.length; k++) {
                    whole[k] += part[k] / 4;
                }
            }
            means.add(whole);
        }
    }

    private static void assertSame(String name, List<double[]> ours, List<double[]> naive) {
        double level = Welch.sidak(0.01, ours.size() * SCENES.size());
        List<String> different = new ArrayList<>();
        for (int k = 0; k < ours.size(); k++) {
            Statistics a = Statistics.of(ours.get(k));
            Statistics b = Statistics.of(naive.get(k));
            Welch test = Welch.of(ours.get(k), naive.get(k));
            boolean rounded = Math.abs(a.mean() - b.mean()) <= ROUNDING * b.mean();
            if (!rounded && test.probability() < level) {
                different.add((k < 12 ? "quarter " + k / 3 : "whole") + ", band " + k % 3 + ": " + a.mean() + " ± "
                        + a.error() + " instead of " + b.mean() + " ± " + b.error());
            }
        }
        assertTrue(different.isEmpty(), () -> name + ":\n" + String.join("\n", different));
    }
}
