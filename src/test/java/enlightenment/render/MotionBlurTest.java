package enlightenment.render;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.SceneException;
import enlightenment.scene.json.SceneReader;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Collections;
import java.util.List;
import java.util.OptionalInt;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Pictures of what moves while the shutter is open are the means of pictures of its moments. */
class MotionBlurTest {
    private static final int FRAME = 2;
    private static final int INSTANTS = 8;

    private static Scene scene(String shading, String shutter) {
        return scene(shading, shutter, 300);
    }

    private static Scene scene(String shading, String shutter, double power) {
        String text =
                """
                { "image": { "width": 32, "height": 24 },
                  "camera": { "type": "perspective", "eye": [0, 1, -6], "lookAt": [0, 0.5, 0], "fieldOfView": 40 },
                  "shading": SHADING,
                  "materials": {
                    "red": { "type": "matte", "color": "#c02010" },
                    "mirror": { "type": "mirror", "color": "#f0f0f0" },
                    "floor": { "type": "matte", "color": "#a0c0a0" } },
                  "lights": [{ "type": "sphere", "center": [2, 4, -3], "radius": 0.4, "color": "#ffffff", "power": POWER }],
                  "objects": [
                    { "type": "sphere", "center": [-1.5, 0.5, 0], "radius": 0.5, "material": "red" },
                    { "type": "sphere", "center": [0.8, 0.6, 0.5], "radius": 0.6, "material": "mirror" },
                    { "type": "rectangle", "corners": [[-5, 0, -5], [-5, 0, 5], [5, 0, 5], [5, 0, -5]], "material": "floor" } ],
                  "animation": { "frames": 4, "framesPerSecond": 25, SHUTTER "tracks": [
                    { "target": "/objects/0/center/0", "keys": { "0": -2, "3": 1 }, "easing": "smooth" },
                    { "target": "/lights/0/center/0", "keys": { "0": 2, "3": -2 } },
                    { "target": "/camera/eye/1", "keys": { "0": 1, "3": 1.3 } } ] } }
                """
                        .replace("SHADING", shading)
                        .replace("SHUTTER", shutter)
                        .replace("POWER", Double.toString(power));
        return SceneReader.readBytes(
                text.getBytes(java.nio.charset.StandardCharsets.UTF_8), Path.of(""), "test", OptionalInt.of(FRAME));
    }

    private static Scene blurred(String shading) {
        return scene(shading, "\"shutter\": 0.8, \"instants\": " + INSTANTS + ",");
    }

    private static RenderSettings settings(Scene scene, int antialias) {
        return RenderSettings.of(scene).withAntialias(antialias);
    }

    private static double meanSquare(float[] a, float[] b) {
        double sum = 0;
        for (int i = 0; i < a.length; i++) {
            sum += (a[i] - b[i]) * (double) (a[i] - b[i]);
        }
        return sum / a.length;
    }

    /** The mean of pictures of the moments, each rendered by itself. */
    private static float[] bruteForce(Scene scene, BuiltInMethod method, int antialias) {
        float[] sum = new float[3 * scene.width() * scene.height()];
        for (Scene instant : scene.instants()) {
            float[] one = Renderer.render(instant, settings(instant, antialias).withMethod(method))
                    .toArray();
            for (int i = 0; i < sum.length; i++) {
                sum[i] += one[i] / INSTANTS;
            }
        }
        return sum;
    }

    /**
     * The blurred picture has as many samples as all of those together, so it comes as close to the truth: the mean square of the
     * difference is some twice that of either. What is blurred is far more than ten times as far from a picture of one moment.
     */
    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "RAYTRACE | { \"model\": \"classic\" } | 1e-4",
                "RAYTRACE | { \"model\": \"physical\", \"background\": { \"linear\": [0.3, 0.4, 0.5] }, \"maxBounces\": 4 } | 1e-3",
                "CLUSTER | { \"model\": \"physical\", \"background\": { \"linear\": [0.3, 0.4, 0.5] }, \"maxBounces\": 4 } | 1e-3",
                "METROPOLIS | { \"model\": \"physical\", \"background\": { \"linear\": [0.3, 0.4, 0.5] }, \"maxBounces\": 4 } | 4e-3",
                "LIGHT | { \"model\": \"physical\", \"maxBounces\": 4 } | 2e-3",
                "BIDIRECTIONAL | { \"model\": \"physical\", \"maxBounces\": 4 } | 2e-3"
            })
    void aBlurredPictureIsTheMeanOfManyFrames(BuiltInMethod method, String shading, double most) {
        Scene scene = blurred(shading);
        assertEquals(INSTANTS, scene.instants().size());
        float[] blurred =
                Renderer.render(scene, settings(scene, 17).withMethod(method)).toArray();
        float[] mean = bruteForce(scene, method, 6);
        double difference = meanSquare(blurred, mean);
        Scene still = scene.withInstants(List.of());
        double ofStill = meanSquare(
                Renderer.render(still, settings(still, 6).withMethod(method)).toArray(), mean);
        assertTrue(difference < most, "mean square " + difference);
        assertTrue(ofStill > 10 * difference, ofStill + " for a still picture, " + difference + " for a blurred one");
        double bias = 0;
        for (int i = 0; i < mean.length; i++) {
            bias += (blurred[i] - mean[i]) / mean.length;
        }
        assertEquals(0, bias, 4 * Math.sqrt(difference / mean.length * 3));
    }

    /** Chains are noisy where shading is classic: means of blocks of 8 × 8 pixels are compared with those of other rays. */
    @Test
    void chainsOfClassicShadingSeeAllMoments() {
        Scene scene = blurred("{ \"model\": \"classic\" }");
        float[] truth = blocks(bruteForce(scene, BuiltInMethod.RAYTRACE, 6));
        RenderSettings chains = settings(scene, 40).withMethod(BuiltInMethod.METROPOLIS);
        double blurred = meanSquare(blocks(Renderer.render(scene, chains).toArray()), truth);
        double still = meanSquare(
                blocks(Renderer.render(scene.withInstants(List.of()), chains).toArray()), truth);
        assertTrue(still > 10 * blurred, still + " for a still picture, " + blurred + " for a blurred one");
    }

    private static float[] blocks(float[] picture) {
        float[] means = new float[3 * 4 * 3];
        for (int i = 0; i < picture.length; i++) {
            int pixel = i / 3;
            means[3 * (4 * (pixel / 32 / 8) + pixel % 32 / 8) + i % 3] += picture[i] / 64;
        }
        return means;
    }

    /** Caustics of what moves have a pass of their own as those of what stands still: the picture has the light of all ways. */
    @Test
    void aBlurredPictureHasTheCausticsThatMove() {
        Scene scene = blurred("{ \"model\": \"physical\", \"maxBounces\": 4 }");
        assertTrue(Renderer.inspect(scene, settings(scene, 2)).modelled().contains("caustics by light tracing"));
        float[] blurred = Renderer.render(scene, settings(scene, 17)).toArray();
        float[] truth = bruteForce(scene, BuiltInMethod.BIDIRECTIONAL, 8);
        double difference = meanSquare(blurred, truth);
        double bias = 0;
        for (int i = 0; i < truth.length; i++) {
            bias += (blurred[i] - truth[i]) / truth.length;
        }
        assertTrue(difference < 2e-3, "mean square " + difference);
        assertEquals(0, bias, 4 * Math.sqrt(difference / truth.length * 3));
    }

    @ParameterizedTest
    @CsvSource(
            delimiter = '|',
            value = {
                "RAYTRACE | { \"model\": \"classic\" }",
                "RAYTRACE | { \"model\": \"physical\", \"maxBounces\": 3 }",
                "CLUSTER | { \"model\": \"physical\", \"maxBounces\": 3 }",
                "METROPOLIS | { \"model\": \"physical\", \"maxBounces\": 3 }",
                "LIGHT | { \"model\": \"physical\", \"maxBounces\": 3 }",
                "BIDIRECTIONAL | { \"model\": \"physical\", \"maxBounces\": 3 }"
            })
    void theSameBytesComeFromAnyNumberOfThreadsAndAnyTiles(BuiltInMethod method, String shading) {
        Scene scene = blurred(shading);
        RenderSettings settings = settings(scene, 3).withMethod(method);
        Image all = Renderer.render(scene, settings.withThreads(1));
        assertArrayEquals(
                all.toArray(), Renderer.render(scene, settings.withThreads(5)).toArray());
        Image crop = Renderer.render(scene, settings.withCrop(new RenderSettings.Crop(7, 5, 13, 11)));
        for (int y = 0; y < 11; y++) {
            for (int x = 0; x < 13; x++) {
                for (int c = 0; c < 3; c++) {
                    assertEquals(all.component(7 + x, 5 + y, c), crop.component(x, y, c));
                }
            }
        }
    }

    /** Whatever the moments: if all are alike, it is the picture of one. */
    @Test
    void whereNothingMovesTheShutterChangesNothing() {
        Scene still = blurred("{ \"model\": \"classic\" }").withInstants(List.of());
        Scene same = still.withInstants(List.of(still, still, still));
        assertArrayEquals(
                Renderer.render(still, settings(still, 4)).toArray(),
                Renderer.render(same, settings(same, 4)).toArray());
    }

    @Test
    void withoutAShutterThereAreNoInstants() {
        assertEquals(0, scene("{ \"model\": \"classic\" }", "").instants().size());
    }

    /**
     * A lamp shines at one moment of sixteen, and each pixel sees that in one of its samples or in none: how many samples it gets must not
     * depend on whether it did. The mean of many pictures is that of all moments.
     */
    @Test
    void aFlashThatFewSamplesSeeIsNotUnderestimated() {
        String shading = "{ \"model\": \"physical\", \"maxBounces\": 2 }";
        Scene dark = scene(shading, "", 1e-9);
        List<Scene> moments = new ArrayList<>(Collections.nCopies(16, dark));
        moments.set(5, scene(shading, "", 300));
        Scene flash = dark.withInstants(moments);
        int seeds = 300;
        double[] mean = new double[2];
        double square = 0;
        for (int seed = 0; seed < seeds; seed++) {
            RenderSettings small = settings(flash, 3).withSize(8, 6).withSeed(seed);
            double one = mean(Renderer.render(flash, small.withMethod(BuiltInMethod.CLUSTER)));
            mean[0] += one / seeds;
            square += one * one / seeds;
            mean[1] += mean(Renderer.render(flash, small.withMethod(BuiltInMethod.RAYTRACE))) / seeds;
        }
        double error = Math.sqrt((square - mean[0] * mean[0]) / seeds);
        assertTrue(mean[1] > 0, "something is seen");
        assertEquals(mean[1], mean[0], 4 * error, "standard error " + error);
    }

    private static double mean(Image image) {
        double sum = 0;
        float[] all = image.toArray();
        for (float v : all) {
            sum += v;
        }
        return sum / all.length;
    }

    @Test
    void theClusterMethodOfClassicShadingCannotBlurAndSaysWhoCan() {
        BuiltInMethod method = BuiltInMethod.CLUSTER;
        Scene scene = blurred("{ \"model\": \"classic\" }");
        SceneException e = assertThrows(
                SceneException.class,
                () -> Renderer.render(scene, settings(scene, 2).withMethod(method)));
        assertTrue(e.getMessage().contains("/animation/shutter"), e.getMessage());
        assertTrue(
                e.getMessage()
                        .contains("the method " + method.word() + " cannot render what moves while the shutter is open"
                                + " in classic shading"),
                e.getMessage());
        assertTrue(e.getMessage().contains("raytrace"), e.getMessage());
    }

    /** An error that is asked for is one of the blurred picture. */
    @Test
    void theErrorOfABlurredPictureIsKept() {
        Scene scene = blurred("{ \"model\": \"classic\" }");
        float[] truth = Renderer.render(scene, settings(scene, 40)).toArray();
        RenderSettings asked = settings(scene, 2);
        asked = asked.withBudget(asked.budget().withError(0.01));
        RenderResult result = Renderer.render(RenderRequest.of(scene, asked));
        assertTrue(result.report().isErrorMet());
        double error = Math.sqrt(meanSquare(result.image().toArray(), truth));
        assertTrue(error < 0.01, "error " + error);
    }
}
