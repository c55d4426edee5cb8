package enlightenment.physical;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import enlightenment.image.Image;
import enlightenment.render.RenderProgress;
import enlightenment.render.Renderer;
import enlightenment.scene.BuiltInMethod;
import enlightenment.scene.RenderSettings;
import enlightenment.scene.Scene;
import enlightenment.scene.json.SceneReader;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** What paths from lights bring where pixels share their vertices; that they bring the right light is {@link BidirectionalClusterPartnerTest}'s. */
class BidirectionalClusterTest {
    private static final int SAMPLES = 16;

    private static Image render(Scene scene, BuiltInMethod method, int samples, long seed) {
        RenderSettings settings = RenderSettings.of(scene)
                .withSize(48, 32)
                .withMethod(method)
                .withSeed(seed)
                .withBudget(RenderSettings.Budget.NONE.withSamples(samples));
        return Renderer.render(scene, settings, RenderProgress.NONE, () -> false)
                .image();
    }

    private static Scene scene(String name) throws IOException {
        return SceneReader.read(Path.of("scenes", name + ".json"));
    }

    /** The mean squared difference of two pictures with different seeds. */
    private static double noise(Scene scene, BuiltInMethod method) {
        Image a = render(scene, method, SAMPLES, 1);
        Image b = render(scene, method, SAMPLES, 2);
        double sum = 0;
        for (int y = 0; y < a.height(); y++) {
            for (int x = 0; x < a.width(); x++) {
                double difference = a.component(x, y, 0) - b.component(x, y, 0);
                sum += difference * difference;
            }
        }
        return sum;
    }

    @Test
    void behindADoorThereIsAtMostAQuarterOfTheNoiseOfUnsharedPaths() throws IOException {
        assertQuarterOfNoise(scene("door-ajar"));
    }

    private static void assertQuarterOfNoise(Scene scene) {
        double shared = noise(scene, BuiltInMethod.BIDIRECTIONAL_CLUSTER);
        double unshared = noise(scene, BuiltInMethod.BIDIRECTIONAL);
        assertTrue(shared < unshared / 4, shared + " and " + unshared);
    }

    /** Matte surfaces made plastic, whose reflection depends on direction, as that of most models is. */
    @Test
    void inARoomOfPlasticLightPathsHelpAsMuch(@TempDir Path folder) throws IOException {
        String text = Files.readString(Path.of("scenes", "door-ajar.json"))
                .replace("\"type\": \"matte\"", "\"type\": \"principled\", \"roughness\": 0.6");
        assertQuarterOfNoise(SceneReader.read(Files.writeString(folder.resolve("plastic.json"), text)));
    }

    @ParameterizedTest
    @ValueSource(strings = {"fog", "fluorescent-poster", "milk-and-glass", "prism"})
    void whereNoVerticesAreSharedItIsCluster(String name) throws IOException {
        Scene scene = scene(name);
        assertSame(
                render(scene, BuiltInMethod.CLUSTER, 8, 1), render(scene, BuiltInMethod.BIDIRECTIONAL_CLUSTER, 8, 1));
    }

    @Test
    void withFewSamplesItIsRaytrace() throws IOException {
        Scene scene = scene("cornell-box");
        assertSame(
                render(scene, BuiltInMethod.RAYTRACE, 4, 1), render(scene, BuiltInMethod.BIDIRECTIONAL_CLUSTER, 4, 1));
    }

    private static void assertSame(Image a, Image b) {
        for (int y = 0; y < a.height(); y++) {
            for (int x = 0; x < a.width(); x++) {
                assertArrayEquals(
                        new float[] {a.component(x, y, 0), a.component(x, y, 1), a.component(x, y, 2)},
                        new float[] {b.component(x, y, 0), b.component(x, y, 1), b.component(x, y, 2)});
            }
        }
    }
}
